#pragma once
// A scene from its start with one integrator and step: what a study is made of.
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "player/options.hpp"
#include "scene/scene.hpp"

namespace pantin::player {

/// Places of things at one time, by their serial numbers: points, and centres of bodies. (things)
using Places = std::vector<std::pair<std::uint64_t, Vec3>>;

struct StudyRun {
  std::string integrator;
  double step = 0.0;             ///< [s]
  double accuracy = 0.0;         ///< [1/s] that chose sub-steps; 0: none did
  std::string trouble;           ///< why it ended early; empty: it did not
  bool finished = false;         ///< the script ended it
  double reached = 0.0;          ///< [s]
  double seconds = 0.0;          ///< [s] processor time of the steps alone
  std::vector<double> portions;  ///< [s] of which each time took, the least of all times that it was run (times)
  std::uint64_t steps = 0;
  Stats stats;
  Accuracy worst;
  std::string overlap, loosely;      ///< what is told of deep overlaps and of islands of contacts; empty: nothing
  double right_until = 0.0;          ///< [s] until then no energy was lost or made that counts beside what moves
  bool touched = false;              ///< shapes pressed on each other
  bool acted_in_steps = false;       ///< that, events, scripts, breaks or emitters did something to it in whole steps
  std::uint64_t random_numbers = 0;  ///< drawn by the script while it ran
  std::vector<Places> positions;     ///< (times that it reached)

  /// [m] from the reference: root mean square over the things, the largest until `comparable`; of the reference itself
  /// what it is surely within.
  double error = std::numeric_limits<double>::quiet_NaN();
  double farthest = std::numeric_limits<double>::quiet_NaN();  ///< [m] the same of the thing that is wrong most
  double order = std::numeric_limits<double>::quiet_NaN();     ///< by how the error fell from twice the step
  double true_until = 0.0;  ///< [s] time of the last comparison within a hundredth of the size

  double cost() const { return seconds / reached; }  ///< [s] per simulated second
};

/// Whether two runs are of one series: of an integrator over its steps, or over accuracies.
inline bool same_series(const StudyRun& a, const StudyRun& b) {
  return a.integrator == b.integrator && (a.accuracy > 0.0) == (b.accuracy > 0.0);
}

/// Whether two runs came to the end the very same way.
bool same_way(const StudyRun& a, const StudyRun& b);

/// [s] processor time of this thread so far, which nothing else on the machine lengthens.
double processor_time();

/// Opens a scene again and again, on one thread.
class Opener {
 public:
  Opener(const RunOptions& options, const std::string& home);
  const std::string& path() const { return path_; }
  /// As it stands.
  std::unique_ptr<Scene> open() const;
  /// With an integrator, a step [s] and an accuracy [1/s], 0: none.
  std::unique_ptr<Scene> open(const std::string& integrator, double step, double accuracy) const;

 private:
  SceneOptions options_;
  std::string path_;
};

/// Every so many-th thing is looked at.
using Stride = std::uint64_t;
Places places_of(const World& world, Stride stride);
double diagonal_of(const Places& places);  ///< [m] of the box round them

/// Steps to a time [s], the script's end or Ctrl-C; returns the processor time that it took, [s]. Throws what went wrong.
double step_to(Scene& scene, double time);

/// Does a run whose integrator, step and accuracy are given, and notes its places at the times. False where it was left:
/// it took more processor time than `limit` [s], or Ctrl-C came. `told` is called after each time, with the part done.
bool perform(StudyRun& run, const Opener& opener, const std::vector<double>& times, Stride stride, double limit,
             const std::function<void(double part)>& told);

/// Runs it once more, for its processor time alone.
void perform_again(StudyRun& run, const Opener& opener, const std::vector<double>& times);

}  // namespace pantin::player
