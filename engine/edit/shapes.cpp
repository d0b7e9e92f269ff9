#include <algorithm>
#include <cmath>

#include "edit/common.hpp"
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

ShapeId insert(World& world, const ShapeDef& def, BodyId body) {
  Shape row;
  row.geometry = def.geometry;
  row.body = body;
  row.at = def.at;
  row.orientation = unit("shape", def.orientation);
  row.material = def.material;
  row.color = def.color;
  row.name = def.name;
  row.serial = world.next_serial++;
  world.places_changed = world.unchecked = true;
  return world.shapes.add(std::move(row));
}

void erase(World& world, ShapeId id, const std::string& who) {
  const std::string what = world.shapes[id].name.empty() ? "shape" : text("shape '", world.shapes[id].name, "'");
  world.shapes.remove(id, {what, world.time, who, 0});
  world.places_changed = true;
}

/// Mass, centre and inertia about it of shapes filled with their density.
OwnMass mass_of(const std::vector<ShapeDef>& shapes) {
  OwnMass sum;
  for (const ShapeDef& s : shapes) {
    const SolidMass solid = solid_mass(s.geometry);
    const double mass = solid.volume * s.material.density;
    sum.mass += mass;
    sum.position += (s.at + rotate(normalised(s.orientation), solid.centre)) * mass;
  }
  sum.position = sum.position / sum.mass;
  for (const ShapeDef& s : shapes) {
    const SolidMass solid = solid_mass(s.geometry);
    const Mat3 R = matrix(normalised(s.orientation));
    const Vec3 d = s.at + R * solid.centre - sum.position;
    sum.inertia += times_transposed(R * solid.second, R) * s.material.density;
    sum.inertia += (identity33() * norm2(d) - outer(d, d)) * (solid.volume * s.material.density);
  }
  return sum;
}

}  // namespace

namespace internal {

void check_shape(const std::string& who, const ShapeDef& def, bool of_body) {
  require_finite(who, "at", def.at, "m");
  std::visit(Checker{who}, def.geometry);
  require(!of_body || is_convex(def.geometry), who, ": a body cannot have it: planes, meshes and heights do not move");
  const Material& m = def.material;
  require_positive(who, "density", m.density, "kg/m³");
  require_not_negative(who, "friction", m.friction, "");
  require(m.restitution >= 0.0 && m.restitution <= 1.0, who, ": restitution must be from 0 to 1, got ", m.restitution);
  require_finite(who, "surface_velocity", m.surface_velocity, "m/s");
}

OwnMass own_mass_of(const BodyDef& def) {
  if (def.shapes.empty()) return {def.mass, def.inertia, zero3()};
  const bool weighed =
      std::any_of(def.points.begin(), def.points.end(), [](const PointDef& p) { return p.mass > 0.0; });
  if (def.mass == 0.0 && weighed) return {0.0, def.inertia, zero3()};
  OwnMass own = mass_of(def.shapes);
  if (def.mass > 0.0) {
    own.inertia = own.inertia * (def.mass / own.mass);
    own.mass = def.mass;
  }
  if (trace(def.inertia) > 0.0) own.inertia = def.inertia;
  return own;
}

void erase_shapes(World& world, BodyId body, const std::string& who) {
  const std::vector<ShapeId> shapes = world.bodies[body].shapes;
  for (const ShapeId id : shapes) erase(world, id, who);
  world.bodies[body].shapes.clear();
}

}  // namespace internal

ShapeId add_shape(World& world, const ShapeDef& def) {
  require_unlocked(world, "shape");
  check_shape("shape", def, false);
  return insert(world, def, {});
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
  if (const BodyId body = world.shapes[id].body) std::erase(world.bodies[body].shapes, id);
  erase(world, id, culprit(world));
}

}  // namespace pantin
