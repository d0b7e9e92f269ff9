#include "player/color_bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/check.hpp"
#include "player/svg.hpp"

namespace pantin::player {
namespace {

constexpr double bar_width = 16, name_at = 92;  // [pixels]

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

}  // namespace

void draw_tile(std::string& svg, double x0, double y0, double x1, double y1, const std::string& color) {
  svg += text("<rect x=\"", svg_number(std::min(x0, x1)), "\" y=\"", svg_number(std::min(y0, y1)), "\" width=\"",
              svg_number(std::fabs(x1 - x0)), "\" height=\"", svg_number(std::fabs(y1 - y0)), "\" fill=\"", color,
              "\" shape-rendering=\"crispEdges\"/>\n");
}

double ColorBar::part_of(double value) const {
  if (!(largest_ > least_)) return 0.5;
  if (logarithmic_) return std::log10(value / least_) / std::log10(largest_ / least_);
  return (value - least_) / (largest_ - least_);
}

std::string ColorBar::color_of(double value) const { return color_at(part_of(value)); }

void ColorBar::draw(std::string& svg, double x, double top, double low) const {
  const double x1 = x + bar_width, side = low - top, middle = low - 0.5 * side;
  constexpr int steps = 60;
  for (int i = 0; i < steps; i++)
    draw_tile(svg, x, low - side * i / steps, x1, low - side * (i + 1) / steps, color_at((i + 0.5) / steps));
  const Scale scale({least_, largest_}, logarithmic_, low, top);
  for (const Scale::Tick& tick : scale.ticks()) {
    const double part = part_of(tick.value);
    if (part < -1e-9 || part > 1.0 + 1e-9 || !(largest_ > least_)) continue;
    svg_words(svg, x1 + 6, low - side * part + 4, "", tick.label);
  }
  svg_words(
      svg, x + name_at, middle,
      text("text-anchor=\"middle\" transform=\"rotate(-90 ", svg_number(x + name_at), " ", svg_number(middle), ")\""),
      name_);
  if (largest_ > least_) return;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", least_);
  svg_words(svg, x1 + 6, middle + 4, "", digits);
}

}  // namespace pantin::player
