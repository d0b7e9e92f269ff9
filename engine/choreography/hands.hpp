#pragma once
#include "world/world.hpp"

namespace pantin {

/// Index of a new hand; one with a `path` [m] of time [s] moves by itself.
std::int32_t add_hand(World& world, std::function<Vec3(double)> path = {});
/// Takes hold of a point with at most `max_force` [N] (default: `usual_grab_force`); lets go of what it held.
void grab(World& world, std::int32_t hand, PointId point, std::optional<double> max_force = {});
void release(World& world, std::int32_t hand);
/// A force that lifts and swings what hangs at the point with ease: 20 times its weight, or without gravity what moves it
/// by its own size in a fifth of a second. [N]
double usual_grab_force(const World& world, PointId point);
/// The hand of that index; hands of the outside come as they are needed: a second finger is a second hand.
Hand& hand_of_input(World& world, std::int32_t hand);
/// Moves the hands to `time` [s], and carries out the input's commands.
void apply_input(World& world, double time);
/// Places of the targets of follows at the end of the coming step, and how far what is drawn in has come by then. After
/// the scripts, which may make follows or change the step's length.
void sample_targets(World& world);

}  // namespace pantin
