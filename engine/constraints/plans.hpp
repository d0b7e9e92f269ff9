#pragma once
// What entries of the table have in common.
#include "constraints/kind.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

inline RowPlan between_points(const Constraint& c, const RowRule& rule) {
  return {&rule, false, c.a, c.b, {}, {}, zero3(), zero3(), 0};
}
inline RowPlan angular_row(const Constraint& c, const RowRule& rule) {
  return {&rule, true, {}, {}, c.body_a, c.body_b, c.axis_a, c.axis_b, 0};
}

inline std::array<Vec3, 3> no_direction(const Constraint&) { return {zero3(), zero3(), zero3()}; }
/// All that are across one of unit length, or all.
inline std::array<Vec3, 3> all_across(Vec3 along) {
  std::array<Vec3, 3> list;
  for (int i = 0; i < 3; i++) {
    Vec3 axis = zero3();
    axis[i] = 1.0;
    list[static_cast<std::size_t>(i)] = axis - along * dot(along, axis);
  }
  return list;
}
inline std::array<Vec3, 3> all_directions(const Constraint&) { return all_across(zero3()); }

}  // namespace pantin
