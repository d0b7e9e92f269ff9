#include "contacts/motor_bounds.hpp"

#include <algorithm>
#include <utility>

#include "articulates/solve/conditions.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// What is turned about a position.
struct Turned {
  double mass = 0.0, inertia = 0.0;  // [kg], [kg m²]
};

bool drives_without_limit(const Model& model, const Row& row, const Condition& c) {
  if (!is_motor(row, c)) return false;
  const Constraint& of = model.constraints[c.constraint];
  return std::isinf(of.max_torque) && (of.number.rate != 0.0 || of.number.now != of.number.previous);
}

}  // namespace

void bound_motors(Articulate& a, const Model& model, const Articulates& articulates, std::span<const Contact> contacts,
                  std::span<const std::size_t> touching, const TouchSettings& settings) {
  constexpr double times_weight = 2.0;
  const auto all_about = [&](Vec3 x) {
    Turned all{a.total_mass, inertia_about(a, x)};
    const auto add = [&](std::uint32_t thing) {
      const BodyState s = state_of(model, articulates, thing, settings.drifted);
      all.mass += s.mass;
      all.inertia += s.mass * norm2(s.x - x) + largest(s.inertia);
    };
    for (const std::size_t k : touching) {
      add(contacts[k].body_a);
      if (contacts[k].body_b >= 0) add(static_cast<std::uint32_t>(contacts[k].body_b));
    }
    return all;
  };
  for (Condition& c : a.conditions) {
    const Row& r = row(a, c);
    if (c.stiff || !drives_without_limit(model, r, c)) continue;
    const Constraint& of = model.constraints[c.constraint];
    const double turned = std::fabs(of.number.now - of.number.previous),
                 speed = std::max(std::fabs(of.number.rate), turned / settings.h), given = norm(r.f) * r.lever,
                 last = c.bound_in_touch * r.lever;
    const Turned all = all_about(a.nodes[static_cast<std::size_t>(r.a)].x0);
    const double torque = 2.0 * all.inertia * speed / settings.h +
                          times_weight * norm(settings.gravity) * std::sqrt(all.mass * all.inertia) +
                          (given < 0.5 * last ? 2.0 * given : 0.0);
    c.bound_in_touch = torque / r.lever;
  }
}

void jam(Condition& motor) {
  motor.jam_force = motor.upper;
  motor.lower = motor.upper = 0.0;
}

void end_jams(Articulate& a) {
  for (Condition& c : a.conditions) {
    if (c.jam_force == 0.0) continue;
    c.upper = std::exchange(c.jam_force, 0.0);
    c.lower = -c.upper;
  }
}

void free_motors(Articulate& a) {
  for (Condition& c : a.conditions) c.bound_in_touch = infinity;
}

}  // namespace pantin
