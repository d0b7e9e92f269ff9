#include <algorithm>

#include "edit/common.hpp"
#include "forces/curves.hpp"
#include "model/weigh.hpp"

namespace pantin {

using namespace internal;

namespace {

void check(const World& world, const std::string& call, const PointDef& def) {
  const Family none;
  attribute_values(call, def.family ? world.families[def.family] : none, def.attributes);
  require_finite(call, "position", def.at, "m");
  require_not_negative(call, "mass", def.mass, "kg");
  require_not_negative(call, "radius", def.radius, "m");
}

Point row_of(const PointDef& def, Color usual, BodyId body) {
  Point row;
  row.position = def.at;
  row.mass = def.mass;
  row.radius = def.radius;
  row.color = def.color.value_or(usual);
  row.name = def.name;
  row.body = body;
  return row;
}

PointId make_body_point(World& world, const PointDef& def, Color usual, BodyId body) {
  const Family none, &family = def.family ? world.families[def.family] : none;
  const PointId point = make_point(world, row_of(def, family.color.value_or(usual), body));
  Particle& particle = world.particles[world.points[point].own];
  particle.family = def.family;
  particle.values = attribute_values("point", family, def.attributes);
  particle.curves = curves_of("point", family, nullptr, def.radius > 0.0, def.color.has_value(), def.attributes);
  return point;
}

/// Checks all numbers, and that the masses make a body.
void check(const World& world, const std::string& who, const BodyDef& def) {
  require_finite(who, "at", def.at, "m");
  require_finite(who, "velocity", def.velocity, "m/s");
  require_finite(who, "spin", def.spin, "rad/s");
  require_not_negative(who, "mass", def.mass, "kg");
  require_inertia(who, def.inertia);
  std::vector<MassPoint> masses;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < def.points.size(); i++) {
    const PointDef& p = def.points[i];
    check(world, p.name.empty() ? text(who, ": point ", i + 1) : text(who, ": point '", p.name, "'"), p);
    if (!p.name.empty()) names.push_back(p.name);
    masses.push_back({p.at, p.mass});
  }
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  require(twice == names.end(), who, ": two points have the name '", twice == names.end() ? "" : *twice, "'");
  require_in_plane(world, who, "velocity", def.velocity, "m/s");
  require_about_normal(world, who, "spin", def.spin, "rad/s");
  const Quat frame = unit(who, def.orientation);
  for (const ShapeDef& shape : def.shapes) check_shape(text(who, ": shape"), shape, true);
  weigh(who, masses, own_mass_of(def), conjugate(frame), normal_in(world, frame));
}

/// Puts a weighed body where and how its definition says.
void start(World& world, BodyId id, const BodyDef& def, const Quat& frame) {
  const Body& body = world.bodies[id];
  Motion& m = world.motion_of(id);
  m.q = world.plane.about(normalised(frame * body.axes));
  m.x = def.at + rotate(frame, body.centre);
  m.p = world.plane.along(def.velocity) * m.mass;
  m.angular = m.inertia * turning_part(m, def.spin);
}

}  // namespace

ParticleId add_particle(World& world, const ParticleDef& def) {
  const std::string call = def.name.empty() ? "particle" : text("particle '", def.name, "'");
  require_unlocked(world, call);
  const Family none, &family = def.family ? world.families[def.family] : none;
  const double mass = def.mass.value_or(family.mass.value_or(1.0));
  const double radius = def.radius.value_or(family.radius.value_or(0.05));
  require_finite(call, "at", def.at, "m");
  require_finite(call, "velocity", def.velocity, "m/s");
  require_in_plane(world, call, "velocity", def.velocity, "m/s");
  require_positive(call, "mass", mass, "kg");
  require_not_negative(call, "radius", radius, "m");
  std::vector<double> values = attribute_values(call, family, def.attributes);
  auto curves = curves_of(call, family, def.curves, def.radius.has_value(), def.color.has_value(), def.attributes);
  require_solid_radius(call, family, radius, curves.get());
  require_positive_or_infinite(call, "lifetime", def.lifetime, "s");
  Point row;
  row.mass = mass;
  row.radius = radius;
  row.color = def.color.value_or(family.color.value_or(ParticleDef::usual_color));
  disturb_forces_by_birth(world, def.family);
  const PointId point = make_point(world, std::move(row));
  world.motion_of(point) = {def.at, world.plane.along(def.velocity)};
  const ParticleId id = world.points[point].own;
  if (std::isfinite(def.lifetime)) set_lifetime(world, id, def.lifetime);
  Particle& particle = world.particles[id];
  particle.name = def.name;
  particle.family = def.family;
  particle.values = std::move(values);
  particle.look = def.look;
  particle.curves = std::move(curves);
  note_site(world, id);
  mark_edited(world, point);
  post(world, Source::edit, energy_of(world, point));
  return id;
}

BodyId add_body(World& world, const BodyDef& def) {
  const std::string who = def.name.empty() ? "body" : text("body '", def.name, "'");
  require_unlocked(world, who);
  check(world, who, def);
  const Quat frame = unit(who, def.orientation);
  disturb_sites(world);
  Body row;
  const OwnMass own = own_mass_of(def);
  row.own_mass = own.mass;
  row.own_inertia = own.inertia;
  row.own_position = own.position;
  row.sprite = def.sprite;
  row.name = def.name;
  row.serial = world.next_serial++;
  const BodyId id = world.bodies.add(std::move(row));
  world.motion.resize(world.bodies.slots());
  world.motion_of(id) = Motion{};
  world.motion_of(id).q = frame;
  for (const PointDef& p : def.points) world.bodies[id].points.push_back(make_body_point(world, p, def.color, id));
  const double denser = filling(def);
  for (ShapeDef shape : def.shapes) {
    shape.material.density *= denser;
    add_shape(world, id, shape);
  }
  update_mass(world, id);
  start(world, id, def, frame);
  mark_edited(world, id);
  post(world, Source::edit, energy_of(world, id));
  return id;
}

PointId add_point(World& world, BodyId body, const PointDef& def) {
  const std::string call = text(describe(world, body), ": point");
  require_unlocked(world, call);
  check(world, call, def);
  for (PointId p : world.bodies[body].points)
    require(def.name.empty() || world.points[p].name != def.name, call, ": the name '", def.name, "' is taken");
  std::vector<MassPoint> masses;
  for (PointId p : world.bodies[body].points) masses.push_back({world.points[p].position, world.points[p].mass});
  masses.push_back({def.at, def.mass});
  const Body& row = world.bodies[body];
  weigh(describe(world, body), masses, own_mass_of(row), row.axes, normal_in(world, orientation(world, body)));

  const Color usual = row.points.empty() ? BodyDef{}.color : world.points[row.points[0]].color;
  const double before = energy_of(world, body);
  disturb_sites(world);
  const PointId point = make_body_point(world, def, usual, body);
  world.bodies[body].points.push_back(point);
  update_mass(world, body);
  mark_edited(world, body);
  post(world, Source::edit, energy_of(world, body) - before);
  return point;
}

}  // namespace pantin
