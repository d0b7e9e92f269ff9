#pragma once
#include <memory>

#include "edit/edit.hpp"
#include "laws/library.hpp"

namespace pantin::cases {

/// Two particles of ½ kg about their common centre at the origin, tied by gravitation of constant 1, in the plane z = 0:
/// on the x axis, `apart` [m] from each other, with a relative velocity [m/s] along y. No gravity otherwise.
struct KeplerPair {
  ParticleId a, b;
};
inline KeplerPair add_kepler_pair(World& world, double apart, double velocity) {
  world.settings.gravity = zero3();
  ParticleDef def;
  def.mass = 0.5;
  def.at = vec(0.5 * apart, 0, 0);
  def.velocity = vec(0, 0.5 * velocity, 0);
  const ParticleId a = add_particle(world, def);
  def.at = -def.at;
  def.velocity = -def.velocity;
  const ParticleId b = add_particle(world, def);
  LawArguments arguments;
  arguments.numbers = {{"constant", 1.0}};
  ConnectionDef tie;
  tie.ends = {{a, zero3()}, {b, zero3()}};
  add_connection(world, std::make_shared<const Law>(make_library_law("gravitation", arguments).front()), tie);
  return {a, b};
}

}  // namespace pantin::cases
