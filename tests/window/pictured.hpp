#pragma once
// Pictures made for tests, and covers of them.
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/color.hpp"
#include "model/cover.hpp"
#include "shapes/shape.hpp"
#include "support/process.hpp"
#include "view/picture.hpp"

namespace pantin::pictured {

inline constexpr Color red = {1, 0, 0, 1}, green = {0, 1, 0, 1}, blue = {0, 0, 1, 1}, yellow = {1, 1, 0, 1},
                       clear = {0, 0, 0, 0};

/// `color(x, y)` of parts from the upper left.
inline std::shared_ptr<const Picture> picture(int columns, int rows,
                                              const std::function<Color(double, double)>& color) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < rows; y++)
    for (int x = 0; x < columns; x++) {
      const Color c = color((x + 0.5) / columns, (y + 0.5) / rows);
      for (const float part : {c.r, c.g, c.b, c.a}) pixels.push_back(static_cast<std::uint8_t>(255.0f * part));
    }
  const support::Folder folder;
  write_png(folder / "a.png", pixels, columns, rows);
  return std::make_shared<const Picture>(Picture{"a.png", support::read_file(folder / "a.png"),
                                                 static_cast<std::uint32_t>(columns),
                                                 static_cast<std::uint32_t>(rows)});
}

/// Red and green above, blue and yellow below.
inline std::shared_ptr<const Picture> quarters() {
  return picture(64, 64, [](double x, double y) { return y < 0.5 ? x < 0.5 ? red : green : x < 0.5 ? blue : yellow; });
}

inline std::shared_ptr<const Cover> cover(std::shared_ptr<const Picture> picture, const Geometry& on,
                                          double width = 0.0) {
  const Bounds box = bounds_of(on, {});
  return std::make_shared<const Cover>(Cover{std::move(picture), width, box.low, box.high});
}

}  // namespace pantin::pictured
