#pragma once
#include <string>
#include <utility>
#include <vector>

namespace pantin::player {

/// Points joined in their order. Those that are not finite and positive are left out.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

/// Two logarithmic axes and the series between them.
struct Plot {
  std::string title, x_name, y_name;
  std::vector<Series> series;
};

/// An SVG picture of the plots, `columns` in a row, with one legend for all: a name has the same colour in each. The
/// background is left open; lines and letters are readable on white and on black.
std::string draw_plots(const std::vector<Plot>& plots, int columns);

}  // namespace pantin::player
