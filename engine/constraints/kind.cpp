#include "constraints/kind.hpp"

namespace pantin {

namespace {

// (kinds)
constexpr const ConstraintRule* rules[] = {
#define CONSTRAINT_KIND(name) &name##_rule,
#include "model/constraint_kinds.hpp"
};

}  // namespace

const ConstraintRule& rule_of(ConstraintKind kind) { return *rules[static_cast<std::size_t>(kind)]; }

void start_constraint(const Model& model, Constraint& c, double tolerance) {
  c.position.previous = c.position.before = c.position.now;
  c.number.previous = c.number.before = c.number.now;
  c.turn.previous = c.turn.now;
  c.position.rate = c.attract.away = c.attract.away_rate = c.attract.previous_away = c.turn.rate =
      c.turn.previous_rate = zero3();
  c.attract.excess = c.attract.excess_rate = c.attract.previous_excess = c.attract.first_excess = 0.0;
  if (!c.by_speed) c.number.rate = 0.0;
  c.moves = 0;
  if (rule_of(c).start != nullptr) rule_of(c).start(model, c, tolerance);
}

}  // namespace pantin
