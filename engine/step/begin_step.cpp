#include "choreography/hands.hpp"
#include "measure/measure.hpp"
#include "step/phases.hpp"

namespace pantin::phases {

namespace {

/// What the mouse did in the last step is over.
void forget_clicks(Mouse& mouse) {
  mouse.wheel = 0.0;
  for (MouseButton* button : {&mouse.left, &mouse.middle, &mouse.right}) button->pressed = button->released = false;
}

}  // namespace

void begin_step(World& world) {
  forget_clicks(world.mouse);
  const bool moved = !world.hands.empty() || !world.input.moves.empty() || !world.input.commands.empty();
  if (world.steps > 0 && !moved) return;
  const Timed timed(world.profile, Phase::begin_step);
  if (world.steps == 0) {
    world.start_energy = energy(world, everything(world)).total();  // laws add theirs when they begin to act
    world.work = 0.0;
    world.ledger.given = {};
  }
  apply_input(world, next_time(world));
}

}  // namespace pantin::phases
