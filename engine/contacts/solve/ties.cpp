#include "contacts/solve/ties.hpp"

#include <algorithm>
#include <limits>

#include "contacts/solve/matrix.hpp"
#include "contacts/solve/search.hpp"

namespace pantin {

namespace {

/// Velocities dv, dw of the bodies more by what these loads make in the matrix of ties.
void add_solved(ContactIsland& island, const std::vector<BodyLoad>& loads) {
  std::vector<BodyLoad>& change = island.tie_change;
  change.resize(loads.size());
  solve(island, island.ties_alone, loads, change);
  for (std::size_t i = 0; i < change.size(); i++) {
    island.bodies[i].dv += change[i].force;
    island.bodies[i].dw += change[i].moment;
  }
}

/// Sets what ties answer at these velocities, and what that does to the bodies.
void find_answers(ContactIsland& island, std::vector<BodyLoad>& loads) {
  loads.assign(island.bodies.size(), {});
  for (IslandTie& t : island.ties) {
    t.answer = (t.u + velocity_of(t, island.bodies, &IslandBody::dv, &IslandBody::dw)) * (-tie_stiffness / t.w);
    add_load(loads, t, t.kept * t.answer);
  }
  for (IslandScalar& s : island.scalars) {
    if (s.is_bounded()) continue;
    s.answer = (s.u + velocity_of(island, s, &IslandBody::dv, &IslandBody::dw)) * (-tie_stiffness / s.w);
    add_load(island, loads, s, s.answer);
  }
}

/// Where ties all but contradict each other, round-off makes other velocities of loads than their impulses do: what is missing,
/// and whether that is much of it.
bool find_missing(const ContactIsland& island, const std::vector<BodyLoad>& loads, std::vector<BodyLoad>& missing) {
  constexpr double much = 1e-6;
  double most = 0.0, largest = 0.0;
  missing.resize(loads.size());
  for (std::size_t i = 0; i < loads.size(); i++) {
    const IslandBody& b = island.bodies[i];
    missing[i] = {loads[i].force - b.dv * b.mass, b.turning * (loads[i].moment - b.inertia * b.dw)};
    most =
        std::max(most, norm(missing[i].force) * b.inverse_mass + norm(b.inverse_inertia * missing[i].moment) * b.reach);
    largest = std::max(largest, norm(b.dv) + norm(b.dw) * b.reach);
  }
  return most > much * largest;
}

}  // namespace

void answer_of_ties(ContactIsland& island, std::vector<BodyLoad>& loads) {
  constexpr int most_refined = 4;
  if (!island.ties_prepared) {
    lay_out_ties(island);
    set_base(island, island.ties_alone, tie_stiffness);
    factorise(island, island.ties_alone, {}, {}, {}, true);
    island.ties_prepared = true;
  }
  loads.assign(island.bodies.size(), {});
  for (IslandTie& t : island.ties) {
    t.u = velocity_of(t, island.bodies, &IslandBody::v, &IslandBody::w) - t.kept * t.wanted;
    add_load(loads, t, t.u * (-tie_stiffness / t.w));
  }
  for (IslandScalar& s : island.scalars) {
    if (s.is_bounded()) continue;
    s.u = velocity_of(island, s, &IslandBody::v, &IslandBody::w) + s.bias;
    add_load(island, loads, s, s.u * (-tie_stiffness / s.w));
  }
  for (IslandBody& b : island.bodies) b.dv = b.dw = zero3();
  add_solved(island, loads);
  find_answers(island, loads);
  std::vector<BodyLoad>& missing = island.tie_missing;
  for (int i = 0; i < most_refined && find_missing(island, loads, missing); i++) {
    add_solved(island, missing);
    find_answers(island, loads);
  }
  for (IslandTie& t : island.ties) t.impulse += t.answer;
  for (IslandScalar& s : island.scalars)
    if (!s.is_bounded()) s.impulse += s.answer;
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
  for (IslandTie& t : island.ties) t.earlier_impulse -= t.kept * t.impulse;
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
  for (IslandTie& t : island.ties) t.earlier_impulse += t.kept * t.impulse;
  for (IslandScalar& s : island.scalars) {
    s.earlier_impulse += s.impulse;
    s.low -= s.impulse;
    s.high -= s.impulse;
  }
}

}  // namespace pantin
