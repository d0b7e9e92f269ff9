#pragma once
// Convex polyhedra, by qhull.
#include <array>
#include <span>

#include "shapes/shape.hpp"

namespace pantin {

/// About its own axes; every face flat within round-off (coplanar triangles are one), its loop anticlockwise from outside.
struct Hull {
  struct Face {
    Vec3 normal;                 ///< outwards, of unit length
    double offset;               ///< [m] of its plane: normal x = offset
    std::uint32_t first, count;  ///< of `loops`: its corners
  };
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Face> faces;
  std::vector<std::uint32_t> loops;                      ///< indices of vertices
  std::vector<std::array<std::uint32_t, 2>> edges;       ///< vertices, each edge once
  std::vector<std::array<std::uint32_t, 2>> edge_faces;  ///< (edges) the two faces that meet there
  double reach = 0.0, thickness = 0.0;                   ///< [m] thickness: the least width across a face
  Vec3 inner_centre = zero3();                           ///< [m] of a ball inside, nearly the largest,
  double inner_radius = 0.0;                             ///< [m] and its radius
  std::vector<Vec3> packs;  ///< [m] (3 per four vertices, the last repeated) their x, their y, their z
};

/// Index of the vertex farthest along a direction; the first of several as far.
std::uint32_t farthest(const Hull& hull, Vec3 direction);

/// The hull of some points [m]. Throws Error("… points …") where there are fewer than four, one is not finite, or they lie
/// in a plane as good as: the volume is below 1e-12 of the cube of their extent.
std::shared_ptr<const Hull> make_hull(std::span<const Vec3> points);

/// The same hull, displaced in its own axes [m].
std::shared_ptr<const Hull> moved(const Hull& hull, Vec3 by);

/// A flat one of a triangle, its front the first face; what it had before goes, its storage stays.
void set_triangle(Hull& hull, const std::array<Vec3, 3>& corner, Vec3 normal);

}  // namespace pantin
