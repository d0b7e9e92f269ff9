#pragma once
// Articulates at rest sleep: no phase moves them, and they cost next to nothing. One falls asleep at the end of a step when
// its kinetic energy stayed, for as long as gravity takes to swing it, below that of its lightest thing at a speed of 1e-8
// of its length in that time (far from the origin a little more), and did not double from one such time to the next. So
// nothing sleeps at a turning point, and nothing that stands on its head sleeps through its fall. The energy that it still
// had is the ledger's line `sleep`. An edit of its things wakes it, a target that moves, another gravity, and whatever has
// laws pull otherwise than before.
#include "world/world.hpp"

namespace pantin {

struct Constraint;

/// Wakes the articulate of a thing, if it has one, or has it stay awake for a while.
void wake(World& world, BodyId body);
void wake(World& world, PointId point);
void wake(World& world, const Constraint& constraint);
void wake_all(World& world);

/// At the end of a step, once states are stored: lets articulates fall asleep.
void fall_asleep(World& world);
/// Where forces were found anew at the start of a step: wakes those whose forces are no longer what they slept in.
void wake_pulled(World& world);
/// The same at the end of a part of it, before the second half kick of `half` [s]: what wakes has then had the first half
/// kick and the drift of what rests, so that momentum is exact.
void wake_pulled(World& world, double half);

/// Whether nothing can move in this step: all is tied and asleep, and no law changes by itself.
bool all_asleep(const World& world);
std::uint64_t sleepers(const World& world);

}  // namespace pantin
