#include "player/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/check.hpp"
#include "player/color_bar.hpp"
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
struct SeriesLook {
  std::string color;
  bool dashed = false;
  std::string stroke() const { return text("stroke=\"", color, dashed ? "\" stroke-dasharray=\"5 3\"" : "\""); }
};

SeriesLook look_of_name(std::size_t index) { return {colors[index % colors.size()], index >= colors.size()}; }

void draw_dot(std::string& svg, const std::string& x, const std::string& y, const SeriesLook& look) {
  svg += text("<circle cx=\"", x, "\" cy=\"", y, "\" r=\"3\" fill=\"", look.color, "\"/>\n");
}

void draw_series(std::string& svg, const Plot& plot, const Series& series, const SeriesLook& look, const Scale& x,
                 const Scale& y) {
  std::string line, marks;
  for (const auto& point : series.points) {
    if (!can_be_drawn(plot, point)) continue;
    const std::string px = svg_number(x.place(point.first)), py = svg_number(y.place(point.second));
    line += (line.empty() ? "" : " ") + px + "," + py;
    draw_dot(marks, px, py, look);
  }
  if (line.empty()) return;
  if (!plot.joined) {
    svg += marks;
    return;
  }
  svg += text("<polyline fill=\"none\" stroke-width=\"1.8\" ", look.stroke(), " points=\"", line, "\"/>\n") + marks;
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

std::optional<ColorBar> bar_of(const std::vector<Plot>& plots) {
  if (plots.empty() || plots.front().bar_name.empty()) return {};
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const Plot& plot : plots)
    for (const Series& series : plot.series) {
      least = std::min(least, series.number);
      largest = std::max(largest, series.number);
    }
  return ColorBar(plots.front().bar_name, least, largest, plots.front().logarithmic_bar);
}

void draw_plot(std::string& svg, const Plot& plot, double x0, double y0, const std::vector<std::string>& names,
               const std::optional<ColorBar>& bar) {
  const Scale x = scale(plot, true, x0 + left, x0 + plot_width - right);
  const Scale y = scale(plot, false, y0 + plot_height - bottom, y0 + top);
  draw_axes(svg, {plot.title, plot.x_name, plot.y_name}, x, y);
  for (const Series& series : plot.series) {
    const auto name = std::find(names.begin(), names.end(), series.name);
    const SeriesLook look =
        bar ? SeriesLook{bar->color_of(series.number)} : look_of_name(static_cast<std::size_t>(name - names.begin()));
    draw_series(svg, plot, series, look, x, y);
  }
  draw_level_and_mark(svg, plot, x, y);
}

constexpr double sample_width = 28, letter_width = 7.4, legend_gap = 16;  // [pixels] of an entry of the legend

struct LegendEntry {
  enum class Kind { line, dot, ring };
  std::string name;
  Kind kind;
  std::string style;  ///< of a line
  SeriesLook look;    ///< of a dot

  double width() const {
    const auto letters = std::ranges::count_if(name, [](char c) { return (c & 0xc0) != 0x80; });
    return sample_width + letter_width * static_cast<double>(letters) + legend_gap;
  }
};

std::vector<LegendEntry> legend_of(const std::vector<Plot>& plots, const std::vector<std::string>& names) {
  using Kind = LegendEntry::Kind;
  std::vector<LegendEntry> entries;
  const bool joined = std::ranges::all_of(plots, &Plot::joined);
  for (std::size_t i = 0; i < names.size(); i++)
    if (!names[i].empty())
      entries.push_back({names[i], joined ? Kind::line : Kind::dot, look_of_name(i).stroke() + " stroke-width=\"2.5\"",
                         look_of_name(i)});
  const auto level = std::find_if(plots.begin(), plots.end(), [](const Plot& plot) { return plot.level > 0.0; });
  if (level != plots.end()) entries.push_back({level->level_name, Kind::line, dashes(), {}});
  const auto mark = std::find_if(plots.begin(), plots.end(), [](const Plot& plot) { return is_marked(plot); });
  if (mark != plots.end()) entries.push_back({mark->mark_name, Kind::ring, "", {}});
  return entries;
}

void draw_legend(std::string& svg, const std::vector<LegendEntry>& entries, int per_line, double width, double y0) {
  for (std::size_t i = 0; i < entries.size(); i++) {
    const int place = static_cast<int>(i), line = place / per_line;
    const double x = left + width * (place % per_line), y = y0 + legend_line * line;
    switch (entries[i].kind) {
      case LegendEntry::Kind::line: svg_line(svg, x, y - 4, x + 22, y - 4, entries[i].style); break;
      case LegendEntry::Kind::dot: draw_dot(svg, svg_number(x + 11), svg_number(y - 4), entries[i].look); break;
      case LegendEntry::Kind::ring: draw_ring(svg, x + 11, y - 4); break;
    }
    svg_words(svg, x + sample_width, y, "", entries[i].name);
  }
}

}  // namespace

std::size_t most_in_legend(bool joined) { return (joined ? 2 : 1) * colors.size(); }

std::string draw_plots(const std::vector<Plot>& plots, int columns) {
  const int count = static_cast<int>(plots.size()), wide = std::clamp(count, 1, columns);
  const int rows = (count + wide - 1) / wide;
  const std::optional<ColorBar> bar = bar_of(plots);
  const std::vector<std::string> names = bar ? std::vector<std::string>{} : names_of(plots);
  const std::vector<LegendEntry> legend = legend_of(plots, names);
  double entry_width = 1.0;
  for (const LegendEntry& entry : legend) entry_width = std::max(entry_width, entry.width());
  const int per_line = std::max(1, static_cast<int>((plot_width * wide - left) / entry_width));
  const double lines = std::ceil(static_cast<double>(legend.size()) / per_line);
  const double width = plot_width * wide, height = plot_height * rows + 20 + legend_line * lines;
  std::string svg = svg_begin(width + (bar ? ColorBar::width : 0.0), height);
  for (int i = 0; i < count; i++) {
    const int row = i / wide;
    draw_plot(svg, plots[static_cast<std::size_t>(i)], plot_width * (i % wide), plot_height * row, names, bar);
  }
  draw_legend(svg, legend, per_line, entry_width, plot_height * rows + 20);
  if (bar) bar->draw(svg, width, top, plot_height - bottom);
  return svg + "</svg>\n";
}

}  // namespace pantin::player
