#pragma once
// A scene run over steps and integrators, and compared with the finest of its own runs.
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "player/ledger.hpp"
#include "player/study_run.hpp"

namespace pantin::player {

/// An integrator that the scene refuses, or that is no other in it, and why.
struct Refused {
  std::string integrator, why;
};

struct Study {
  std::string path, title;
  double step = 0.0;       ///< [s] the scene's own
  std::string integrator;  ///< the scene's own
  bool energy_return = false;
  double wanted_until = 0.0;  ///< [s] as asked for, or the scene's end
  double until = 0.0;         ///< [s] compared: what there was time for, in whole intervals
  std::vector<double> times;  ///< [s] of comparison, without 0
  double size = 0.0;          ///< [m] diagonal of the box round all things at the start
  std::size_t things = 0;     ///< compared at the start
  double moved = 0.0;         ///< [m] furthest that anything went in the scene's own integrator's finest run, while its
                              ///< energy is right
  std::vector<StudyRun> runs;  ///< series by series, the longest step first
  std::vector<Refused> refused;

  std::size_t reference = 0;          ///< the run that the others are compared with
  double uncertain = 0.0;             ///< [m] by how much it may be wrong itself, until `comparable`
  double together = 0.0;              ///< [s] until then three runs agree that it is right to a hundredth of the size
  double comparable = 0.0;            ///< [s] until then errors are told: while the finest run is sure of small ones
  double growth = 0.0;                ///< [1/s] of the logarithm of the finest runs' distance, where they part
  std::optional<std::size_t> loser;   ///< the finest runs part where this one of them loses or makes energy
  bool chaotic = false;               ///< they part because small errors grow
  std::optional<LedgerLines> ledger;  ///< of the scene with its own step and integrator
  bool random = false;                ///< scripts draw random numbers while they run
  bool noisy = false;                 ///< a law draws noise
  bool emits = false;                 ///< emitters make particles
  std::vector<std::string> warnings;  ///< of the scene

  bool unresolved() const { return loser.has_value(); }
  bool parts() const { return together < until; }
  bool touches() const {
    return std::any_of(runs.begin(), runs.end(), [](const StudyRun& run) { return run.touched; });
  }
  const StudyRun& finest() const { return runs[reference]; }
  /// [m] What the error of a run, or that of its worst thing, is at most.
  double error_of(const StudyRun& run) const { return run.error + (&run == &finest() ? 0.0 : uncertain); }
  double farthest_of(const StudyRun& run) const { return run.farthest + (&run == &finest() ? 0.0 : finest().farthest); }
};

/// Studies a scene within about `budget` [s] of processor time; where a time is asked for, it takes as long as its first
/// runs need. `progress` is told what is being run, and which part of all is done. Throws what the scene throws with each
/// of its steps.
Study study(const RunOptions& options, const std::string& home, double budget,
            const std::function<void(const std::string& what, double part)>& progress);

/// The longest of … 0.5, 1, 2, 5, 10 … that is not longer: what is compared does not change with every load of the machine.
double round_time(double seconds);

/// Root mean square over the things that both have, [m]; the largest over the times that both reached. NaN where there
/// are none.
double distance(const StudyRun& a, const StudyRun& b);

/// Fills what follows from the runs' places. Needs a run that reached two times.
void compare(Study& study);

/// The cheapest run whose error is surely below `error` [m], as are those of all shorter steps of its series, or null; of
/// those that cost nearly the same the first, unless another is more exact by far.
const StudyRun* cheapest(const Study& study, double error);

}  // namespace pantin::player
