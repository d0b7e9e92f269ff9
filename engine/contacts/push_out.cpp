// What overlaps all the same is opened: displacements of least mass-weighted squares, without friction.
#include <algorithm>
#include <cmath>

#include "articulates/solve/fallback_step.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/state.hpp"
#include "contacts/pass_parts.hpp"
#include "contacts/passes.hpp"
#include "contacts/turn_back.hpp"

namespace pantin {

namespace {

constexpr double told_overlap = 3e-4;                      // of the size: what overlaps more is pushed out,
constexpr double left_overlap = 2e-4;                      // down to this
constexpr double deep = 1e-3;                              // of the size: what is less deep and tied to nothing is
constexpr std::uint8_t shallow_every = 4;                  // pushed out in each fourth step alone, by as much more
constexpr double pushed_a_step = 0.2, most_a_step = 5e-3;  // of what is too much; of the size
constexpr double most_at_rest = 1e-3;                      // of the size: what opens so much is not at rest
constexpr double farthest_pushed = 10.0;                   // times the largest opening: what ties hold goes no farther

struct Overlaps {
  const Model& model;
  const Articulates& articulates;
  const Contacts& contacts;

  bool is_deeper(std::size_t k, double than) const { return contacts.list[k].gap < -than * contacts.list[k].size; }
  bool is_told(std::size_t k) const { return is_deeper(k, told_overlap); }
  bool is_tied(std::uint32_t thing) const {
    return island_number(model, articulates.size(), thing) < articulates.size();
  }
  /// Whether it does not wait.
  bool is_urgent(std::size_t k) const {
    const Contact& c = contacts.list[k];
    const auto ties = [&] {
      return is_tied(c.body_a) || (c.body_b >= 0 && is_tied(static_cast<std::uint32_t>(c.body_b)));
    };
    return is_deeper(k, deep) || (is_told(k) && ties());
  }
};

double fastest(const ContactIsland& island) {
  double most = 0.0;
  for (const IslandBody& b : island.bodies) most = std::fmax(most, norm(b.v) + norm(b.w) * b.reach);
  return most;
}

/// Where light things that are tied would have to go far to let heavy ones go a little, all go less far: opened is then a part.
void limit_displacements(ContactIsland& island, double most) {
  if (!island.is_tied()) return;
  const double now = fastest(island);
  if (!(now > most)) return;
  for (IslandBody& b : island.bodies) {
    b.v *= most / now;
    b.w *= most / now;
  }
}

/// What an articulate ties did not turn.
void keep_from_turning(const Model& model, std::size_t articulates, std::uint32_t articulate, TouchIsland& island) {
  for (std::size_t i = 0; i < island.things.size(); i++)
    if (island_number(model, articulates, island.things[i]) == articulate) island.problem.bodies[i].w = zero3();
}

/// Whether they rest is asked from now on.
void keep_awake(const Model& model, const Articulates& articulates, Contacts& contacts, const TouchIsland& island) {
  for (const std::uint32_t a : island.articulates) wake(*articulates[a]);
  for (const std::uint32_t thing : island.things)
    if (!is_point(thing) && model.motion[thing].articulate < 0) contacts.bodies[thing].rest = {};
}

/// Whether nothing holds or touches the world.
bool is_alone(const TouchIsland& island, const Articulates& articulates, const Contacts& contacts) {
  return std::none_of(island.contacts.begin(), island.contacts.end(),
                      [&](std::size_t k) { return contacts.list[k].body_b < 0; }) &&
         std::all_of(island.articulates.begin(), island.articulates.end(),
                     [&](std::uint32_t a) { return is_free(*articulates[a]); });
}

/// Takes contacts along with what was displaced a little; they are found anew where it was more.
void move_along(const Model& model, const std::vector<Displaced>& displaced, Contacts& contacts) {
  constexpr double little = 5e-3;  // of the size: within the margin of bounds
  for (Contact& c : contacts.list) {
    const Vec3 of_a = displaced[number_of(model, c.body_a)].at(c.at);
    const Vec3 of_b =
        c.body_b < 0 ? zero3() : displaced[number_of(model, static_cast<std::uint32_t>(c.body_b))].at(c.at);
    if (std::fmax(norm2(of_a), norm2(of_b)) > little * little * c.size * c.size) contacts.stale = true;
    const bool in_point = is_point(c.body_a) && !(c.body_b >= 0 && is_point(static_cast<std::uint32_t>(c.body_b)));
    c.at += c.body_b < 0 || in_point ? of_a : (of_a + of_b) * 0.5;
    c.gap += dot(c.normal, of_a - of_b);
  }
}

}  // namespace

void push_out(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
              const TouchSettings& settings, TouchReport& sum) {
  std::vector<Displaced>& displaced = space.displaced;
  displaced.clear();
  std::vector<char> used(contacts.list.size(), 0);
  const Overlaps overlaps{model, articulates, contacts};
  bool any = false, any_urgent = false;
  for (std::size_t k = 0; k < used.size(); k++) {
    const Contact& c = contacts.list[k];
    used[k] = !c.from_before && c.gap <= 0.02 * c.size;
    any = any || overlaps.is_told(k);
    any_urgent = any_urgent || overlaps.is_urgent(k);
  }
  if (!any) return;
  const bool shallow_too = ++contacts.shallow_left >= shallow_every;
  if (shallow_too) contacts.shallow_left = 0;
  if (!shallow_too && !any_urgent) return;
  const double h = settings.h;
  const std::span<TouchIsland> islands =
      gather(space.opening, space.index, workers, model, articulates, contacts, settings, used);
  displaced.assign(space.index.size(), {});
  each_island(workers, islands, sum, [&](TouchIsland& island, TouchReport& report) {
    ContactIsland& problem = island.problem;
    problem.rolls.clear();
    const auto any_is = [&](auto which) { return std::any_of(island.contacts.begin(), island.contacts.end(), which); };
    const bool is_urgent = any_is([&](std::size_t k) { return overlaps.is_urgent(k); });
    if (!is_urgent && !(shallow_too && any_is([&](std::size_t k) { return overlaps.is_told(k); }))) return;
    const double part = is_urgent ? pushed_a_step : shallow_every * pushed_a_step;
    const double before = kinetic_energy_now(model, island);
    problem.calm = is_calm(problem, before) ? infinity : -infinity;
    const Vec3 turning = angular_momentum(model, articulates, island.things, settings.drifted);
    for (IslandBody& b : problem.bodies) b.v0 = b.w0 = zero3();
    for (IslandTie& t : problem.ties) t.wanted = zero3();
    set_scalars(island, articulates, h, 0.0);
    for (std::size_t k = 0; k < problem.scalars.size(); k++) problem.scalars[k].bias += island.scalars[k].row.wanted;
    double largest = 0.0, size = infinity;
    for (std::size_t k = 0; k < problem.contacts.size(); k++) {
      const Contact& from = contacts.list[island.contacts[k]];
      IslandContact& c = problem.contacts[k];
      const double left = left_overlap * from.size;
      const double wanted =
          from.gap < -left ? std::max(part * (from.gap + left), -most_a_step * from.size) : std::max(from.gap, 0.0);
      c.friction = 0.0;
      c.bias = vec(wanted / h, 0, 0);
      largest = std::fmax(largest, -wanted / h);
      size = std::fmin(size, from.size);
    }
    problem.tolerance *= 1e4;
    problem.enough *= 1e2;
    solve_pass(contacts, island, Pass::push_out, settings.search, report);
    limit_displacements(problem, farthest_pushed * largest);
    for (const std::uint32_t a : island.articulates) {
      report.work -= add_energies_of_solved_laws(*articulates[a], 1.0);
      articulates[a]->saved = articulates[a]->nodes;
    }
    for (std::size_t i = 0; i < island.things.size(); i++)
      displace(model, island.states[i], island.things[i], model.plane.along(problem.bodies[i].v) * h,
               problem.bodies[i].w * h);
    for (const std::uint32_t a : island.articulates) {
      if (!close_displaced(*articulates[a])) keep_from_turning(model, articulates.size(), a, island);
      report.work += add_energies_of_solved_laws(*articulates[a], -1.0);
    }
    if (std::fmin(largest, fastest(problem)) * h > most_at_rest * size)
      keep_awake(model, articulates, contacts, island);
    for (std::size_t i = 0; i < island.things.size(); i++) {
      const Vec3 way = position_of(model, island.states[i], island.things[i]) - island.states[i].x,
                 turn = problem.bodies[i].w * h;
      report.work -= problem.bodies[i].mass * dot(settings.gravity, way);
      const std::size_t number = number_of(model, island.things[i]);
      if (number < displaced.size()) displaced[number] = {island.states[i].x, way, turn};
    }
    if (is_alone(island, articulates, contacts))
      turn_as_one(model, articulates, island.things,
                  turning - angular_momentum(model, articulates, island.things, settings.drifted), settings.drifted);
    report.work += kinetic_energy_now(model, island) - before;
  });
  hold_again(articulates);
  move_along(model, displaced, contacts);
}

}  // namespace pantin
