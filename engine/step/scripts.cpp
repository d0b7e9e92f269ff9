// The two phases in which scripts run and may edit.
#include "choreography/choreography.hpp"
#include "choreography/hands.hpp"
#include "step/phases.hpp"

namespace pantin::phases {

void fire_events(World& world) {
  world.choreography.reached = world.time;
  if (world.choreography.heap.empty() && world.choreography.watching.empty()) return;
  const Timed timed(world.profile, Phase::fire_events);
  fire_due(world, world.time);
}

void run_behaviours(World& world) {
  const Timed timed(world.profile, Phase::run_behaviours);
  const auto told = static_cast<std::ptrdiff_t>(world.notices.size());
  if (world.behaviours) world.behaviours();
  // What the scripts themselves did is told in the next step.
  world.notices.erase(world.notices.begin(), world.notices.begin() + told);
  sample_targets(world);
}

}  // namespace pantin::phases
