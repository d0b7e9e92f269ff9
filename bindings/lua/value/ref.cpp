#include "lua/value/ref.hpp"

#include <array>

#include "scene/errors.hpp"

namespace pantin::lua {
namespace {

/// With its article, by kind.
std::array<std::string, kind_count> words() {
  std::array<std::string, kind_count> all;
  const auto set = [&](Kind kind, std::string word) { all[static_cast<std::size_t>(kind)] = std::move(word); };
  for (std::size_t i = 0; i < constraint_names.size(); i++) {
    const std::string name(constraint_names[i]);
    const bool vowel = name.find_first_of("aeiou") == 0;
    if (const auto kind = static_cast<ConstraintKind>(i); kind != ConstraintKind::axis)
      set(kind_of(kind), (vowel ? "an " : "a ") + name);
  }
  set(Kind::point, "a point");
  set(Kind::particle, "a particle");
  set(Kind::body, "a body");
  set(Kind::group, "a group");
  set(Kind::family, "a family");
  set(Kind::connection, "a connection");
  set(Kind::interaction, "an interaction");
  set(Kind::field, "a field");
  set(Kind::emitter, "an emitter");
  set(Kind::collider, "a collider");
  set(Kind::event, "an event");
  set(Kind::hand, "a hand");
  set(Kind::subscription, "a subscription");
  set(Kind::structure, "a structure");
  set(Kind::shape, "a shape");
  set(Kind::draw, "scene.draw");
  set(Kind::held_keys, "scene.keys");
  set(Kind::gamepad, "scene.pad");
  set(Kind::mouse, "scene.mouse");
  set(Kind::camera, "scene.camera");
  set(Kind::saved, "scene.saved");
  set(Kind::snapshot, "a snapshot");
  set(Kind::scene, "a scene");
  return all;
}

}  // namespace

const Ref* to_ref(lua_State* state, int index) {
  return tag_of(state, index) == Tag::ref ? static_cast<const Ref*>(lua_touserdata(state, index)) : nullptr;
}

bool alive(const Ref& ref) { return std::holds_alternative<std::monostate>(ref.thing) || alive(*ref.world, ref.thing); }

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
    case Kind::collider: return check(w.shapes, ref.id<ShapeId>());
    default: return;
  }
}

const char* kind_of_thing(const Ref& ref) {
  if (ref.kind == Kind::particle && alive(ref) && ref.world->particles[ref.id<ParticleId>()].is_hinge())
    return "a hinge";
  static const std::array<std::string, kind_count> all = words();
  return all[static_cast<std::size_t>(ref.kind)].c_str();
}

std::string describe(const Ref& ref) {
  switch (ref.kind) {
    case Kind::hand: return text("hand ", ref.slot);
    case Kind::event: return "event";
    case Kind::subscription: return "subscription";
    case Kind::structure: return "structure";
    case Kind::shape: return "shape";
    case Kind::draw: return "scene.draw";
    case Kind::held_keys: return "scene.keys";
    case Kind::gamepad: return "scene.pad";
    case Kind::mouse: return "scene.mouse";
    case Kind::camera: return "scene.camera";
    case Kind::saved: return "scene.saved";
    case Kind::snapshot: return "snapshot";
    case Kind::scene: return "scene";
    default: return describe(*ref.world, ref.thing);
  }
}

}  // namespace pantin::lua
