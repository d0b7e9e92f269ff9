#include "forces/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "articulates/articulate.hpp"
#include "articulates/solve/state.hpp"
#include "base/sets.hpp"
#include "base/stable.hpp"
#include "contacts/gather.hpp"
#include "contacts/held.hpp"
#include "contacts/resting.hpp"
#include "forces/forces.hpp"

namespace pantin {

namespace {

constexpr double stillness = 1e-8;   // of its length; the square, an energy, is lost in the round-off of its weight's
constexpr double round_off = 4e-11;  // of its distance from the origin, which positions are rounded to
constexpr double unsolved = 10.0;    // times what contacts are solved to: where the search for their impulses may end
constexpr double least_steps = 256, least_steps_in_touch = 32;
constexpr double swing = 4.0;        // times sqrt(length / gravity)
constexpr double most_growth = 2.0;  // round-off grows slowly, a fall by thousands in such a time,
constexpr double unseen = 1e-20;     // but what is so much smaller may grow
constexpr double unsolved_energy =
    1e-2;                      // and so may what is slower than contacts are solved to, where they would hold it
constexpr double slow = 3e-2;  // of sqrt(length gravity): the speed of what may be stopped where contacts hold it;
constexpr double unseen_slow = 1e-4;  // of its energy may grow

/// An articulate that is awake, or a body that touches something and that nothing ties.
struct Thing {
  std::size_t number;      // of the articulate; of bodies after those
  Articulate* articulate;  // or null
  std::uint32_t slot;      // of the body
  std::size_t island;      // its smallest number
  Rest* rest;
};

/// What the end of a step leaves of an island.
struct Island {
  std::span<Thing> things;
  double tolerance;  // [m/s] that its contacts are solved to; 0 where it has none
};

double kinetic_of(const World& world, const Thing& t) {
  return t.articulate ? t.articulate->totals.kinetic : kinetic_energy(world.motion[t.slot]);
}

/// For how many steps its motion is looked at. Where it touches something a step from rest tells that nothing moves it.
double least_steps_of(bool touches) { return touches ? least_steps_in_touch : least_steps; }

/// How long its motion is looked at [s].
double watch_time(const World& world, const Thing& t, bool touches) {
  const double gravity = norm(world.settings.gravity);
  const double least = least_steps_of(touches) * world.settings.step;
  const double length = t.articulate ? t.articulate->length : gyration(world.motion[t.slot]);
  return gravity > 0.0 ? std::max(least, swing * std::sqrt(length / gravity)) : least;
}

/// The speed at which its lightest part is as good as still, and that at which it is stopped where contacts hold it.
struct Still {
  double speed;        // [m/s]
  double energy;       // [J] of that part
  double slow_energy;  // [J] of it at the other
};

Still still(const World& world, const Thing& t, double time, double tolerance) {
  const Motion* m = t.articulate ? nullptr : &world.motion[t.slot];
  double least = m ? m->mass : t.articulate->total_mass, far = m ? largest(m->x) : 0.0;
  const double length = m ? gyration(*m) : t.articulate->length;
  if (!m)
    for (const Node& n : t.articulate->nodes) {
      least = std::min(least, n.mass);
      far = std::max(far, largest(n.x0));
    }
  const double speed = (stillness * length + round_off * far) / time + unsolved * tolerance;
  return {speed, 0.5 * least * speed * speed, 0.5 * least * slow * slow * length * norm(world.settings.gravity)};
}

bool is_closed(const Thing& t) { return !t.articulate || (!t.articulate->fell_back && !is_open(*t.articulate)); }

/// What laws do to bodies and points: [N], [N m].
std::vector<BodyLoad> pulls_of_laws(const World& world) {
  if (!world.forces) return {};
  const std::size_t bodies = world.bodies.slots();
  std::vector<BodyLoad> pulls(bodies + world.points.slots());
  for (const Receiver& m : world.forces->receivers)
    pulls[m.is_body ? m.slot : bodies + m.slot] = {m.force + m.nonconservative_force,
                                                   m.torque + m.nonconservative_torque};
  return pulls;
}

/// Whether contacts would hold the island if it were at rest.
bool is_held(World& world, const Island& island) {
  constexpr double touching = 1e-5;  // of the size
  const std::size_t tied = world.articulates.size();
  std::vector<std::size_t> numbers;
  for (const Thing& t : island.things) numbers.push_back(t.number);  // rising
  const std::vector<Contact>& list = world.contacts.list;
  std::vector<char> used(list.size(), 0);
  for (std::size_t k = 0; k < used.size(); k++)
    used[k] = (list[k].gap <= touching * list[k].size || norm2(list[k].total) > 0.0) &&
              std::binary_search(numbers.begin(), numbers.end(), island_number(world, tied, list[k].body_a));
  const TouchSettings settings = {world.stage.h,       world.settings.gravity, true, 1.0, 1.0,
                                  world.settings.step, world.settings.contact};
  return held_at_rest(*world.touch_space, *world.workers, world, world.articulates, world.contacts, settings, used,
                      pulls_of_laws(world), numbers);
}

/// Whether its motion has died away, or is so slow that contacts may stop it, at the end of a step.
bool is_still(World& world, const Island& island) {
  const bool touches = island.tolerance > 0.0;
  std::uint32_t steps = ~0u;
  for (const Thing& t : island.things) {
    Rest& r = *t.rest;
    r.peak = std::max(r.peak, kinetic_of(world, t));
    steps = std::min(steps, ++r.steps);
  }
  for (const Thing& t : island.things) t.rest->steps = steps;
  if (steps < least_steps_of(touches)) return false;
  double time = 0.0;
  for (const Thing& t : island.things) time = std::max(time, watch_time(world, t, touches));
  if (steps * world.settings.step < time) return false;
  bool calm = true, known = true, closed = true, slowly = touches, tied = false;
  double energy = 0.0, last_peaks = 0.0, rests = 0.0;
  for (const Thing& t : island.things) {
    Rest& r = *t.rest;
    const Still rest = still(world, t, time, island.tolerance);
    calm = calm && r.peak <= rest.energy;
    const double now = kinetic_of(world, t);  // what begins to move has its largest energy now
    slowly = slowly && r.peak <= rest.slow_energy &&
             now <= std::max(most_growth * r.last_peak, unseen_slow * rest.slow_energy);
    known = known && r.last_peak >= 0.0;
    closed = closed && is_closed(t);
    tied = tied || t.articulate;
    energy += now;
    last_peaks += r.last_peak;
    rests += rest.energy;
    r = {false, 0, 0.0, r.peak, rest.speed / time, {}, 0};
  }
  const bool grows = energy > std::max(most_growth * last_peaks, unseen * rests);
  if (!known || !closed || (grows && !(touches && energy <= unsolved_energy * rests))) return false;
  if (calm && !grows && !(touches && tied)) return true;
  return (calm || slowly) && is_held(world, island);
}

void stop(World& world, const Thing& t) {
  post(world, Source::sleep, -kinetic_of(world, t));
  t.rest->asleep = true;
  if (!t.articulate) {
    world.motion[t.slot].p = world.motion[t.slot].angular = zero3();
    return;
  }
  Articulate& a = *t.articulate;
  for (Node& n : a.nodes) n.p0 = n.P0 = n.spin0 = zero3();
  a.by_tree = false;
  a.totals.kinetic = 0.0;
  store(a, world);
}

/// Bodies of an island that touches get a number that they have in common.
void number(World& world, const Island& island) {
  Contacts& contacts = world.contacts;
  std::int32_t own = -1;
  const auto add = [&](std::uint32_t slot) {
    if (own < 0) own = static_cast<std::int32_t>(slot);
    contacts.bodies[slot].island = own;
    contacts.sleepers.push_back(slot);
  };
  for (const Thing& t : island.things) {
    if (!t.articulate) add(t.slot);
    if (t.articulate)
      for (const Node& n : t.articulate->nodes)
        if (n.is_body) add(n.slot);
  }
}

/// Notes what laws do to what falls asleep.
void note_pulls(World& world, const std::vector<char>& falling) {
  if (!world.forces) return;
  const std::size_t tied = world.articulates.size();
  for (const Receiver& m : world.forces->receivers) {
    const NodePull pull = {m.force, m.torque, m.nonconservative_force, m.nonconservative_torque};
    if (m.articulate >= 0) {
      const auto i = static_cast<std::size_t>(m.articulate);
      if (!falling[i]) continue;
      Articulate& a = *world.articulates[i];
      a.rest.pulls.resize(a.nodes.size());
      a.rest.pulls[m.node] = pull;
      a.rest.receivers++;
    } else if (m.is_body && falling[tied + m.slot]) {
      Rest& rest = world.contacts.bodies[m.slot].rest;
      rest.pulls = {pull};
      rest.receivers = 1;
    }
  }
}

/// A body that touches nothing does not fall asleep, and is to be watched from the beginning.
void watch_anew(Rest& rest) {
  if (rest.steps > 0 || rest.last_peak >= 0.0) rest = {};
}

/// Bodies that nothing ties, as far as they ever touched something.
std::span<const std::uint32_t> loose_bodies(const World& world) {
  const std::vector<std::uint32_t>& all = world.loose_bodies;
  const auto end = std::lower_bound(all.begin(), all.end(), world.contacts.bodies.size());
  return {all.begin(), end};
}

/// Islands of what touches, behind each other in `things`.
std::vector<Island> islands_of(World& world, std::vector<Thing>& things) {
  Contacts& contacts = world.contacts;
  const std::size_t tied = world.articulates.size();
  const auto number = [&](std::uint32_t thing) { return island_number(world, tied, thing); };
  const std::size_t all = tied + world.bodies.slots() + (world.solids ? world.points.slots() : 0);
  Sets sets(all);
  std::vector<double> size(all, infinity);
  std::vector<char> has_points(all, 0);  // solid points are not watched: what touches them stays awake
  for (const Contact& c : contacts.list)
    if (c.body_b >= 0) sets.join(number(c.body_a), number(static_cast<std::uint32_t>(c.body_b)));
  for (const Contact& c : contacts.list) {
    const std::size_t island = sets.find(number(c.body_a));
    size[island] = std::min(size[island], c.size);
    has_points[island] |= is_point(c.body_a);
  }
  for (std::size_t i = 0; i < tied; i++)
    if (Articulate& a = *world.articulates[i]; !a.rest.asleep && has_points[sets.find(i)])
      watch_anew(a.rest);
    else if (!a.rest.asleep)
      things.push_back({i, &a, 0, sets.find(i), &a.rest});
  for (const std::uint32_t slot : loose_bodies(world)) {
    Rest& rest = contacts.bodies[slot].rest;
    if (const std::size_t island = sets.find(tied + slot); std::isfinite(size[island]) && !has_points[island])
      things.push_back({tied + slot, nullptr, slot, island, &rest});
    else
      watch_anew(rest);
  }
  sort_stably(things.begin(), things.end(), [](const Thing& x, const Thing& y) { return x.island < y.island; });
  std::vector<Island> islands;
  for (std::size_t from = 0, to = 0; from < things.size(); from = to) {
    while (to < things.size() && things[to].island == things[from].island) to++;
    const double least = size[things[from].island];
    islands.push_back({std::span(things).subspan(from, to - from),
                       std::isfinite(least) ? contact_tolerance * least / world.stage.h : 0.0});
  }
  return islands;
}

/// Does it to each island that may fall asleep. Where nothing touches each articulate is one.
template <class F>
void each_island(World& world, F&& f) {
  if (!world.contacts.list.empty()) {
    if (all_asleep(world)) return;
    std::vector<Thing> things;
    for (const Island& island : islands_of(world, things)) f(island);
    return;
  }
  for (const std::uint32_t slot : loose_bodies(world)) watch_anew(world.contacts.bodies[slot].rest);
  for (std::size_t i = 0; i < world.articulates.size(); i++) {
    Articulate& a = *world.articulates[i];
    if (a.rest.asleep) continue;
    Thing alone{i, &a, 0, i, &a.rest};
    f(Island{std::span(&alone, 1), 0.0});
  }
}

}  // namespace

void fall_asleep(World& world) {
  std::vector<char> falling;
  bool touching = false;
  const std::size_t tied = world.articulates.size();
  each_island(world, [&](const Island& island) {
    if (!is_still(world, island)) return;
    falling.resize(tied + world.bodies.slots());
    for (const Thing& t : island.things) {
      stop(world, t);
      falling[t.number] = 1;
    }
    if (island.tolerance == 0.0) return;
    number(world, island);
    touching = true;
  });
  if (falling.empty()) return;
  note_pulls(world, falling);
  if (!touching) return;
  std::sort(world.contacts.sleepers.begin(), world.contacts.sleepers.end());
  std::erase_if(world.loose_bodies, [&](std::uint32_t slot) { return falling[tied + slot] != 0; });
  sort_resting(world, world.articulates, world.contacts);
}

}  // namespace pantin
