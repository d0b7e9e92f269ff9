#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/lanes.hpp"
#include "contacts/solve/contact_search.hpp"

namespace pantin {

/// How things are moved; `rule_of` in forces/integrator.hpp says what each is.
enum class Integrator : std::uint8_t { verlet, euler, implicit, suzuki4, rk4, adaptive };

struct NamedIntegrator {
  Integrator integrator;
  std::string_view name;
};
/// Every integrator with the name that scenes give it.
inline constexpr std::array integrators = {
    NamedIntegrator{Integrator::verlet, "verlet"},   NamedIntegrator{Integrator::implicit, "implicit"},
    NamedIntegrator{Integrator::suzuki4, "suzuki4"}, NamedIntegrator{Integrator::rk4, "rk4"},
    NamedIntegrator{Integrator::euler, "euler"},     NamedIntegrator{Integrator::adaptive, "adaptive"}};

constexpr std::string_view name_of(Integrator integrator) {
  for (const NamedIntegrator& known : integrators)
    if (known.integrator == integrator) return known.name;
  return "";
}

struct Settings {
  Vec3 gravity = vec(0, -9.81, 0);  ///< [m/s²]
  double step = 1.0 / 240.0;        ///< [s] > 0
  Integrator integrator = Integrator::verlet;
  bool accuracy_per_step = false;  ///< `accuracy` is that of a step, not of a second
  std::optional<double> accuracy;  ///< [1/s] > 0: wanted error, relative to the sizes of things; none: fixed steps
  bool energy_return = true;       ///< give back what the velocity projection took
  ContactSearch contact = ContactSearch::automatic;
  double tolerance = 1e-6;  ///< points of a new hinge may be this far apart, relative to the size of their bodies
  std::optional<Vec3> box;  ///< [m] edges of the periodic box, each > 0; none: open space
  std::uint64_t seed = 1;
  double boltzmann = 1.0;  ///< [J/K] > 0
};

}  // namespace pantin
