#pragma once
#include <span>

#include "contacts/bodies.hpp"
#include "contacts/stages.hpp"

namespace pantin {

/// [kg m²/s] Of these things about the origin, world axes.
Vec3 angular_momentum(const Model& model, const Articulates& articulates, std::span<const std::uint32_t> things,
                      bool drifted);
/// Turns them as if they were one body, so that they have `missing` [kg m²/s] more angular momentum, and the same momentum.
/// Nothing where they are all on a line. Returns the work of it [J].
double turn_as_one(Model& model, const Articulates& articulates, std::span<const std::uint32_t> things, Vec3 missing,
                   bool drifted);

}  // namespace pantin
