#include <algorithm>

#include "edit/common.hpp"
#include "edit/edit.hpp"

namespace pantin {

using namespace internal;

namespace {

ParticleId hinge_to_cut(const World& world, ParticleId particle) {
  require_unlocked(world, "cut");
  const ParticleId hinge = awake(world, particle);
  require(world.particles[hinge].is_hinge(), "cut: ", describe(world, hinge), " is no hinge");
  return hinge;
}

}  // namespace

void cut(World& world, ParticleId particle) {
  const ParticleId hinge = hinge_to_cut(world, particle);
  end_ring(world, hinge, culprit(world));
  notice(world, Notice::Kind::cut, hinge, world.particles.story(hinge));
}

void cut(World& world, ParticleId particle, BodyId body) {
  const ParticleId hinge = hinge_to_cut(world, particle);
  const std::string name = describe(world, body), from = describe(world, hinge);
  require(world.bodies.alive(body), "cut: ", name);
  const auto& points = world.particles[hinge].points;
  const auto member =
      std::find_if(points.begin(), points.end(), [&](PointId p) { return world.points[p].body == body; });
  require(member != points.end(), "cut: ", name, " is not in ", from);
  leave_ring(world, *member, culprit(world));
  const std::string story = world.particles.alive(hinge)
                                ? text(name, " was cut out of ", from, " at ", world.time, " s by ", culprit(world))
                                : world.particles.story(hinge);
  notice(world, Notice::Kind::cut, hinge, story);
}

}  // namespace pantin
