#pragma once
#include <cstdint>
#include <vector>

#include "view/overlay.hpp"
#include "view/viewport.hpp"

namespace pantin {

/// Arrows at the picture's edge that point to what left it, with its number where it is more than one thing. None where all is
/// seen, where more than a few things are out, as when somebody looks at a part, and in a periodic box. What is joined by hinges
/// and rods is one thing, and seen where a part of it is.
class EdgeArrows {
 public:
  void mark(const Viewport& viewport, std::vector<Mark>& marks);

 private:
  enum class Found : std::uint8_t { nothing, out, seen };
  struct Out {
    std::int32_t articulate;  ///< or -1
    Vec3 place;               ///< [m]
  };
  void add(const Viewport& viewport, std::int32_t articulate, Vec3 place);

  // Kept so that nothing is allocated for the next frame.
  std::vector<Found> of_articulates_;
  std::vector<Out> out_;
};

}  // namespace pantin
