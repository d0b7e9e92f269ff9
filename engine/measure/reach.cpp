#include "measure/reach.hpp"

#include <unordered_set>

namespace pantin {
namespace {

struct Walk {
  const World& world;
  Things found;
  std::vector<PointId> open;  // points whose ring and rods are still to be followed
  std::unordered_set<BodyId> bodies;
  std::unordered_set<PointId> free_points;

  void meet(BodyId body) {
    if (!bodies.insert(body).second) return;
    found.bodies.push_back(body);
    for (PointId p : world.bodies[body].points) open.push_back(p);
    for (ConstraintId id : world.bodies[body].constraints) {
      if (world.constraints[id].enabled) meet(world.constraints[id]);
    }
  }
  void meet(const Constraint& c) {
    c.each_point([&](PointId point) { meet(point); });
    c.each_body([&](BodyId body) { meet(body); });
  }
  void meet(PointId id) {
    if (const BodyId body = world.points[id].body) return meet(body);
    if (!free_points.insert(id).second) return;
    found.free_points.push_back(id);
    open.push_back(id);
  }
  void meet_all_tied(bool by_connections) {
    while (!open.empty()) {
      const PointId id = open.back();
      open.pop_back();
      const Particle& ring = world.particles[world.points[id].particle];
      for (PointId member : ring.points) meet(member);
      for (ConnectionId c : ring.connections) {
        const Connection& tie = world.connections[c];
        for (std::uint32_t i = 0; by_connections && tie.enabled && i < tie.count; i++)
          if (tie.particles[i]) meet(world.particles[awake(world, tie.particles[i])].points[0]);
      }
      for (ConstraintId c : world.points[id].constraints) {
        if (world.constraints[c].enabled) meet(world.constraints[c]);
      }
    }
  }
};

template <class Id>
Things all_tied_to(const World& world, Id id, bool by_connections) {
  Walk walk{world, {}, {}, {}, {}};
  walk.meet(id);
  walk.meet_all_tied(by_connections);
  return std::move(walk.found);
}

}  // namespace

Things tied_to(const World& world, PointId point, bool by_connections) {
  return all_tied_to(world, point, by_connections);
}
Things tied_to(const World& world, BodyId body, bool by_connections) {
  return all_tied_to(world, body, by_connections);
}

}  // namespace pantin
