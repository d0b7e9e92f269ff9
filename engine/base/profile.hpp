#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <utility>

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

/// Wall time spent in each phase since the start. A look at the clock takes as long as a hinge, so of steps shorter than
/// `enough` a few are timed and stand for those before them.
struct Profile {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::microseconds enough{20};
  static constexpr int most = 17;  ///< [steps] that one stands for; no divisor of what scripts do each so many steps

  std::array<std::int64_t, phase_names.size()> ns{};  ///< [ns]
  Clock::time_point now;                              ///< when last looked at, in a step that is timed
  Clock::time_point began;                            ///< the last step that was timed
  int stands_for = 0;                                 ///< [steps] of this one; 0 where it is not timed
  int left_out = 0;                                   ///< [steps] since the last that was timed
  int period = 1;                                     ///< [steps]

  /// Before the first phase of a step.
  void begin() {
    if (stands_for > 0) {
      const auto cost = std::max<Clock::duration>(now - began, std::chrono::nanoseconds(1));
      period = 1 + static_cast<int>(std::min<Clock::rep>(enough / cost, most - 1));
      stands_for = left_out = 0;
    }
    if (++left_out < period) return;
    stands_for = left_out;
    now = began = Clock::now();
  }
};

/// Adds the time since the last phase ended to this one, which ends with the scope.
class Timed {
 public:
  Timed(Profile& profile, Phase phase) : profile_(profile), phase_(phase) {}
  ~Timed() {
    if (profile_.stands_for == 0) return;
    const auto before = std::exchange(profile_.now, Profile::Clock::now());
    profile_.ns[static_cast<std::size_t>(phase_)] +=
        profile_.stands_for * std::chrono::duration_cast<std::chrono::nanoseconds>(profile_.now - before).count();
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  Profile& profile_;
  Phase phase_;
};

}  // namespace pantin
