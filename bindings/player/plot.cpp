#include "player/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/check.hpp"

namespace pantin::player {
namespace {

constexpr double plot_width = 430, plot_height = 330;                             // [pixels] with margins
constexpr double left = 68, right = 16, top = 34, bottom = 52, legend_line = 20;  // [pixels]
constexpr const char* ink = "#7d8590";
constexpr std::array colors = {"#3b8fd9", "#e2762b", "#36a35c", "#b565c7", "#c39b1f", "#d7566a", "#2aa5a5", "#8f7a68"};

std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

/// A coordinate in pixels, to a hundredth.
std::string at(double pixels) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2f", pixels);
  return digits;
}

std::string power_of_ten(int exponent) {
  constexpr std::array raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) result += raised[static_cast<std::size_t>(c - '0')];
  return result;
}

bool can_be_drawn(const std::pair<double, double>& point) {
  return std::isfinite(point.first) && std::isfinite(point.second) && point.first > 0.0 && point.second > 0.0;
}

/// One axis: whole decades round all values, over a stretch of pixels.
struct Axis {
  int first = 0, last = 1;    ///< decades
  double start = 0, end = 1;  ///< [pixels]
  double place(double value) const { return start + (end - start) * (std::log10(value) - first) / (last - first); }
  /// A label every so many decades.
  int stride() const { return (last - first + 7) / 8; }
};

Axis axis(const Plot& plot, bool of_x, double start, double end) {
  Axis result{0, 1, start, end};
  bool any = false;
  const auto include = [&](double value) {
    const double decade = std::log10(value);
    const int low = static_cast<int>(std::floor(decade)), high = static_cast<int>(std::ceil(decade));
    result.first = any ? std::min(result.first, low) : low;
    result.last = any ? std::max(result.last, high) : high;
    any = true;
  };
  for (const Series& series : plot.series)
    for (const auto& point : series.points)
      if (can_be_drawn(point)) include(of_x ? point.first : point.second);
  if (!of_x && plot.level > 0.0) include(plot.level);
  result.last = std::max(result.last, result.first + 1);
  return result;
}

/// The names of all plots, each once, in the order in which they come.
std::vector<std::string> names_of(const std::vector<Plot>& plots) {
  std::vector<std::string> names;
  for (const Plot& plot : plots)
    for (const Series& series : plot.series)
      if (std::find(names.begin(), names.end(), series.name) == names.end()) names.push_back(series.name);
  return names;
}

/// Colour, and dashes from the ninth name on.
std::string stroke(std::size_t index) {
  const std::string color = text("stroke=\"", colors[index % colors.size()], "\"");
  return index < colors.size() ? color : color + " stroke-dasharray=\"5 3\"";
}

void draw_line(std::string& svg, double x0, double y0, double x1, double y1, const std::string& style) {
  svg += text("<line x1=\"", at(x0), "\" y1=\"", at(y0), "\" x2=\"", at(x1), "\" y2=\"", at(y1), "\" ", style, "/>\n");
}

void draw_words(std::string& svg, double x, double y, const std::string& style, const std::string& words) {
  svg += text("<text x=\"", at(x), "\" y=\"", at(y), "\" ", style, ">", escaped(words), "</text>\n");
}

void draw_axes(std::string& svg, const Plot& plot, const Axis& x, const Axis& y) {
  const std::string grid = text("stroke=\"", ink, "\" stroke-opacity=\"0.3\"");
  for (int k = x.first; k <= x.last; k++) {
    const double place = x.place(std::pow(10.0, k));
    draw_line(svg, place, y.start, place, y.end, grid);
    if ((k - x.first) % x.stride() == 0)
      draw_words(svg, place, y.start + 16, "text-anchor=\"middle\"", power_of_ten(k));
  }
  for (int k = y.first; k <= y.last; k++) {
    const double place = y.place(std::pow(10.0, k));
    draw_line(svg, x.start, place, x.end, place, grid);
    if ((k - y.first) % y.stride() == 0)
      draw_words(svg, x.start - 6, place + 4, "text-anchor=\"end\"", power_of_ten(k));
  }
  const double middle = 0.5 * (x.start + x.end), centre = 0.5 * (y.start + y.end);
  draw_words(svg, middle, y.end - 12, "text-anchor=\"middle\" font-weight=\"bold\"", plot.title);
  draw_words(svg, middle, y.start + 36, "text-anchor=\"middle\"", plot.x_name);
  draw_words(svg, x.start - 48, centre,
             text("text-anchor=\"middle\" transform=\"rotate(-90 ", at(x.start - 48), " ", at(centre), ")\""),
             plot.y_name);
}

void draw_series(std::string& svg, const Series& series, std::size_t index, const Axis& x, const Axis& y) {
  std::string line, marks;
  for (const auto& point : series.points) {
    if (!can_be_drawn(point)) continue;
    const std::string px = at(x.place(point.first)), py = at(y.place(point.second));
    line += (line.empty() ? "" : " ") + px + "," + py;
    marks += text("<circle cx=\"", px, "\" cy=\"", py, "\" r=\"3\" fill=\"", colors[index % colors.size()], "\"/>\n");
  }
  if (line.empty()) return;
  svg += text("<polyline fill=\"none\" stroke-width=\"1.8\" ", stroke(index), " points=\"", line, "\"/>\n") + marks;
}

std::string dashes() { return text("stroke=\"", ink, "\" stroke-dasharray=\"6 4\""); }

void draw_ring(std::string& svg, double x, double y) {
  svg += text("<circle cx=\"", at(x), "\" cy=\"", at(y), "\" r=\"7\" fill=\"none\" stroke-width=\"1.5\" stroke=\"", ink,
              "\"/>\n");
}

void draw_level_and_mark(std::string& svg, const Plot& plot, const Axis& x, const Axis& y) {
  if (plot.level > 0.0) {
    const double height = y.place(plot.level);
    draw_line(svg, x.start, height, x.end, height, dashes());
  }
  if (!can_be_drawn(plot.mark)) return;
  const double px = x.place(plot.mark.first), py = y.place(plot.mark.second);
  draw_ring(svg, px, py);
}

void draw_plot(std::string& svg, const Plot& plot, double x0, double y0, const std::vector<std::string>& names) {
  const Axis x = axis(plot, true, x0 + left, x0 + plot_width - right);
  const Axis y = axis(plot, false, y0 + plot_height - bottom, y0 + top);
  draw_axes(svg, plot, x, y);
  for (const Series& series : plot.series) {
    const auto name = std::find(names.begin(), names.end(), series.name);
    draw_series(svg, series, static_cast<std::size_t>(name - names.begin()), x, y);
  }
  draw_level_and_mark(svg, plot, x, y);
}

constexpr double legend_width = 190;  // [pixels] of one name

struct LegendEntry {
  std::string name;
  std::string style;  ///< of a line; empty: a ring
};

std::vector<LegendEntry> legend_of(const std::vector<Plot>& plots, const std::vector<std::string>& names) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < names.size(); i++) entries.push_back({names[i], stroke(i) + " stroke-width=\"2.5\""});
  const auto level = std::find_if(plots.begin(), plots.end(), [](const Plot& plot) { return plot.level > 0.0; });
  if (level != plots.end()) entries.push_back({level->level_name, dashes()});
  const auto mark = std::find_if(plots.begin(), plots.end(), [](const Plot& plot) { return can_be_drawn(plot.mark); });
  if (mark != plots.end()) entries.push_back({mark->mark_name, ""});
  return entries;
}

void draw_legend(std::string& svg, const std::vector<LegendEntry>& entries, int per_line, double y0) {
  for (std::size_t i = 0; i < entries.size(); i++) {
    const int place = static_cast<int>(i);
    const double x = left + legend_width * (place % per_line), y = y0 + legend_line * (place / per_line);
    if (entries[i].style.empty())
      draw_ring(svg, x + 11, y - 4);
    else
      draw_line(svg, x, y - 4, x + 22, y - 4, entries[i].style);
    draw_words(svg, x + 28, y, "", entries[i].name);
  }
}

}  // namespace

std::string draw_plots(const std::vector<Plot>& plots, int columns) {
  const int count = static_cast<int>(plots.size()), wide = std::clamp(count, 1, columns);
  const int rows = (count + wide - 1) / wide;
  const std::vector<std::string> names = names_of(plots);
  const std::vector<LegendEntry> legend = legend_of(plots, names);
  const int per_line = std::max(1, static_cast<int>((plot_width * wide - left) / legend_width));
  const double lines = std::ceil(static_cast<double>(legend.size()) / per_line);
  const double width = plot_width * wide, height = plot_height * rows + 20 + legend_line * lines;
  std::string svg = text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", at(width), "\" height=\"", at(height),
                         "\" viewBox=\"0 0 ", at(width), " ", at(height),
                         "\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\" fill=\"", ink, "\">\n");
  for (int i = 0; i < count; i++)
    draw_plot(svg, plots[static_cast<std::size_t>(i)], plot_width * (i % wide), plot_height * (i / wide), names);
  draw_legend(svg, legend, per_line, plot_height * rows + 20);
  return svg + "</svg>\n";
}

}  // namespace pantin::player
