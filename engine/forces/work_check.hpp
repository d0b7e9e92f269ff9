#pragma once
// What kicks give by laws that have no energy, held against what these forces give along the way.
#include "world/world.hpp"

namespace pantin {

/// After the kick that begins a stage of a step: notes where all is.
void note_nonconservative_forces(World& world);
/// After the kick at its end: where the stage is one of those that are looked at, asks these laws along the way, with the mean
/// velocity on it. Kicks give the forces at both ends, halves each, Δx·(F0 + F1)/2, the way Δx·(F0 + 4 Fm + F1)/6 (Simpson):
/// their difference is the step's own error, which no balance of the kicks can see. Looked at are some stages at random,
/// which stand for the others, and all in which these laws did much. Noise cannot be told so, nor is it.
void check_work(World& world);

/// What the energy error counts of it [J]: all of it where it is a large part of what these laws did, or has one sign.
double missed_work(const World& world);

}  // namespace pantin
