#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "articulates/solve/matrix.hpp"
#include "articulates/solve/momenta.hpp"
#include "contacts/gains.hpp"
#include "contacts/heat.hpp"
#include "contacts/pass_parts.hpp"
#include "contacts/solve/impacts.hpp"
#include "contacts/solve/ties.hpp"
#include "contacts/take_back.hpp"
#include "contacts/turn_back.hpp"

namespace pantin {

namespace {

/// Takes out what ties answered to impulses of `place`, in articulates that touch nothing after the drift.
std::vector<WorkOnThing> answer_where_nothing_touches(Model& model, const Articulates& articulates,
                                                      std::span<const TouchIsland> islands,
                                                      const TouchSettings& settings, TouchReport& report) {
  std::vector<WorkOnThing> work;
  std::vector<char> touches(articulates.size(), 0);
  for (const TouchIsland& island : islands)
    for (const std::uint32_t number : island.articulates) touches[number] = 1;
  for (std::size_t k = 0; k < touches.size(); k++) {
    Articulate& a = *articulates[k];
    if (touches[k] || !a.touches) continue;
    let_overdriven_give_way_now(a, model, settings);
    const auto kinetic = [&] {
      return std::accumulate(a.nodes.begin(), a.nodes.end(), 0.0,
                             [](double sum, const Node& n) { return sum + kinetic_energy(n); });
    };
    const double before = kinetic();
    const ImpulseWork ties = answer_of_ties(a, model, settings);
    report.ties += ties;
    const double by = kinetic() - before - ties.all();
    report.work += by;
    const auto body = std::find_if(a.nodes.begin(), a.nodes.end(), [](const Node& n) { return n.is_body; });
    if (body != a.nodes.end()) work.emplace_back(body->slot, by);
  }
  return work;
}

/// What a thing's articulate took that touches nothing after the drift is of those that it was touched by before.
void share_heat_beside(const Model& model, std::span<const TouchIsland> placed, std::size_t thing, double work,
                       Contacts& contacts) {
  for (const TouchIsland& island : placed)
    if (std::find(island.things.begin(), island.things.end(), thing) != island.things.end())
      return share_work(model, island.placed, work, contacts.new_heat);
}

/// What ties gave that draw ends together which are apart turned a free articulate: it turns back. Returns what that gave [J].
double turn_back_drawn(const Articulates& articulates, const TouchIsland& island) {
  double work = 0.0;
  for (const std::uint32_t number : island.articulates) {
    Articulate& a = *articulates[number];
    if (!acts_at_distance(a)) continue;
    Momenta wanted = momenta_of(a);
    for (std::size_t k = 0; k < island.rows.size(); k++) {
      const IslandTie& t = island.problem.ties[k];
      if (island.rows[k][0] != number || t.lever > 0.0 || t.b < 0) continue;
      const auto end = [&](std::int32_t body, Vec3 arm) {
        return island.states[static_cast<std::size_t>(body)].x + arm;
      };
      wanted.angular -= cross(end(t.a, t.ra) - end(t.b, t.rb), t.kept * t.impulse);
    }
    work += restore_momenta(a, wanted);
  }
  return work;
}

/// What ties that move give by impulses at the end of the step.
ImpulseWork work_of_ties(const Articulates& articulates, const TouchIsland& island) {
  ImpulseWork work;
  for (const IslandTie& t : island.problem.ties)
    (t.lever > 0.0 ? work.angular_rows : work.anchors) += dot(t.kept * t.impulse, t.wanted);
  for (std::size_t k = 0; k < island.scalars.size(); k++) {
    const IslandScalar& s = island.problem.scalars[k];
    add_work(work, articulates, island.scalars[k], s.impulse, s.u - s.bias);
  }
  return work;
}

/// Speed [m/s] with which what is tied leaves what does not move, as if it had met it at the surface: between the start and the
/// end of the drift of h [s] the square of its speed goes evenly along its way.
double rebound_of_tied(const Contact& from, const IslandContact& c, const ContactIsland& problem, double h) {
  if (from.rebound == 0.0) return 0.0;
  const double start = -from.approach,
               end = -dot(from.normal, relative(c, problem.bodies, &IslandBody::v0, &IslandBody::w0));
  const double way = 0.5 * (start + end) * h;
  if (!(way > 0.0)) return 0.0;
  const double part = std::min(1.0, from.gap_before / way);
  return from.restitution * std::sqrt(std::max(0.0, start * start + (end * end - start * start) * part));
}

/// Whether what nears now did not when the drift began: it has no approach then, or nothing held it.
bool is_new_blow(const Contact& c) { return c.approach == 0.0 || norm2(c.place_impulse) == 0.0; }

/// [m/s²] By gravity and by laws that kick.
Vec3 acceleration(const Model& model, std::uint32_t thing, const TouchSettings& settings,
                  std::span<const BodyLoad> kicks, const ContactIsland& problem, const IslandContact& c) {
  const std::size_t i = number_of(model, thing);
  if (i >= kicks.size()) return settings.gravity;
  return settings.gravity + kicks[i].force * problem.bodies[static_cast<std::size_t>(c.a)].inverse_mass;
}

/// Whether ties bore anything of what `place` gave the contacts of an island, beyond round-off.
bool ties_bore(const TouchIsland& island, const Articulates& articulates, const std::vector<Contact>& contacts) {
  double most = 0.0, given = 0.0;  // [N s]
  const auto bore = [&](std::uint32_t articulate, std::size_t row) {
    const Articulate& a = *articulates[articulate];
    const std::vector<Vec3>& ties = a.tie_impulses[number(Pass::place)];
    const std::vector<double>& scalars = a.scalar_impulses[number(Pass::place)];
    if (ties.size() == a.rows.size()) most = std::max(most, norm(ties[row]));
    if (scalars.size() == a.rows.size()) most = std::max(most, std::fabs(scalars[row]));
  };
  for (const auto& [articulate, row] : island.rows) bore(articulate, row);
  for (const TouchScalar& s : island.scalars) bore(s.articulate, s.row.row());
  for (const std::size_t k : island.contacts) given = std::max(given, norm(contacts[k].place_impulse));
  return most > 1e-9 * given;
}

/// Those that are far from acting are nothing to velocities; of the rest, none is open. One that `place` held back in a drift of
/// h [s] by more than what is left of its room is where it was to be.
void close_scalars(TouchIsland& island, const Articulates& articulates, double h) {
  for (std::size_t k = 0; k < island.scalars.size(); k++) {
    TouchScalar& scalar = island.scalars[k];
    IslandScalar& s = island.problem.scalars[k];
    s.bias = -scalar.row.wanted;
    const Articulate& a = *articulates[scalar.articulate];
    const std::vector<double>& placed = a.scalar_impulses[number(Pass::place)];
    const std::size_t row = scalar.row.row();
    const bool held =
        placed.size() == a.rows.size() && std::fabs(placed[row]) * mobility(a, a.rows[row]) * h > scalar.row.room;
    if (scalar.row.room > (held ? held_gap : closed_gap) * a.length) s.low = s.high = 0.0;
  }
}

/// What was foreseen acts where it is met, at two points by now: with what `place` gave there, and was taken back, that hardly
/// changes the angular momentum. What it does is given back.
void turn_where_foreseen(Model& model, const Articulates& articulates, const Contacts& contacts,
                         const std::vector<Vec3>& turned, bool drifted, const TouchIsland& island) {
  std::vector<Vec3> missing;
  std::vector<std::array<std::int32_t, 2>> pushed;
  for (std::size_t k = 0; k < island.contacts.size(); k++) {
    const Contact& from = contacts.list[island.contacts[k]];
    const IslandContact& c = island.problem.contacts[k];
    if (from.from_before || norm2(c.impulse) > 0.0) pushed.push_back({c.a, c.b});
    if (!from.from_before || c.b < 0) continue;
    if (missing.empty()) missing.assign(island.things.size(), zero3());
    const auto end = [&](std::int32_t body, Vec3 arm) {
      return centre_of(model, articulates, island.things[static_cast<std::size_t>(body)], drifted) + arm;
    };
    missing[static_cast<std::size_t>(c.a)] -= cross(end(c.a, c.ra) - end(c.b, c.rb), from.total);
  }
  if (missing.empty()) return;
  for (std::size_t i = 0; i < missing.size(); i++)
    if (const std::size_t k = number_of(model, island.things[i]); k < turned.size()) missing[i] -= turned[k];
  turn_back(model, articulates, island, drifted, pushed, missing);
}

/// [m] Where what was foreseen was met: between its ends of now.
Vec3 met_at(const Model& model, const Articulates& articulates, const Contact& c, bool drifted) {
  const Vec3 of_a = centre_of(model, articulates, c.body_a, drifted) + c.arm_a;
  if (c.body_b < 0) return of_a;
  return (of_a + centre_of(model, articulates, static_cast<std::uint32_t>(c.body_b), drifted) + c.arm_b) * 0.5;
}

/// Where shapes have contacts of before the drift, those of now are not used.
void leave_to_past(const std::vector<Contact>& list, std::vector<char>& used) {
  for (std::size_t first = 0, last = 0; first < list.size(); first = last) {
    bool past = false;
    for (; last < list.size() && list[last].key.same_shapes(list[first].key); last++)
      past = past || list[last].from_before;
    for (std::size_t k = first; past && k < last; k++) used[k] = list[k].from_before;
  }
}

/// (contacts) Which are met; the others have no impulse.
std::vector<char> begin_meeting(const Model& model, const Articulates& articulates, Contacts& contacts, bool drifted) {
  std::vector<char> used(contacts.list.size(), 0);
  for (std::size_t k = 0; k < used.size(); k++) {
    Contact& c = contacts.list[k];
    c.place_index = -1;
    if (c.from_before) c.at = met_at(model, articulates, c, drifted);
    used[k] = c.from_before || c.gap <= (norm2(c.place_impulse) > 0.0 ? held_gap : closed_gap) * c.size;
  }
  leave_to_past(contacts.list, used);
  for (std::size_t k = 0; k < used.size(); k++)
    if (!used[k]) contacts.list[k].total = contacts.list[k].total_moment = zero3();
  return used;
}

}  // namespace

void meet(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
          const TouchSettings& settings, std::span<const BodyLoad> kicks, TouchReport& sum) {
  take_back(space, workers, model, articulates, contacts, settings, sum);
  const double h = settings.h;
  const std::vector<char> used = begin_meeting(model, articulates, contacts, settings.drifted);
  const std::span<TouchIsland> islands =
      gather(space.meeting, space.index, workers, model, articulates, contacts, settings, used);
  each_island(workers, islands, sum, [&](TouchIsland& island, TouchReport& report) {
    ContactIsland& problem = island.problem;
    act_where_met(island, contacts, true);
    start_meeting(island, contacts, articulates);
    set_scalars(island, articulates, h, h, h);
    close_scalars(island, articulates, h);
    hold_ties(problem);
    bool rebounds = false;
    double lifted = 0.0;  // [J] that `place` gave by holding above the surface what rebounds off it
    for (std::size_t k = 0; k < problem.contacts.size(); k++) {
      const Contact& from = contacts.list[island.contacts[k]];
      IslandContact& c = problem.contacts[k];
      c.other_start = to_frame(c, from.place_impulse);
      if (from.body_b < 0 && problem.is_tied()) c.rebound = rebound_of_tied(from, c, problem, h);
      if (from.body_b < 0 && from.rebound > 0.0)
        lifted -= dot(acceleration(model, from.body_a, settings, kicks, problem, c), from.place_impulse) * h;
      rebounds = rebounds || from.rebound > 0.0 || (from.restitution > 0.0 && is_new_blow(from));
    }
    if (rebounds) {
      double done_before = 0.0;
      const bool by_contacts = !problem.is_tied() || !ties_bore(island, articulates, contacts.list);
      for (const std::uint32_t thing : by_contacts ? island.things : std::vector<std::uint32_t>())
        if (const std::size_t i = number_of(model, thing); i < space.placing_work.size())
          done_before += space.placing_work[i];
      report.iterations +=
          resolve_impacts(problem, slow_of(settings, problem), done_before, problem.is_tied() ? 0.0 : lifted)
              .iterations;
    }
    solve_pass(contacts, island, Pass::meet, settings.search, report);
    keep_tie_impulses(articulates, island, Pass::meet);
    keep_rolls(problem, contacts, island.contacts, &Contact::total_moment);
    const double before = kinetic_energy_now(model, island);
    std::vector<Placing> given;  // where heat is kept
    for (std::size_t k = 0; k < problem.contacts.size(); k++) {
      Contact& to = contacts.list[island.contacts[k]];
      IslandContact& c = problem.contacts[k];
      c.impulse += c.impact_impulse;
      to.total = to_world(c, c.impulse);
      report.belts -= dot(to.total, to.belt - to.normal * dot(to.normal, to.belt));
      if (contacts.heat_kept)
        given.push_back({to.body_a, to.body_b, to.key.b, to.total, to.total_moment, c.ra, c.rb, to.normal, to.foreseen,
                         zero3(), c.a, c.b});
    }
    HeatOf heat(model, articulates, contacts, settings.drifted, given, island.heat);
    std::vector<BodyLoad> loads(problem.bodies.size());
    add_contact_loads(problem, loads);
    for (IslandTie& t : problem.ties) t.impulse += t.earlier_impulse;
    for (IslandScalar& s : problem.scalars) s.impulse += s.earlier_impulse;
    add_tie_loads(problem, loads);
    tell_reactions(articulates, island, settings.step, true);
    give(model, island, loads);
    const double drawn = turn_back_drawn(articulates, island);
    turn_where_foreseen(model, articulates, contacts, space.turned, settings.drifted, island);
    ImpulseWork ties = work_of_ties(articulates, island);
    ties.anchors += drawn;
    report.ties += ties;
    const double work = kinetic_energy_now(model, island) - before - ties.all();
    report.work += work;
    heat.add(work);
  });
  const std::vector<WorkOnThing> beside = answer_where_nothing_touches(model, articulates, islands, settings, sum);
  if (contacts.heat_kept)
    for (const auto& [thing, by] : beside)
      share_heat_beside(model, std::span(space.placing).first(space.placed), thing, by, contacts);
  const Gains gains = settle_gains(model, articulates, std::span(space.placing).first(space.placed), islands, beside,
                                   norm(settings.gravity) * settings.step, settings.drifted);
  sum.wrong = gains.wrong;
  sum.taken_back = gains.taken_back;
  space.placed = 0;
  contacts.drift = h;
  collect_heat(contacts, islands);
  hold_again(articulates);
}

}  // namespace pantin
