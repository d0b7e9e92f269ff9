#pragma once
// What does not move and need not be convex: triangles, and heights over a grid.
#include <array>
#include <functional>
#include <span>

#include "shapes/shape.hpp"

namespace pantin {

/// Triangles with a tree of bounds over them. The front of a triangle is where its corners run anticlockwise; an edge that
/// two triangles share is known, so that what slides over it is not caught there.
struct TriangleMesh {
  struct Triangle {
    std::array<std::uint32_t, 3> corner;
    Vec3 normal;                            ///< of unit length
    std::array<std::int32_t, 3> neighbour;  ///< over the edge from corner i to i + 1, or -1
    std::array<bool, 3> convex;             ///< that edge is a ridge (or a rim): things may touch it from its sides
  };
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Triangle> triangles;
  struct Branch {
    Bounds bounds;
    std::uint32_t first,
        count;  ///< of `order` where it is a leaf (count > 0); else `first` and `first + 1` are its branches
  };
  std::vector<Branch> tree;  ///< the first is the root
  std::vector<std::uint32_t> order;
  Bounds bounds;
};

/// Heights y over points of a grid in x and z; solid below. Each cell has two triangles: 2 (row (columns - 1) + column) is at
/// its corner of low x and high z, the next at that of high x and low z.
struct HeightField {
  std::uint32_t columns = 0, rows = 0;  ///< points along x and z, each >= 2
  double spacing = 1.0;                 ///< [m] between neighbours, centred on the origin
  std::vector<double> heights;          ///< [m] (rows columns) row by row
  double lowest = 0.0, highest = 0.0;   ///< [m]
};

/// Throws Error where there is no triangle, an index is out of range, a vertex is not within 1e12 m, or all triangles have
/// no area; those without area are left out. Holes are no error. Corners at the same place count as one.
std::shared_ptr<const TriangleMesh> make_mesh(std::vector<Vec3> vertices,
                                              std::span<const std::array<std::uint32_t, 3>> faces);
/// Throws Error where there are fewer than 2 x 2 heights, their number is not rows x columns, or one is not within 1e12 m.
std::shared_ptr<const HeightField> make_height_field(std::uint32_t columns, std::uint32_t rows, double spacing,
                                                     std::vector<double> heights);

/// A triangle with what is known of its edges.
struct MeshTriangle {
  std::array<Vec3, 3> corner;
  Vec3 normal;
  std::array<Vec3, 3> over;  ///< normals of the triangles over its edges; its own where there is none
  std::array<bool, 3> convex;
  std::uint32_t index;
};
MeshTriangle triangle_of(const TriangleMesh& mesh, std::uint32_t index);
MeshTriangle triangle_of(const HeightField& field, std::uint32_t index);
/// Calls use(triangle) for each whose bounds meet the box, in the shape's own axes and rising index.
void triangles_in(const TriangleMesh& mesh, const Bounds& box, const std::function<void(const MeshTriangle&)>& use);
void triangles_in(const HeightField& field, const Bounds& box, const std::function<void(const MeshTriangle&)>& use);

}  // namespace pantin
