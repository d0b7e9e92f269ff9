#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "base/lanes.hpp"
#include "shapes/shape.hpp"

namespace pantin {

/// What a file of a picture holds. The engine does not look into it.
struct Picture {
  std::string file;                     ///< as the script called it
  std::string content;                  ///< PNG or JPEG
  std::uint32_t columns = 0, rows = 0;  ///< [pixels]
};

/// How a picture lies on a shape, or stands for a thing as its sprite.
struct Cover {
  std::shared_ptr<const Picture> picture;
  double width = 0.0;                  ///< [m] of the picture, which is repeated; 0: once over the box
  Vec3 low = zero3(), high = zero3();  ///< [m] the box that it lies over, in the shape's axes
};

/// Whether it lies over a shape's own box, to rounding; else it lies over that of a whole of which the shape is a piece.
bool is_over_own_box(const Cover& cover, const Geometry& shape);

}  // namespace pantin
