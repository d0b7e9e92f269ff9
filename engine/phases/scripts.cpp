// The two phases in which scripts run and may edit.
#include "phases/phases.hpp"

namespace pantin::phases {

void fire_events(World& world) {
  const Timed timed(world.profile, Phase::fire_events);
  pantin::fire_events(world, next_time(world));
}

void run_behaviours(World& world) {
  const Timed timed(world.profile, Phase::run_behaviours);
  if (world.behaviours) world.behaviours();
  world.notices.clear();
}

}  // namespace pantin::phases
