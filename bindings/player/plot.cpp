#include "player/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/check.hpp"
#include "player/svg.hpp"

namespace pantin::player {
namespace {

constexpr double plot_width = 430, plot_height = 330;                             // [pixels] with margins
constexpr double left = 68, right = 16, top = 34, bottom = 52, legend_line = 20;  // [pixels]
constexpr std::array colors = {"#3b8fd9", "#e2762b", "#36a35c", "#b565c7", "#c39b1f", "#d7566a", "#2aa5a5", "#8f7a68"};

bool can_be_drawn(const Plot& plot, const std::pair<double, double>& point) {
  const auto fits = [](double value, bool linear) { return std::isfinite(value) && (linear || value > 0.0); };
  return fits(point.first, plot.linear_x) && fits(point.second, plot.linear_y);
}

bool is_marked(const Plot& plot) { return !plot.mark_name.empty() && can_be_drawn(plot, plot.mark); }

Scale scale(const Plot& plot, bool of_x, double start, double end) {
  std::vector<double> values;
  for (const Series& series : plot.series)
    for (const auto& point : series.points)
      if (can_be_drawn(plot, point)) values.push_back(of_x ? point.first : point.second);
  if (!of_x && plot.level > 0.0) values.push_back(plot.level);
  return {values, !(of_x ? plot.linear_x : plot.linear_y), start, end};
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

void draw_series(std::string& svg, const Plot& plot, const Series& series, std::size_t index, const Scale& x,
                 const Scale& y) {
  std::string line, marks;
  for (const auto& point : series.points) {
    if (!can_be_drawn(plot, point)) continue;
    const std::string px = svg_number(x.place(point.first)), py = svg_number(y.place(point.second));
    line += (line.empty() ? "" : " ") + px + "," + py;
    marks += text("<circle cx=\"", px, "\" cy=\"", py, "\" r=\"3\" fill=\"", colors[index % colors.size()], "\"/>\n");
  }
  if (line.empty()) return;
  if (!plot.joined) {
    svg += marks;
    return;
  }
  svg += text("<polyline fill=\"none\" stroke-width=\"1.8\" ", stroke(index), " points=\"", line, "\"/>\n") + marks;
}

std::string dashes() { return text("stroke=\"", svg_ink, "\" stroke-dasharray=\"6 4\""); }

void draw_ring(std::string& svg, double x, double y) {
  svg += text("<circle cx=\"", svg_number(x), "\" cy=\"", svg_number(y),
              "\" r=\"7\" fill=\"none\" stroke-width=\"1.5\" stroke=\"", svg_ink, "\"/>\n");
}

void draw_level_and_mark(std::string& svg, const Plot& plot, const Scale& x, const Scale& y) {
  if (plot.level > 0.0) {
    const double height = y.place(plot.level);
    svg_line(svg, x.start(), height, x.end(), height, dashes());
  }
  if (!is_marked(plot)) return;
  const double px = x.place(plot.mark.first), py = y.place(plot.mark.second);
  draw_ring(svg, px, py);
}

void draw_plot(std::string& svg, const Plot& plot, double x0, double y0, const std::vector<std::string>& names) {
  const Scale x = scale(plot, true, x0 + left, x0 + plot_width - right);
  const Scale y = scale(plot, false, y0 + plot_height - bottom, y0 + top);
  draw_axes(svg, {plot.title, plot.x_name, plot.y_name}, x, y);
  for (const Series& series : plot.series) {
    const auto name = std::find(names.begin(), names.end(), series.name);
    draw_series(svg, plot, series, static_cast<std::size_t>(name - names.begin()), x, y);
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
  for (std::size_t i = 0; i < names.size(); i++)
    if (!names[i].empty()) entries.push_back({names[i], stroke(i) + " stroke-width=\"2.5\""});
  const auto level = std::find_if(plots.begin(), plots.end(), [](const Plot& plot) { return plot.level > 0.0; });
  if (level != plots.end()) entries.push_back({level->level_name, dashes()});
  const auto mark = std::find_if(plots.begin(), plots.end(), [](const Plot& plot) { return is_marked(plot); });
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
      svg_line(svg, x, y - 4, x + 22, y - 4, entries[i].style);
    svg_words(svg, x + 28, y, "", entries[i].name);
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
  std::string svg = svg_begin(width, height);
  for (int i = 0; i < count; i++)
    draw_plot(svg, plots[static_cast<std::size_t>(i)], plot_width * (i % wide), plot_height * (i / wide), names);
  draw_legend(svg, legend, per_line, plot_height * rows + 20);
  return svg + "</svg>\n";
}

}  // namespace pantin::player
