// What a group's things have among them: near pairs, connections, heat.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "edit/assemble.hpp"
#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "measure/freedoms.hpp"
#include "measure/near_pairs.hpp"

namespace pantin {

using namespace internal;

namespace {

/// Awake particles of things, those of bodies' points too, in the order of making.
std::vector<ParticleId> particles_of(const World& world, const Things& things) {
  std::vector<ParticleId> list;
  const auto add = [&](PointId p) { list.push_back(awake(world, world.points[p].own)); };
  for (BodyId body : things.bodies)
    for (PointId p : world.bodies[body].points) add(p);
  for (PointId p : things.free_points) add(p);
  std::sort(list.begin(), list.end(),
            [&](ParticleId a, ParticleId b) { return world.particles[a].serial < world.particles[b].serial; });
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

bool are_of_one_body(const World& world, ParticleId a, ParticleId b) {
  for (PointId p : world.particles[a].points)
    for (PointId q : world.particles[b].points)
      if (world.points[p].body && world.points[p].body == world.points[q].body) return true;
  return false;
}

bool are_connected(const World& world, ParticleId a, ParticleId b) {
  const auto ends_at = [&](ConnectionId id) {
    const Connection& c = world.connections[id];
    return std::any_of(c.particles.begin(), c.particles.begin() + c.count,
                       [&](ParticleId end) { return end && awake(world, end) == b; });
  };
  const auto has = [&](ParticleId id) {
    return std::any_of(world.particles[id].connections.begin(), world.particles[id].connections.end(), ends_at);
  };
  return has(a) || std::any_of(world.particles[a].points.begin(), world.particles[a].points.end(),
                               [&](PointId p) { return has(world.points[p].own); });
}

/// In the order of making, each once.
std::vector<ConnectionId> in_order(const World& world, std::vector<ConnectionId> list) {
  std::sort(list.begin(), list.end(),
            [&](ConnectionId a, ConnectionId b) { return world.connections[a].serial < world.connections[b].serial; });
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// Velocities of random directions for things at rest, without a common motion.
void stir(World& world, const Things& things) {
  const auto random = [&] {
    const auto number = [&] { return 2.0 * world.random.uniform() - 1.0; };
    const double x = number(), y = number(), z = number();
    return world.plane.along(vec(x, y, z));
  };
  for (BodyId id : things.bodies) {
    Motion& m = world.motion_of(id);
    m.p = random() * std::sqrt(m.mass);
  }
  for (PointId id : things.free_points) world.motion_of(id).v = random() / std::sqrt(world.points[id].mass);
}

void add_velocity(World& world, const Things& things, Vec3 v) {
  for (BodyId id : things.bodies) world.motion_of(id).p += v * world.motion_of(id).mass;
  for (PointId id : things.free_points) world.motion_of(id).v += v;
}

void scale_motion(World& world, const Things& things, double factor) {
  for (BodyId id : things.bodies) {
    world.motion_of(id).p *= factor;
    world.motion_of(id).angular *= factor;
  }
  for (PointId id : things.free_points) world.motion_of(id).v *= factor;
}

}  // namespace

std::vector<std::array<ParticleId, 2>> pairs_within(const World& world, GroupId group, double distance) {
  return pairs_within(world, particles_of(world, things_of(world, group)), distance);
}

std::vector<std::array<ParticleId, 2>> pairs_within(const World& world, const std::vector<ParticleId>& list,
                                                    double distance) {
  require_positive("connect_within", "distance", distance, "m");
  std::vector<Vec3> positions;
  for (ParticleId id : list) positions.push_back(position(world, id));
  std::vector<std::array<ParticleId, 2>> pairs;
  each_near_pair(positions, {world.settings.box.value_or(zero3())}, distance, [&](std::uint32_t a, std::uint32_t b) {
    if (!are_of_one_body(world, list[a], list[b]) && !are_connected(world, list[a], list[b]))
      pairs.push_back({list[a], list[b]});
  });
  return pairs;
}

std::vector<ConnectionId> connections_among(const World& world, const std::vector<ParticleId>& list) {
  const std::unordered_set<ParticleId> inside(list.begin(), list.end());
  std::vector<ConnectionId> found;
  const auto look = [&](ParticleId particle) {
    for (ConnectionId id : world.particles[particle].connections) {
      const Connection& c = world.connections[id];
      if (std::all_of(c.particles.begin(), c.particles.begin() + c.count,
                      [&](ParticleId end) { return end && inside.contains(awake(world, end)); }))
        found.push_back(id);
    }
  };
  for (ParticleId id : list) {
    look(id);
    if (!world.particles[id].is_hinge()) continue;
    for (PointId p : world.particles[id].points) look(world.points[p].own);
  }
  return in_order(world, std::move(found));
}

std::vector<ConnectionId> connections_in(const World& world, GroupId group) {
  std::vector<ConnectionId> found = connections_among(world, particles_of(world, things_of(world, group)));
  for (const AnyId& member : world.groups[group].members)
    if (const auto* id = std::get_if<ConnectionId>(&member); id && world.connections.alive(*id)) found.push_back(*id);
  return in_order(world, std::move(found));
}

double heat_in(const World& world, const Things& things) {
  if (things.bodies.empty() && things.free_points.empty()) return 0.0;
  const Vec3 common = count_freedoms(world, things).loose * momentum(world, things);
  return energy(world, things).kinetic - 0.5 * norm2(common) / mass(world, things);
}

namespace {

Vec3 centre_of_mass(const World& world, const Things& things) {
  Vec3 moment = zero3();
  for (const BodyId id : things.bodies) moment += world.motion_of(id).x * world.motion_of(id).mass;
  for (const PointId id : things.free_points) moment += world.motion_of(id).x * world.points[id].mass;
  return moment / mass(world, things);
}

}  // namespace

void move(World& world, const Things& things, Vec3 by, const Quat& turn) {
  require_unlocked(world, "move");
  require_finite("move", "the way", by, "m");
  require(!things.bodies.empty() || !things.free_points.empty(), "move: there is nothing to move");
  const Quat q = unit("move", turn);
  const Vec3 middle = centre_of_mass(world, things);
  const auto there = [&](Vec3 x) { return middle + rotate(q, x - middle) + by; };
  for (const BodyId id : things.bodies) require_finite("move", "a position", there(world.motion_of(id).x), "m");
  for (const PointId id : things.free_points) require_finite("move", "a position", there(world.motion_of(id).x), "m");
  const bool turns = std::fabs(q.w) < 1.0;
  for (const BodyId id : things.bodies) {
    const Motion& m = world.motion_of(id);
    const Vec3 x = there(m.x), v = rotate(q, m.p / m.mass), spin = rotate(q, angular_velocity(m));
    if (turns) {
      set_orientation(world, id, q * orientation(world, id));
      set_velocity(world, id, v);
      set_spin(world, id, spin);
    }
    set_position(world, id, x);
  }
  for (const PointId id : things.free_points) {
    const Vec3 x = there(world.motion_of(id).x), v = rotate(q, world.motion_of(id).v);
    if (turns) set_velocity(world, id, v);
    set_position(world, id, x);
  }
}

void heat(World& world, const AnyId& target, double joules) {
  heat(world, std::holds_alternative<std::monostate>(target) ? everything(world) : things_of(world, target), joules);
}

void heat(World& world, const Things& things, double joules) {
  require_unlocked(world, "heat");
  require_finite("heat", "the energy", joules, "J");
  require(!things.bodies.empty() || !things.free_points.empty(), "heat: there is nothing to heat");
  if (joules == 0.0) return;
  acted(world);
  const FreedomCount freedoms = count_freedoms(world, things);
  const double before = energy(world, things).kinetic;
  const Vec3 common = freedoms.loose * momentum(world, things) / mass(world, things);
  const double own = before - 0.5 * dot(common, momentum(world, things));
  require(own + joules >= -1e-12 * before, "heat: ", -joules, " J are to be taken, and there are only ", own, " J");
  const bool at_rest = !(own > 1e-12 * std::fmax(before, joules));
  require(!at_rest || freedoms.common == 0 || things.bodies.size() + things.free_points.size() > 1,
          "heat: a single thing has no motion relative to itself");
  disturb_forces_by_motion(world);
  add_velocity(world, things, common * -1.0);
  if (at_rest) {
    stir(world, things);
    add_velocity(world, things, freedoms.loose * momentum(world, things) / -mass(world, things));
  }
  const double now = energy(world, things).kinetic;
  scale_motion(world, things, std::sqrt(std::fmax(0.0, own + joules) / now));
  add_velocity(world, things, common);
  for (BodyId id : things.bodies) disturb(world, id);
  for (PointId id : things.free_points) disturb(world, id);
  post(world, Source::event, energy(world, things).kinetic - before);
}

}  // namespace pantin
