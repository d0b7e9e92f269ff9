#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "base/lanes.hpp"

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
  Vec3 low = zero3(), high = zero3();  ///< [m] the box of the shape, in its axes
};

}  // namespace pantin
