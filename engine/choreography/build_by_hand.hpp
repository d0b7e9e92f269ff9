#pragma once
// What hands make, tie together and drive.
#include "world/world.hpp"

namespace pantin {

/// The body that is meant where the command has no point; null: none.
BodyId body_meant(const Command& command);
/// The point that is meant, or a new one at the position on the body that is.
PointId point_meant(World& world, const Command& command, std::string name = "");

/// A thing of the command's form, hinged to what its ends are at; a wheel turns about its axle there. Throws Error where it
/// cannot be, and nothing is changed.
void make_by_hand(World& world, const Command& command);
/// Draws two points, or places on bodies, together, and hinges them. Throws Error where it cannot be, and nothing is changed.
void join_by_hand(World& world, const Command& command);
/// A rod, rope, chain or spring between two points, places on bodies, or a place in the world. A rope is one string; a chain
/// is of rods that touch things. A spring swings what it holds three times a second, and dies down. Throws Error where it
/// cannot be, and nothing is changed.
void tie_by_hand(World& world, const Command& command);
/// A motor about the axis `amount` with that speed [rad/s], of a body against what it is hinged to, or nailed; 0 takes it
/// away. It has the torque to lift all that is tied to it by its own reach, and some more. Throws Error where it turns against nothing.
void drive_by_hand(World& world, const Command& command);

}  // namespace pantin
