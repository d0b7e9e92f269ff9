#include <algorithm>

#include "model/weigh.hpp"
#include "world/edit.hpp"
#include "world/editing.hpp"

namespace pantin {

using namespace editing;

namespace {

void check(const std::string& call, const PointDef& def) {
  require_finite(call, "place", def.at, "m");
  require_not_negative(call, "mass", def.mass, "kg");
  require_not_negative(call, "radius", def.radius, "m");
}

Point row_of(const PointDef& def, Color usual, BodyId body) {
  Point row;
  row.place = def.at;
  row.mass = def.mass;
  row.radius = def.radius;
  row.color = def.color.value_or(usual);
  row.name = def.name;
  row.body = body;
  return row;
}

/// Checks all numbers, and that the masses make a body.
void check(const std::string& who, const BodyDef& def) {
  require_finite(who, "at", def.at, "m");
  require_finite(who, "velocity", def.velocity, "m/s");
  require_finite(who, "spin", def.spin, "rad/s");
  require_not_negative(who, "mass", def.mass, "kg");
  require_inertia(who, def.inertia);
  std::vector<MassPoint> masses;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < def.points.size(); i++) {
    const PointDef& p = def.points[i];
    check(p.name.empty() ? text(who, ": point ", i + 1) : text(who, ": point '", p.name, "'"), p);
    if (!p.name.empty()) names.push_back(p.name);
    masses.push_back({p.at, p.mass});
  }
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  require(twice == names.end(), who, ": two points have the name '", twice == names.end() ? "" : *twice, "'");
  weigh(who, masses, def.mass, def.inertia, Quat{});
}

/// Puts a weighed body where and how its definition says.
void start(World& world, BodyId id, const BodyDef& def, const Quat& frame) {
  const Body& body = world.bodies[id];
  Motion& m = world.motion_of(id);
  m.q = normalised(frame * body.axes);
  m.x = def.at + rotate(frame, body.centre);
  m.p = def.velocity * m.mass;
  m.angular = m.inertia * turning_part(m, def.spin);
}

}  // namespace

ParticleId add_particle(World& world, const ParticleDef& def) {
  const std::string call = def.name.empty() ? "particle" : text("particle '", def.name, "'");
  require_unlocked(world, call);
  require_finite(call, "at", def.at, "m");
  require_finite(call, "velocity", def.velocity, "m/s");
  require_positive(call, "mass", def.mass, "kg");
  require_not_negative(call, "radius", def.radius, "m");
  require_positive_or_infinite(call, "lifetime", def.lifetime, "s");
  Point row;
  row.place = def.at;
  row.velocity = def.velocity;
  row.mass = def.mass;
  row.radius = def.radius;
  row.color = def.color;
  const PointId point = make_point(world, std::move(row));
  const ParticleId id = world.points[point].own;
  if (std::isfinite(def.lifetime)) set_lifetime(world, id, def.lifetime);
  world.particles[id].name = def.name;
  touch(world, point);
  post(world, energy_of(world, point));
  return id;
}

BodyId add_body(World& world, const BodyDef& def) {
  const std::string who = def.name.empty() ? "body" : text("body '", def.name, "'");
  require_unlocked(world, who);
  check(who, def);
  const Quat frame = unit(who, def.orientation);
  Body row;
  row.own_mass = def.mass;
  row.own_inertia = def.inertia;
  row.name = def.name;
  row.serial = world.next_serial++;
  const BodyId id = world.bodies.add(std::move(row));
  world.motion.resize(world.bodies.slots());
  world.motion_of(id) = Motion{};
  for (const PointDef& p : def.points) {
    const PointId point = make_point(world, row_of(p, def.color, id));
    world.bodies[id].points.push_back(point);
  }
  weigh_again(world, id);
  start(world, id, def, frame);
  touch(world, id);
  post(world, energy_of(world, id));
  return id;
}

PointId add_point(World& world, BodyId body, const PointDef& def) {
  const std::string call = text(describe(world, body), ": point");
  require_unlocked(world, call);
  check(call, def);
  for (PointId p : world.bodies[body].points)
    require(def.name.empty() || world.points[p].name != def.name, call, ": the name '", def.name, "' is taken");
  std::vector<MassPoint> masses;
  for (PointId p : world.bodies[body].points) masses.push_back({world.points[p].place, world.points[p].mass});
  masses.push_back({def.at, def.mass});
  const Body& row = world.bodies[body];
  weigh(describe(world, body), masses, row.own_mass, row.own_inertia, row.axes);

  const Color usual = row.points.empty() ? BodyDef{}.color : world.points[row.points[0]].color;
  const double before = energy_of(world, body);
  const PointId point = make_point(world, row_of(def, usual, body));
  world.bodies[body].points.push_back(point);
  weigh_again(world, body);
  touch(world, body);
  post(world, energy_of(world, body) - before);
  return point;
}

}  // namespace pantin
