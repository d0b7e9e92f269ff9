// Shapes that touch, as they are drawn.
#include <bit>
#include <cmath>
#include <numbers>

#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"
#include "view/figure.hpp"
#include "view/figure_pictures.hpp"

namespace pantin {

namespace {

constexpr int cylinder_sides = 32;  // of a cylinder

struct ShapePen {
  Figure& figure;
  const Shape& shape;
  Pose pose{shape.at, matrix(shape.orientation)};

  void corner(Vec3 at, Vec3 normal) { figure.corners.push_back({pose.to_world(at), pose.R * normal, shape.color}); }
  void triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
    for (const Vec3 v : {a, b, c}) corner(v, normal);
  }
  void triangle(Vec3 a, Vec3 b, Vec3 c) { triangle(a, b, c, direction(cross(b - a, c - a))); }

  void operator()(const BallShape& ball) { figure.ellipsoids.push_back({shape.at, pose.R * ball.radius, shape.color}); }
  void operator()(const BoxShape& box) {
    for (int axis = 0; axis < 3; axis++)
      for (const double side : {-1.0, 1.0}) {
        Vec3 normal = zero3(), u = zero3(), v = zero3();
        normal[axis] = side;
        u[(axis + 1) % 3] = side * box.half[(axis + 1) % 3];
        v[(axis + 2) % 3] = box.half[(axis + 2) % 3];
        const Vec3 middle = normal * box.half[axis];
        triangle(middle - u - v, middle + u - v, middle + u + v, normal);
        triangle(middle - u - v, middle + u + v, middle - u + v, normal);
      }
  }
  void operator()(const CapsuleShape& capsule) {
    const Vec3 half = pose.R[2] * capsule.half;
    figure.bars.push_back({shape.at - half, shape.at + half, capsule.radius, shape.color});
  }
  void operator()(const CylinderShape& cylinder) {
    const Vec3 top = vec(0, 0, cylinder.half);
    for (int i = 0; i < cylinder_sides; i++) {
      const double a = 2.0 * std::numbers::pi * i / cylinder_sides,
                   b = 2.0 * std::numbers::pi * (i + 1) / cylinder_sides;
      const Vec3 na = vec(std::cos(a), std::sin(a), 0), nb = vec(std::cos(b), std::sin(b), 0);
      const Vec3 pa = na * cylinder.radius, pb = nb * cylinder.radius;
      triangle(top, pa + top, pb + top, vec(0, 0, 1));
      triangle(-top, pb - top, pa - top, vec(0, 0, -1));
      corner(pa - top, na), corner(pb - top, nb), corner(pb + top, nb);
      corner(pa - top, na), corner(pb + top, nb), corner(pa + top, na);
    }
  }
  void operator()(const std::shared_ptr<const Hull>& hull) {
    for (const Hull::Face& face : hull->faces)
      for (std::uint32_t i = 2; i < face.count; i++) {
        const auto at = [&](std::uint32_t k) { return hull->vertices[hull->loops[face.first + k]]; };
        triangle(at(0), at(i - 1), at(i), face.normal);
      }
  }
  void operator()(const HalfSpaceShape&) {}
  void operator()(const std::shared_ptr<const TriangleMesh>& mesh) {
    for (const TriangleMesh::Triangle& t : mesh->triangles)
      triangle(mesh->vertices[t.corner[0]], mesh->vertices[t.corner[1]], mesh->vertices[t.corner[2]], t.normal);
  }
  /// Shaded as round: each place with the slope between its neighbours.
  void operator()(const std::shared_ptr<const HeightField>& field) {
    const auto columns = static_cast<int>(field->columns), rows = static_cast<int>(field->rows);
    const auto height = [&](int column, int row) {
      const int c = std::clamp(column, 0, columns - 1), r = std::clamp(row, 0, rows - 1);
      return field->heights[static_cast<std::size_t>(r) * field->columns + static_cast<std::size_t>(c)];
    };
    const auto put = [&](int column, int row) {
      const double x = (column - 0.5 * (columns - 1)) * field->spacing, z = (row - 0.5 * (rows - 1)) * field->spacing;
      const double over_x = field->spacing * (std::min(column + 1, columns - 1) - std::max(column - 1, 0)),
                   over_z = field->spacing * (std::min(row + 1, rows - 1) - std::max(row - 1, 0));
      corner(vec(x, height(column, row), z),
             direction(vec((height(column - 1, row) - height(column + 1, row)) / over_x, 1,
                           (height(column, row - 1) - height(column, row + 1)) / over_z)));
    };
    for (int row = 0; row + 1 < rows; row++)
      for (int column = 0; column + 1 < columns; column++) {
        put(column, row), put(column, row + 1), put(column + 1, row);
        put(column + 1, row), put(column, row + 1), put(column + 1, row + 1);
      }
  }
};

struct ShapeSizes {
  Hash& hash;

  void operator()(const BallShape& ball) { hash.add(ball.radius); }
  void operator()(const BoxShape& box) { hash.add(box.half); }
  void operator()(const CapsuleShape& capsule) {
    hash.add(capsule.radius);
    hash.add(capsule.half);
  }
  void operator()(const CylinderShape& cylinder) {
    hash.add(cylinder.radius);
    hash.add(cylinder.half);
  }
  void operator()(const HalfSpaceShape&) {}
  template <class Shared>
  void operator()(const std::shared_ptr<const Shared>& shared) {
    hash.add(std::uint64_t{reinterpret_cast<std::uintptr_t>(shared.get())});
  }
};

}  // namespace

void add_shape(Figure& figure, const Shape& shape) {
  if (!shape.cover) return std::visit(ShapePen{figure, shape}, shape.geometry);
  Figure bare;
  std::visit(ShapePen{bare, shape}, shape.geometry);
  add_covered(figure, shape, bare);
}

void add_to(Hash& hash, const Shape& shape) {
  hash.add(std::uint64_t{shape.geometry.index()});
  std::visit(ShapeSizes{hash}, shape.geometry);
  hash.add(shape.at);
  for (const double part : {shape.orientation.w, shape.orientation.x, shape.orientation.y, shape.orientation.z})
    hash.add(part);
  for (const float c : {shape.color.r, shape.color.g, shape.color.b, shape.color.a})
    hash.add(std::uint64_t{std::bit_cast<std::uint32_t>(c)});
  if (!shape.cover) return;
  hash.add(std::uint64_t{reinterpret_cast<std::uintptr_t>(shape.cover->picture.get())});
  hash.add(shape.cover->width);
  hash.add(shape.cover->low);
  hash.add(shape.cover->high);
}

}  // namespace pantin
