#pragma once
// `pantin test soak`: whether scenes go on and on as they began.
#include <cstdint>
#include <string>
#include <vector>

namespace pantin::player {

struct SoakOptions {
  std::string scene;        ///< a path or a shipped scene's name; empty: all shipped scenes
  std::uint64_t steps = 0;  ///< 0: an hour of simulated time
};

/// One scene's life: a tenth of its steps are warm-up, then its first and its last quarter are compared.
struct Soak {
  std::string scene;
  std::uint64_t steps = 0;
  double memory_early = 0.0,
         memory_late = 0.0;  ///< [MiB] resident but for what probes keep, after the warm-up and at the end
  double step_early = 0.0, step_late = 0.0;      ///< [µs] of processor time a step, in a quarter of the steps
  double energy_early = 0.0, energy_late = 0.0;  ///< [1] worst error until the first quarter is over, and the end
  double gap = 0.0;                              ///< [m] worst hinge gap
  double extent = 1.0;                           ///< [m] largest coordinate at the end, at least 1
  std::string trouble;                           ///< the error that it stopped with
  /// What is not as it should be; empty: nothing.
  std::string fault() const;
};

Soak soak_scene(const std::string& path, const std::string& home, std::uint64_t steps);
/// Prints a table. Returns the exit code: 1 if a scene has a fault.
int soak(const SoakOptions& options, const std::string& home);

}  // namespace pantin::player
