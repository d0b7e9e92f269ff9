#pragma once
// The userdata of a thing: a handle, which names it while it lives and its story afterwards.
#include <cstdint>
#include <lua.hpp>
#include <string>

#include "lua/value/values.hpp"
#include "world/world.hpp"

namespace pantin::lua {

struct Script;

enum class Kind : std::uint32_t {
  point,
  particle,
  body,
  constraint,  ///< the first kind of constraints; the others follow it
  group = constraint + constraint_names.size() - 1,
  family,
  connection,
  interaction,
  field,
  emitter,
  collider,
  event,
  hand,
  subscription,
  structure,
  shape,
  draw,
  held_keys,
  gamepad,
  mouse,
  camera,
  saved,
  snapshot,
  scene
};
inline constexpr std::size_t kind_count = static_cast<std::size_t>(Kind::scene) + 1;

/// Whether things of this kind are constraints.
inline bool is_constraint(Kind kind) { return kind >= Kind::constraint && kind < Kind::group; }
/// Of a constraint's thing: in the order of ConstraintKind without the axis, which is of a hinge and no thing of its own.
inline Kind kind_of(ConstraintKind kind) {
  const auto i = static_cast<std::uint32_t>(kind);
  return static_cast<Kind>(static_cast<std::uint32_t>(Kind::constraint) + i - (kind > ConstraintKind::axis ? 1 : 0));
}

/// The userdata.
struct Ref {
  Tag tag = Tag::ref;
  Kind kind = Kind::point;
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  std::uint64_t serial = 0;  ///< order of making
  Script* script = nullptr;
  const World* world = nullptr;  ///< the script's
  AnyId thing;                   ///< as the engine knows it; monostate for hands, events, structures and the like

  template <class Id>
  Id id() const {
    return {slot, generation};
  }
};

/// The thing at `index`, alive or not, or null.
const Ref* to_ref(lua_State* state, int index);
/// Whether what it names still lives.
bool alive(const Ref& ref);
/// Throws StaleHandle with its story where it is gone.
void require_alive(const Ref& ref);

/// "a body", "a hinge": for messages.
const char* kind_of_thing(const Ref& ref);
/// "body 'arm'": the thing itself.
std::string describe(const Ref& ref);

}  // namespace pantin::lua
