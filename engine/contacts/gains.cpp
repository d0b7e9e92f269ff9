#include "contacts/gains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "articulates/solve/momenta.hpp"
#include "base/sets.hpp"
#include "contacts/bodies.hpp"
#include "contacts/turn_back.hpp"

namespace pantin {

namespace {

/// Islands before and after the drift that share a thing: 1 … in the order of both; 0 stands for what is in none.
struct Joined {
  std::vector<const TouchIsland*> islands = {nullptr};
  std::vector<std::size_t> owner;  // (things, by number)
  Sets sets;

  Joined(const Model& model, std::span<const TouchIsland> placed, std::span<const TouchIsland> met)
      : owner(model.bodies.slots() + (model.solids ? model.points.slots() : 0), 0),
        sets(placed.size() + met.size() + 1) {
    for (const std::span<const TouchIsland> some : {placed, met})
      for (const TouchIsland& island : some) islands.push_back(&island);
    for (std::size_t i = 1; i < islands.size(); i++)
      for (const std::uint32_t thing : islands[i]->things) {
        const std::size_t number = number_of(model, thing);
        if (number >= owner.size()) continue;
        if (owner[number] != 0) sets.join(owner[number], i);
        owner[number] = i;
      }
  }
};

/// Whether it is a motor with a largest torque: it does not restore at once what it lost.
bool gives_way_to_slowing(const Condition& c) { return is_limited(c) && std::isinf(c.bound_in_touch); }

/// Of islands that are joined, whether any of them is this.
struct Traits {
  bool missed = false, tied = false, driven = false, held = false, rubs_on_world = false, rebounds = false;
  double enough = 0.0;  // [J] the kinetic energy, and what gravity would give in a step from rest

  void add(const TouchIsland& island, const Articulates& articulates) {
    missed = missed || island.missed;
    tied = tied || !island.articulates.empty();
    for (const std::uint32_t index : island.articulates) {
      const Articulate& a = *articulates[index];
      held = held || !is_free(a);
      for (const Condition& c : a.conditions)
        driven = driven || (!gives_way_to_slowing(c) && (c.value_rate != 0.0 || norm2(c.velocity) > 0.0));
    }
    for (const IslandContact& c : island.problem.contacts) {
      rubs_on_world = rubs_on_world || (c.b < 0 && c.friction > 0.0);
      rebounds = rebounds || c.restitution > 0.0;
    }
  }
  /// By a gain of so much, which is an error whatever made it where it is a large part of all.
  bool may_slow(double gain) const {
    constexpr double large = 1e-3;
    return !driven && ((missed && rubs_on_world && !tied && !rebounds) || gain > large * enough);
  }
};

/// Slows these down alike, by so much energy [J] or to a stop: against the world, or against their motion as one, which they
/// keep. Returns what it took.
double slow_down(Model& model, const Articulates& articulates, const std::set<std::uint32_t>& things, double by,
                 bool against_world, bool drifted) {
  std::vector<BodyState> states;
  for (const std::uint32_t thing : things) states.push_back(state_of(model, articulates, thing, drifted));
  const MotionAsOne one = against_world ? MotionAsOne{} : motion_as_one(model, states);
  double kinetic = 0.0;
  for (BodyState& s : states) {
    s.v -= one.velocity_at(s.x);
    s.w -= one.spin;
    kinetic += 0.5 * (s.mass * norm2(s.v) + dot(s.w, own_inertia(s) * s.w));
  }
  if (!(kinetic > 0.0)) return 0.0;
  const double taken = std::min(by, kinetic), less = std::sqrt(1.0 - taken / kinetic) - 1.0;
  std::size_t i = 0;
  for (const std::uint32_t thing : things) {
    const BodyState& s = states[i++];
    add_momenta(model, s, thing, s.v * (s.mass * less), own_inertia(s) * s.w * less);
  }
  return taken;
}

}  // namespace

Gains settle_gains(Model& model, const Articulates& articulates, std::span<const TouchIsland> placed,
                   std::span<const TouchIsland> met, std::span<const WorkOnThing> beside, double fallen, bool drifted) {
  Joined joined(model, placed, met);
  const std::size_t count = joined.islands.size();
  std::vector<double> work(count, 0.0), belts(count, 0.0);
  for (std::size_t i = 1; i < count; i++) {
    const bool is_placed = i <= placed.size();
    const TouchIsland& island = *joined.islands[i];
    work[joined.sets.find(i)] += island.report.work + (is_placed ? island.placed_work : 0.0);
    belts[joined.sets.find(i)] += is_placed ? 0.0 : island.report.belts;
  }
  for (const auto& [thing, by] : beside) work[joined.sets.find(joined.owner[thing])] += by;
  const auto gain = [&](std::size_t i) { return std::max(0.0, work[i] - std::max(0.0, belts[i])); };
  Gains sum;
  for (std::size_t i = 0; i < count; i++) sum.wrong += gain(i);
  std::vector<Traits> traits(count);
  std::map<std::size_t, std::set<std::uint32_t>> gained;
  for (std::size_t i = 1; i < count; i++)
    if (const std::size_t set = joined.sets.find(i); gain(set) > 0.0) {
      traits[set].add(*joined.islands[i], articulates);
      gained[set].insert(joined.islands[i]->things.begin(), joined.islands[i]->things.end());
    }
  for (const auto& [set, things] : gained) {
    Traits& of = traits[set];
    if (of.driven) continue;
    for (const std::uint32_t thing : things) {
      const BodyState s = state_of(model, articulates, thing, drifted);
      of.enough += kinetic_energy(model, s, thing) + 0.5 * s.mass * fallen * fallen;
    }
    if (of.may_slow(gain(set)))
      sum.taken_back += slow_down(model, articulates, things, gain(set), of.rubs_on_world || of.held, drifted);
  }
  return sum;
}

}  // namespace pantin
