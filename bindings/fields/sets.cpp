// Group and family, and what is measured of their things.
#include "edit/edit.hpp"
#include "fields/make.hpp"
#include "fields/measures.hpp"
#include "measure/query.hpp"

namespace pantin::fields {
namespace {

std::vector<Property> of_any_set() {
  return {
      property<AnyId>("energy", "Energy", "J", "of its things",
                      [](const World& w, const AnyId& set) { return table_of(energy(w, things_of(w, set))); }),
      property<AnyId>("momentum", "vec", "kg m/s", "sum over its things",
                      [](const World& w, const AnyId& set) { return momentum(w, things_of(w, set)); }),
      property<AnyId>("angular_momentum", "vec", "kg m²/s", "sum over its things about the world's origin",
                      [](const World& w, const AnyId& set) { return angular_momentum(w, things_of(w, set)); }),
      property<AnyId>("temperature", "number", "K",
                      "of its things, relative to their common motion; in J while scene.boltzmann is 1",
                      [](const World& w, const AnyId& set) { return temperature(w, things_of(w, set)); }),
      property<AnyId>("mass", "number", "kg", "sum over its things",
                      [](const World& w, const AnyId& set) { return mass(w, things_of(w, set)); }),
  };
}

/// The members of one kind, in the order of adding; one that is gone keeps its place.
template <class Id>
std::vector<Id> members(const World& world, GroupId group) {
  std::vector<Id> found;
  for (const AnyId& id : world.groups[group].members)
    if (const Id* member = std::get_if<Id>(&id)) found.push_back(*member);
  return found;
}

std::vector<ParticleId> member_hinges(const World& world, GroupId group) {
  std::vector<ParticleId> found = members<ParticleId>(world, group);
  std::erase_if(found, [&](ParticleId id) { return !world.particles.alive(id) || !world.particles[id].is_hinge(); });
  return found;
}

std::vector<Property> properties_of_group() {
  return {
      property<GroupId>("particles", "Particle[]", "",
                        "its particles, in the order of adding; of a built structure one for each vertex",
                        [](const World& w, GroupId g) { return members<ParticleId>(w, g); }),
      property<GroupId>("bodies", "Body[]", "", "its bodies, in the order of adding",
                        [](const World& w, GroupId g) { return members<BodyId>(w, g); }),
      property<GroupId>("hinges", "Particle[]", "", "those of its particles that are hinges",
                        [](const World& w, GroupId g) { return member_hinges(w, g); }),
      property<GroupId>("connections", "Connection[]", "", "its connections, in the order of adding",
                        [](const World& w, GroupId g) { return members<ConnectionId>(w, g); }),
  };
}

Table attributes(const World& world, FamilyId family) {
  Table table;
  for (const Family::Attribute& a : world.families[family].attributes) table.push_back({a.name, a.value});
  return table;
}

std::optional<Solid> solid(const World& world, FamilyId family) { return world.families[family].solid; }

std::optional<std::string> layer_of_family(const World& world, FamilyId family) {
  const std::optional<Solid> touch = solid(world, family);
  return touch && touch->layer > 0 ? std::optional(world.layers.names[touch->layer - 1]) : std::nullopt;
}

std::vector<Property> touch_of_family() {
  return {
      property<FamilyId>(
          "solid", "boolean", "",
          "whether its free particles touch shapes and each other, as balls of their radius that do not turn",
          [](const World& w, FamilyId f) { return solid(w, f).has_value(); }),
      property<FamilyId>(
          "friction", "number?", "1", "of what is solid, else nil",
          [](const World& w, FamilyId f) { return solid(w, f) ? std::optional(solid(w, f)->friction) : std::nullopt; },
          [](World& w, FamilyId f, double friction) { set_friction(w, f, friction); }),
      property<FamilyId>(
          "restitution", "number?", "1", "0 … 1, of what is solid, else nil",
          [](const World& w, FamilyId f) {
            return solid(w, f) ? std::optional(solid(w, f)->restitution) : std::nullopt;
          },
          [](World& w, FamilyId f, double restitution) { set_restitution(w, f, restitution); }),
      property<FamilyId>(
          "layer", "string?", "", "of what is solid, see scene:collide",
          [](const World& w, FamilyId f) { return layer_of_family(w, f); },
          [](World& w, FamilyId f, const std::optional<std::string>& layer) { set_layer(w, f, layer.value_or("")); }),
  };
}

std::vector<Property> properties_of_family() {
  return {
      fixed(property<FamilyId>("attributes", "table<string, number>", "each its own",
                               "values of a particle that gives none",
                               [](const World& w, FamilyId f) { return attributes(w, f); })),
      property<FamilyId>("particles", "Particle[]", "", "its living particles, in the order of making",
                         [](const World& w, FamilyId f) { return particles(w, f); }),
  };
}

}  // namespace

const Type& any_set_type() {
  static const Type type = {"AnySet", "set of things", "What groups and families tell of their things.", of_any_set(),
                            &any_thing_type()};
  return type;
}

const Type& group_type() {
  static const Type type = {"Group", "group", "A named set of things. It is gone when no member lives.",
                            properties_of_group(), &any_set_type()};
  return type;
}

const Type& family_type() {
  static const Type type = {"Family", "family", "Particles of a kind, with named numeric attributes that laws read.",
                            [] {
                              std::vector<Property> all = properties_of_family();
                              for (Property& more : touch_of_family()) all.push_back(std::move(more));
                              return all;
                            }(),
                            &any_set_type()};
  return type;
}

}  // namespace pantin::fields
