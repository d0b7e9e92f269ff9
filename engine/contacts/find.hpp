#pragma once
// From shapes and where they are to contacts.
#include <utility>
#include <vector>

#include "articulates/articulate.hpp"
#include "contacts/broad_phase.hpp"
#include "contacts/contact.hpp"
#include "contacts/manifold.hpp"
#include "model/model.hpp"

namespace pantin {

/// Two bodies that collide although a hinge ties them.
struct HingedPair {
  std::uint32_t a, b;  ///< slots, a < b
  Vec3 arm, axis;      ///< [m], of unit length: of the hinge and its axis, in principal axes of a; axis 0: about any
};

/// What finding contacts keeps to be quick: nothing that its result depends on.
struct ContactFinder {
  BroadPhase broad_phase;
  std::vector<std::uint32_t> height_fields;                   ///< their slots: solid far below their bounds
  std::vector<std::uint64_t> serials;                         ///< (slots of shapes) of what is in there; 0: nothing
  std::vector<std::pair<std::uint32_t, std::uint32_t>> tied;  ///< (smaller, larger) slots of bodies that do not collide
  std::vector<HingedPair> hinged;                             ///< rising
};

/// Where things are: of what rows tie in the articulates after a drift, else in the model.
struct Placement {
  const Model& model;
  const std::vector<std::unique_ptr<Articulate>>& articulates;
  bool drifted;
  Vec3 gravity;        ///< [m/s²]
  double h;            ///< [s] over which they are to be foreseen
  double drift = 0.0;  ///< [s] of the last drift, where it has
};

/// Makes a finder where there is none, and tells it what edits changed of who may touch. Whether its bounds are to be put anew.
bool renew(std::unique_ptr<ContactFinder>& finder, Model& model);
/// Puts the bounds of all shapes where they are.
void put_bounds(const Placement& placement, ContactFinder& finder);
/// Finds all contacts anew; those that were there before keep their impulses.
void find_contacts(const Placement& placement, ContactFinder& finder, Contacts& contacts);
/// Pairs of bodies that a hinge or a weld ties and that do not collide, sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> tied_bodies(const Model& model);
/// A body's shape in the world.
Pose pose_of(const Model& model, const Shape& shape);

}  // namespace pantin
