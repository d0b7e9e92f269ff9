#include <algorithm>
#include <cmath>
#include <tuple>

#include "edit/common.hpp"
#include "forces/sleep.hpp"
#include "shapes/mass.hpp"

namespace pantin {

using namespace internal;

namespace {

struct Checker {
  const std::string& who;

  void operator()(const BallShape& s) const { require_positive(who, "radius", s.radius, "m"); }
  void operator()(const BoxShape& s) const {
    for (int i = 0; i < 3; i++) require_positive(who, "half its size", s.half[i], "m");
  }
  void operator()(const CapsuleShape& s) const {
    require_positive(who, "radius", s.radius, "m");
    require_positive(who, "half its length", s.half, "m");
  }
  void operator()(const CylinderShape& s) const {
    require_positive(who, "radius", s.radius, "m");
    require_positive(who, "half its length", s.half, "m");
  }
  void operator()(const HalfSpaceShape&) const {}
  template <class Shared>
  void operator()(const std::shared_ptr<const Shared>& s) const {
    require(s != nullptr, who, " is missing");
  }
};

/// Sensors weigh nothing beside others.
std::vector<Filled> weighing(const std::vector<ShapeDef>& shapes) {
  const bool sensors = std::all_of(shapes.begin(), shapes.end(), [](const ShapeDef& s) { return s.sensor; });
  std::vector<Filled> list;
  for (const ShapeDef& s : shapes)
    if (sensors || !s.sensor) list.push_back({s.geometry, s.at, s.orientation, s.material.density});
  return list;
}

/// Of a moment of friction.
void require_arm(const std::string& who, const char* name, double arm) {
  require_not_negative(who, name, arm, "m");
  require(arm <= 1e12, who, ": ", name, " must be at most 1e12 m, got ", arm);
}

/// Says that a shape changes. What the world's touch could be anywhere.
void change_places(World& world, BodyId of) {
  world.places_changed = true;
  of ? wake(world, of) : wake_all(world);
}

ShapeId insert(World& world, const ShapeDef& def, BodyId body) {
  Shape row;
  row.geometry = def.geometry;
  row.body = body;
  row.at = def.at;
  row.orientation = unit("shape", def.orientation);
  row.material = def.material;
  row.layer = layer_of(world, def.layer);
  row.sensor = def.sensor;
  row.color = def.color;
  row.extent = def.extent;
  row.cover = def.cover;
  row.name = def.name;
  row.serial = world.next_serial++;
  world.unchecked = true;
  change_places(world, body);
  return world.shapes.add(std::move(row));
}

}  // namespace

namespace internal {

void require_friction(const std::string& who, double friction) {
  require_not_negative(who, "friction", friction, "");
  require(friction <= 1e100, who, ": friction must be at most 1e100, got ", friction);
}

void require_restitution(const std::string& who, double restitution) {
  require(restitution >= 0.0 && restitution <= 1.0, who, ": restitution must be from 0 to 1, got ", restitution);
}

void check_shape(const std::string& who, const ShapeDef& def, bool of_body) {
  require_finite(who, "at", def.at, "m");
  std::visit(Checker{who}, def.geometry);
  require(!of_body || is_convex(def.geometry), who, ": a body cannot have it: planes, meshes and heights do not move");
  const Material& m = def.material;
  require_positive(who, "density", m.density, "kg/m³");
  require_friction(who, m.friction);
  require_restitution(who, m.restitution);
  require_arm(who, "rolling", m.rolling);
  require_arm(who, "spinning", m.spinning);
  if (def.extent) require_positive(who, "size", *def.extent, "m");
  require_finite(who, "surface_velocity", m.surface_velocity, "m/s");
}

OwnMass mass_of(std::span<const Filled> shapes) {
  OwnMass sum;
  for (const Filled& s : shapes) {
    const SolidMass solid = solid_mass(s.geometry);
    const double mass = solid.volume * s.density;
    sum.mass += mass;
    sum.position += (s.at + rotate(normalised(s.orientation), solid.centre)) * mass;
  }
  sum.position = sum.position / sum.mass;
  for (const Filled& s : shapes) {
    const SolidMass solid = solid_mass(s.geometry);
    const Mat3 R = matrix(normalised(s.orientation));
    const Vec3 d = s.at + R * solid.centre - sum.position;
    sum.inertia += times_transposed(R * solid.second, R) * s.density;
    sum.inertia += (identity33() * norm2(d) - outer(d, d)) * (solid.volume * s.density);
  }
  return sum;
}

double filling(const BodyDef& def) {
  return def.mass > 0.0 && !def.shapes.empty() ? def.mass / mass_of(weighing(def.shapes)).mass : 1.0;
}

OwnMass own_mass_of(const BodyDef& def) {
  if (def.shapes.empty()) return {def.mass, def.inertia, zero3()};
  const bool weighed =
      std::any_of(def.points.begin(), def.points.end(), [](const PointDef& p) { return p.mass > 0.0; });
  if (def.mass == 0.0 && weighed) return {0.0, def.inertia, zero3()};
  OwnMass own = mass_of(weighing(def.shapes));
  if (def.mass > 0.0) {
    own.inertia = own.inertia * (def.mass / own.mass);
    own.mass = def.mass;
  }
  if (trace(def.inertia) > 0.0) own.inertia = def.inertia;
  return own;
}

void erase_shape(World& world, ShapeId id, const std::string& who) {
  const BodyId body = world.shapes[id].body;
  if (body) std::erase(world.bodies[body].shapes, id);
  change_places(world, body);
  world.shapes.remove(id, {describe(world, id), world.time, who, 0});
  world.places_changed = true;
}

void erase_shapes(World& world, BodyId body, const std::string& who) {
  const std::vector<ShapeId> shapes = world.bodies[body].shapes;
  for (const ShapeId id : shapes) erase_shape(world, id, who);
}

}  // namespace internal

ShapeId add_shape(World& world, const ShapeDef& def) { return add_shapes(world, {&def, 1})[0]; }

std::vector<ShapeId> add_shapes(World& world, std::span<const ShapeDef> defs) {
  require_unlocked(world, "shape");
  for (const ShapeDef& def : defs) check_shape("shape", def, false);
  std::vector<ShapeId> ids;
  for (const ShapeDef& def : defs) ids.push_back(insert(world, def, {}));
  return ids;
}

ShapeId add_shape(World& world, BodyId body, const ShapeDef& def) {
  require_unlocked(world, "shape");
  check_shape(text(describe(world, body), ": shape"), def, true);
  const ShapeId id = insert(world, def, body);
  world.bodies[body].shapes.push_back(id);
  return id;
}

void remove(World& world, ShapeId id) {
  require_unlocked(world, "remove");
  erase_shape(world, id, culprit(world));
  notice(world, Notice::Kind::removed, id, world.shapes.story(id));
}

std::uint32_t layer_of(World& world, std::string_view name) {
  if (name.empty()) return 0;
  auto& names = world.layers.names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    names.emplace_back(name);
    return static_cast<std::uint32_t>(names.size());
  }
  return static_cast<std::uint32_t>(found - names.begin()) + 1;
}

namespace {

/// The row of a shape that is about to be written.
Shape& written(World& world, ShapeId id, const char* what) {
  require_unlocked(world, what);
  Shape& shape = world.shapes[id];
  change_places(world, shape.body);
  return shape;
}

}  // namespace

void set_layer(World& world, ShapeId id, std::string_view layer) {
  written(world, id, "layer").layer = layer_of(world, layer);
}

void set_extent(World& world, ShapeId id, std::optional<double> extent) {
  require_unlocked(world, "size");
  const std::string who = describe(world, id);
  require(std::holds_alternative<HalfSpaceShape>(world.shapes[id].geometry), who,
          ": size is of planes alone, which have no end");
  if (extent) require_positive(who, "size", *extent, "m");
  world.shapes[id].extent = extent;
}

void set_sensor(World& world, ShapeId id, bool sensor) { written(world, id, "sensor").sensor = sensor; }

void set_friction(World& world, ShapeId id, double friction) {
  require_friction(describe(world, id), friction);
  written(world, id, "friction").material.friction = friction;
}

void set_restitution(World& world, ShapeId id, double restitution) {
  require_restitution(describe(world, id), restitution);
  written(world, id, "restitution").material.restitution = restitution;
}

void set_rolling(World& world, ShapeId id, double rolling) {
  require_arm(describe(world, id), "rolling", rolling);
  written(world, id, "rolling").material.rolling = rolling;
}

void set_spinning(World& world, ShapeId id, double spinning) {
  require_arm(describe(world, id), "spinning", spinning);
  written(world, id, "spinning").material.spinning = spinning;
}

void set_surface_velocity(World& world, ShapeId id, Vec3 velocity) {
  require_finite(describe(world, id), "surface_velocity", velocity, "m/s");
  written(world, id, "surface_velocity").material.surface_velocity = velocity;
}

void set_rule(World& world, std::string_view a, std::string_view b, LayerRule rule) {
  require_unlocked(world, "collide");
  require(!a.empty() && !b.empty(), "collide: a layer must have a name");
  if (rule.friction) require_friction("collide", *rule.friction);
  if (rule.restitution) require_restitution("collide", *rule.restitution);
  const std::uint32_t x = layer_of(world, a), y = layer_of(world, b);
  std::tie(rule.a, rule.b) = std::minmax(x, y);
  Layers& layers = world.layers;
  const auto at = layers.rules.begin() + static_cast<std::ptrdiff_t>(layers.index(x, y));
  if (layers.rule(x, y))
    *at = rule;
  else
    layers.rules.insert(at, rule);
  world.places_changed = true;
  wake_all(world);
}

void set_collide(World& world, ParticleId id, bool collide) {
  require_unlocked(world, "collide");
  Particle& hinge = world.particles[awake(world, id)];
  require(hinge.is_hinge(), "collide: ", describe(world, id), " is no hinge");
  hinge.collide = collide;
  world.places_changed = true;
  wake(world, hinge.points[0]);
}

}  // namespace pantin
