#pragma once
#include <string>

namespace pantin::player {

/// Colours for numbers, and the bar that tells which is which.
class ColorBar {
 public:
  static constexpr double width = 108;  ///< [pixels] with its labels and name

  /// Of a logarithmic one both are above 0.
  ColorBar(std::string name, double least, double largest, bool logarithmic)
      : name_(std::move(name)), least_(least), largest_(largest), logarithmic_(logarithmic) {}

  std::string color_of(double value) const;
  void draw(std::string& svg, double x, double top, double low) const;  ///< [pixels]

 private:
  double part_of(double value) const;

  std::string name_;
  double least_, largest_;
  bool logarithmic_;
};

void draw_tile(std::string& svg, double x0, double y0, double x1, double y1, const std::string& color);

}  // namespace pantin::player
