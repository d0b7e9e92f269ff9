#pragma once
// The properties of every kind of thing, in one table per kind: scripts, the inspector, the annotations for editors and
// the reference all have them from here.
#include <string>
#include <string_view>
#include <vector>

#include "fields/value.hpp"
#include "world/world.hpp"

namespace pantin::fields {

/// What may be written to a property: `number` is a double in Value, `family` a thing, `place` an EmitterPosition;
/// those of time and of age are a value or a function that gives it; a rate is not below 0.
enum class Form : std::uint8_t {
  none,
  number,
  boolean,
  text,
  vec,
  quat,
  color,
  family,
  breaking,
  inertia,
  place,
  lifetimes,
  number_of_time,
  rate_of_time,
  vec_of_time,
  quat_of_time,
  number_of_age,
  color_of_age
};

struct Property {
  const char* name;
  const char* type;  ///< as annotations write it: "number", "vec", "Point[]"
  const char* unit;  ///< "" where there is none, "1" of a number or vec without
  const char* doc;   ///< of what may be written before it is read, with "(default `1/240`)" at its end
  Value (*read)(const World&, const AnyId&);
  void (*write)(World&, const AnyId&, const Value&) = nullptr;  ///< null: cannot be written
  Form form = Form::none;
  bool or_nothing = false;              ///< may be written as nothing
  bool or_infinity = false;             ///< a number that need not be finite
  bool of_dead = false;                 ///< may be read of a thing that is gone
  bool fixed = false;                   ///< a table of what it was made with, which a script may think it can change
  const char* word = nullptr;           ///< begins messages instead of the type's
  std::vector<std::string> parts = {};  ///< of a Breaking: which of its numbers may be written
};

struct Type {
  const char* name;  ///< "Body"
  const char* word;  ///< "body": begins messages
  const char* doc;
  std::vector<Property> properties;  ///< without the base's
  const Type* base = nullptr;        ///< says once what it has in common with others
};

// What several have in common.
const Type& any_thing_type();
const Type& any_constraint_type();
const Type& any_force_element_type();
const Type& any_set_type();
const Type& any_scene_type();  ///< what is measured of the whole world

const Type& point_type();
const Type& particle_type();
const Type& body_type();
const Type& constraint_type(ConstraintKind kind);
const Type& connection_type();
const Type& interaction_type();
const Type& field_type();
const Type& group_type();
const Type& family_type();
const Type& emitter_type();
const Type& collider_type();
/// The settings of the world, which is no thing: its AnyId is std::monostate.
const Type& scene_type();

/// Of a living thing, or of the world.
const Type& type_of(const World& world, const AnyId& thing);
/// Its properties and its bases', in the order in which they are shown.
std::vector<const Property*> properties(const Type& type);
/// Null where it has none of this name.
const Property* find(const Type& type, std::string_view name);

/// Its unit, but "" of a number without one.
const char* unit_in_messages(const Property& property);

/// What a property of a living thing is now. Throws Error that names it where there is none of this name.
Value read(const World& world, const AnyId& thing, std::string_view name);
/// As a person reads it: a color as its text, an inertia without products as the vec of its diagonal, a whole number as a
/// number.
Value plain(const Value& value);
/// Whether it is nothing, a number, a truth, a text, a vec or a thing: what can be shown in a line.
bool is_plain(const Value& value);
/// Writes it between two steps; what is `plain` may be given, too. Throws Error that names it where that cannot be, or
/// where the value does not fit.
void write(World& world, const AnyId& thing, std::string_view name, const Value& value);

}  // namespace pantin::fields
