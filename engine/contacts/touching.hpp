#pragma once
// Who begins and who ends to touch.
#include <vector>

#include "contacts/contact.hpp"
#include "contacts/passes.hpp"
#include "model/model.hpp"

namespace pantin {

/// Two touch from the step on in which they press on each other or their gap is at most 1e-5 of the thickness of the thinner
/// shape, until a step at whose end they do neither and all their gaps are above 1e-3 of it. What a sensor is part of touches
/// where it overlaps.
struct TouchChanges {
  std::vector<Touch> touched;     ///< by pair
  std::vector<TouchPair> parted;  ///< rising
};

/// Whether the two touch there, as above.
bool presses(const Contact& contact);
/// Who touches there; nothing where one of them is gone. `body_b` -1: the world's shape in the slot `shape_b`.
TouchPair pair_of(const Model& model, std::uint32_t body_a, std::int32_t body_b, std::uint32_t shape_b);
/// A body, or the particle of a point; nothing where it is gone.
AnyId thing_of(const Model& model, std::uint32_t thing);
/// What the first of a contact touches: such a thing, or a shape of the world.
AnyId second_of(const Model& model, std::int32_t body_b, std::uint32_t shape_b);
/// Begins or ends to watch. What touches already is not told.
void watch(const Model& model, Contacts& contacts, bool watched);
/// Those that touch now, rising; where that is not watched, by their contacts.
std::vector<TouchPair> touching_now(const Model& model, const Contacts& contacts);
/// After a stage of a step: adds what pressed to `contacts.felt`.
void feel(const Model& model, const Articulates& articulates, Contacts& contacts);
/// After a step: what changed in it.
TouchChanges take_changes(const Model& model, Contacts& contacts);
/// How deep shapes overlap at most [m].
double penetration(const Contacts& contacts);

}  // namespace pantin
