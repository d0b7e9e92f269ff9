#include <algorithm>
#include <unordered_set>

#include "constraints/kind.hpp"
#include "measure/freedoms.hpp"

namespace pantin {
namespace {

/// Counts what the things can do: their own freedoms, less what ties among them take.
struct Freedoms {
  const World& world;
  std::unordered_set<BodyId> bodies;
  std::unordered_set<PointId> points;
  std::unordered_set<ParticleId> rings;
  std::unordered_set<ConstraintId> constraints;
  long count = 0;
  FreedomCount common = {};

  void hold(Vec3 direction) {
    constexpr double least = 1e-6;  // of a direction that counts as another one
    const Vec3 rest = common.loose * direction;
    if (!(norm(rest) > least)) return;
    common.loose = common.loose - outer(rest, rest) * (1.0 / norm2(rest));
    common.common--;
    if (common.common == 0) common.loose = zero33();
  }

  void hold_by(const Constraint& c) {
    for (const Vec3 held : rule_of(c).directions(c)) hold(held);
  }

  bool among(PointId id) const {
    const BodyId body = world.points[id].body;
    return body ? bodies.contains(body) : points.contains(id);
  }

  void ties_of(PointId id) {
    const ParticleId ring = world.points[id].particle;
    const auto& members = world.particles[ring].points;
    if (world.particles[ring].joins() && rings.insert(ring).second)
      count -= (world.plane.flat() ? 2 : 3) *
               (std::count_if(members.begin(), members.end(), [&](PointId p) { return among(p); }) - 1);
    ties(world.points[id].constraints);
  }

  void ties(const std::vector<ConstraintId>& list) {
    for (ConstraintId c : list)
      if (constraints.insert(c).second) tie(world.constraints[c]);
  }

  /// How many freedoms a constraint takes.
  long taken(const Constraint& c) const {
    const FreedomsTaken freedoms = rule_of(c).freedoms(c);
    return world.plane.flat() ? freedoms.in_plane : freedoms.in_space;
  }

  void tie(const Constraint& c) {
    if (!c.enabled || taken(c) == 0) return;
    if (c.a && !c.b) hold_by(c);
    bool all = true;
    c.each_point([&](PointId point) { all = all && among(point); });
    c.each_body([&](BodyId body) { all = all && bodies.contains(body); });
    if (!all) return;
    count -= taken(c);
  }
};

}  // namespace

FreedomCount count_freedoms(const World& world, const Things& things) {
  Freedoms f{world,
             {things.bodies.begin(), things.bodies.end()},
             {things.free_points.begin(), things.free_points.end()},
             {},
             {}};
  const bool flat = world.plane.flat();
  const long ways = flat ? 2 : 3;
  f.common = {0, diagonal(world.plane.directions()), ways};
  for (BodyId id : things.bodies) {
    const Freedom freedom = world.motion_of(id).freedom;
    f.count += ways + (freedom == Freedom::point ? 0 : flat ? 1 : freedom == Freedom::line ? 2 : 3);
    for (PointId p : world.bodies[id].points) f.ties_of(p);
    f.ties(world.bodies[id].constraints);
  }
  f.count += ways * static_cast<long>(things.free_points.size());
  for (PointId p : things.free_points) f.ties_of(p);
  f.common.count = f.count - f.common.common;
  return f.common;
}

double temperature(const World& world, const Things& things) {
  const FreedomCount freedoms = count_freedoms(world, things);
  if (freedoms.count <= 0) return 0.0;
  const Vec3 common = freedoms.loose * momentum(world, things);
  const double kinetic = energy(world, things).kinetic - 0.5 * norm2(common) / mass(world, things);
  return std::fmax(0.0, 2.0 * kinetic / (static_cast<double>(freedoms.count) * world.settings.boltzmann));
}

}  // namespace pantin
