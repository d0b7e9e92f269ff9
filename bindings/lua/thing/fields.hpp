#pragma once
// What each type of thing has in Lua, in one table per type: the properties of bindings/fields, fields whose values are
// Lua's own, and methods. The bindings, the annotations for editors and the messages about unknown names come from it.
#include <lua.hpp>
#include <string>
#include <vector>

#include "fields/property.hpp"
#include "lua/thing/handles.hpp"

namespace pantin::lua {

/// A call on a thing.
struct Self {
  lua_State* state;
  const Ref& ref;
  Script& script;
  World& world;
};

/// A property of bindings/fields, or a field that only Lua has.
struct Field {
  const char* name;
  const char* type;
  const char* unit;
  const char* doc;
  void (*read)(const Self&);              ///< pushes the value; null: as the property has it
  void (*write)(const Self&, int index);  ///< null: as the property has it, or it cannot be written
  bool of_dead = false;                   ///< may be read of a thing that is gone
  const fields::Property* property = nullptr;
};
bool writable(const Field& field);
/// The table at the top, a copy of what a thing has in a field, is told to be one when a script writes into it.
void lock_copy(lua_State* state, const char* word, const char* name, bool can_be_written);

struct Method {
  const char* name;
  lua_CFunction function;  ///< guarded
  const char* parameters;  ///< as annotations write them: "force: vec [N], at?: vec [m]"
  const char* returns;     ///< type, or ""
  const char* doc;
  const char* example = "";  ///< one to three lines, which run after `example_scene` or `example_test`
};

struct Type {
  const char* name;  ///< "Body"
  const char* word;  ///< "body": begins messages
  const char* doc;
  std::vector<Field> fields;
  std::vector<Method> methods;
  bool (*more)(const Self&, const char* name) = nullptr;  ///< pushes a value that only this one has, or returns false
  bool (*write_more)(const Self&, const char* name, int index) = nullptr;  ///< writes one, or returns false
  std::vector<std::string> (*more_names)(const Self&) = nullptr;           ///< what `more` has, where it says so
  const char* more_doc = "";                                               ///< type and meaning of those values
  lua_CFunction length = nullptr;                                          ///< of `#`
  const Type* base = nullptr;  ///< says once what it has in common with others; its fields and methods are here, too
};

/// Pushes a function that is no method, called with no more arguments than its annotation has; its first upvalue is the script.
void push_maker(lua_State* state, const Method& maker, Script& script);

const Type& type_of(Kind kind);
const Type& type_of_opened_scene();
/// All types that a script can meet, tests' included.
std::vector<const Type*> all_types();
/// What several of them have in common, each after its own base.
std::vector<const Type*> base_types();

/// Pushes the metatable of a kind of thing.
void push_metatable(lua_State* state, Kind kind);
/// Pushes the metatable of a type.
void push_metatable(lua_State* state, const Type& type);

/// The thing on which a method was called: argument 1, alive. `call` is the method's name.
Self check_self(lua_State* state, Kind kind, const char* call);
/// The same for a thing that may be gone.
Self check_self_or_dead(lua_State* state, Kind kind, const char* call);

/// Its properties, without its base's, as fields.
std::vector<Field> fields_of(const fields::Type& type);
/// The type with its properties, without its base's.
Type type_with(const fields::Type& type);
/// The field of this name, which there is: to give a property a way of being read that is Lua's own.
Field& field_named(Type& type, std::string_view name);
/// Reads the field "energy", of laws that see what the script has changed so far.
void read_energy(const Self& self);
/// Gives a type what it has in common with others: the fields of a base and of the base's base.
void add_base(Type& type, const Type& base);
/// `remove`, which a group has its own of.
void add_common_remove(Type& type);

/// Whether a type has a field or method of this name.
bool has_member(const Type& type, const std::string& name);

const Type& any_thing_type();
const Type& any_constraint_type();
const Type& any_force_element_type();
const Type& any_set_type();
const Type& any_scene_type();
const Type& point_type();
const Type& particle_type();
const Type& body_type();
const Type& constraint_type(Kind kind);
const Type& group_type();
const Type& family_type();
const Type& connection_type();
const Type& interaction_type();
const Type& field_type();
const Type& emitter_type();
const Type& collider_type();
const Type& event_type();
const Type& hand_type();
const Type& subscription_type();
const Type& structure_type();
const Type& shape_type();
const Type& draw_type();
const Type& held_keys_type();
const Type& gamepad_type();
const Type& mouse_type();
const Type& camera_type();
const Type& saved_type();
const Type& snapshot_type();
const Type& scene_type();

}  // namespace pantin::lua
