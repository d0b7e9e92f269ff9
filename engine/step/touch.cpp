// Things with shapes and solid particles touch: phases around the drift. Nothing happens in a scene without any.
#include <algorithm>
#include <cmath>
#include <utility>

#include "articulates/solve/tension.hpp"
#include "contacts/bodies.hpp"
#include "contacts/find.hpp"
#include "contacts/foresee_anew.hpp"
#include "contacts/gather.hpp"
#include "contacts/heat.hpp"
#include "contacts/motor_bounds.hpp"
#include "contacts/overlaps.hpp"
#include "contacts/passed.hpp"
#include "contacts/passes.hpp"
#include "contacts/pushed.hpp"
#include "contacts/touching.hpp"
#include "forces/forces.hpp"
#include "forces/sleep.hpp"
#include "step/ledger_posts.hpp"
#include "step/phases.hpp"
#include "step/touch.hpp"

namespace pantin {

namespace {

bool nothing_touches(const World& world) { return world.shapes.empty() && !world.solids; }

/// [rad/s] How fast two that meet within the step turn when they have rebounded, as if nothing else touched them, by how much
/// of the energy that is to be kept; 0: they do not.
double turn_of_rebound(const World& world, const Contact& c) {
  if (c.restitution == 0.0 || is_of_point(c)) return 0.0;
  struct Struck {
    Vec3 turn = zero3(), by = zero3();   ///< [rad/s] what counts of it, and what 1 N s adds
    double speed = 0.0, mobility = 0.0;  ///< [m/s] along the normal, and what 1 N s adds
  };
  const auto struck = [&](std::uint32_t body, std::uint32_t shape) -> Struck {
    if (!world.shapes.alive_at(shape)) return {};
    const Motion& m = world.motion[body];
    const Shape& of = world.shapes.at_slot(shape);
    const Pose pose = pose_of(world, of);
    const Vec3 turn = angular_velocity(m), arm = c.at - m.x, lever = cross(arm, c.normal);
    const Vec3 by = rotate(m.q, rotate(conjugate(m.q), lever) * inverse_inertia(m));
    return {turn_of(of.geometry, pose, turn), turn_of(of.geometry, pose, by),
            dot(m.p / m.mass + cross(turn, arm), c.normal), 1.0 / m.mass + dot(by, lever)};
  };
  const Struck a = struck(c.body_a, c.key.a);
  const Struck b = c.body_b < 0 ? Struck{} : struck(static_cast<std::uint32_t>(c.body_b), c.key.b);
  const double nears = b.speed - a.speed;
  if (!(nears * world.settings.step > c.gap)) return 0.0;
  const double impulse = (1.0 + c.restitution) * nears / (a.mobility + b.mobility);
  const double kept = c.restitution * c.restitution;
  return kept * kept * std::max(norm(a.turn + a.by * impulse), norm(b.turn - b.by * impulse));
}

}  // namespace

void divide_for_contacts(World& world) {
  if (nothing_touches(world)) return;
  constexpr double most_way = 0.2;   // of the thickness, in a sub-step of what may touch
  constexpr double most_turn = 0.1;  // [rad]
  constexpr double most = 4.0;
  constexpr double most_whirl = 0.4;      // [rad] in a sub-step of what is tied, where it turns that fast,
  constexpr double most_whirling = 16.0;  // in no more of them
  constexpr double most_rebound = 0.05;   // [rad] in a sub-step of what rebounds and loses nothing,
  constexpr double most_rebounds = 16.0;  // in no more of them
  constexpr double most_swing = 0.3;      // [rad] of what touches, across what pulls it taut,
  constexpr double most_swings = 8.0;     // in no more of them
  double wanted = 1.0, whirling = 1.0, rebounds = 1.0;
  const auto see = [&](const Contact& c, std::uint32_t body, std::uint32_t shape) {
    if (!world.shapes.alive_at(shape)) return;
    const Motion& m = world.motion[body];
    const Shape& of = world.shapes.at_slot(shape);
    const double step = world.settings.step;
    const double reach = reach_of(of.geometry), spin = norm(m.angular * inverse_inertia(m)), speed = norm(m.p) / m.mass;
    const auto ask = [&](double moves, double turns) {
      return std::max({wanted, moves * step / (most_way * c.size), turns * step / most_turn});
    };
    if (m.articulate >= 0 && spin * step > most_whirl * whirling)
      whirling =
          std::max(whirling, norm(turn_of(of.geometry, pose_of(world, of), angular_velocity(m))) * step / most_whirl);
    const double arm = norm(of.at - world.bodies.at_slot(body).centre);
    if (ask(speed + spin * (arm + reach), spin) <= wanted) return;
    const Pose pose = pose_of(world, of);
    const Vec3 turn = angular_velocity(m);
    const double turning = norm(turn_of(of.geometry, pose, turn));
    wanted = ask(norm(m.p / m.mass + cross(turn, pose.x - m.x)) + turning * reach, turning);
  };
  constexpr double most_missed = 2e-4;  // of the thickness: what ties made of a drift, beyond what was foreseen
  const double before = world.sub_steps.count;
  const Contact* last = nullptr;
  for (const Contact& c : world.contacts.list) {
    rebounds = std::max(rebounds, turn_of_rebound(world, c) * world.settings.step / most_rebound);
    wanted = std::max(wanted, before * std::sqrt(c.closed_beyond / most_missed));
    if (last && c.key.same_shapes(last->key)) continue;
    last = &c;
    if (is_point(c.body_a)) continue;  // what does not turn is not passed through
    see(c, c.body_a, c.key.a);
    if (c.body_b >= 0) see(c, static_cast<std::uint32_t>(c.body_b), c.key.b);
  }
  double swings = 1.0;
  for (const auto& articulate : world.articulates)
    if (articulate->touches) swings = std::max(swings, rate_of_tension(*articulate) * world.settings.step / most_swing);
  const auto count = static_cast<std::uint16_t>(
      std::ceil(std::max({std::min(wanted, most), std::min(whirling, most_whirling), std::min(rebounds, most_rebounds),
                          std::min(swings, most_swings)})));
  world.sub_steps.count = world.settings.accuracy ? std::max(world.sub_steps.count, count) : count;
}

void post_opening(World& world) {
  if (!world.touch_space || world.touch_space->displaced.empty() || !world.trouble.empty()) return;
  const std::vector<Displaced> displaced = std::exchange(world.touch_space->displaced, {});
  const Forces& f = *world.forces;
  const std::size_t bodies = world.bodies.slots();
  const auto of = [&](std::size_t number) { return number < displaced.size() ? displaced[number] : Displaced{}; };
  AlignedVector<Vec3> ways;
  ways.assign(f.sites.n, zero3());
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != Forces::none) ways[i] = of(bodies + f.point[i]).way;
  for (const Attached& a : f.attached) {
    const Receiver& r = f.receivers[a.receiver];
    const Displaced d = of(r.is_body ? r.slot : bodies + r.slot);
    ways[a.site] = d.way + cross(d.turn, a.r);
  }
  post_displacements(world, ways);
}

namespace phases {

namespace {

TouchSettings settings_of(const World& world, bool drifted, double at, double wanted_at) {
  return {world.stage.h, world.settings.gravity, drifted, at, wanted_at, world.settings.step, world.settings.contact};
}

/// Forces of laws with energies that kick; none where there are none.
std::vector<BodyLoad> kicks_of(const World& world) {
  if (world.contacts.list.empty() || !world.forces) return {};
  const std::size_t bodies = world.bodies.slots();
  std::vector<BodyLoad> kicks(bodies + world.points.slots());
  const Forces& f = *world.forces;
  for (const Receiver& r : f.receivers) kicks[r.is_body ? r.slot : bodies + r.slot] = {r.force, r.torque};
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != Forces::none) kicks[bodies + f.point[i]].force = f.sites.force[i];
  return kicks;
}

void count(World& world, const TouchReport& report) {
  post(world, Source::hand, report.ties.anchors);
  post(world, Source::motor, report.ties.angular_rows);
  world.stats.contact_iterations += report.iterations;
  world.stats.unsolved_islands += report.unsolved;
}

/// Friction and impact only take, but for what moving surfaces give. What else came is no work from outside: it is an error.
void post_contacts(World& world, const TouchReport& report) {
  post(world, Source::contact, world.contacts.work + report.work - report.wrong);
  DriftReport told;
  told.unsolved = report.wrong - report.taken_back;
  world.stats.gains_taken_back += report.taken_back;
  post_report(world, told);
  if (world.contacts.heat_kept) settle_heat(world, world.contacts, report.wrong);
}

/// What ties bore in this drift is a part of what they do in the step, if that has several.
void note_drift(World& world) {
  const double share = world.stage.h / world.settings.step;
  for (const auto& articulate : world.articulates) {
    Articulate& a = *articulate;
    a.drift_share = share;
    if (world.stage.to >= 1.0 || a.rest.asleep) continue;
    a.reaction.resize(a.rows.size(), zero3());
    for (std::size_t k = 0; k < a.rows.size(); k++) a.reaction[k] += force_in_drift(a, k) * share;
  }
}

/// The last that could touch is gone: nothing goes on to press, and no motor has a bound.
void forget_touch(World& world) {
  world.touch_space.reset();
  world.contacts.list.clear();
  for (const auto& articulate : world.articulates) {
    articulate->touches = false;
    articulate->drift_share = 1.0;
    end_jams(*articulate);
    free_motors(*articulate);
  }
}

/// What touches does not do so through the sides of a periodic box.
void tell_box(World& world) {
  const std::string what = "scene.box: laws reach through its sides, but what touches does so within it alone";
  const auto told = [&](const LogLine& line) { return line.text == what; };
  if (world.settings.box && std::none_of(world.log.begin(), world.log.end(), told)) log_line(world, "warning", what);
}

void tell_crowd(World& world) {
  const std::string what =
      "so much moves so fast in one place that contacts are not looked for over all of a step: a shorter scene.step "
      "does";
  const auto told = [&](const LogLine& line) { return line.text == what; };
  if (std::none_of(world.log.begin(), world.log.end(), told)) log_line(world, "warning", what);
}

bool goes_untouched(const World& world) { return nothing_touches(world) || !world.trouble.empty(); }

ThingsNow things_now(const World& world, bool drifted) {
  const double h = drifted && world.stage.to >= 1.0 ? world.settings.step : world.stage.h;
  return {world, world.articulates, world.contacts, drifted, world.settings.gravity, h, world.stage.h};
}

/// There is what contacts are found with, it knows of all edits, and goes on as if nothing had asked between steps.
void make_ready(World& world) {
  if (!world.touch_space) world.touch_space = std::make_unique<TouchSpace>();
  renew(world.contact_finder, world);
  ContactFinder& finder = *world.contact_finder;
  finder.changed = std::exchange(finder.asked_changed, false) || finder.changed;
  finder.displaced = std::exchange(finder.asked_displaced, false) || finder.displaced;
}

/// What a drift took through something goes back to where they met.
void put_passed_back(World& world) {
  const double work = put_back_passed(things_now(world, true), *world.contact_finder, world, world.contacts);
  if (work == 0.0) return;
  post(world, Source::push_out, work);
  post_falling(world, -work);
}

/// Finds contacts where things are now. After the last stage for all of the next step, which may have fewer sub-steps.
void find(World& world, bool drifted) {
  try {
    find_all_contacts(things_now(world, drifted), *world.contact_finder, *world.workers, world.contacts);
  } catch (const Error& error) {
    world.trouble = error.what();
    world.contacts.stale = true;
    return;
  }
  if (world.contact_finder->ahead < 1.0) tell_crowd(world);
  wake_touched(world);
}

/// Finds contacts with what those meet that contacts push. Whether there are any.
bool find_more(World& world, bool drifted) {
  make_ready(world);
  const TouchSpace& space = *world.touch_space;
  try {
    if (!find_pushed(things_now(world, drifted), *world.contact_finder, std::span(space.placing).first(space.placed),
                     world.contacts))
      return false;
  } catch (const Error& error) {
    world.trouble = error.what();
    world.contacts.stale = true;
    return false;
  }
  wake_touched(world);
  return true;
}

}  // namespace

void place_contacts(World& world) {
  constexpr int most_rounds = 8;  // of those that push others that push others
  if (nothing_touches(world) && world.touch_space) forget_touch(world);
  if (goes_untouched(world)) return;
  const Timed timed(world.profile, Phase::place_contacts);
  const bool drifted = world.stage.index > 0;
  if (!drifted)
    for (TouchHeat& one : world.contacts.heat) one.last = 0.0;
  if (world.contacts.stale || world.places_changed) {
    make_ready(world);
    find(world, drifted);
    if (!drifted) {
      note_put(world.contacts, world.steps);
      tell_box(world);
    }
  } else {
    make_ready(world);
    foresee_anew(things_now(world, drifted), *world.contact_finder, world.contacts);
  }
  if (!world.trouble.empty()) return;
  TouchReport report;
  const std::vector<BodyLoad> kicks = kicks_of(world);
  TouchSettings settings = settings_of(world, drifted, world.stage.from, 0.5 * (world.stage.from + world.stage.to));
  settings.foresees = true;
  begin_placing(world, world.articulates, world.contacts, settings);
  for (int round = 1;; round++) {
    report.from_rest = 0.0;
    report.unsolved = 0;
    find_placing(*world.touch_space, *world.workers, world, world.articulates, world.contacts, settings, report);
    if (round == most_rounds || !find_more(world, drifted)) break;
  }
  const AlignedVector<Vec3> before = site_velocities(world, drifted);
  give_placing(*world.touch_space, *world.workers, world, world.articulates, world.contacts, settings, kicks, report);
  world.contacts.work = report.work;
  post_falling(world, report.beside_falls);
  post_laws_beside_kicks(world, before);
  // In a scene at rest there is no other energy to hold errors against.
  world.largest_kinetic = std::max(world.largest_kinetic, report.from_rest);
  count(world, report);
}

void find_contacts(World& world) {
  if (goes_untouched(world)) return;
  const Timed timed(world.profile, Phase::find_contacts);
  make_ready(world);
  put_passed_back(world);
  find(world, true);
  if (!world.trouble.empty()) return;
  const LedgerMark before = ledger_mark(world, true);
  TouchReport report;
  push_out(*world.touch_space, *world.workers, world, world.articulates, world.contacts,
           settings_of(world, true, world.stage.to, world.stage.to), report);
  post(world, Source::push_out, report.work);
  if (report.work != 0.0) {
    post_falling(world, before.all_falling - ledger_mark(world, true).all_falling);
    for (const auto& articulate : world.articulates) post_solved_laws(world, *articulate);
  }
  count(world, report);
  world.contact_finder->displaced = world.contact_finder->displaced || report.work != 0.0;
  if (world.contacts.stale) find(world, true);
}

void meet_contacts(World& world) {
  if (goes_untouched(world)) return;
  const Timed timed(world.profile, Phase::meet_contacts);
  TouchReport report;
  meet(*world.touch_space, *world.workers, world, world.articulates, world.contacts,
       settings_of(world, true, world.stage.to, world.stage.to), kicks_of(world), report);
  post_contacts(world, report);
  count(world, report);
  note_drift(world);
  if (world.contacts.watched) feel(world, world.articulates, world.contacts);
  world.stats.contacts = report.contacts;
  world.stats.contact_islands = report.islands;
}

}  // namespace phases

}  // namespace pantin
