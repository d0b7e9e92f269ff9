#include "forces/forces.hpp"

#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "step/phases.hpp"
#include "step/touch.hpp"

namespace pantin::phases {

namespace {

/// A law that fails stops the world at the end of the step, in its last good state.
template <class Run>
void run_or_fail(World& world, Run run) {
  if (!world.trouble.empty()) return;
  try {
    run(world);
  } catch (const Error& error) { world.trouble = error.what(); }
}

/// What came since the integrator was set is told with where that was.
void check_integrator(const World& world) {
  try {
    require_integrator_fits(world);
  } catch (const Error& error) { throw Error(place_of_integrator(world) + error.what()); }
}

}  // namespace

void refresh_forces(World& world) {
  if (!world.unchecked && !world.force_elements_changed && !world.forces) return;
  const Timed timed(world.profile, Phase::refresh_forces);
  try {
    if (world.unchecked) check_integrator(world);
    world.unchecked = false;
    bool anew = world.force_elements_changed || !acting_now(world);
    refresh_laws(world);
    while (world.force_elements_changed) {  // connections were found too stiff
      anew = true;
      find_articulates(world);
      refresh_laws(world);
    }
    if (!anew) return;
    wake_pulled(world);
    tell_idle(world);
  } catch (const Error& error) {
    world.failure = error.what();
    log_line(world, "failure", world.failure);
  }
}

void find_pairs(World& world) {
  if (!world.forces) return;
  const Timed timed(world.profile, Phase::find_pairs);
  run_or_fail(world, renew_pairs);
}

void apply_forces(World& world) {
  if (!world.forces) return;
  const Timed timed(world.profile, Phase::apply_forces);
  run_or_fail(world, find_forces_after_drift);
  post_opening(world);
}

}  // namespace pantin::phases
