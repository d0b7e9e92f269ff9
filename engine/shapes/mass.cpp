#include "shapes/mass.hpp"

#include <numbers>

#include "base/check.hpp"
#include "shapes/hull.hpp"

namespace pantin {

namespace {

constexpr double pi = std::numbers::pi;

/// Of moments about the axes through the centre, at the origin.
SolidMass about_origin(double volume, double across, double along) {
  return {volume, zero3(), diagonal(vec(across, across, along))};
}

/// Sums over the tetrahedra from a point to triangles of the faces.
struct Sums {
  double volume = 0.0;     ///< [m³]
  Vec3 first = zero3();    ///< [m⁴] integral of x
  Mat3 second = zero33();  ///< [m⁵] integral of x x'

  void add(Vec3 a, Vec3 b, Vec3 c) {
    const double v = dot(a, cross(b, c)) / 6.0;
    const Vec3 sum = a + b + c;
    volume += v;
    first += sum * (v / 4.0);
    second += (outer(a, a) + outer(b, b) + outer(c, c) + outer(sum, sum)) * (v / 20.0);
  }
};

Mat3 inertia_of(const Mat3& second) { return diagonal(vec(1, 1, 1) * trace(second)) - second; }

struct SolidMassOf {
  SolidMass operator()(const BallShape& ball) const {
    const double rr = ball.radius * ball.radius, volume = 4.0 / 3.0 * pi * rr * ball.radius;
    return about_origin(volume, 0.4 * volume * rr, 0.4 * volume * rr);
  }
  SolidMass operator()(const BoxShape& box) const {
    const double x = box.half[0], y = box.half[1], z = box.half[2], volume = 8.0 * x * y * z;
    return {volume, zero3(), diagonal(vec(y * y + z * z, z * z + x * x, x * x + y * y) * (volume / 3.0))};
  }
  SolidMass operator()(const CapsuleShape& capsule) const {
    const double r = capsule.radius, h = capsule.half, rr = r * r;
    const double side = 2.0 * pi * rr * h, ends = 4.0 / 3.0 * pi * rr * r;
    const double along = side * rr / 2.0 + ends * 0.4 * rr;
    const double across = side * (rr / 4.0 + h * h / 3.0) + ends * (0.4 * rr + h * h + 0.75 * h * r);
    return about_origin(side + ends, across, along);
  }
  SolidMass operator()(const CylinderShape& cylinder) const {
    const double rr = cylinder.radius * cylinder.radius, hh = cylinder.half * cylinder.half;
    const double volume = 2.0 * pi * rr * cylinder.half;
    return about_origin(volume, volume * (rr / 4.0 + hh / 3.0), volume * rr / 2.0);
  }
  SolidMass operator()(const std::shared_ptr<const Hull>& hull) const {
    const std::vector<Vec3>& vertices = hull->vertices;
    Vec3 origin = zero3();
    for (const Vec3 v : vertices) origin += v / static_cast<double>(vertices.size());
    Sums sums;
    for (const Hull::Face& face : hull->faces) {
      const auto corner = [&](std::uint32_t i) { return vertices[hull->loops[face.first + i]] - origin; };
      for (std::uint32_t i = 1; i + 1 < face.count; i++) sums.add(corner(0), corner(i), corner(i + 1));
    }
    const Vec3 centre = sums.first / sums.volume;
    return {sums.volume, origin + centre, inertia_of(sums.second - outer(centre, centre) * sums.volume)};
  }
  SolidMass operator()(const HalfSpaceShape&) const { none(); }
  SolidMass operator()(const std::shared_ptr<const TriangleMesh>&) const { none(); }
  SolidMass operator()(const std::shared_ptr<const HeightField>&) const { none(); }

  [[noreturn]] static void none() { refuse("Half spaces, meshes and height fields have no mass: they do not move."); }
};

}  // namespace

SolidMass solid_mass(const Geometry& convex) { return std::visit(SolidMassOf{}, convex); }

}  // namespace pantin
