#pragma once
// For the tables of properties: a property is made of functions that read and write values of the engine's own types.
#include <optional>
#include <type_traits>
#include <utility>

#include "fields/property.hpp"

namespace pantin::fields {

/// A value, or a function of time that gives it.
template <class T>
using OfTime = std::variant<T, std::function<T(double)>>;
/// A value, or a function of age and lifetime that gives it.
template <class T>
using OrOfAge = std::variant<T, OfAge>;

/// What it is now; the function may not change the world.
template <class T>
T now(World& world, const OfTime<T>& given) {
  if (const T* value = std::get_if<T>(&given)) return *value;
  const Lock lock(world);
  return std::get<1>(given)(world.time);
}
/// The function, or an empty one.
template <class T>
std::function<T(double)> function_of(const OfTime<T>& given) {
  return given.index() == 1 ? std::get<1>(given) : std::function<T(double)>();
}

namespace detail {

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;

template <class T>
Value value_of(const T& given) {
  return given;
}
inline Value value_of(std::string_view text) { return std::string(text); }
inline Value value_of(const char* text) { return std::string(text); }
inline Value value_of(std::uint64_t count) { return static_cast<std::int64_t>(count); }
template <class Row>
Value value_of(Handle<Row> id) {
  return id ? Value(AnyId(id)) : Value();
}
template <class Row>
Value value_of(const std::vector<Handle<Row>>& ids) {
  return Things(ids.begin(), ids.end());
}
template <class T>
Value value_of(const std::optional<T>& given) {
  return given ? value_of(*given) : Value();
}

/// How a value of a type is written.
template <class T>
struct Taken;
template <Form form_, class T>
struct TakenAs {
  static constexpr Form form = form_;
  static T from(const Value& value) { return std::get<T>(value); }
};
template <Form form_, class T, class Function>
struct TakenAsEither {
  static constexpr Form form = form_;
  static std::variant<T, Function> from(const Value& value) {
    if (const T* plain = std::get_if<T>(&value)) return *plain;
    return std::get<Function>(value);
  }
};
template <>
struct Taken<double> : TakenAs<Form::number, double> {};
template <>
struct Taken<bool> : TakenAs<Form::boolean, bool> {};
template <>
struct Taken<std::string> : TakenAs<Form::text, std::string> {};
template <>
struct Taken<Vec3> : TakenAs<Form::vec, Vec3> {};
template <>
struct Taken<Quat> : TakenAs<Form::quat, Quat> {};
template <>
struct Taken<Color> : TakenAs<Form::color, Color> {};
template <>
struct Taken<Mat3> : TakenAs<Form::inertia, Mat3> {};
template <>
struct Taken<Breaking> : TakenAs<Form::breaking, Breaking> {};
template <>
struct Taken<Lifetimes> : TakenAs<Form::lifetimes, Lifetimes> {};
template <>
struct Taken<EmitterPosition> : TakenAs<Form::place, EmitterPosition> {};
template <>
struct Taken<FamilyId> {
  static constexpr Form form = Form::family;
  static FamilyId from(const Value& value) { return std::get<FamilyId>(std::get<AnyId>(value)); }
};
template <>
struct Taken<OfTime<double>> : TakenAsEither<Form::number_of_time, double, NumberOfTime> {};
template <>
struct Taken<OfTime<Vec3>> : TakenAsEither<Form::vec_of_time, Vec3, VecOfTime> {};
template <>
struct Taken<OfTime<Quat>> : TakenAsEither<Form::quat_of_time, Quat, QuatOfTime> {};
template <>
struct Taken<OrOfAge<double>> : TakenAsEither<Form::number_of_age, double, OfAge> {};
template <>
struct Taken<OrOfAge<Color>> : TakenAsEither<Form::color_of_age, Color, OfAge> {};
template <class T>
struct Taken<std::optional<T>> {
  static constexpr Form form = Taken<T>::form;
  static std::optional<T> from(const Value& value) {
    if (std::holds_alternative<std::monostate>(value)) return {};
    return Taken<T>::from(value);
  }
};

/// The type of a writer's third argument.
template <class Write>
struct Third;
template <class Write, class World_, class Id, class T>
struct Third<void (Write::*)(World_, Id, T) const> {
  using type = std::remove_cvref_t<T>;
};

template <class Id>
const Id& id_in(const AnyId& thing) {
  if constexpr (std::is_same_v<Id, AnyId>)
    return thing;
  else
    return *std::get_if<Id>(&thing);
}

}  // namespace detail

/// `read(const World&, Id)` and, where it can be written, `write(World&, Id, T)`; both without captures. Id is the handle
/// of its kind, std::monostate of the world, or AnyId.
template <class Id, class Read>
Property property(const char* name, const char* type, const char* unit, const char* doc, Read) {
  return {name, type, unit, doc, [](const World& world, const AnyId& thing) {
            return detail::value_of(Read()(world, detail::id_in<Id>(thing)));
          }};
}
template <class Id, class Read, class Write>
Property property(const char* name, const char* type, const char* unit, const char* doc, Read read, Write) {
  using T = typename detail::Third<decltype(&Write::operator())>::type;
  Property made = property<Id>(name, type, unit, doc, read);
  made.write = [](World& world, const AnyId& thing, const Value& value) {
    Write()(world, detail::id_in<Id>(thing), detail::Taken<T>::from(value));
  };
  made.form = detail::Taken<T>::form;
  made.or_nothing = detail::is_optional<T>;
  return made;
}
/// Of a number that may be infinite.
inline Property or_infinity(Property property) {
  property.or_infinity = true;
  return property;
}
/// Of a number of time that is never below 0.
inline Property as_rate(Property property) {
  property.form = Form::rate_of_time;
  return property;
}
/// Of a table that cannot be written, and is what the thing was made with.
inline Property fixed(Property property) {
  property.fixed = true;
  return property;
}
/// Messages about it begin with this word.
inline Property called(const char* word, Property property) {
  property.word = word;
  return property;
}
/// Of a Breaking, of which only these may be written.
inline Property of_parts(std::vector<std::string> parts, Property property) {
  property.parts = std::move(parts);
  return property;
}

}  // namespace pantin::fields
