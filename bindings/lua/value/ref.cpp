#include "lua/value/ref.hpp"

#include "scene/errors.hpp"

namespace pantin::lua {
namespace {

const char* const words[] = {"a point",    "a particle", "a body",   "a nail",         "a follow",       "a rod",
                             "a weld",     "an orient",  "an align", "a motor",        "a limit",        "an on_plane",
                             "a string",   "an on_path", "a join",   "a gear",         "a rack",         "a pulley",
                             "a screw",    "a group",    "a family", "a connection",   "an interaction", "a field",
                             "an emitter", "an event",   "a hand",   "a subscription", "a structure",    "scene.draw",
                             "a snapshot", "a scene"};

}  // namespace

const Ref* to_ref(lua_State* state, int index) {
  return tag_of(state, index) == Tag::ref ? static_cast<const Ref*>(lua_touserdata(state, index)) : nullptr;
}

AnyId any_of(const Ref& ref) {
  if (is_constraint(ref.kind)) return ref.id<ConstraintId>();
  switch (ref.kind) {
    case Kind::point: return ref.id<PointId>();
    case Kind::particle: return ref.id<ParticleId>();
    case Kind::body: return ref.id<BodyId>();
    case Kind::group: return ref.id<GroupId>();
    case Kind::family: return ref.id<FamilyId>();
    case Kind::connection: return ref.id<ConnectionId>();
    case Kind::interaction: return ref.id<InteractionId>();
    case Kind::field: return ref.id<FieldId>();
    case Kind::emitter: return ref.id<EmitterId>();
    default: return {};
  }
}

bool alive(const Ref& ref) {
  const AnyId id = any_of(ref);
  return std::holds_alternative<std::monostate>(id) || alive(*ref.world, id);
}

void require_alive(const Ref& ref) {
  const World& w = *ref.world;
  const auto check = [](const auto& rows, auto id) {
    if (!rows.alive(id)) throw StaleHandle(rows.story(id));
  };
  if (is_constraint(ref.kind)) return check(w.constraints, ref.id<ConstraintId>());
  switch (ref.kind) {
    case Kind::point: return check(w.points, ref.id<PointId>());
    case Kind::particle: return check(w.particles, ref.id<ParticleId>());
    case Kind::body: return check(w.bodies, ref.id<BodyId>());
    case Kind::group: return check(w.groups, ref.id<GroupId>());
    case Kind::family: return check(w.families, ref.id<FamilyId>());
    case Kind::connection: return check(w.connections, ref.id<ConnectionId>());
    case Kind::interaction: return check(w.interactions, ref.id<InteractionId>());
    case Kind::field: return check(w.fields, ref.id<FieldId>());
    case Kind::emitter: return check(w.emitters, ref.id<EmitterId>());
    default: return;
  }
}

const char* kind_of_thing(const Ref& ref) {
  if (ref.kind == Kind::particle && alive(ref) && ref.world->particles[ref.id<ParticleId>()].is_hinge())
    return "a hinge";
  return words[static_cast<std::size_t>(ref.kind)];
}

std::string describe(const Ref& ref) {
  switch (ref.kind) {
    case Kind::hand: return text("hand ", ref.slot);
    case Kind::event: return "event";
    case Kind::subscription: return "subscription";
    case Kind::structure: return "structure";
    case Kind::draw: return "scene.draw";
    case Kind::snapshot: return "snapshot";
    case Kind::scene: return "scene";
    default: return describe(*ref.world, any_of(ref));
  }
}

}  // namespace pantin::lua
