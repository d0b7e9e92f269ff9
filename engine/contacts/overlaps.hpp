#pragma once
// What overlaps deeply: the deepest so far, and what stays so where it was put.
#include <vector>

#include "contacts/contact.hpp"
#include "model/model.hpp"

namespace pantin {

/// Of the thickness of the thinner shape: what overlaps by more is told.
constexpr double deep_overlap = 0.01;

/// After a step, at `time` [s]: keeps the deepest.
void note_deepest(const Model& model, Contacts& contacts, double time);

/// Once contacts are found where an edit put things, after `steps` steps: keeps those that overlap deeply.
void note_put(Contacts& contacts, std::uint64_t steps);

/// Two that overlap where they were put, for longer than it takes to push them out by half, and by more than half.
struct Stuck {
  TouchPair pair;
  double depth = 0.0;  ///< [m]
};

/// After a step, the deepest first: those that are due; they are forgotten.
std::vector<Stuck> take_stuck(const Model& model, Contacts& contacts, std::uint64_t steps);

}  // namespace pantin
