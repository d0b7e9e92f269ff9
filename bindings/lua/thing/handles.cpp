#include "lua/thing/handles.hpp"

#include <set>

#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

lua_Integer key_of(const Ref& ref) {
  return static_cast<lua_Integer>((static_cast<std::uint64_t>(ref.generation) << 32) | ref.slot);
}

/// Pushes the registry's table at a key of the script, and makes it where it is not there yet.
void push_registry_table(lua_State* state, const void* key, bool weak) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, key) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  if (weak) make_weak(state, "v");
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, key);
}

template <class Row>
Ref ref_of(Script& script, Kind kind, Handle<Row> id, const Store<Row>& rows) {
  Ref ref = make_ref(script, kind, id.slot, id.generation, rows.alive(id) ? rows[id].serial : 0);
  if constexpr (std::is_constructible_v<AnyId, Handle<Row>>) ref.thing = id;
  return ref;
}

/// An event is told how it ended after its row is gone.
struct EventRef : Ref {
  std::shared_ptr<EventState> state;
};

int drop_event(lua_State* state) {
  static_cast<EventRef*>(lua_touserdata(state, 1))->state.reset();
  return 0;
}

/// Leaves the thing's value at the top and returns true, or pushes nothing.
bool push_known(lua_State* state, const Ref& ref) {
  luaL_checkstack(state, 6, nullptr);
  push_registry_table(state, &ref.script->keys[static_cast<std::size_t>(ref.kind)], true);
  lua_rawgeti(state, -1, key_of(ref));
  lua_remove(state, -2);
  if (!lua_isnil(state, -1)) return true;
  lua_pop(state, 1);
  return false;
}

/// Gives the new userdata at the top its metatable and remembers it.
void remember(lua_State* state, const Ref& ref) {
  push_metatable(state, ref.kind);
  lua_setmetatable(state, -2);
  push_registry_table(state, &ref.script->keys[static_cast<std::size_t>(ref.kind)], true);
  lua_pushvalue(state, -2);
  lua_rawseti(state, -2, key_of(ref));
  lua_pop(state, 1);
}

/// What the script holds of a constraint that is gone, whatever its kind was; false, and nothing is pushed, where it holds none.
bool push_gone(lua_State* state, Script& script, ConstraintId id) {
  for (const ConstraintKind kind : {
#define CONSTRAINT_KIND(name) ConstraintKind::name,
#include "model/constraint_kinds.hpp"
       })
    if (push_known(state, make_ref(script, kind_of(kind), id.slot, id.generation, 0))) return true;
  return false;
}

}  // namespace

Ref make_ref(Script& script, Kind kind, std::uint32_t slot, std::uint32_t generation, std::uint64_t serial) {
  return {Tag::ref, kind, slot, generation, serial, &script, &script.world, {}};
}

void push_ref(lua_State* state, const Ref& ref) {
  if (push_known(state, ref)) return;
  *static_cast<Ref*>(lua_newuserdatauv(state, sizeof(Ref), 0)) = ref;
  remember(state, ref);
}

void push_thing(lua_State* state, Script& script, const AnyId& thing) {
  const World& w = script.world;
  if (const auto* point = std::get_if<PointId>(&thing))
    return push_ref(state, ref_of(script, Kind::point, *point, w.points));
  if (const auto* particle = std::get_if<ParticleId>(&thing))
    return push_ref(state, ref_of(script, Kind::particle, *particle, w.particles));
  if (const auto* body = std::get_if<BodyId>(&thing))
    return push_ref(state, ref_of(script, Kind::body, *body, w.bodies));
  if (const auto* group = std::get_if<GroupId>(&thing))
    return push_ref(state, ref_of(script, Kind::group, *group, w.groups));
  if (const auto* family = std::get_if<FamilyId>(&thing))
    return push_ref(state, ref_of(script, Kind::family, *family, w.families));
  if (const auto* connection = std::get_if<ConnectionId>(&thing))
    return push_ref(state, ref_of(script, Kind::connection, *connection, w.connections));
  if (const auto* interaction = std::get_if<InteractionId>(&thing))
    return push_ref(state, ref_of(script, Kind::interaction, *interaction, w.interactions));
  if (const auto* field = std::get_if<FieldId>(&thing))
    return push_ref(state, ref_of(script, Kind::field, *field, w.fields));
  if (const auto* emitter = std::get_if<EmitterId>(&thing))
    return push_ref(state, ref_of(script, Kind::emitter, *emitter, w.emitters));
  if (const auto* shape = std::get_if<ShapeId>(&thing))
    return push_ref(state, ref_of(script, Kind::collider, *shape, w.shapes));
  if (const auto* id = std::get_if<ConstraintId>(&thing)) {
    if (!w.constraints.alive(*id) && push_gone(state, script, *id)) return;
    const Kind kind = w.constraints.alive(*id) ? kind_of(w.constraints[*id].kind) : Kind::constraint;
    return push_ref(state, ref_of(script, kind, *id, w.constraints));
  }
  lua_pushnil(state);
}

void push_hand(lua_State* state, Script& script, std::int32_t hand) {
  const auto slot = static_cast<std::uint32_t>(hand + 1);
  push_ref(state, make_ref(script, Kind::hand, slot, 1, slot));
}

void push_event(lua_State* state, Script& script, EventId event) {
  const auto& events = script.world.choreography.events;
  const Ref ref = ref_of(script, Kind::event, event, events);
  push_event_ref(state, ref, events.alive(event) ? events[event].state : nullptr);
}

void push_event_ref(lua_State* state, const Ref& ref, const std::shared_ptr<EventState>& shared) {
  if (push_known(state, ref)) return;
  new (lua_newuserdatauv(state, sizeof(EventRef), 0)) EventRef{ref, shared};
  push_metatable(state, Kind::event);
  lua_pushcfunction(state, drop_event);
  lua_setfield(state, -2, "__gc");
  lua_pop(state, 1);
  remember(state, ref);
}

EventState state_of_event(const Ref& event) { return *shared_state_of_event(event); }

const std::shared_ptr<EventState>& shared_state_of_event(const Ref& event) {
  return static_cast<const EventRef&>(event).state;
}

namespace {
/// The data of a group stay while its set is there, even an empty one.
bool in_store(const Ref& ref) {
  return ref.kind == Kind::group ? ref.script->world.groups.alive(ref.id<GroupId>()) : alive(ref);
}
}  // namespace

void push_data(lua_State* state, const Ref& ref) {
  Script& script = *ref.script;
  push_registry_table(state, &script.keys[kind_count], false);
  push_ref(state, ref);
  if (lua_rawget(state, -2) == LUA_TNIL) {
    lua_pop(state, 1);
    if (++script.data_count >= script.data_sweep) sweep_data(state, script);
    push_ref(state, ref);
    lua_newtable(state);
    lua_pushvalue(state, -1);
    lua_insert(state, -3);
    lua_rawset(state, -4);
  }
  lua_remove(state, -2);
}

void sweep_data(lua_State* state, Script& script) {
  push_registry_table(state, &script.keys[kind_count], false);
  script.data_count = 0;
  std::set<AnyId> untold;
  for (const Notice& notice : script.world.notices) untold.insert(notice.thing);
  lua_pushnil(state);
  while (lua_next(state, -2)) {
    lua_pop(state, 1);
    const Ref* ref = to_ref(state, -1);
    require(ref != nullptr, "data belongs to no thing");
    if (in_store(*ref) || untold.contains(ref->thing)) {
      script.data_count++;
      continue;
    }
    lua_pushvalue(state, -1);
    lua_pushnil(state);
    lua_rawset(state, -4);
  }
  lua_pop(state, 1);
  script.data_sweep = std::max<std::size_t>(64, 2 * script.data_count);
}

}  // namespace pantin::lua
