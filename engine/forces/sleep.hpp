#pragma once
// What is at rest sleeps: no phase moves it, and it costs next to nothing. What touches sleeps with all that it touches and
// that touches those, and so do articulates; what stands still joins nothing. Such an island falls asleep at the end of a step
// when the kinetic energy of each of its things stayed, for as long as gravity takes to swing it, below that of its lightest
// part at a speed of 1e-8 of its length in that time (far from the origin a little more, in touch by what contacts are solved
// to), and that of all did not double from one such time to the next. What is slow and touches falls asleep as well where
// contacts would hold it at rest. So nothing sleeps at a turning point, and nothing that
// stands on its head sleeps through its fall. The energy that it still had is the ledger's line `sleep`. An edit of its
// things wakes all of it, a target that moves, another gravity, whatever has laws pull otherwise than before, and whatever is
// awake and has a contact with it.
#include "world/world.hpp"

namespace pantin {

struct Constraint;

/// Wakes what a thing moves with, in the coming step with all that sleeps with it, or has it stay awake for a while.
void wake(World& world, BodyId body);
void wake(World& world, PointId point);
void wake(World& world, const Constraint& constraint);
void wake_all(World& world);

/// At the start of a step, before articulates are found: wakes what sleeps with what an edit or a force woke.
void wake_stirred(World& world);
/// Where contacts were found: wakes what has one with something awake, and all that sleeps with it.
void wake_touched(World& world);

/// At the end of a step, once states are stored: lets things fall asleep.
void fall_asleep(World& world);
/// Where forces were found anew at the start of a step: wakes those whose forces are no longer what they slept in.
void wake_pulled(World& world);
/// The same at the end of a part of it, before the second half kick of `half` [s]: articulates that wake have then had the
/// first half kick and the drift of what rests, so that momentum is exact.
void wake_pulled(World& world, double half);

/// Whether nothing can move in this step: all sleeps, and no law changes by itself.
bool all_asleep(const World& world);
/// Articulates that sleep, and bodies that nothing ties.
std::uint64_t sleepers(const World& world);

}  // namespace pantin
