#include "player/heat_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/check.hpp"
#include "player/svg.hpp"

namespace pantin::player {
namespace {

constexpr double map_left = 68, map_top = 34, map_side = 420;                    // [pixels]
constexpr double bar_gap = 24, bar_width = 16, map_right = 76, map_bottom = 52;  // [pixels]

/// From dark blue over green to yellow, even to the eye (viridis, van der Walt and Smith 2015).
std::string color_at(double part) {
  constexpr std::array<std::array<double, 3>, 6> stops = {
      {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {253, 231, 37}}};
  const double at = std::clamp(part, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t k = std::min(stops.size() - 2, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  std::array<int, 3> c{};
  for (std::size_t i = 0; i < 3; i++)
    c[i] = static_cast<int>(std::lround(stops[k][i] + f * (stops[k + 1][i] - stops[k][i])));
  char code[8];
  std::snprintf(code, sizeof code, "#%02x%02x%02x", c[0], c[1], c[2]);
  return code;
}

std::vector<double> different(const std::vector<HeatValue>& values, double HeatValue::*which) {
  std::vector<double> all;
  for (const HeatValue& v : values) all.push_back(v.*which);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Where the tile of each value begins and, as the last, where the last one ends: midway between values, in the logarithm
/// where the axis is logarithmic.
std::vector<double> borders(const std::vector<double>& values, bool logarithmic) {
  std::vector<double> at, result;
  for (const double value : values) at.push_back(logarithmic ? std::log10(value) : value);
  const double alone = logarithmic ? 0.5 : std::max(0.5 * std::fabs(at[0]), 1e-9);
  const double first = at.size() > 1 ? 0.5 * (at[1] - at[0]) : alone;
  const double last = at.size() > 1 ? 0.5 * (at.back() - at[at.size() - 2]) : alone;
  result.push_back(at[0] - first);
  for (std::size_t i = 1; i < at.size(); i++) result.push_back(0.5 * (at[i - 1] + at[i]));
  result.push_back(at.back() + last);
  if (logarithmic)
    for (double& border : result) border = std::pow(10.0, border);
  return result;
}

void draw_tile(std::string& svg, double x0, double y0, double x1, double y1, const std::string& color) {
  svg += text("<rect x=\"", svg_number(std::min(x0, x1)), "\" y=\"", svg_number(std::min(y0, y1)), "\" width=\"",
              svg_number(std::fabs(x1 - x0)), "\" height=\"", svg_number(std::fabs(y1 - y0)), "\" fill=\"", color,
              "\" shape-rendering=\"crispEdges\"/>\n");
}

double part_of(double value, double least, double largest, bool logarithmic) {
  if (logarithmic) {
    value = std::log10(value);
    least = std::log10(least);
    largest = std::log10(largest);
  }
  return largest > least ? (value - least) / (largest - least) : 0.5;
}

/// Where a value is in the map, each axis from 0 to 1.
struct Spot {
  double x, y;
  std::string color;
};

/// Each place in the colour of the value that is nearest in the picture, and a dot at each value.
void draw_nearest(std::string& svg, const std::vector<Spot>& spots) {
  constexpr int count = 105;  // of places along a side
  constexpr double side = map_side / count;
  for (int j = 0; j < count; j++) {
    std::vector<const Spot*> nearest;
    for (int i = 0; i < count; i++) {
      const auto distance = [&](const Spot& spot) {
        return std::hypot(spot.x - (i + 0.5) / count, spot.y - (j + 0.5) / count);
      };
      nearest.push_back(&*std::ranges::min_element(spots, {}, distance));
    }
    for (int i = 0, from = 0; i < count; from = i) {
      while (i < count && nearest[static_cast<std::size_t>(i)] == nearest[static_cast<std::size_t>(from)]) i++;
      const double low = map_top + map_side - j * side;
      draw_tile(svg, map_left + from * side, low, map_left + i * side, low - side,
                nearest[static_cast<std::size_t>(from)]->color);
    }
  }
  for (const Spot& spot : spots)
    svg += text("<circle cx=\"", svg_number(map_left + map_side * spot.x), "\" cy=\"",
                svg_number(map_top + map_side * (1.0 - spot.y)), "\" r=\"1.5\" fill=\"", svg_ink, "\"/>\n");
}

void draw_bar(std::string& svg, const HeatMap& map, double least, double largest) {
  const double x0 = map_left + map_side + bar_gap, x1 = x0 + bar_width, low = map_top + map_side;
  constexpr int steps = 60;
  for (int i = 0; i < steps; i++)
    draw_tile(svg, x0, low - map_side * i / steps, x1, low - map_side * (i + 1) / steps, color_at((i + 0.5) / steps));
  const Scale scale({least, largest}, map.logarithmic_value, low, map_top);
  for (const Scale::Tick& tick : scale.ticks()) {
    const double part = part_of(tick.value, least, largest, map.logarithmic_value);
    if (part < -1e-9 || part > 1.0 + 1e-9 || !(largest > least)) continue;
    svg_words(svg, x1 + 6, low - map_side * part + 4, "", tick.label);
  }
  svg_words(svg, x0, map_top - 12, "", map.value_name);
  if (largest > least) return;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", least);
  svg_words(svg, x1 + 6, low - 0.5 * map_side + 4, "", digits);
}

}  // namespace

std::string draw_heat_map(const HeatMap& map) {
  const std::vector<double> xs = different(map.values, &HeatValue::x), ys = different(map.values, &HeatValue::y);
  const std::vector<double> values = different(map.values, &HeatValue::value);
  const std::vector<double> columns = borders(xs, map.logarithmic_x), rows = borders(ys, map.logarithmic_y);
  const Scale x = Scale::between(columns.front(), columns.back(), map.logarithmic_x, map_left, map_left + map_side);
  const Scale y = Scale::between(rows.front(), rows.back(), map.logarithmic_y, map_top + map_side, map_top);
  const bool is_grid = 2 * map.values.size() >= xs.size() * ys.size();
  std::string svg = svg_begin(map_left + map_side + bar_gap + bar_width + map_right, map_top + map_side + map_bottom);
  std::vector<Spot> spots;
  for (const HeatValue& v : map.values) {
    const std::string color = color_at(part_of(v.value, values.front(), values.back(), map.logarithmic_value));
    if (!is_grid) {
      spots.push_back({(x.place(v.x) - map_left) / map_side, 1.0 - (y.place(v.y) - map_top) / map_side, color});
      continue;
    }
    const auto i = static_cast<std::size_t>(std::ranges::lower_bound(xs, v.x) - xs.begin());
    const auto j = static_cast<std::size_t>(std::ranges::lower_bound(ys, v.y) - ys.begin());
    draw_tile(svg, x.place(columns[i]), y.place(rows[j]), x.place(columns[i + 1]), y.place(rows[j + 1]), color);
  }
  if (!is_grid) draw_nearest(svg, spots);
  draw_bar(svg, map, values.front(), values.back());
  draw_axes(svg, {map.title, map.x_name, map.y_name}, x, y);
  return svg + "</svg>\n";
}

}  // namespace pantin::player
