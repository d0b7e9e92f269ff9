#include "fields/property.hpp"

#include <cmath>

#include "fields/check.hpp"
#include "fields/color.hpp"
#include "fields/constraint.hpp"

namespace pantin::fields {
namespace {

/// What is written to a property of this form, as messages call it.
const char* wanted(Form form) {
  switch (form) {
    case Form::number: return "a number";
    case Form::boolean: return "true or false";
    case Form::text: return "a string";
    case Form::vec: return "a vec";
    case Form::quat: return "a quat";
    case Form::color: return "a color";
    case Form::family: return "a family";
    case Form::breaking: return "loads and a length to break at";
    case Form::inertia: return "an inertia";
    case Form::place: return "a position, a box or a point";
    case Form::lifetimes: return "lifetimes";
    case Form::number_of_time:
    case Form::rate_of_time: return "a number or a function of time";
    case Form::vec_of_time: return "a vec or a function of time";
    case Form::quat_of_time: return "a quat or a function of time";
    case Form::number_of_age: return "a number or a function of age";
    case Form::color_of_age: return "a color or a function of age";
    case Form::none: break;
  }
  return "nothing";
}

template <class... T>
bool holds(const Value& value) {
  return (std::holds_alternative<T>(value) || ...);
}

bool fits(Form form, const Value& value) {
  switch (form) {
    case Form::number: return holds<double>(value);
    case Form::boolean: return holds<bool>(value);
    case Form::text: return holds<std::string>(value);
    case Form::vec: return holds<Vec3>(value);
    case Form::quat: return holds<Quat>(value);
    case Form::color: return holds<Color>(value);
    case Form::family: {
      const auto* thing = std::get_if<AnyId>(&value);
      return thing && std::holds_alternative<FamilyId>(*thing);
    }
    case Form::breaking: return holds<Breaking>(value);
    case Form::inertia: return holds<Mat3>(value);
    case Form::place: return holds<EmitterPosition>(value);
    case Form::lifetimes: return holds<Lifetimes>(value);
    case Form::number_of_time:
    case Form::rate_of_time: return holds<double, NumberOfTime>(value);
    case Form::vec_of_time: return holds<Vec3, VecOfTime>(value);
    case Form::quat_of_time: return holds<Quat, QuatOfTime>(value);
    case Form::number_of_age: return holds<double, OfAge>(value);
    case Form::color_of_age: return holds<Color, OfAge>(value);
    case Form::none: break;
  }
  return false;
}

/// What is plain, as the property has it.
Value settled(Form form, Value value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) value = static_cast<double>(*whole);
  const auto* number = std::get_if<double>(&value);
  const auto* words = std::get_if<std::string>(&value);
  const auto* vector = std::get_if<Vec3>(&value);
  if (form == Form::lifetimes && number) return Lifetimes{*number, *number};
  if (form == Form::inertia && vector) return diagonal(*vector);
  if (form == Form::place && vector) return EmitterPosition{{}, *vector, {}};
  if ((form == Form::color || form == Form::color_of_age) && words)
    if (const auto color = color_of_text(*words)) return *color;
  return value;
}

/// The value as the property has it.
Value checked(const Type& type, const Property& property, const Value& given) {
  const char* word = property.word ? property.word : type.word;
  require(property.write, word, ": ", property.name, " can be read, not written");
  if (property.or_nothing && holds<std::monostate>(given)) return given;
  const std::string_view unit = unit_in_messages(property);
  Value value = settled(property.form, given);
  require(fits(property.form, value), word, ": ", property.name, " must be ", wanted(property.form), in_brackets(unit));
  if (const auto* number = std::get_if<double>(&given)) {
    require(!std::isnan(*number), word, ": ", property.name, " must be a number", in_brackets(unit), ", got NaN");
    if (!property.or_infinity && property.form != Form::lifetimes) check_finite(*number, word, property.name, unit);
  }
  if (const auto* vector = std::get_if<Vec3>(&given)) check_finite(*vector, word, property.name, unit);
  return value;
}

const Property& known(const Type& type, std::string_view name) {
  const Property* found = find(type, name);
  require(found, type.word, ": there is no property '", name, "'");
  return *found;
}

}  // namespace

std::optional<Vec3> diagonal_of(const Mat3& m) {
  const double most = 1e-12 * (m[0][0] + m[1][1] + m[2][2]);
  const auto small = [&](double product) { return std::fabs(product) <= most; };
  if (!small(m[1][0]) || !small(m[2][0]) || !small(m[2][1])) return {};
  return vec(m[0][0], m[1][1], m[2][2]);
}

const Type& type_of(const World& world, const AnyId& thing) {
  if (const auto* constraint = std::get_if<ConstraintId>(&thing))
    return constraint_type(world.constraints[*constraint].kind);
  if (std::holds_alternative<PointId>(thing)) return point_type();
  if (std::holds_alternative<ParticleId>(thing)) return particle_type();
  if (std::holds_alternative<BodyId>(thing)) return body_type();
  if (std::holds_alternative<GroupId>(thing)) return group_type();
  if (std::holds_alternative<FamilyId>(thing)) return family_type();
  if (std::holds_alternative<ConnectionId>(thing)) return connection_type();
  if (std::holds_alternative<InteractionId>(thing)) return interaction_type();
  if (std::holds_alternative<FieldId>(thing)) return field_type();
  if (std::holds_alternative<EmitterId>(thing)) return emitter_type();
  if (std::holds_alternative<ShapeId>(thing)) return collider_type();
  return scene_type();
}

std::vector<const Property*> properties(const Type& type) {
  std::vector<const Property*> all;
  for (const Type* more = &type; more; more = more->base)
    for (const Property& property : more->properties) all.push_back(&property);
  return all;
}

const char* unit_in_messages(const Property& property) {
  return std::string_view(property.unit) == "1" ? "" : property.unit;
}

const Property* find(const Type& type, std::string_view name) {
  for (const Type* more = &type; more; more = more->base)
    for (const Property& property : more->properties)
      if (property.name == name) return &property;
  return nullptr;
}

Value read(const World& world, const AnyId& thing, std::string_view name) {
  return known(type_of(world, thing), name).read(world, thing);
}

Value plain(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* color = std::get_if<Color>(&value)) return text_of(*color);
  if (const auto* inertia = std::get_if<Mat3>(&value))
    if (const auto moments = diagonal_of(*inertia)) return *moments;
  return value;
}

bool is_plain(const Value& value) { return holds<std::monostate, double, bool, std::string, Vec3, AnyId>(value); }

void write(World& world, const AnyId& thing, std::string_view name, const Value& value) {
  const Type& type = type_of(world, thing);
  const Property& property = known(type, name);
  const Value fitting = checked(type, property, value);
  property.write(world, thing, fitting);
}

}  // namespace pantin::fields
