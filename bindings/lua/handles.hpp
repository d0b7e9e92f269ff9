#pragma once
// Things in Lua: one userdata per thing, the same value each time, so it may be a key. No finalizers; it holds a handle.
#include <array>
#include <cstdint>
#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lua/values.hpp"
#include "world/world.hpp"

namespace pantin::lua {

struct Script;

enum class Kind : std::uint32_t {
  point,
  particle,
  body,
  nail,
  follow,
  rod,
  weld,
  orient,
  align,
  motor,
  limit,
  on_plane,
  string,
  on_path,
  join,
  group,
  family,
  connection,
  interaction,
  field,
  emitter,
  event,
  hand,
  subscription,
  structure,
  draw,
  snapshot,
  scene
};
inline constexpr std::size_t kind_count = 28;

/// Whether things of this kind are constraints.
inline bool is_constraint(Kind kind) { return kind >= Kind::nail && kind <= Kind::join; }

/// The userdata.
struct Ref {
  Tag tag = Tag::ref;
  Kind kind = Kind::point;
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  std::uint64_t serial = 0;  ///< order of making
  Script* script = nullptr;

  template <class Id>
  Id id() const {
    return {slot, generation};
  }
};

/// The thing at `index`, alive or not, or null.
const Ref* to_ref(lua_State* state, int index);
/// The ref as the engine knows it; monostate for hands, events, subscriptions, structures and scenes.
AnyId any_of(const Ref& ref);

void push_thing(lua_State* state, Script& script, const AnyId& thing);
void push_ref(lua_State* state, const Ref& ref);
void push_hand(lua_State* state, Script& script, std::int32_t hand);
/// Of an event that waits.
void push_event(lua_State* state, Script& script, EventId event);
EventState state_of_event(const Ref& event);
/// Pushes a list { thing, … }.
template <class Id>
void push_list(lua_State* state, Script& script, const std::vector<Id>& ids) {
  lua_createtable(state, static_cast<int>(ids.size()), 0);
  lua_Integer i = 0;
  for (const Id& id : ids) {
    push_thing(state, script, id);
    lua_rawseti(state, -2, ++i);
  }
}

/// Whether what it names still lives.
bool alive(const Ref& ref);
/// Throws StaleHandle with its story where it is gone.
void require_alive(const Ref& ref);

/// "a body", "a hinge": for messages.
const char* kind_of_thing(lua_State* state, int index);
/// "body 'arm'": the thing itself.
std::string describe(const Ref& ref);

/// Pushes the table of the scene's own data for a thing; it goes with the thing.
void push_data(lua_State* state, const Ref& ref);
/// Drops the data of things that are gone.
void sweep_data(lua_State* state, Script& script);

}  // namespace pantin::lua
