#include "world/reach.hpp"

#include <unordered_set>

namespace pantin {
namespace {

struct Walk {
  const World& world;
  Things found;
  std::vector<PointId> open;  // points whose ring and rods are still to be followed
  std::unordered_set<BodyId> bodies;
  std::unordered_set<PointId> free_points;

  void meet(PointId id) {
    const BodyId body = world.points[id].body;
    if (!body) {
      if (!free_points.insert(id).second) return;
      found.free_points.push_back(id);
      open.push_back(id);
    } else if (bodies.insert(body).second) {
      found.bodies.push_back(body);
      for (PointId p : world.bodies[body].points) open.push_back(p);
    }
  }
};

}  // namespace

Things tied_to(const World& world, PointId point, bool by_connections) {
  Walk walk{world, {}, {}, {}, {}};
  walk.meet(point);
  while (!walk.open.empty()) {
    const PointId id = walk.open.back();
    walk.open.pop_back();
    const Particle& ring = world.particles[world.points[id].particle];
    for (PointId member : ring.points) walk.meet(member);
    for (ConnectionId c : ring.connections) {
      const Connection& tie = world.connections[c];
      for (std::uint32_t i = 0; by_connections && tie.enabled && i < tie.count; i++)
        if (tie.particles[i]) walk.meet(world.particles[awake(world, tie.particles[i])].points[0]);
    }
    for (ConstraintId c : world.points[id].constraints) {
      const Constraint& rod = world.constraints[c];
      if (rod.kind != ConstraintKind::rod || !rod.enabled) continue;
      walk.meet(rod.a);
      if (rod.b) walk.meet(rod.b);
    }
  }
  return std::move(walk.found);
}

}  // namespace pantin
