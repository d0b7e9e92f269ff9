#include "player/mesh.hpp"

#include <cmath>
#include <numbers>

namespace pantin::player {
namespace {

constexpr std::uint32_t meridians = 16, parallels = 8;

void put_vertex(std::vector<float>& list, Vec3 v) {
  for (int i = 0; i < 3; i++) list.push_back(static_cast<float>(v[i]));
}

std::uint32_t vertices(const Mesh::Patch& patch) { return static_cast<std::uint32_t>(patch.positions.size() / 3); }

void put_triangle(Mesh::Patch& patch, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  for (const std::uint32_t i : {a, b, c}) patch.indices.push_back(i);
}

/// A sphere of radius 1 about the third axis, cut at its equator, where it may be stretched: `place(direction, side)` is where
/// a vertex goes, side 1 for the upper half and -1 for the lower, and `normal(direction)` its normal.
template <class PlaceOf, class NormalOf>
void add_round(Mesh::Patch& patch, bool stretched, PlaceOf place, NormalOf normal) {
  const std::uint32_t first = vertices(patch), wide = meridians + 1;
  const auto row = [&](std::uint32_t k, double side) {
    const double latitude = std::numbers::pi * (0.5 - static_cast<double>(k) / parallels);
    for (std::uint32_t i = 0; i <= meridians; i++) {
      const double angle = 2.0 * std::numbers::pi * i / meridians;
      const Vec3 d =
          vec(std::cos(latitude) * std::cos(angle), std::cos(latitude) * std::sin(angle), std::sin(latitude));
      put_vertex(patch.positions, place(d, side));
      put_vertex(patch.normals, direction(normal(d)));
    }
  };
  for (std::uint32_t k = 0; k <= parallels / 2; k++) row(k, 1.0);
  for (std::uint32_t k = parallels / 2; k <= parallels; k++) row(k, -1.0);
  for (std::uint32_t k = 0; k <= parallels; k++)
    for (std::uint32_t i = 0; i < meridians; i++) {
      const std::uint32_t a = first + k * wide + i, below = a + wide;
      if (k == parallels / 2 && !stretched) continue;
      if (k > 0) put_triangle(patch, a, below, a + 1);
      if (k < parallels) put_triangle(patch, a + 1, below, below + 1);
    }
}

/// A capsule; a ball where both ends are one.
void add_capsule(Mesh::Patch& patch, Vec3 from, Vec3 to, double radius) {
  const Vec3 middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const Vec3 z = norm(half) > 0.0 ? direction(half) : vec(0, 0, 1);
  const Vec3 x = direction(cross(std::fabs(z[0]) < 0.7 ? vec(1, 0, 0) : vec(0, 1, 0), z)), y = cross(z, x);
  const auto turned = [&](Vec3 d) { return x * d[0] + y * d[1] + z * d[2]; };
  add_round(
      patch, norm(half) > 0.0, [&](Vec3 d, double side) { return middle + half * side + turned(d) * radius; }, turned);
}

void add_ellipsoid(Mesh::Patch& patch, const Figure::Ellipsoid& ellipsoid) {
  const Mat3& a = ellipsoid.axes;
  const double sign = dot(cross(a[0], a[1]), a[2]) < 0.0 ? -1.0 : 1.0;
  add_round(
      patch, false, [&](Vec3 d, double) { return ellipsoid.at + a * vec(d[0], d[1], sign * d[2]); },
      [&](Vec3 d) { return (cross(a[1], a[2]) * d[0] + cross(a[2], a[0]) * d[1]) * sign + cross(a[0], a[1]) * d[2]; });
}

void put_corner(Mesh::Patch& patch, Vec3 at, Vec3 normal) {
  patch.indices.push_back(vertices(patch));
  put_vertex(patch.positions, at);
  put_vertex(patch.normals, normal);
}

/// Its rows of vertices are circles about its second axis, each from the back to the back.
void add_globe(Mesh::Patch& patch, const Figure::Globe& globe) {
  const Mat3& a = globe.shape.axes;
  const std::size_t first = patch.positions.size() / 3;
  add_ellipsoid(patch, {globe.shape.at, {{-a[2], -a[0], a[1]}}, globe.shape.color});
  for (std::size_t i = first; i < patch.positions.size() / 3; i++) {
    const std::size_t row = (i - first) / (meridians + 1), k = row > parallels / 2 ? row - 1 : row;
    patch.places.push_back(globe.around * static_cast<float>((i - first) % (meridians + 1)) / meridians);
    patch.places.push_back(globe.down * static_cast<float>(k) / parallels);
  }
}

}  // namespace

Mesh::Patch& Mesh::patch(const Color& color, const std::shared_ptr<const Picture>& picture) {
  for (Patch& p : patches)
    if (p.color == color && p.picture == picture) return p;
  patches.push_back({color, picture, {}, {}, {}, {}});
  return patches.back();
}

Mesh body_mesh(const Figure& figure) {
  Mesh mesh;
  for (const Figure::Bar& bar : figure.bars) add_capsule(mesh.patch(bar.color), bar.from, bar.to, bar.radius);
  for (const Figure::Ball& ball : figure.balls) add_capsule(mesh.patch(ball.color), ball.at, ball.at, ball.radius);
  for (const Figure::Ellipsoid& ellipsoid : figure.ellipsoids) add_ellipsoid(mesh.patch(ellipsoid.color), ellipsoid);
  for (const Figure::Corner& corner : figure.corners) put_corner(mesh.patch(corner.color), corner.at, corner.normal);
  for (const Figure::Sheet& sheet : figure.sheets) {
    for (const Figure::PictureCorner& corner : sheet.corners) {
      Mesh::Patch& patch = mesh.patch(corner.color, sheet.picture);
      put_corner(patch, corner.at, corner.normal);
      patch.places.insert(patch.places.end(), {corner.u, corner.v});
    }
    for (const Figure::Globe& globe : sheet.globes) add_globe(mesh.patch(globe.shape.color, sheet.picture), globe);
  }
  return mesh;
}

Mesh floor_mesh(const Color& color) {
  Mesh mesh;
  Mesh::Patch& patch = mesh.patch(color);
  for (const Vec3 corner : {vec(-0.5, -0.5, 0), vec(0.5, -0.5, 0), vec(0.5, 0.5, 0), vec(-0.5, 0.5, 0)}) {
    put_vertex(patch.positions, corner);
    put_vertex(patch.normals, vec(0, 0, 1));
  }
  put_triangle(patch, 0, 1, 2);
  put_triangle(patch, 0, 2, 3);
  return mesh;
}

Mesh ball_mesh(const Color& color) {
  Mesh mesh;
  add_capsule(mesh.patch(color), zero3(), zero3(), 1.0);
  return mesh;
}

Mesh tube_mesh(const Color& color) {
  Mesh mesh;
  Mesh::Patch& patch = mesh.patch(color);
  for (const double end : {0.5, -0.5})
    for (std::uint32_t i = 0; i <= meridians; i++) {
      const double angle = 2.0 * std::numbers::pi * i / meridians;
      const Vec3 d = vec(std::cos(angle), std::sin(angle), 0.0);
      put_vertex(patch.positions, d + vec(0, 0, end));
      put_vertex(patch.normals, d);
    }
  for (std::uint32_t i = 0; i < meridians; i++) {
    put_triangle(patch, i, i + meridians + 1, i + 1);
    put_triangle(patch, i + 1, i + meridians + 1, i + meridians + 2);
  }
  return mesh;
}

}  // namespace pantin::player
