#pragma once
// A step whose error is above `scene.accuracy` is rejected: done again with more sub-steps, from the state kept at its start. So
// is one in which something broke at once, without what broke.
#include "articulates/articulate.hpp"
#include "world/world.hpp"

namespace pantin {

struct ArticulateStart {
  ArticulateState state;
  std::vector<Vec3> forces, offsets;  // (rows) [N], [m]
  std::vector<Node> nodes;            // where it sleeps: else they are loaded from the model
};

/// What a step changes, beside loose things, which World keeps in any case.
struct StepStart {
  bool kept = false;  ///< the step may have to be done again
  std::vector<ArticulateStart> articulates;
  Ledger ledger;
  Stats stats;
  Contacts contacts;
  std::vector<std::uint32_t> loose_bodies;
  double work = 0.0, nonconservative_work = 0.0;  // [J]
  WorkCheck work_check;
  std::uint64_t instant = 0;
};

/// Keeps what a step changes before its end, where it may have to be done again; momenta in any case.
void keep_start(World& world);
/// All is as it was at the start of the step, with the work of what was given up told nowhere. Only where that was kept.
void put_start_back(World& world);
/// After a stage of a step: notes its error.
void note_error(World& world);
/// Whether the error is above what is wanted, and more sub-steps may be had.
bool misses_accuracy(const World& world);
/// After the stages of a step: whether it is to be done again; all is then as it was at its start, with more sub-steps. Else
/// chooses those of the next step, and tells where not even the most are enough.
bool is_to_be_done_again(World& world);

}  // namespace pantin
