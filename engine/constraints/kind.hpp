#pragma once
// What the engine knows of a kind of constraint: one file of this folder fills one entry of the table, and whoever deals
// with constraints asks the table. Their list is model/constraint_kinds.hpp. How to add one: assets/pages/adding.md.
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "constraints/row.hpp"
#include "model/model.hpp"

namespace pantin {

/// How many degrees of freedom a constraint takes from what it ties.
struct FreedomsTaken {
  long in_space = 0, in_plane = 0;
};

/// A row that a constraint wants, and which of its things and positions it ties; null b: the world.
struct RowPlan {
  const RowRule* rule = &rigid_row;
  bool angular = false;
  PointId point_a, point_b;
  BodyId body_a, body_b;                  // where no points are given
  Vec3 arm_a = zero3(), arm_b = zero3();  // [m] or axis, in the frame of a body
  std::uint32_t index = 0;
};

/// What a scene in a plane asks of a vector of a constraint, world axes: to lie in the plane, or along its normal.
struct PlaneNeed {
  std::string_view name;
  Vec3 vector = zero3();
  bool along_normal = false;
};

/// The number that a constraint keeps, where it has one that may be set.
struct KeptNumber {
  enum class Range : std::uint8_t { all, positive, not_zero };
  const char* name = nullptr;  ///< null: it has none
  const char* unit = "";
  Range range = Range::all;
  bool allows(double value) const {
    return std::isfinite(value) && (range == Range::all || value > 0.0 || (range == Range::not_zero && value != 0.0));
  }
};
inline constexpr KeptNumber kept_length{"length", "m", KeptNumber::Range::positive}, kept_angle{"angle", "rad"};

struct ConstraintRule {
  KeptNumber keeps = {};
  bool joins_points = false;      ///< its gap is one between points, as a hinge's
  bool parts_points = false;      ///< keeps its two points apart: they cannot be hinged together
  bool ends_at_position = false;  ///< its second end, where that is no point, is a position of the world
  bool orients = false;           ///< keeps an orientation in the world

  /// Throws Error, which begins with the kind's name, where it cannot be what it was given; may bring that into form, as a
  /// direction to unit length. That what it ties lives, its time constant and the number that it keeps are checked of all
  /// kinds. Null: no more is checked.
  void (*check)(const Model& model, Constraint& constraint) = nullptr;
  FreedomsTaken (*freedoms)(const Constraint& constraint) = nullptr;
  /// How messages call what leaves its point no freedom at all, as "nailed"; null where it leaves some.
  const char* (*pins)(const Constraint& constraint) = nullptr;
  /// Directions in which it holds its point in the world; zero: none.
  std::array<Vec3, 3> (*directions)(const Constraint& constraint) = nullptr;
  /// Starts anew what begins at rest: notes what is further away than `tolerance`, relative to sizes; null: never far.
  void (*start)(const Model& model, Constraint& constraint, double tolerance) = nullptr;
  /// What it misses now, but for what it still attracts [m]; null: nothing is told.
  double (*gap)(const Model& model, const Constraint& constraint) = nullptr;
  /// A length that goes with it, for what counts as small [m]; 0 or null: it has none.
  double (*size)(const Constraint& constraint) = nullptr;
  /// Distance or angle that it has now [m], [rad]; null: it has no such number.
  double (*value)(const Model& model, const Constraint& constraint) = nullptr;
  /// Sets the number that it keeps; throws Error, which begins with `call`, where it cannot be that. Null: just written.
  void (*set)(Constraint& constraint, std::string_view call, double value) = nullptr;
  /// Once its number has moved on for the coming step, from `before` in the middle of the last one; null: nothing.
  void (*follow)(const Model& model, Constraint& constraint, double before) = nullptr;
  std::vector<RowPlan> (*rows)(const Model& model, const Constraint& constraint) = nullptr;
  /// What a row is to know in the coming step beyond what all do; null: nothing.
  void (*load)(Condition& condition, const Row& row, const Model& model, const Constraint& constraint) = nullptr;
  /// Whether it keeps its value in a range, and so may be struck; null: no.
  bool (*has_range)(const Constraint& constraint) = nullptr;
  std::vector<PlaneNeed> (*in_plane)(const Model& model, const Constraint& constraint) = nullptr;  ///< null: nothing
};

const ConstraintRule& rule_of(ConstraintKind kind);
inline const ConstraintRule& rule_of(const Constraint& constraint) { return rule_of(constraint.kind); }

/// How messages call what leaves its point no freedom at all; null where it leaves some.
inline const char* pins(const Constraint& c) { return rule_of(c).pins == nullptr ? nullptr : rule_of(c).pins(c); }
/// Whether it keeps its value in a range: a limit, a string, a path with ends.
inline bool has_range(const Constraint& c) { return rule_of(c).has_range != nullptr && rule_of(c).has_range(c); }
/// Whether a number that was beyond its range at first is on its way in: until 1e-4 of that is left it is held on both sides,
/// so that it comes in as smoothly as it is to.
inline bool is_drawn_in(const Constraint& c) {
  return std::fabs(c.attract.previous_excess) > 1e-4 * std::fabs(c.attract.first_excess);
}
/// Whether a string has become as long as it was last written: it does so in the step after.
inline bool is_paid_out(const Constraint& c) { return c.number.rate != 0.0; }
/// What a constraint misses now, but for what it still attracts [m].
inline double present_gap(const Model& model, const Constraint& c) {
  return rule_of(c).gap == nullptr ? 0.0 : rule_of(c).gap(model, c);
}
/// A length that goes with a constraint, for what counts as small [m]; 0: it has none.
inline double size_of(const Constraint& c) { return rule_of(c).size == nullptr ? 0.0 : rule_of(c).size(c); }
/// Distance or angle that it has now [m], [rad].
inline double present_value(const Model& model, const Constraint& c) { return rule_of(c).value(model, c); }
/// A constraint starts anew: what is far from where it wants it is attracted, a violation within `tolerance`, relative to
/// sizes, is not one. Targets have no history.
void start_constraint(const Model& model, Constraint& constraint, double tolerance);

// The kinds, each in the file of its name.
#define CONSTRAINT_KIND(name) extern const ConstraintRule name##_rule;
#include "model/constraint_kinds.hpp"

}  // namespace pantin
