#include "player/heat_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "player/color_bar.hpp"
#include "player/svg.hpp"

namespace pantin::player {
namespace {

constexpr double map_left = 68, map_top = 34, map_side = 420;  // [pixels]
constexpr double bar_gap = 24, map_bottom = 52;                // [pixels]
constexpr const char* hatched = "url(#hatched)";

std::vector<double> different(const std::vector<HeatValue>& values, double HeatValue::*which) {
  std::vector<double> all;
  for (const HeatValue& v : values)
    if (std::isfinite(v.*which)) all.push_back(v.*which);
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

/// Says of the hatching what it is.
void draw_without(std::string& svg) {
  constexpr double x = map_left + map_side + bar_gap, y = map_top + map_side + 18, side = 16;
  draw_tile(svg, x, y, x + side, y + side, hatched);
  svg_words(svg, x + side + 6, y + 13, "", "no number");
}

}  // namespace

std::string draw_heat_map(const HeatMap& map) {
  const std::vector<double> xs = different(map.values, &HeatValue::x), ys = different(map.values, &HeatValue::y);
  const std::vector<double> values = different(map.values, &HeatValue::value);
  const std::vector<double> columns = borders(xs, map.logarithmic_x), rows = borders(ys, map.logarithmic_y);
  const Scale x = Scale::between(columns.front(), columns.back(), map.logarithmic_x, map_left, map_left + map_side);
  const Scale y = Scale::between(rows.front(), rows.back(), map.logarithmic_y, map_top + map_side, map_top);
  const ColorBar bar(map.value_name, values.front(), values.back(), map.logarithmic_value);
  const bool is_grid = 2 * map.values.size() >= xs.size() * ys.size();
  std::string svg = svg_begin(map_left + map_side + bar_gap + ColorBar::width, map_top + map_side + map_bottom);
  svg += text("<defs><pattern id=\"hatched\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\">",
              "<path d=\"M0 6L6 0\" stroke=\"", svg_ink, "\" stroke-opacity=\"0.5\"/></pattern></defs>\n");
  bool all_have_one = true;
  std::vector<Spot> spots;
  for (const HeatValue& v : map.values) {
    const bool has_one = std::isfinite(v.value);
    all_have_one = all_have_one && has_one;
    const std::string color = has_one ? bar.color_of(v.value) : hatched;
    if (!is_grid) {
      spots.push_back({(x.place(v.x) - map_left) / map_side, 1.0 - (y.place(v.y) - map_top) / map_side, color});
      continue;
    }
    const auto i = static_cast<std::size_t>(std::ranges::lower_bound(xs, v.x) - xs.begin());
    const auto j = static_cast<std::size_t>(std::ranges::lower_bound(ys, v.y) - ys.begin());
    draw_tile(svg, x.place(columns[i]), y.place(rows[j]), x.place(columns[i + 1]), y.place(rows[j + 1]), color);
  }
  if (!is_grid) draw_nearest(svg, spots);
  if (!all_have_one) draw_without(svg);
  bar.draw(svg, map_left + map_side + bar_gap, map_top, map_top + map_side);
  draw_axes(svg, {map.title, map.x_name, map.y_name}, x, y);
  return svg + "</svg>\n";
}

}  // namespace pantin::player
