#include "contacts/held.hpp"

#include <algorithm>
#include <cmath>

#include "contacts/pass_parts.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {

namespace {

constexpr double unmoved = 10.0;  // of the tolerance: speed after a step from rest

/// Velocities of a step from rest without contacts and ties.
void fall_from_rest(const Model& model, TouchIsland& island, const TouchSettings& settings,
                    std::span<const BodyLoad> pulls) {
  for (std::size_t i = 0; i < island.things.size(); i++) {
    const std::uint32_t thing = island.things[i];
    const std::size_t number = is_point(thing) ? model.bodies.slots() + slot_of(thing) : thing;
    BodyLoad load = island.pulls[i];
    if (number < pulls.size()) load = {load.force + pulls[number].force, load.moment + pulls[number].moment};
    IslandBody& b = island.problem.bodies[i];
    b.v0 = model.plane.along(settings.gravity + load.force * b.inverse_mass) * settings.h;
    b.w0 = b.inverse_inertia * load.moment * settings.h;
  }
}

/// Speeds of surfaces over those at the levers of rolling and spinning, at which these are solved; 1 without.
double rolling_by_lever(const ContactIsland& island) {
  double most = 1.0;
  for (const IslandRoll& r : island.rolls)
    for (int k = 0; k < 3; k++)
      if (r.lever[k] > 0.0)
        most =
            std::fmax(most, island.bodies[static_cast<std::size_t>(island.contacts[r.contact].a)].reach / r.lever[k]);
  return most;
}

bool is_held(const Contacts& contacts, const Articulates& articulates, TouchIsland& island, double h) {
  ContactIsland& problem = island.problem;
  start_meeting(island, contacts, articulates);
  set_scalars(island, articulates, h, h);
  hold_ties(problem);
  const double most = unmoved * problem.tolerance;
  problem.tolerance /= rolling_by_lever(problem);
  if (solve_island(problem).residual > most) return false;
  return std::all_of(problem.bodies.begin(), problem.bodies.end(),
                     [&](const IslandBody& b) { return norm(b.v) <= most && norm(b.w) * b.reach <= most; });
}

}  // namespace

bool held_at_rest(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates,
                  const Contacts& contacts, const TouchSettings& settings, const std::vector<char>& used,
                  std::span<const BodyLoad> pulls, std::span<const std::size_t> things) {
  const std::span<TouchIsland> islands =
      gather(space.resting, space.index, workers, model, articulates, contacts, settings, used);
  hold_again(articulates);
  std::vector<std::size_t> touching;
  for (const TouchIsland& island : islands)
    for (const std::uint32_t thing : island.things) touching.push_back(island_number(model, articulates.size(), thing));
  std::sort(touching.begin(), touching.end());
  const auto touches = [&](std::size_t thing) { return std::binary_search(touching.begin(), touching.end(), thing); };
  return std::all_of(things.begin(), things.end(), touches) &&
         std::all_of(islands.begin(), islands.end(), [&](TouchIsland& island) {
           fall_from_rest(model, island, settings, pulls);
           return is_held(contacts, articulates, island, settings.h);
         });
}

}  // namespace pantin
