#include "contacts/take_back.hpp"

#include "contacts/bodies.hpp"
#include "contacts/heat.hpp"

namespace pantin {

namespace {

/// Of an impulse before the drift what takes it back, at one point of both bodies: nearer to that of the lighter one, or in a free point.
void turn_back(const Model& model, const Articulates& articulates, Placing& p, bool drifted) {
  p.impulse = p.impulse * -1.0;
  p.moment = p.moment * -1.0;
  if (p.body_b < 0) return;
  const BodyState a = state_of(model, articulates, p.body_a, drifted);
  const BodyState b = state_of(model, articulates, static_cast<std::uint32_t>(p.body_b), drifted);
  const double of_b = is_point(p.body_a) ? 0.0 : a.mass / (a.mass + b.mass);
  const Vec3 at = (a.x + p.arm_a) * (1.0 - of_b) + (b.x + p.arm_b) * of_b;
  p.arm_a = at - a.x;
  p.arm_b = at - b.x;
}

}  // namespace

double take_back(Model& model, const Articulates& articulates, Contacts& contacts, bool drifted) {
  double work = 0.0;
  for (Placing& p : contacts.placed) turn_back(model, articulates, p, drifted);
  HeatOf heat(model, articulates, contacts, drifted, contacts.placed, contacts.new_heat);
  const auto add = [&](const BodyState& s, std::uint32_t thing, Vec3 arm, Vec3 impulse, Vec3 moment) {
    const double before = kinetic_energy(model, s, thing);
    add_momenta(model, s, thing, model.plane.along(impulse), cross(arm, impulse) + moment);
    work += kinetic_energy(model, s, thing) - before;
  };
  for (const Placing& p : contacts.placed) {
    add(state_of(model, articulates, p.body_a, drifted), p.body_a, p.arm_a, p.impulse, p.moment);
    if (p.body_b < 0) continue;
    const auto slot_b = static_cast<std::uint32_t>(p.body_b);
    add(state_of(model, articulates, slot_b, drifted), slot_b, p.arm_b, p.impulse * -1.0, p.moment * -1.0);
  }
  heat.add(work);
  return work;
}

}  // namespace pantin
