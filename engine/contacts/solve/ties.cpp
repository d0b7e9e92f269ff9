#include "contacts/solve/ties.hpp"

#include <algorithm>
#include <limits>

#include "contacts/solve/matrix.hpp"
#include "contacts/solve/search.hpp"

namespace pantin {

void answer_of_ties(ContactIsland& island, std::vector<BodyLoad>& loads) {
  if (!island.ties_prepared) {
    lay_out_ties(island);
    set_base(island, island.ties_alone);
    factorise(island, island.ties_alone, {}, {}, {}, true);
    island.ties_prepared = true;
  }
  loads.assign(island.bodies.size(), {});
  for (IslandTie& t : island.ties) {
    t.u = velocity_of(t, island.bodies, &IslandBody::v, &IslandBody::w) - t.kept * t.wanted + t.impulse * t.softness;
    add_load(loads, t, t.u * -stiffness_of(t));
  }
  for (IslandScalar& s : island.scalars) {
    if (s.is_bounded()) continue;
    s.u = velocity_of(island, s, &IslandBody::v, &IslandBody::w) + s.bias;
    add_load(island, loads, s, s.u * (-tie_stiffness / s.w));
  }
  std::vector<BodyLoad>& change = island.tie_change;
  change.resize(loads.size());
  solve(island, island.ties_alone, loads, change);
  for (std::size_t i = 0; i < change.size(); i++) {
    island.bodies[i].dv = change[i].force;
    island.bodies[i].dw = change[i].moment;
    loads[i] = {};
  }
  for (IslandTie& t : island.ties) {
    const Vec3 du = velocity_of(t, island.bodies, &IslandBody::dv, &IslandBody::dw);
    const Vec3 impulse = (t.u + du) * -stiffness_of(t);
    t.impulse += impulse;
    add_load(loads, t, t.kept * impulse);
  }
  for (IslandScalar& s : island.scalars) {
    if (s.is_bounded()) continue;
    const double du = velocity_of(island, s, &IslandBody::dv, &IslandBody::dw),
                 impulse = (s.u + du) * (-tie_stiffness / s.w);
    s.impulse += impulse;
    add_load(island, loads, s, impulse);
  }
}

namespace {

/// Ties and couplings alone: a linear problem.
void hold_linear(ContactIsland& island) {
  constexpr int rounds = 2;  // each leaves some 1e-7 of what the one before did
  std::vector<BodyLoad> loads;
  for (int round = 0; round < rounds; round++) {
    answer_of_ties(island, loads);
    for (std::size_t i = 0; i < loads.size(); i++) {
      IslandBody& b = island.bodies[i];
      b.v += loads[i].force * b.inverse_mass;
      b.w += b.inverse_inertia * loads[i].moment;
    }
  }
}

/// With what holds within bounds: contacts are set aside.
void hold_within_bounds(ContactIsland& island) {
  constexpr std::uint32_t most_iterations = 50;
  std::vector<IslandContact> contacts;
  std::vector<IslandRoll> rolls;
  contacts.swap(island.contacts);
  rolls.swap(island.rolls);
  std::swap(island.all, island.ties_alone);
  lay_out_all(island, std::numeric_limits<std::size_t>::max());
  newton_search(island, most_iterations);
  std::swap(island.all, island.ties_alone);
  island.ties_prepared = false;
  contacts.swap(island.contacts);
  rolls.swap(island.rolls);
}

}  // namespace

double work_of_ties(const ContactIsland& island) {
  double sum = 0.0;
  for (const IslandTie& t : island.ties) sum += dot(t.kept * (t.wanted + t.turning), t.impulse);
  for (const IslandScalar& s : island.scalars) sum -= s.bias * s.impulse;
  return sum;
}

void forget_turning(ContactIsland& island) {
  for (IslandTie& t : island.ties) {
    t.wanted += t.turning;
    t.turning = zero3();
  }
}

void forget_held(ContactIsland& island) {
  for (IslandTie& t : island.ties) {
    t.earlier_impulse -= t.kept * t.impulse;
    t.wanted += t.impulse * t.softness;
  }
  for (IslandScalar& s : island.scalars) {
    s.earlier_impulse -= s.impulse;
    s.low += s.impulse;
    s.high += s.impulse;
  }
}

void hold_ties(ContactIsland& island) {
  if (!island.is_tied()) return;
  weigh_ties(island);
  start_without_impulses(island);
  for (IslandTie& t : island.ties) t.impulse = zero3();
  for (IslandScalar& s : island.scalars) s.impulse = std::clamp(0.0, s.low, s.high);
  const auto bounded = [](const IslandScalar& s) { return s.is_bounded(); };
  if (std::any_of(island.scalars.begin(), island.scalars.end(), bounded))
    hold_within_bounds(island);
  else
    hold_linear(island);
  for (IslandBody& b : island.bodies) {
    b.v0 = b.v;
    b.w0 = b.w;
  }
  for (IslandTie& t : island.ties) {
    t.earlier_impulse += t.kept * t.impulse;
    t.wanted -= t.impulse * t.softness;
  }
  for (IslandScalar& s : island.scalars) {
    s.earlier_impulse += s.impulse;
    s.low -= s.impulse;
    s.high -= s.impulse;
  }
}

}  // namespace pantin
