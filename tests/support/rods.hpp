#pragma once
// Rods of two masses, and two of them on a hinge: the smallest scenes for edits.
#include <string>
#include <vector>

#include "edit/edit.hpp"

namespace pantin::test {

/// A rod of two masses along x with its left end at `left`.
inline BodyDef rod_at(Vec3 left, std::string name = "") {
  BodyDef def;
  def.at = left;
  def.name = std::move(name);
  def.points.resize(2);
  def.points[0].mass = def.points[1].mass = 1;
  def.points[1].at = vec(1, 0, 0);
  return def;
}

inline PointId left_of(const World& world, BodyId b) { return world.bodies[b].points[0]; }
inline PointId right_of(const World& world, BodyId b) { return world.bodies[b].points[1]; }
inline PointId point_of(const World& world, ParticleId p) { return world.particles[p].points[0]; }

inline ParticleId join(World& world, std::vector<PointId> points, const HingeDef& def = {}) {
  return add_hinge(world, points, def);
}

/// Two rods in a line, hinged in the middle.
struct Two {
  World world;
  BodyId a = add_body(world, rod_at(vec(0, 0, 0), "a")), b = add_body(world, rod_at(vec(1, 0, 0), "b"));
  ParticleId hinge = join(world, {right_of(world, a), left_of(world, b)});
};

}  // namespace pantin::test
