// A slider: a point stays on a line of a body, or of the world, and its own body does not turn against that. Each way that it
// keeps is a coupling of one value, so that what pulls along an axis that turns does so without work; the orientation is kept
// by a rigid angular row.
#include "constraints/slider.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "constraints/coupling.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"

namespace pantin {

namespace {

const CoupledValue& value_at(const Constraint& c, SliderValue which) {
  return c.coupled()[static_cast<std::size_t>(which)];
}

/// [m] How far its point is along its axis.
double way_of(const Model& model, const Constraint& c) { return value_of(model, value_at(c, SliderValue::along)); }

/// [m/s] How fast that grows.
double rate_of_way(const Model& model, const Constraint& c) {
  const CoupledValue& v = value_at(c, SliderValue::along);
  Vec3 apart = velocity(model, c.a);
  if (v.body_b) {
    const Motion& carrier = model.motion_of(v.body_b);
    apart -= carrier.p / carrier.mass + cross(angular_velocity(carrier), position(model, c.a) - carrier.x);
  }
  return dot(direction_of(model, v.body_b, v.axis_b), apart);
}

/// [m] By how much it is beyond what it keeps, or outside its range.
double beyond(const Model& model, const Constraint& c) {
  const double way = way_of(model, c);
  if (c.as<CouplingData>().given) return way - c.number.now;
  return std::fmax(0.0, way - c.high) + std::fmin(0.0, way - c.low);
}

void check(const Model& model, Constraint& c) {
  const BodyId carrier = value_at(c, SliderValue::across).body_b;
  require(!carrier || model.points[c.a].body != carrier, "slider: its point belongs to the carrier");
  require(c.low < c.high, "slider: min must be below max, got ", c.low, " and ", c.high, " m");
}

/// What is off its line, or turned, since it was off, slides from there.
void start(const Model& model, Constraint& c, double tolerance) {
  for (const SliderValue which : {SliderValue::across, SliderValue::across_too}) {
    CoupledValue& v = c.as<CouplingData>().values[static_cast<std::size_t>(which)];
    v.total = value_of(model, v);
  }
  if (c.body_a) {
    c.turn.now = orientation(model, c.body_a);
    if (c.body_b) c.turn.now = normalised(conjugate(orientation(model, c.body_b)) * c.turn.now);
    c.turn.previous = c.turn.now;
  }
  double size = std::fmax(size_of(model, c.a), std::fabs(c.number.now));
  for (const double end : {c.low, c.high})
    if (std::isfinite(end)) size = std::fmax(size, std::fabs(end));
  start_number(c, beyond(model, c), rate_of_way(model, c), tolerance * size);
}

double gap(const Model& model, const Constraint& c) {
  double most = 0.0;
  for (const SliderValue which : {SliderValue::across, SliderValue::across_too})
    most = std::fmax(most, std::fabs(value_of(model, value_at(c, which)) - value_at(c, which).total));
  if (c.body_a) most = std::fmax(most, lever(model, c) * norm(present_turn(model, c)));
  const double past = c.as<CouplingData>().given ? std::fabs(beyond(model, c) - c.attract.excess)
                                                 : std::fabs(beyond(model, c)) - std::fabs(c.attract.excess);
  return std::fmax(most, past);
}

/// Of the two ways across the line that which leaves a scene's plane.
SliderValue across_plane(const Model& model, const Constraint& c) {
  const auto leaves = [&](SliderValue which) {
    const Vec3 axis = direction_of(model, value_at(c, which).body_b, value_at(c, which).axis_b);
    return norm(axis - model.plane.along(axis));
  };
  return leaves(SliderValue::across) > leaves(SliderValue::across_too) ? SliderValue::across : SliderValue::across_too;
}

bool is_kept(const Model& model, const Constraint& c, SliderValue which) {
  const bool given = c.as<CouplingData>().given;
  switch (which) {
    case SliderValue::along: return given;
    case SliderValue::to_max: return !given && std::isfinite(c.high);
    case SliderValue::to_min: return !given && std::isfinite(c.low);
    default: return !model.plane.flat() || which != across_plane(model, c);
  }
}

std::vector<RowPlan> rows(const Model& model, const Constraint& c) {
  std::vector<RowPlan> plans;
  for (std::uint32_t i = 0; i < slider_values; i++)
    if (is_kept(model, c, static_cast<SliderValue>(i))) add_coupled_rows(plans, c.coupled()[i], i);
  if (!c.body_a) return plans;
  plans.push_back(angular_row(c, rigid_row));
  plans.back().index = slider_values;
  return plans;
}

/// What the way may be less the number or end, and how that comes in: `sign` -1 where it is counted the other way.
void load_end(Condition& condition, const Constraint& c, double end, double sign) {
  const Attraction& attract = c.attract;
  condition.ranged = !(is_drawn_in(c) && sign * attract.first_excess > 0.0);
  condition.whole_value0 = sign * end + std::fmax(0.0, sign * attract.previous_excess);
  condition.whole_value1 = sign * end + std::fmax(0.0, sign * attract.excess);
  condition.value_rate = condition.ranged ? 0.0 : sign * attract.excess_rate;
}

void load_along(Condition& condition, const Constraint& c) {
  condition.whole_value0 = c.number.previous + c.attract.previous_excess;
  condition.whole_value1 = c.number.now + c.attract.excess;
  condition.value_rate = c.number.rate + c.attract.excess_rate;
  condition.bent = c.bend.straight() ? Bent::nothing : Bent::value;
  condition.bend = c.bend;
}

void load(Condition& condition, const Row& row, const Model&, const Constraint& c) {
  condition.whole_value0 = condition.whole_value1 = condition.value_rate = 0.0;
  condition.bent = Bent::nothing;
  condition.driven =
      condition.driven && is_coupled(row) && condition.index == static_cast<std::uint32_t>(SliderValue::along);
  if (!is_coupled(row)) return;
  switch (static_cast<SliderValue>(condition.index)) {
    case SliderValue::along: load_along(condition, c); break;
    case SliderValue::to_max: load_end(condition, c, c.high, 1.0); break;
    case SliderValue::to_min: load_end(condition, c, c.low, -1.0); break;
    default: condition.whole_value0 = condition.whole_value1 = c.coupled()[condition.index].total;
  }
  condition.works_along_d = condition.ranged || condition.whole_value0 != condition.whole_value1;
}

std::vector<PlaneNeed> in_plane(const Model& model, const Constraint& c) {
  const CoupledValue &along = value_at(c, SliderValue::along), &across = value_at(c, across_plane(model, c));
  return {{"axis", direction_of(model, along.body_b, along.axis_b), false},
          {"one way across the line", direction_of(model, across.body_b, across.axis_b), true}};
}

}  // namespace

const ConstraintRule slider_rule = {
    .keeps = {"length", "m"},
    .check = check,
    .freedoms =
        [](const Constraint& c) {
          const long turns = c.body_a ? 1 : 0, along = c.as<CouplingData>().given ? 1 : 0;
          return FreedomsTaken{2 + 3 * turns + along, 1 + turns + along};
        },
    .directions =
        [](const Constraint& c) {
          const CoupledValue& v = value_at(c, SliderValue::along);
          return v.body_b ? no_direction(c) : all_across(c.as<CouplingData>().given ? zero3() : v.axis_b);
        },
    .start = start,
    .gap = gap,
    .value = way_of,
    .set =
        [](Constraint& c, std::string_view, double value) {
          c.as<CouplingData>().given = true;
          c.number.now = value;
        },
    .rows = rows,
    .load = load,
    .in_plane = in_plane,
};

}  // namespace pantin
