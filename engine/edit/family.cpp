#include <algorithm>

#include "edit/common.hpp"
#include "forces/curves.hpp"

namespace pantin {

using namespace internal;

namespace {

std::string names_of(const Family& family) {
  std::string list;
  for (const Family::Attribute& a : family.attributes) list += (list.empty() ? "" : ", ") + a.name;
  return list.empty() ? "none" : list;
}

}  // namespace

namespace internal {

std::vector<double> attribute_values(std::string_view call, const Family& family, std::span<const AttributeDef> given) {
  std::vector<double> values;
  for (const Family::Attribute& a : family.attributes) values.push_back(a.value);
  for (const AttributeDef& g : given) {
    const std::ptrdiff_t found = family.find(g.name);
    require(found >= 0, call, ": ",
            family.name.empty()
                ? std::string("it has no family to have attributes of")
                : text("family '", family.name, "' has no attribute '", g.name, "'; it has ", names_of(family)));
    require_finite(call, g.name, g.value, "");
    values[static_cast<std::size_t>(found)] = g.value;
  }
  return values;
}

void require_solid_radius(std::string_view call, const Family& family, double radius, const Curves* curves) {
  if (!family.solid) return;
  const std::string who = text(call, ": as one of the solid family '", family.name, "' it ");
  require(!(curves && curves->find("radius")), who, "touches, and its radius cannot follow its age");
  require(radius > 0.0, who, "needs a radius > 0 m, got ", radius);
}

}  // namespace internal

FamilyId add_family(World& world, const FamilyDef& def) {
  require_unlocked(world, "family");
  require(!def.name.empty(), "family: the name must not be empty");
  const std::string call = text("family '", def.name, "'");
  for (FamilyId other : world.families.ids())
    require(world.families[other].name != def.name, call, ": there is one of this name already");
  if (def.mass) require_positive(call, "mass", *def.mass, "kg");
  if (def.radius) require_not_negative(call, "radius", *def.radius, "m");
  Family row;
  for (const AttributeDef& a : def.attributes) {
    require_finite(call, a.name, a.value, "");
    require(!a.name.empty(), call, ": the name of an attribute must not be empty");
    row.attributes.push_back({a.name, a.value});
  }
  std::sort(row.attributes.begin(), row.attributes.end(),
            [](const Family::Attribute& a, const Family::Attribute& b) { return a.name < b.name; });
  for (std::size_t i = 1; i < row.attributes.size(); i++)
    require(row.attributes[i - 1].name != row.attributes[i].name, call, ": attribute '", row.attributes[i].name,
            "' is given twice");
  row.color = def.color;
  row.radius = def.radius;
  row.mass = def.mass;
  row.look = def.look;
  row.sprite = def.sprite;
  row.curves = curves_of(call, row, def.curves, false, false, {});
  row.name = def.name;
  if (def.solid) {
    require_friction(call, def.solid->friction);
    require_restitution(call, def.solid->restitution);
    row.solid = def.solid;
    require_solid_radius(call, row, def.radius.value_or(1.0), row.curves.get());
    row.solid->layer = layer_of(world, def.layer);
    world.solids = world.places_changed = world.unchecked = true;
  }
  row.serial = world.next_serial++;
  return world.families.add(std::move(row));
}

void set_family(World& world, ParticleId id, FamilyId family) {
  require_unlocked(world, "family");
  Particle& particle = world.particles[awake(world, id)];
  const Family next = family ? world.families[family] : Family{};
  std::vector<AttributeDef> kept;
  if (particle.family) {
    const Family& old = world.families[particle.family];
    for (std::size_t i = 0; i < old.attributes.size(); i++)
      if (next.find(old.attributes[i].name) >= 0) kept.push_back({old.attributes[i].name, particle.values[i]});
  }
  const PointId first = particle.points[0];
  require_solid_radius(describe(world, id), next, radius_of(world, world.points[first]), next.curves.get());
  disturb_site(world, awake(world, id));
  particle.values = attribute_values("family", next, kept);
  particle.family = family;
  particle.curves = next.curves;
  world.places_changed = world.places_changed || world.solids;
}

namespace {

/// How a family touches, which is about to be written.
Solid& written(World& world, FamilyId id, const char* what) {
  require_unlocked(world, what);
  Family& family = world.families[id];
  require(family.solid.has_value(), describe(world, id), ": ", what, " is of what is solid, and it is not");
  world.places_changed = true;
  return *family.solid;
}

}  // namespace

void set_layer(World& world, FamilyId id, std::string_view layer) {
  written(world, id, "layer").layer = layer_of(world, layer);
}

void set_friction(World& world, FamilyId id, double friction) {
  require_friction(describe(world, id), friction);
  written(world, id, "friction").friction = friction;
}

void set_restitution(World& world, FamilyId id, double restitution) {
  require_restitution(describe(world, id), restitution);
  written(world, id, "restitution").restitution = restitution;
}

namespace {

const Family& family_of(const World& world, const Particle& particle) {
  static const Family none;
  return particle.family ? world.families[particle.family] : none;
}

}  // namespace

void set_radius(World& world, ParticleId particle, double radius) {
  require_unlocked(world, "radius");
  require_not_negative(describe(world, particle), "radius", radius, "m");
  Particle& row = world.particles[particle];
  require_solid_radius(describe(world, particle), family_of(world, row), radius, nullptr);
  disturb_site(world, awake(world, particle));
  world.places_changed = world.places_changed || world.solids;
  row.radius = radius;
  row.curves = without(row.curves, "radius");
}

void set_color(World& world, ParticleId particle, const Color& color) {
  require_unlocked(world, "color");
  Particle& row = world.particles[particle];
  row.color = color;
  row.curves = without(row.curves, "color");
}

void set_look(World& world, ParticleId particle, Look look) {
  require_unlocked(world, "look");
  world.particles[particle].look = look;
}

void set_attribute(World& world, ParticleId id, std::string_view name, double value) {
  require_unlocked(world, name);
  const std::string who = describe(world, id);
  Particle& particle = world.particles[awake(world, id)];
  require(static_cast<bool>(particle.family), who, ": it has no family, so no attribute '", name, "'");
  const Family& family = world.families[particle.family];
  const std::ptrdiff_t found = family.find(name);
  require(found >= 0, who, ": family '", family.name, "' has no attribute '", name, "'; it has ", names_of(family));
  require_finite(who, name, value, "");
  disturb_site(world, awake(world, id));
  particle.values[static_cast<std::size_t>(found)] = value;
  particle.curves = without(particle.curves, name);
}

void remove(World& world, FamilyId id) {
  require_unlocked(world, "remove");
  const std::string what = describe(world, id);
  for (ParticleId p : world.particles.ids())
    require(world.particles[p].family != id, "remove: ", what, " still has ", describe(world, p));
  for (InteractionId i : world.interactions.ids())
    require(world.interactions[i].a != id && world.interactions[i].b != id, "remove: ", what, " is still in ",
            describe(world, i));
  for (FieldId f : world.fields.ids())
    require(world.fields[f].family != id, "remove: ", what, " is still in ", describe(world, f));
  world.families.remove(id, obituary(world, what));
}

}  // namespace pantin
