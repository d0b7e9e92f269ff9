#pragma once
// Properties that constraints share, and the tables of each kind.
#include "fields/make.hpp"

namespace pantin::fields {

/// The type with these properties and those that every constraint has.
Type type_of_constraint(const char* name, const char* word, const char* doc, std::vector<Property> properties);
Property point_property();   ///< that it holds
Property force_property();   ///< as a vec
Property torque_property();  ///< as a vec
inline const Constraint& constraint_row(const World& world, ConstraintId id) { return world.constraints[id]; }

const Type& nail_type();
const Type& follow_type();
const Type& rod_type();
const Type& weld_type();
const Type& orient_type();
const Type& align_type();
const Type& motor_type();
const Type& limit_type();
const Type& on_plane_type();
const Type& string_type();
const Type& on_path_type();
const Type& join_type();
const Type& gear_type();
const Type& rack_type();
const Type& pulley_type();
const Type& screw_type();

}  // namespace pantin::fields
