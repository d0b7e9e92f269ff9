#pragma once
// One engine with one setting on one mechanism: how wrong it is and what it costs, measured alike for every engine.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "peers/mechanism.hpp"

namespace pantin::peers {

/// A mechanism at work in an engine.
class Rig {
 public:
  Rig() = default;
  virtual ~Rig() = default;
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;
  virtual void step() = 0;
  /// Places and velocities of the solids, in their order. Leaves the motion as it is.
  virtual void read(std::vector<SolidState>& state) = 0;
  /// Points at which shapes touched in the last step, as the engine counts them.
  virtual std::size_t contacts() const { return 0; }
  /// Times so far that the engine said it did not solve what touches.
  virtual std::size_t unsolved() const { return 0; }
};

/// A way to use an engine.
struct Setting {
  std::string name;
  std::function<std::unique_ptr<Rig>(const Mechanism&, double step)> make;
  bool chooses_steps = false;  ///< keeps an accuracy by steps of its own
  std::function<bool(const Mechanism&)> can = [](const Mechanism&) { return true; };  ///< what it can do at all
  bool in_plane = false;                                                              ///< takes piles in a plane
};

struct Trial {
  double error = 0.0;   ///< [m] of the measured body at compare_at
  double energy = 0.0;  ///< largest change in 5 s, relative to the largest kinetic energy
  double gap = 0.0;     ///< [m] largest separation in 5 s
  double cost = 0.0;    ///< [s] of the processor per simulated second, until compare_at
  std::string trouble;  ///< not empty: it failed, and the rest says nothing
};

/// Measures a setting. `position` [m] of the measured body at compare_at is from the reference. Energy and gap are NaN where
/// 5 s would take more than 1 s of the processor.
Trial run_trial(const Setting& setting, const Mechanism& mechanism, double rate, const Eigen::Vector2d& position);

}  // namespace pantin::peers
