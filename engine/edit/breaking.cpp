// Constraints and hinges that bear only so much.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "articulates/articulate.hpp"
#include "articulates/solve/state.hpp"
#include "base/stable.hpp"
#include "constraints/coupling.hpp"
#include "constraints/kind.hpp"
#include "constraints/row_rule.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"

namespace pantin {

using namespace internal;

namespace {

void require_breaking(const std::string& who, const Breaking& b) {
  require_positive_or_infinite(who, "breaks_at.force", b.force, "N");
  require_positive_or_infinite(who, "breaks_at.torque", b.torque, "N m");
  require_positive_or_infinite(who, "breaks_at.length", b.length, "m");
}

/// Of one that bears too much in several ways the worst.
template <class Id>
void note(std::vector<Overload<Id>>& list, const Overload<Id>& load, bool too_much) {
  if (!too_much) return;
  const auto known = std::find(list.begin(), list.end(), load.id);
  if (known == list.end())
    list.push_back(load);
  else if (load.part > known->part)
    *known = load;
}

constexpr double leaps = 1.5;  // of what is borne: so far no load grows in a step, if it was borne in the last one

/// How long before the end of the step [s] a load that grew evenly, from the middle of the last step to that of this one,
/// passed what is borne; 0 where it is not known, or leapt.
double time_since(const World& world, double before, double load, double borne) {
  const double h = world.settings.step, more = load - before;
  if (!(before <= borne) || !(more < 0.5 * borne) || !(more > 0.0)) return 0.0;
  return h * (0.5 + (load - borne) / more);
}

/// Of hinges of more than two: rows tie each other member to one, which bears what they bear together.
void find_overloads_of_stars(const World& world, const Articulate& a, Overloads& found) {
  std::map<std::uint32_t, std::pair<ParticleId, Vec3>> loads;  // by the slot of the point that others are tied to
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    if (row.condition >= 0 || !row.star_point) continue;
    const ParticleId ring = world.points[row.member].particle;
    if (world.particles[ring].points.size() < 3 || std::isinf(world.particles[ring].breaks_at.force)) continue;
    auto& [of, load] = loads.try_emplace(row.star_point.slot, ring, zero3()).first->second;
    load += exerted_force(a, k);
  }
  for (const auto& [slot, of] : loads) {
    const double load = norm(of.second);
    const double borne = world.particles[of.first].breaks_at.force;
    note(found.hinges, {of.first, load, load / borne, text("its load of ", load, " N"), 0.0, load > leaps * borne},
         load > borne);
  }
}

/// Of sliders: what all their rows pull with together.
void find_overloads_of_sliders(const World& world, const Articulate& a, Overloads& found) {
  std::map<std::uint32_t, std::pair<ConstraintId, Vec3>> loads;  // by slot
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    if (!is_coupled(row) || row.lever > 0.0) continue;
    const ConstraintId id = condition(a, row).constraint;
    if (world.constraints[id].kind != ConstraintKind::slider) continue;
    loads.try_emplace(id.slot, id, zero3()).first->second.second += exerted_force(a, k);
  }
  for (const auto& [slot, of] : loads) {
    const double load = norm(of.second), borne = world.constraints[of.first].breaks_at.force;
    note(found.constraints, {of.first, load, load / borne, text("its load of ", load, " N"), 0.0, load > leaps * borne},
         load > borne);
  }
}

void find_overloads(const World& world, const Articulate& a, Overloads& found) {
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    if (pulls_by_law(row)) continue;  // connections break by themselves
    const bool angular = row.lever > 0.0;
    const double load = norm(exerted_force(a, k)) * (angular ? row.lever : 1.0);
    const auto since = [&](double borne) {
      return a.loads.size() == a.rows.size() ? time_since(world, a.loads[k], load, borne) : 0.0;
    };
    const auto leapt = [&](double borne) {
      return load > leaps * borne || (a.loads.size() == a.rows.size() && since(borne) == 0.0);
    };
    const auto story = [&] {
      return angular ? text("its torque of ", load, " N m") : text("its load of ", load, " N");
    };
    if (row.condition < 0) {
      const ParticleId ring = world.points[row.member].particle;
      const double borne = world.particles[ring].breaks_at.force;
      note(found.hinges, {ring, load, load / borne, story(), since(borne), leapt(borne)}, load > borne);
      continue;
    }
    const ConstraintId id = condition(a, row).constraint;
    const Constraint& c = world.constraints[id];
    if (!tells_force(world, condition(a, row), row, c)) continue;
    if (c.ring()) {
      const double borne = world.particles[c.ring()].breaks_at.torque;
      note(found.hinges, {c.ring(), load, load / borne, story(), since(borne), leapt(borne)}, load > borne);
      continue;
    }
    const double length = angular ? 0.0 : norm(row.d1);
    const double borne = angular ? c.breaks_at.torque : c.breaks_at.force;
    if (length > c.breaks_at.length)
      note(found.constraints, {id, load, 1.0, text("its length of ", length, " m"), 0.0, false}, true);
    else
      note(found.constraints, {id, load, load / borne, story(), since(borne), leapt(borne)}, load > borne);
  }
}

Overloads find_overloads(const World& world) {
  Overloads found;
  for (const auto& articulate : world.articulates) {
    if (!articulate->breakable) continue;
    find_overloads(world, *articulate, found);
    find_overloads_of_stars(world, *articulate, found);
    find_overloads_of_sliders(world, *articulate, found);
  }
  return found;
}

/// When what a row is of broke [s] before the end of the step; 0: it did not, or that is not known.
double broken_since(const World& world, const Articulate& a, const Row& row, const Overloads& found) {
  const auto time = [](const auto& list, auto id) {
    const auto at = std::find(list.begin(), list.end(), id);
    return at == list.end() ? 0.0 : at->since;
  };
  if (pulls_by_law(row)) return 0.0;
  if (row.condition < 0) return time(found.hinges, world.points[row.member].particle);
  const ConstraintId id = condition(a, row).constraint;
  const ParticleId ring = world.constraints[id].ring();
  return std::max(time(found.constraints, id), ring ? time(found.hinges, ring) : 0.0);
}

/// Takes back what rows did after they broke.
void take_back(World& world, Articulate& a, const Overloads& found) {
  const double before = kinetic_energy(a);
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    const double since = broken_since(world, a, row, found);
    if (since == 0.0) continue;
    const Vec3 f = exerted_force(a, k);
    const double load = norm(f), last = a.loads[k] / (row.lever > 0.0 ? row.lever : 1.0);
    const double mean = load + (load - last) * (0.5 - 0.5 * since / world.settings.step);  // from then to the end
    const auto strike = [&](std::int32_t node, Vec3 arm, double sign) {
      if (node < 0) return;
      Node& n = a.nodes[static_cast<std::size_t>(node)];
      const Vec3 impulse = f * (sign * since * mean / load);
      if (row.lever == 0.0) n.p0 += impulse;
      if (!n.turns) return;
      const Vec3 twist = row.lever > 0.0 ? impulse * row.lever : cross(n.R0 * arm, impulse);
      n.P0 += transposed_times(n.R0, world.plane.about(twist));
      n.spin0 = n.inverse_inertia * n.P0;
    };
    strike(row.a, row.la, -1.0);
    strike(row.b, row.lb, 1.0);
  }
  post(world, Source::edit, kinetic_energy(a) - before);
}

void break_constraint(World& world, const Overload<ConstraintId>& overload) {
  const ConstraintId id = overload.id;
  let_go(world, id);
  take_out_constraint(world, id, {describe(world, id), next_time(world) - overload.since, overload.story});
  world.notices.push_back({Notice::Kind::broke, id, -1, world.constraints.story(id), overload.load});
}

void break_hinge(World& world, const Overload<ParticleId>& overload) {
  end_ring(world, overload.id, overload.story);
  world.notices.push_back({Notice::Kind::broke, overload.id, -1, world.particles.story(overload.id), overload.load});
}

void note_loads(Articulate& a) {
  a.loads.resize(a.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); k++)
    a.loads[k] = norm(exerted_force(a, k)) * (a.rows[k].lever > 0.0 ? a.rows[k].lever : 1.0);
}

}  // namespace

void set_breaks_at(World& world, ConstraintId id, const Breaking& breaks_at) {
  require_unlocked(world, "breaks_at");
  const std::string who = describe(world, id);
  require_breaking(who, breaks_at);
  Constraint& c = world.constraints[id];
  const std::vector<RowPlan> rows = rule_of(c).rows(world, c);
  const bool turns = std::any_of(rows.begin(), rows.end(), [](const RowPlan& row) { return row.angular; });
  const bool pulls = std::any_of(rows.begin(), rows.end(), [](const RowPlan& row) { return !row.angular; });
  require(turns || std::isinf(breaks_at.torque), who, ": breaks_at.torque: it bears no torque; give `force`");
  require(pulls || std::isinf(breaks_at.force), who, ": breaks_at.force: it bears no force; give `torque`");
  require(pulls || std::isinf(breaks_at.length), who, ": breaks_at.length: it has no length; give `torque`");
  if (c.breaks_at.possible() != breaks_at.possible()) mark_edited(world, c);
  c.breaks_at = breaks_at;
}

void set_breaks_at(World& world, ParticleId id, const Breaking& breaks_at) {
  require_unlocked(world, "breaks_at");
  Particle& hinge = world.particles[id];
  require(hinge.is_hinge(), "breaks_at: ", describe(world, id), " is no hinge");
  const std::string who = describe(world, id);
  require_breaking(who, breaks_at);
  require(!hinge.axes.empty() || std::isinf(breaks_at.torque), who,
          ": breaks_at.torque: it has no axis, and bears no torque");
  if (hinge.breaks_at.possible() != breaks_at.possible()) mark_edited(world, id);
  hinge.breaks_at = breaks_at;
}

void set_enabled(World& world, ParticleId id, bool enabled) {
  require_unlocked(world, "enabled");
  Particle& hinge = world.particles[id];
  require(hinge.is_hinge(), "enabled: ", describe(world, id), " is no hinge");
  if (hinge.enabled == enabled) return;
  if (enabled) require_together(world, hinge.points);
  hinge.enabled = enabled;
  for (ConstraintId axis : hinge.axes) set_enabled(world, axis, enabled);
  for (PointId point : hinge.points) world.points[point].row_force = zero3();
  mark_edited(world, id);
}

Overloads overloads_at_once(const World& world) {
  constexpr double as_much = 0.5;  // of the most
  Overloads found = find_overloads(world);
  double most = 0.0;
  const auto each = [&](auto&& use) {
    use(found.constraints);
    use(found.hinges);
  };
  each([&](auto& list) {
    std::erase_if(list, [](const auto& one) { return !one.at_once; });
    for (const auto& one : list) most = std::max(most, one.part);
  });
  each([&](auto& list) { std::erase_if(list, [&](const auto& one) { return one.part < as_much * most; }); });
  return found;
}

void break_overloaded(World& world, const Overloads& overloads) {
  for (const auto& overload : overloads.constraints) break_constraint(world, overload);
  for (const auto& overload : overloads.hinges) break_hinge(world, overload);
}

BrokenThings break_constraints(World& world) {
  const Overloads found = find_overloads(world);
  for (const auto& articulate : world.articulates) {
    if (!articulate->breakable) continue;
    if (!found.empty()) take_back(world, *articulate, found);
    note_loads(*articulate);
  }
  BrokenThings broken;
  for (const auto& overload : found.constraints)
    broken.emplace_back(overload.id, world.constraints[overload.id].serial);
  for (const auto& overload : found.hinges) broken.emplace_back(overload.id, world.particles[overload.id].serial);
  break_overloaded(world, found);
  return broken;
}

void tell_in_order(World& world, std::size_t first, const BrokenThings& broken) {
  std::vector<std::size_t> places;
  std::vector<std::pair<std::uint64_t, Notice>> told;
  for (std::size_t i = first; i < world.notices.size(); i++) {
    const Notice& notice = world.notices[i];
    const auto of = std::find_if(broken.begin(), broken.end(), [&](const auto& b) { return b.first == notice.thing; });
    if (notice.kind != Notice::Kind::broke || of == broken.end()) continue;
    places.push_back(i);
    told.emplace_back(of->second, notice);
  }
  sort_stably(told.begin(), told.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < places.size(); i++) world.notices[places[i]] = told[i].second;
}

}  // namespace pantin
