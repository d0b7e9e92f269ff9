#pragma once
#include <string>
#include <utility>
#include <vector>

namespace pantin::player {

/// Points in their order. Those that are not finite, or on a logarithmic axis not positive, are left out.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
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
};

/// An SVG picture of the plots, `columns` in a row, with one legend for all: a name has the same colour in each. The
/// background is left open; lines and letters are readable on white and on black.
std::string draw_plots(const std::vector<Plot>& plots, int columns);

}  // namespace pantin::player
