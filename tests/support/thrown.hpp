#pragma once
// Bodies that fly and spin, and what edits of them are held against.
#include <algorithm>
#include <array>
#include <cmath>

#include "contacts/find.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "shapes/distance.hpp"

namespace pantin {

inline ShapeDef thrown_shape(Geometry geometry, Vec3 at = zero3(), double density = 1000.0) {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.at = at;
  def.material.density = density;
  return def;
}

inline BoxShape box(double x, double y, double z) { return {vec(x, y, z) * 0.5}; }

inline PointDef point(Vec3 at, double mass = 0.0) {
  PointDef def;
  def.at = at;
  def.mass = mass;
  return def;
}

/// A body that flies and spins.
inline BodyDef thrown(std::vector<ShapeDef> shapes) {
  BodyDef def;
  def.shapes = std::move(shapes);
  def.at = vec(1, 2, 3);
  def.orientation = normalised({0.8, 0.2, -0.3, 0.4});
  def.velocity = vec(1, -2, 0.5);
  def.spin = vec(3, -1, 2);
  return def;
}

struct Weightless : World {
  Weightless() { settings.gravity = zero3(); }
};

/// m/12 (b² + c²) about each axis.
inline Vec3 box_moments(double mass, double x, double y, double z) {
  return vec(y * y + z * z, z * z + x * x, x * x + y * y) * (mass / 12.0);
}

inline Vec3 sorted(Vec3 v) {
  std::array<double, 3> all = {v[0], v[1], v[2]};
  std::sort(all.begin(), all.end());
  return vec(all[0], all[1], all[2]);
}

inline double kinetic(const World& world) { return energy(world).kinetic; }

/// Deepest overlap of any two shapes of different bodies [m].
inline double overlap_of(const World& world) {
  const std::vector<ShapeId> ids = world.shapes.ids();
  double deepest = 0.0;
  for (std::size_t i = 0; i < ids.size(); i++)
    for (std::size_t j = 0; j < i; j++) {
      const Shape &a = world.shapes[ids[i]], &b = world.shapes[ids[j]];
      deepest =
          std::fmax(deepest, -separation(a.geometry, pose_of(world, a), b.geometry, pose_of(world, b), 1.0).distance);
    }
  return deepest;
}

}  // namespace pantin
