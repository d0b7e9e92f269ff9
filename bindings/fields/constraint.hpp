#pragma once
// Properties that constraints share, and the tables of each kind.
#include "fields/make.hpp"

namespace pantin::fields {

/// The type with these properties and those that every constraint has.
Type type_of_constraint(const char* name, const char* word, const char* doc, std::vector<Property> properties);
Property point_property();  ///< that it holds
/// The number that it keeps, written as one or as a function of time.
Property kept_property(const char* name, const char* unit, const char* doc);
Property force_property();   ///< as a vec
Property torque_property();  ///< as a vec
inline const Constraint& constraint_row(const World& world, ConstraintId id) { return world.constraints[id]; }

// The types of the kinds.
#define CONSTRAINT_KIND(name) const Type& name##_type();
#include "model/constraint_kinds.hpp"

}  // namespace pantin::fields
