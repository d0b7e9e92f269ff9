#include "articulates/solve/wanted_velocities.hpp"

#include "articulates/solve/conditions.hpp"

namespace pantin {

namespace {

/// Adds the rate of the bend `at` a moment, `times` 1/step; the velocity of an angular row is that of lever times the turn.
void add_bend(Condition& c, double lever, double times, double at) {
  if (c.bent == Bent::nothing) return;
  const Vec3 rate = c.bend.rate(at) * times;
  if (c.bent == Bent::value)
    c.value_rate += rate[0];
  else
    c.velocity += c.bent == Bent::turn ? rate * lever : rate;
}

/// Sets what a condition wants at the moment from what it wants at the end of the step.
void want(Condition& c, double lever, double step, double at) {
  c.weight1 = c.weight0 + (c.weight1 - c.weight0) * at;
  if (c.by_speed) {
    c.value_rate = speed(c, at);
    return;
  }
  add_bend(c, lever, -1.0 / step, 1.0);
  const double start_rate = (c.whole_value1 - c.whole_value0) / step * 2.0 - c.value_rate;
  c.value_rate = start_rate + (c.value_rate - start_rate) * at;
  if (lever == 0.0 || is_turned(c)) {
    const Vec3 mean = lever == 0.0 ? (c.whole1 - c.whole0) / step : turn_in_step(c) * (lever / step);
    const Vec3 start = mean * 2.0 - c.velocity;
    c.velocity = start + (c.velocity - start) * at;
  }
  add_bend(c, lever, 1.0 / step, at);
}

}  // namespace

WantedVelocities::WantedVelocities(Articulate& articulate, double step, double at) : a_(articulate) {
  for (const Condition& c : a_.conditions) at_end_.push_back({c.velocity, c.value_rate, c.weight1});
  for (const Row& row : a_.rows)
    if (row.condition >= 0) want(a_.conditions[static_cast<std::size_t>(row.condition)], row.lever, step, at);
}

WantedVelocities::~WantedVelocities() {
  for (std::size_t k = 0; k < a_.conditions.size(); k++)
    std::tie(a_.conditions[k].velocity, a_.conditions[k].value_rate, a_.conditions[k].weight1) = at_end_[k];
}

}  // namespace pantin
