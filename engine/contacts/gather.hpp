#pragma once
// From contacts to the problems that are solved: what touches, and all that ties it, is an island.
#include <algorithm>
#include <span>
#include <vector>

#include "articulates/solve/scalar_rows.hpp"
#include "base/parallel.hpp"
#include "base/stable.hpp"
#include "base/subnormals.hpp"
#include "contacts/bodies.hpp"
#include "contacts/contact.hpp"
#include "contacts/passes.hpp"
#include "contacts/solve/island.hpp"

namespace pantin {

/// Times the thickness of the thinnest, over the length of the drift: the speed to which contacts are solved.
constexpr double contact_tolerance = 4e-11;
/// The same of what a sweep may still change.
constexpr double swept_tolerance = 4e-7;

/// What one thing was given before a drift, by contacts and by what ties answered, world axes.
struct BodyImpulse {
  std::uint32_t body;    ///< in its island
  Vec3 impulse, moment;  ///< [N s], [N m s] about its centre
};

/// A scalar of an island, and what it gave before the drift.
struct TouchScalar {
  std::uint32_t articulate;
  ScalarRow row;
  double given = 0.0;  ///< [N s]
};

/// What bore as a drift began, of a shape that rolls on to another point of the same one of the world in it: what it gives until
/// then.
struct RolledOff {
  ContactKey from;
  Placing given;
};

/// Where the parts of an island's problem come from.
struct TouchIsland {
  ContactIsland problem;
  std::vector<std::uint32_t> things;               ///< (bodies)
  std::vector<BodyState> states;                   ///< (bodies)
  std::vector<std::size_t> contacts;               ///< (contacts) index in Contacts::list
  std::vector<std::uint32_t> articulates;          ///< that are in it, rising
  std::vector<std::uint32_t> first_nodes;          ///< (articulates) body of the first node; the others follow it
  std::vector<std::array<std::uint32_t, 2>> rows;  ///< (ties) articulate and its row
  std::vector<TouchScalar> scalars;                ///< (scalars)
  std::vector<BodyLoad> pulls;                     ///< (bodies) [N], [N m] of soft rows in the last step
  std::vector<Placing> placed;                     ///< what `place` gave in it
  std::vector<RolledOff> rolled;                   ///< taken for given if it touches no more after the drift
  std::size_t first_placed = 0;                    ///< number of the first of that in the pass
  bool missed = false;                             ///< the law, by more than 100 tolerances
  bool solved = false;  ///< to 100 tolerances, masses within 1 : 100: that is taken back as its contact is now
  std::vector<BodyImpulse> given;  ///< what bodies got of that, and of ties, that is taken back as it was given
  std::vector<TouchScalar> held;   ///< what scalars within bounds gave in `place`
  ImpulseWork answered;            ///< what ties that move gave of that
  std::vector<TouchHeat> heat;     ///< of the pass, where it is kept
  double placed_work = 0.0;        ///< [J] of the report of placing
  TouchReport report;              ///< of the pass, of it alone

  void clear();  ///< keeps memory
};

/// How a thing was displaced [m], [rad], about its centre before.
struct Displaced {
  Vec3 x = zero3(), way = zero3(), turn = zero3();
  Vec3 at(Vec3 point) const { return way + cross(turn, point - x); }
};

/// Islands of each pass, whose memory and layouts last from step to step.
struct TouchSpace {
  std::vector<TouchIsland> placing, meeting;  ///< of `place`, `meet`
  std::vector<TouchIsland> opening, resting;  ///< of `push_out`, `held_at_rest`
  std::size_t placed = 0;                     ///< how many islands of `placing` there are now
  std::vector<Vec3> turned;                   ///< (as index) [N m s] what taking back left of what was foreseen
  std::vector<double> placing_work;           ///< (as index) [J] done to things by placing, and by taking that back
  std::vector<Displaced> displaced;           ///< (as index) by the last `push_out`; none: by nothing
  std::vector<std::int32_t> index;  ///< (slots of bodies, then of points where some are solid) in its island, or -1
};

/// Known by the articulate that it is in; or after these bodies by their slots, and after those points.
std::size_t island_number(const Model& model, std::size_t articulates, std::uint32_t thing);

/// Calls f(island) for each, among the threads: largest first, and where there is enough to do. What f does must concern its
/// island only.
template <class F>
void share_islands(Workers& workers, std::span<TouchIsland> islands, F&& f) {
  constexpr std::size_t enough_contacts = 32;  // some 20 us of work: a thread is slow to wake
  std::vector<std::uint32_t> order(islands.size());
  std::size_t contacts = 0;
  for (std::uint32_t i = 0; i < order.size(); i++) order[i] = i, contacts += islands[i].contacts.size();
  if (workers.count() == 1 || contacts < 2 * enough_contacts) {
    for (TouchIsland& island : islands) f(island);
    return;
  }
  sort_stably(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
    return islands[x].contacts.size() > islands[y].contacts.size();
  });
  workers.run(order.size(), [&](std::size_t task, int) {
    const SubnormalsAreZero subnormals_are_zero;
    f(islands[order[task]]);
  });
}

/// Islands of the contacts that are `used`, in the order of the smallest number of what they hold; tied things with their rows
/// as they are now, in `space`, with the index of each thing. Velocities are set, biases and starts are not.
std::span<TouchIsland> gather(std::vector<TouchIsland>& space, std::vector<std::int32_t>& index, Workers& workers,
                              Model& model, const Articulates& articulates, const Contacts& contacts,
                              const TouchSettings& settings, const std::vector<char>& used);

}  // namespace pantin
