#pragma once
// Worlds for the tests of the view, built without a scene.
#include <vector>

#include "edit/edit.hpp"

namespace pantin::small_worlds {

inline PointDef anchor(Vec3 at) {
  PointDef def;
  def.at = at;
  return def;
}

inline ShapeDef shape(Geometry geometry, Vec3 at = zero3()) {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.at = at;
  return def;
}

inline ParticleId particle(World& world, Vec3 at) {
  ParticleDef def;
  def.at = at;
  return add_particle(world, def);
}

/// n rods of length `size` [m] in a row from (0, 4 size, 0) along x, the first nailed.
inline std::vector<BodyId> chain(World& world, int n, double size = 1.0) {
  std::vector<BodyId> rods;
  for (int i = 0; i < n; i++) {
    BodyDef def;
    def.mass = 1.0;
    def.inertia = diagonal(vec(0.0017, 0.0842, 0.0842) * (size * size));
    def.at = vec((i + 0.5) * size, 4.0 * size, 0);
    def.points = {anchor(vec(-0.5 * size, 0, 0)), anchor(vec(0.5 * size, 0, 0))};
    rods.push_back(add_body(world, def));
    const PointId head = world.bodies[rods.back()].points[0];
    if (i == 0) {
      add_nail(world, head);
    } else {
      const PointId ring[2] = {world.bodies[rods[rods.size() - 2]].points[1], head};
      add_hinge(world, ring);
    }
  }
  return rods;
}

/// A top that stands on (0, 0, 0), nailed there.
inline BodyId top(World& world) {
  BodyDef def;
  def.mass = 1.0;
  def.inertia = diagonal(vec(0.05, 0.08, 0.05));
  def.at = vec(0, 0.5, 0);
  def.points = {anchor(vec(0, -0.5, 0)), anchor(vec(0, 0.4, 0))};
  const BodyId body = add_body(world, def);
  add_nail(world, world.bodies[body].points[0]);
  return body;
}

}  // namespace pantin::small_worlds
