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
  refresh_forces,
  half_kick,
  place_contacts,
  drift,
  find_contacts,
  find_pairs,
  apply_forces,
  half_kick_to_end,
  project_velocities,
  meet_contacts,
  break_connections,
  end_step,
};

inline constexpr std::array<std::string_view, 17> phase_names = {
    "begin_step",        "fire_events",        "run_behaviours",
    "age_particles",     "find_articulates",   "refresh_forces",
    "half_kick",         "place_contacts",     "drift",
    "find_contacts",     "find_pairs",         "apply_forces",
    "half_kick_to_end",  "project_velocities", "meet_contacts",
    "break_connections", "end_step",
};

/// Wall time spent in each phase since the start.
struct Profile {
  std::array<std::int64_t, phase_names.size()> ns{};  ///< [ns]
  std::chrono::steady_clock::time_point now;  ///< the clock when last looked at: a look takes as long as a hinge

  /// Before the first phase of a step.
  void begin() { now = std::chrono::steady_clock::now(); }
};

/// Adds the time since the last phase ended to this one, which ends with the scope.
class Timed {
 public:
  Timed(Profile& profile, Phase phase) : profile_(profile), phase_(phase) {}
  ~Timed() {
    const auto before = profile_.now;
    profile_.begin();
    profile_.ns[static_cast<std::size_t>(phase_)] +=
        std::chrono::duration_cast<std::chrono::nanoseconds>(profile_.now - before).count();
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  Profile& profile_;
  Phase phase_;
};

}  // namespace pantin
