#pragma once
// A scene run over steps and integrators, and compared with the finest of its own runs.
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "player/options.hpp"

namespace pantin::player {

/// Places of things at one time, by their serial numbers: points, and centres of bodies. (things)
using Places = std::vector<std::pair<std::uint64_t, Vec3>>;

/// The scene from its start with one integrator and step.
struct StudyRun {
  std::string integrator;
  double step = 0.0;      ///< [s]
  double accuracy = 0.0;  ///< [1/s] that chose sub-steps; 0: none did
  std::string trouble;    ///< why it ended early; empty: it did not
  double reached = 0.0;   ///< [s]
  double seconds = 0.0;   ///< [s] of the clock, for the steps alone
  std::uint64_t steps = 0;
  Stats stats;
  Accuracy worst;
  std::uint64_t random_numbers = 0;  ///< drawn by the script while it ran
  std::vector<Places> places;        ///< (times that it reached)

  /// [m] from the reference: root mean square over the things, the largest until `comparable`.
  double error = std::numeric_limits<double>::quiet_NaN();
  double order = std::numeric_limits<double>::quiet_NaN();  ///< by how the error fell from twice the step
  double true_until = 0.0;  ///< [s] time of the last comparison within a hundredth of the size

  double cost() const { return seconds / reached; }  ///< [s] per simulated second
};

/// Whether two runs are of one series: of an integrator over its steps, or over accuracies.
inline bool same_series(const StudyRun& a, const StudyRun& b) {
  return a.integrator == b.integrator && (a.accuracy > 0.0) == (b.accuracy > 0.0);
}

/// An integrator that the scene refuses, or that is no other in it, and why.
struct Refused {
  std::string integrator, why;
};

struct Study {
  std::string path, title;
  double step = 0.0;       ///< [s] the scene's own
  std::string integrator;  ///< the scene's own
  bool energy_return = false;
  double wanted_until = 0.0;   ///< [s] as asked for, or the scene's end
  double until = 0.0;          ///< [s] compared: what there was time for, in whole intervals
  std::vector<double> times;   ///< [s] of comparison, without 0
  double size = 0.0;           ///< [m] diagonal of the box round all things at the start
  std::size_t things = 0;      ///< compared at the start
  double moved = 0.0;          ///< [m] furthest that anything went in the scene's own integrator's finest run
  std::vector<StudyRun> runs;  ///< series by series, the longest step first
  std::vector<Refused> refused;

  std::size_t reference = 0;          ///< the run that the others are compared with
  double uncertain = 0.0;             ///< [m] by how much it may be wrong itself, until `comparable`
  double together = 0.0;              ///< [s] until then the two finest runs stay within a hundredth of the size
  double comparable = 0.0;            ///< [s] until then errors are told: while the finest run is sure of small ones
  double growth = 0.0;                ///< [1/s] of the logarithm of their distance, where they part
  nlohmann::ordered_json ledger;      ///< [J] of the scene with its own step and integrator
  bool random = false;                ///< scripts draw random numbers while they run
  bool noisy = false;                 ///< a law draws noise
  bool emits = false;                 ///< emitters make particles
  std::vector<std::string> warnings;  ///< of the scene

  bool parts() const { return together < until; }
  const StudyRun& finest() const { return runs[reference]; }
};

/// Studies a scene within about `budget` [s] of the clock. `progress` is told what is being run, and which part of the
/// budget is spent. Throws what the scene throws with its own step and integrator.
Study study(const RunOptions& options, const std::string& home, double budget,
            const std::function<void(const std::string& what, double part)>& progress);

/// Fills what follows from the runs' places. Needs a run that reached two times.
void compare(Study& study);

/// The cheapest run whose error is surely below `error` [m], or null; of those that cost nearly the same the most exact.
const StudyRun* cheapest(const Study& study, double error);

}  // namespace pantin::player
