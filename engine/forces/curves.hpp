#pragma once
// What follows the age of particles: its values at a time.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "laws/curve.hpp"
#include "world/world.hpp"

namespace pantin {

/// What a curve gives at a time [s]; none where the particle has no curve of that name.
std::optional<double> curve_value(const World& world, ParticleId particle, std::string_view name, double time);
/// The color of a particle now: its curve's, its own, or its first point's.
Color present_color(const World& world, ParticleId particle);
/// Its radius now [m], in the same order.
double present_radius(const World& world, ParticleId particle);

/// The particle's own, else its family's, else a ball.
Look look_of(const World& world, const Particle& particle);

/// Evaluates the curves of one name in blocks: writes output k of particle `slots[i]` (slot of Model::particles) to
/// columns[k][i], where that particle has such a curve; leaves the others.
void follow_curves(const World& world, std::string_view name, double time, std::span<const std::uint32_t> slots,
                   std::span<double* const> columns);

}  // namespace pantin
