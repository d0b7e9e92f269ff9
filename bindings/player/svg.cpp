#include "player/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/check.hpp"
#include "scene/printable.hpp"

namespace pantin::player {
namespace {

std::string power_of_ten(int exponent) {
  constexpr std::array raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) result += raised[static_cast<std::size_t>(c - '0')];
  return result;
}

/// 1, 2 or 5 times a power of ten, so that a span has about six.
double round_step(double span) {
  const double rough = span / 6.0, decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * decade >= rough) return times * decade;
  return 10.0 * decade;
}

constexpr double fine_decades = 2.0;  ///< below which powers of ten alone are too few ticks

std::string label(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value);
  return digits;
}

}  // namespace

std::string svg_number(double pixels) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2f", pixels);
  return digits;
}

std::string svg_escaped(const std::string& words) {
  std::string result;
  for (const char c : printable(words))
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

std::string svg_begin(double width, double height) {
  return text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", svg_number(width), "\" height=\"",
              svg_number(height), "\" viewBox=\"0 0 ", svg_number(width), " ", svg_number(height),
              "\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\" fill=\"", svg_ink, "\">\n");
}

void svg_line(std::string& svg, double x0, double y0, double x1, double y1, const std::string& style) {
  svg += text("<line x1=\"", svg_number(x0), "\" y1=\"", svg_number(y0), "\" x2=\"", svg_number(x1), "\" y2=\"",
              svg_number(y1), "\" ", style, "/>\n");
}

void svg_words(std::string& svg, double x, double y, const std::string& style, const std::string& words) {
  svg +=
      text("<text x=\"", svg_number(x), "\" y=\"", svg_number(y), "\" ", style, ">", svg_escaped(words), "</text>\n");
}

Scale::Scale(const std::vector<double>& values, bool logarithmic, double start, double end)
    : logarithmic_(logarithmic), start_(start), end_(end) {
  double low = logarithmic ? 1.0 : 0.0, high = low;
  if (!values.empty()) {
    const auto [least, largest] = std::ranges::minmax_element(values);
    low = *least;
    high = *largest;
  }
  if (logarithmic)
    set_decades(low, high);
  else
    set_steps(low, high);
}

Scale Scale::between(double low, double high, bool logarithmic, double start, double end) {
  Scale scale({low, high}, logarithmic, start, end);
  scale.low_ = logarithmic ? std::log10(low) : low;
  scale.high_ = logarithmic ? std::log10(high) : high;
  std::erase_if(scale.ticks_, [&](const Tick& tick) { return tick.value < low || tick.value > high; });
  return scale;
}

/// Powers of ten about both; twice and five times those, too, where they are near each other.
void Scale::set_decades(double low, double high) {
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = std::max(first + 1, static_cast<int>(std::ceil(std::log10(high))));
  const bool fine = std::log10(high / low) < fine_decades;
  const int stride = (last - first + 7) / 8;
  std::vector<Tick> ticks;
  for (int k = first; k <= last; k++)
    for (const int times : {1, 2, 5}) {
      if (times > 1 && (!fine || k == last)) break;
      const double value = times * std::pow(10.0, k);
      ticks.push_back({value, fine ? label(value) : (k - first) % stride == 0 ? power_of_ten(k) : ""});
    }
  std::size_t from = 0, to = ticks.size() - 1;
  while (fine && from + 1 < to && ticks[from + 1].value <= low) from++;
  while (fine && to - 1 > from && ticks[to - 1].value >= high) to--;
  low_ = std::log10(ticks[from].value);
  high_ = std::log10(ticks[to].value);
  ticks_.assign(ticks.begin() + static_cast<std::ptrdiff_t>(from), ticks.begin() + static_cast<std::ptrdiff_t>(to) + 1);
}

void Scale::set_steps(double low, double high) {
  if (!(high - low > 1e-12 * std::max(std::fabs(low), std::fabs(high)))) {
    const double half = low == 0.0 ? 0.5 : 0.5 * std::fabs(low);
    low -= half;
    high += half;
  }
  const double step = round_step(high - low);
  const double first = std::floor(low / step), last = std::ceil(high / step);
  low_ = first * step;
  high_ = last * step;
  for (double k = first; k <= last; k += 1.0) { ticks_.push_back({k * step, label(k == 0.0 ? 0.0 : k * step)}); }
}

double Scale::place(double value) const {
  const double at = logarithmic_ ? std::log10(value) : value;
  return start_ + (end_ - start_) * (at - low_) / (high_ - low_);
}

void draw_axes(std::string& svg, const AxisNames& names, const Scale& x, const Scale& y) {
  const std::string grid = text("stroke=\"", svg_ink, "\" stroke-opacity=\"0.3\"");
  for (const Scale::Tick& tick : x.ticks()) {
    const double place = x.place(tick.value);
    svg_line(svg, place, y.start(), place, y.end(), grid);
    if (!tick.label.empty()) svg_words(svg, place, y.start() + 16, "text-anchor=\"middle\"", tick.label);
  }
  for (const Scale::Tick& tick : y.ticks()) {
    const double place = y.place(tick.value);
    svg_line(svg, x.start(), place, x.end(), place, grid);
    if (!tick.label.empty()) svg_words(svg, x.start() - 6, place + 4, "text-anchor=\"end\"", tick.label);
  }
  const double middle = 0.5 * (x.start() + x.end()), centre = 0.5 * (y.start() + y.end());
  svg_words(svg, middle, y.end() - 12, "text-anchor=\"middle\" font-weight=\"bold\"", names.title);
  svg_words(svg, middle, y.start() + 36, "text-anchor=\"middle\"", names.x);
  svg_words(svg, x.start() - 48, centre,
            text("text-anchor=\"middle\" transform=\"rotate(-90 ", svg_number(x.start() - 48), " ", svg_number(centre),
                 ")\""),
            names.y);
}

}  // namespace pantin::player
