#pragma once
// Parts of pictures as SVG: lines and letters that are readable on white and on black, and scales.
#include <string>
#include <utility>
#include <vector>

namespace pantin::player {

inline constexpr const char* svg_ink = "#7d8590";

/// A coordinate in pixels, to a hundredth.
std::string svg_number(double pixels);
std::string svg_escaped(const std::string& words);
std::string svg_begin(double width, double height);  ///< [pixels]; end with "</svg>\n"
void svg_line(std::string& svg, double x0, double y0, double x1, double y1, const std::string& style);
void svg_words(std::string& svg, double x, double y, const std::string& style, const std::string& words);

/// One axis: round numbers about all values, over a stretch of pixels.
class Scale {
 public:
  /// Of a logarithmic one all values are above 0; without values it goes from 0, or 1, up.
  Scale(const std::vector<double>& values, bool logarithmic, double start, double end);
  /// From one value to another and no farther.
  static Scale between(double low, double high, bool logarithmic, double start, double end);

  double place(double value) const;  ///< [pixels]
  double start() const { return start_; }
  double end() const { return end_; }
  struct Tick {
    double value;
    std::string label;  ///< empty where labels would be too dense
  };
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void set_decades(double low, double high);
  void set_steps(double low, double high);

  bool logarithmic_;
  double low_ = 0.0, high_ = 1.0;  ///< their logarithms where it is logarithmic
  double start_, end_;
  std::vector<Tick> ticks_;
};

struct AxisNames {
  std::string title, x, y;
};
/// Grid, labels and names.
void draw_axes(std::string& svg, const AxisNames& names, const Scale& x, const Scale& y);

}  // namespace pantin::player
