// `name` and `alive`: what every thing has.
#include "fields/make.hpp"

namespace pantin::fields {
namespace {

/// Calls `use` with the store of a thing's kind and its id.
template <class World_, class Use>
void with_rows(World_& world, const AnyId& thing, Use&& use) {
  if (const auto* point = std::get_if<PointId>(&thing)) return use(world.points, *point);
  if (const auto* particle = std::get_if<ParticleId>(&thing)) return use(world.particles, *particle);
  if (const auto* body = std::get_if<BodyId>(&thing)) return use(world.bodies, *body);
  if (const auto* constraint = std::get_if<ConstraintId>(&thing)) return use(world.constraints, *constraint);
  if (const auto* group = std::get_if<GroupId>(&thing)) return use(world.groups, *group);
  if (const auto* family = std::get_if<FamilyId>(&thing)) return use(world.families, *family);
  if (const auto* connection = std::get_if<ConnectionId>(&thing)) return use(world.connections, *connection);
  if (const auto* interaction = std::get_if<InteractionId>(&thing)) return use(world.interactions, *interaction);
  if (const auto* field = std::get_if<FieldId>(&thing)) return use(world.fields, *field);
  if (const auto* emitter = std::get_if<EmitterId>(&thing)) return use(world.emitters, *emitter);
  if (const auto* shape = std::get_if<ShapeId>(&thing)) return use(world.shapes, *shape);
}

Value read_name(const World& world, const AnyId& thing) {
  std::string name;
  with_rows(world, thing, [&](const auto& rows, auto id) { name = rows.name(id); });
  return name;
}

void write_name(World& world, const AnyId& thing, const std::string& name) {
  if (const auto* point = std::get_if<PointId>(&thing))
    require(!world.points[*point].body, "point: name of a body's point is given with the body and stays");
  with_rows(world, thing, [&](auto& rows, auto id) { rows[id].name = name; });
}

}  // namespace

const Type& any_thing_type() {
  static const Type type = [] {
    Property name = property<AnyId>(
        "name", "string", "", "what messages and scene:find call it (default `\"\"`)",
        [](const World& w, const AnyId& thing) { return read_name(w, thing); },
        [](World& w, const AnyId& thing, const std::string& v) { write_name(w, thing, v); });
    name.of_dead = true;
    Property living = property<AnyId>("alive", "boolean", "", "whether it still exists",
                                      [](const World& w, const AnyId& thing) { return alive(w, thing); });
    living.of_dead = true;
    return Type{"AnyThing",
                "thing",
                "What every thing has; it may be a target of events and behaviours, and a member of a group.",
                {name, living}};
  }();
  return type;
}

}  // namespace pantin::fields
