#pragma once
// Laws of the library, and what each of their tests asks: the force against the slope of the energy, the power against
// its rate, opposite forces.
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "laws/library.hpp"
#include "support/law_state.hpp"

namespace pantin::testing {

using Numbers = std::map<std::string, double>;

std::vector<Law> make(const std::string& name, Numbers numbers = {}, std::map<std::string, Vec3> vectors = {});
LawArguments table_arguments(std::vector<double> distances, std::vector<double> potentials,
                             std::vector<double> tensions);

/// Each law of the library, with its parts.
std::vector<std::vector<Law>> one_of_each();

/// Particles somewhere near each other, moving; with every attribute that a law may want.
LawState some_particles(std::size_t count, double size, std::uint64_t seed);
/// Two particles at a distance of r, the second going away at 0.4 m/s and sideways.
LawState pair_at(double r);

inline double energy_at(const Law& law, double r) { return energy_of(law, pair_at(r)); }
inline double tension_at(const Law& law, double r) { return tension_of(law, pair_at(r)); }

/// Forces are against the slope of the energy to 1e-8 of the largest, their power is its rate.
void check_conservative(const Law& law, const LawState& state);
/// No net force, no net torque.
void check_opposite(const std::vector<Law>& laws, const LawState& state);
/// The stiffness is the slope of the tension.
void check_stiffness(const Law& law, double r);
/// All three.
void check_central(const std::vector<Law>& laws, std::initializer_list<double> distances);

}  // namespace pantin::testing
