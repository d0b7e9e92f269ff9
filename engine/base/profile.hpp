#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>

namespace pantin {

/// The phases of a step, in their order.
enum class Phase {
  begin_step,
  fire_events,
  run_behaviours,
  age_particles,
  find_articulates,
  half_kick,
  drift,
  project_velocities,
  end_step,
};

inline constexpr std::array<std::string_view, 9> phase_names = {
    "begin_step", "fire_events", "run_behaviours",     "age_particles", "find_articulates",
    "half_kick",  "drift",       "project_velocities", "end_step",
};

/// Wall time spent in each phase since the start.
struct Profile {
  std::array<std::int64_t, phase_names.size()> ns{};  ///< [ns]
};

/// Adds the time of a scope to its phase.
class Timed {
 public:
  Timed(Profile& profile, Phase phase) : ns_(profile.ns[static_cast<std::size_t>(phase)]) {}
  ~Timed() {
    ns_ += std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - start_).count();
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  std::int64_t& ns_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace pantin
