#pragma once
// Things in Lua: one userdata per thing, the same value each time, so it may be a key. No finalizers; it holds a handle.
#include <array>
#include <cstdint>
#include <lua.hpp>
#include <memory>
#include <vector>

#include "lua/value/ref.hpp"

namespace pantin::lua {

/// A ref of a kind whose things the script or the scene itself numbers.
Ref make_ref(Script& script, Kind kind, std::uint32_t slot, std::uint32_t generation, std::uint64_t serial);
void push_ref(lua_State* state, const Ref& ref);
void push_thing(lua_State* state, Script& script, const AnyId& thing);
void push_ref(lua_State* state, const Ref& ref);
void push_hand(lua_State* state, Script& script, std::int32_t hand);
/// Of an event that waits.
void push_event(lua_State* state, Script& script, EventId event);
EventState state_of_event(const Ref& event);
/// What the handle of an event tells it from, and one that tells it from that.
const std::shared_ptr<EventState>& shared_state_of_event(const Ref& event);
void push_event_ref(lua_State* state, const Ref& event, const std::shared_ptr<EventState>& shared);
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

/// Pushes the table of the scene's own data for a thing; it goes with the thing.
void push_data(lua_State* state, const Ref& ref);
/// Drops the data of things that are gone.
void sweep_data(lua_State* state, Script& script);

}  // namespace pantin::lua
