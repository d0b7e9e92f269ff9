#pragma once
#include <string>
#include <vector>

namespace pantin::player {

struct HeatValue {
  double x, y, value;
};

/// Places with a colour each, with a scale of colours beside them.
struct HeatMap {
  std::string title, x_name, y_name, value_name;
  std::vector<HeatValue> values;  ///< one for each pair of x and y; NaN where it is not known
  bool logarithmic_x = false, logarithmic_y = false, logarithmic_value = false;  ///< then above 0
};

/// As SVG; each tile ends midway to the next, and where values are no grid each place has the colour of the nearest. One
/// that is not known is hatched. There must be one that is.
std::string draw_heat_map(const HeatMap& map);

}  // namespace pantin::player
