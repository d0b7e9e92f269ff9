// Connection, interaction and field: what makes laws act.
#include "edit/edit.hpp"
#include "fields/make.hpp"
#include "forces/forces.hpp"
#include "laws/law.hpp"

namespace pantin::fields {
namespace {

/// Calls `use` with the id of the thing, whichever of the three it is.
template <class Use>
decltype(auto) with_id(const AnyId& thing, Use&& use) {
  if (const auto* connection = std::get_if<ConnectionId>(&thing)) return use(*connection);
  if (const auto* interaction = std::get_if<InteractionId>(&thing)) return use(*interaction);
  return use(*std::get_if<FieldId>(&thing));
}

const Connection& row_of(const World& world, ConnectionId id) { return world.connections[id]; }
const Interaction& row_of(const World& world, InteractionId id) { return world.interactions[id]; }
const Field& row_of(const World& world, FieldId id) { return world.fields[id]; }

Table parameters(const World& world, const AnyId& thing) {
  return with_id(thing, [&](auto id) {
    const auto& row = row_of(world, id);
    Table table;
    for (std::size_t i = 0; i < row.parameters.size(); i++)
      table.push_back({row.law->parameters[i].name, row.parameters[i]});
    return table;
  });
}

std::vector<Property> of_any_element() {
  return {
      property<AnyId>("parameters", "table<string, number>", "each its own", "of its law: read and written by name",
                      [](const World& w, const AnyId& thing) { return parameters(w, thing); }),
      property<AnyId>("energy", "number?", "J", "of its law now; nil where the law has none",
                      [](const World& w, const AnyId& thing) {
                        return with_id(thing, [&](auto id) { return law_energy(w, id); });
                      }),
      property<AnyId>(
          "enabled", "boolean", "", "whether it acts (default `true`)",
          [](const World& w, const AnyId& thing) {
            return with_id(thing, [&](auto id) { return row_of(w, id).enabled; });
          },
          [](World& w, const AnyId& thing, bool on) { with_id(thing, [&](auto id) { set_enabled(w, id, on); }); }),
  };
}

Table ends(const World& world, ConnectionId id) {
  const Connection& row = world.connections[id];
  Table list;
  for (std::uint32_t i = 0; i < row.count; i++)
    list.push_back({"", row.particles[i] ? Value(AnyId(row.particles[i])) : Value(row.positions[i])});
  return list;
}

Breaking breaks_at(const World& world, ConnectionId id) {
  Breaking b;
  b.force = world.connections[id].max_force;
  b.length = world.connections[id].max_length;
  return b;
}

std::vector<Property> properties_of_connection() {
  return {
      fixed(property<ConnectionId>("particles", "(Particle|vec)[]", "m", "what it ties: particles, or positions",
                                   [](const World& w, ConnectionId c) { return ends(w, c); })),
      property<ConnectionId>("force", "number", "N",
                             "tension in the last step, positive where it pulls; 0 of a law of three or four",
                             [](const World& w, ConnectionId c) { return tension(w, c); }),
      of_parts({"force", "length"},
               property<ConnectionId>(
                   "breaks_at", "Breaking", "", "tension or length at which it breaks (default `{}`)",
                   [](const World& w, ConnectionId c) { return breaks_at(w, c); },
                   [](World& w, ConnectionId c, const Breaking& b) { set_breaks_at(w, c, b.force, b.length); })),
  };
}

}  // namespace

const Type& any_force_element_type() {
  static const Type type = {"AnyForceElement", "force element", "What every connection, interaction and field has.",
                            of_any_element(), &any_thing_type()};
  return type;
}

const Type& connection_type() {
  static const Type type = {"Connection", "connection", "Ties two, three or four particles by a law.",
                            properties_of_connection(), &any_force_element_type()};
  return type;
}

const Type& interaction_type() {
  static const Type type = {"Interaction",
                            "interaction",
                            "A law between all pairs of two families, or within one.",
                            {},
                            &any_force_element_type()};
  return type;
}

const Type& field_type() {
  static const Type type = {"Field",
                            "field",
                            "A law on each particle of a family, of a group or of the scene.",
                            {},
                            &any_force_element_type()};
  return type;
}

}  // namespace pantin::fields
