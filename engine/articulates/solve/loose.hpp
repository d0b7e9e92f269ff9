#pragma once
// A node without rows: what nothing ties. It turns by the preprocessed discrete Moser-Veselov algorithm (Hairer and Vilmart
// 2006), of the fourth order: energy, and angular momentum in the world, stay to round-off.
#include "articulates/articulate.hpp"

namespace pantin {

/// Moves a node without rows by h [s], under its constant force and torque; of a torque half acts before the turn, and half
/// after it, which is of the second order. Where it turns too fast for one step it takes several.
void drift_alone(Node& node, double h);
/// Turns a node by h [s], with its angular momentum fixed in the world.
void turn_freely(Node& node, double h);

}  // namespace pantin
