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

/// What finding contacts keeps to be quick: nothing that its result depends on.
struct ContactFinder {
  BroadPhase broad_phase;
  std::vector<std::uint64_t> serials;                         ///< (slots of shapes) of what is in there; 0: nothing
  std::vector<std::pair<std::uint32_t, std::uint32_t>> tied;  ///< (smaller, larger) slots of bodies that do not collide
};

/// Where things are: of what rows tie in the articulates after a drift, else in the model.
struct Placement {
  const Model& model;
  const std::vector<std::unique_ptr<Articulate>>& articulates;
  bool drifted;
  Vec3 gravity;  ///< [m/s²]
  double h;      ///< [s] over which they are to be foreseen
};

/// Finds all contacts anew; those that were there before keep their impulses.
void find_contacts(const Placement& placement, ContactFinder& finder, Contacts& contacts);
/// Pairs of bodies that a hinge or a weld ties and that do not collide, sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> tied_bodies(const Model& model);
/// A body's shape in the world.
Pose pose_of(const Model& model, const Shape& shape);

}  // namespace pantin
