#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "view/figure.hpp"

namespace pantin::player {

/// Triangles, for programs that show them.
struct Mesh {
  /// Of one colour, times a picture where there is one; `positions` [m] and `normals` are three numbers a vertex, `places`
  /// two, on the picture, `indices` three a triangle, counter-clockwise from outside.
  struct Patch {
    Color color;
    std::shared_ptr<const Picture> picture;  ///< null: none, and no places
    std::vector<float> positions, normals, places;
    std::vector<std::uint32_t> indices;
  };
  std::vector<Patch> patches;

  Patch& patch(const Color& color, const std::shared_ptr<const Picture>& picture = nullptr);
};

/// In the body's frame, [m].
Mesh body_mesh(const Figure& figure);
/// A square of edge 1 across the third axis.
Mesh floor_mesh(const Color& color);
/// A ball of radius 1.
Mesh ball_mesh(const Color& color);
/// A tube of radius 1 from (0, 0, -1/2) to (0, 0, 1/2), with open ends.
Mesh tube_mesh(const Color& color);

}  // namespace pantin::player
