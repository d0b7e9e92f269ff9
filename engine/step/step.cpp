#include "step/step.hpp"

#include "base/subnormals.hpp"
#include "choreography/choreography.hpp"
#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "step/break_at_once.hpp"
#include "step/phases.hpp"
#include "step/reject.hpp"
#include "step/touch.hpp"
#include "world/checks.hpp"

namespace pantin {

namespace {

/// No step, and no restore, may be begun in its scope.
class Stepping {
 public:
  explicit Stepping(World& world) : world_(world) {
    require(!world.stepping && !world.locked, "step: a step is under way; the next can be made when it is done");
    world_.stepping = true;
  }
  ~Stepping() { world_.stepping = false; }
  Stepping(const Stepping&) = delete;
  Stepping& operator=(const Stepping&) = delete;

 private:
  World& world_;
};

}  // namespace

void step(World& world) {
  const Stepping stepping(world);
  if (!world.failure.empty()) return;
  internal::check_settings(world.settings);
  world.profile.begin();
  phases::begin_step(world);
  phases::fire_events(world);
  phases::run_behaviours(world);
  phases::age_particles(world);
  const Lock lock(world);
  {
    const SubnormalsAreZero subnormals_are_zero;
    phases::find_articulates(world);
    phases::refresh_forces(world);
    if (!world.failure.empty()) return;
    const bool touching = may_touch(world);
    if (touching) divide_for_contacts(world);
    keep_start(world);
    constexpr int most_breaks = 16;  // at once, one after the other; what is left breaks at the end
    int breaks = 0;
    do {
      const std::uint32_t count = all_asleep(world) ? 0 : stage_count(world);
      for (std::uint32_t stage = 0; stage < count && !misses_accuracy(world); stage++) {
        begin_stage(world, stage);
        phases::half_kick(world);
        if (touching) phases::place_contacts(world);
        phases::drift(world);
        if (touching) phases::find_contacts(world);
        phases::find_pairs(world);
        phases::apply_forces(world);
        phases::half_kick_to_end(world);
        phases::project_velocities(world);
        if (touching) phases::meet_contacts(world);
      }
    } while ((breaks < most_breaks && !misses_accuracy(world) && breaks_at_once(world) && ++breaks) ||
             is_to_be_done_again(world));
    phases::break_connections(world);
  }
  phases::end_step(world);
}

void advance(World& world, double until) {
  internal::require_finite("advance", "until", until, "s");
  internal::check_settings(world.settings);
  while (world.failure.empty() && world.time < until - 0.5 * world.settings.step) step(world);
}

}  // namespace pantin
