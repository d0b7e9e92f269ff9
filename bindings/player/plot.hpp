#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pantin::player {

/// Points in their order. Those that are not finite, or on a logarithmic axis not positive, are left out.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
  double number = 0.0;  ///< for its colour, where a plot has a bar of colours
};

/// Two axes, logarithmic unless they are linear, and the series between them.
struct Plot {
  std::string title, x_name, y_name;
  std::vector<Series> series;
  std::string level_name = {};  ///< of a dashed line
  double level = 0.0;           ///< its height; 0: none
  std::string mark_name = {};   ///< of a ring
  std::pair<double, double> mark = {0.0, 0.0};
  bool linear_x = false, linear_y = false;
  bool joined = true;  ///< by lines, in each series
  std::string bar_name =
      {};  ///< of the series' numbers, which a bar of colours tells in place of a legend; empty: none
  bool logarithmic_bar = false;  ///< numbers are above 0
};

/// How many series can be told apart by a legend.
std::size_t most_in_legend(bool joined);

/// An SVG picture of the plots, `columns` in a row, with one legend for all, or the bar of the first: a name has the same colour in each. The
/// background is left open; lines and letters are readable on white and on black.
std::string draw_plots(const std::vector<Plot>& plots, int columns);

}  // namespace pantin::player
