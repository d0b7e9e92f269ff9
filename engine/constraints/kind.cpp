#include "constraints/kind.hpp"

namespace pantin {

namespace {

// (kinds) in the order of ConstraintKind
constexpr const ConstraintRule* rules[] = {&nail_rule,   &follow_rule,  &rod_rule,   &axis_rule,  &weld_rule,
                                           &orient_rule, &align_rule,   &motor_rule, &limit_rule, &on_plane_rule,
                                           &string_rule, &on_path_rule, &join_rule,  &gear_rule,  &rack_rule,
                                           &pulley_rule, &screw_rule};
static_assert(std::size(rules) == constraint_names.size());

}  // namespace

const ConstraintRule& rule_of(ConstraintKind kind) { return *rules[static_cast<std::size_t>(kind)]; }

void start_constraint(const Model& model, Constraint& c, double tolerance) {
  c.position.previous = c.position.before = c.position.now;
  c.number.previous = c.number.before = c.number.now;
  c.turn.previous = c.turn.now;
  c.position.rate = c.attract.away = c.attract.away_rate = c.attract.previous_away = c.turn.rate =
      c.turn.previous_rate = zero3();
  c.attract.excess = c.attract.excess_rate = c.attract.previous_excess = 0.0;
  if (!c.by_speed) c.number.rate = 0.0;
  c.moves = 0;
  if (rule_of(c).start != nullptr) rule_of(c).start(model, c, tolerance);
}

}  // namespace pantin
