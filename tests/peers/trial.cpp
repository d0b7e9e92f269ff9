#include "peers/trial.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

namespace pantin::peers {

namespace {

constexpr double duration = 5.0;      // [s]
constexpr double most_seconds = 1.0;  // [s] of the processor

double processor_time() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// [s] per simulated second: the fastest of several runs to compare_at.
double measure_cost(const Setting& setting, const Mechanism& mechanism, double rate) {
  const long steps = std::lround(mechanism.compare_at * rate);
  const double begin = processor_time();
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 10 && (run == 0 || processor_time() - begin < 0.15); run++) {
    const auto rig = setting.make(mechanism, 1.0 / rate);
    const double start = processor_time();
    for (long i = 0; i < steps; i++) rig->step();
    best = std::min(best, (processor_time() - start) / mechanism.compare_at);
  }
  return best;
}

/// Largest changes of energy and separations, from after each step. Some engines keep velocities of half a step before:
/// the energy with the mean of two neighbouring velocities is followed, too, and the smaller change counts.
class Observer {
 public:
  Observer(const Mechanism& mechanism, Rig& rig) : mechanism_(mechanism) {
    rig.read(now_);
    check_start();
    start_ = potential_energy(mechanism, now_);
  }

  void look(Rig& rig) {
    std::swap(before_, now_);
    rig.read(now_);
    const double kinetic = kinetic_energy(mechanism_, now_), total = kinetic + potential_energy(mechanism_, now_);
    if (!std::isfinite(total)) throw std::runtime_error("not finite");
    if (kinetic > 1e3 * std::max(1.0, -start_ + fall())) throw std::runtime_error("blew up");
    kinetic_ = std::max(kinetic_, kinetic);
    change_ = std::max(change_, std::fabs(total - start_));
    mean_change_ = std::max(mean_change_, std::fabs(energy_between() - start_));
    gap_ = std::max(gap_, largest_separation(mechanism_, now_));
  }

  double energy() const { return std::min(change_, mean_change_) / kinetic_; }
  double gap() const { return gap_; }
  const SolidState& measured() const { return now_[static_cast<std::size_t>(mechanism_.measured)]; }

 private:
  void check_start() const {
    for (std::size_t i = 0; i < now_.size(); i++) {
      const SolidDef& def = mechanism_.solids[i];
      if ((now_[i].position - def.at).norm() > 1e-6 * (1 + def.at.norm()) || now_[i].velocity.norm() > 1e-6 ||
          now_[i].turn.angularDistance(def.turn) > 1e-6)
        throw std::runtime_error("does not start where it should");
    }
  }

  /// [J] that weights give up by falling through the mechanism's size.
  double fall() const {
    double sum = 0.0;
    for (const SolidDef& solid : mechanism_.solids) sum += solid.mass * gravity * static_cast<double>(now_.size());
    return sum;
  }

  double energy_between() {
    if (!looked_) {
      looked_ = true;
      return start_;
    }
    mean_ = before_;
    for (std::size_t i = 0; i < mean_.size(); i++) {
      mean_[i].velocity = 0.5 * (before_[i].velocity + now_[i].velocity);
      mean_[i].spin = 0.5 * (before_[i].spin + now_[i].spin);
    }
    return kinetic_energy(mechanism_, mean_) + potential_energy(mechanism_, mean_);
  }

  const Mechanism& mechanism_;
  std::vector<SolidState> before_, now_, mean_;
  double start_ = 0.0, kinetic_ = 0.0, change_ = 0.0, mean_change_ = 0.0, gap_ = 0.0;
  bool looked_ = false;
};

void observe(const Setting& setting, const Mechanism& mechanism, double rate, const Eigen::Vector2d& position,
             Trial& trial) {
  const bool to_the_end = trial.cost * duration <= most_seconds;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const long compare = std::lround(mechanism.compare_at * rate);
  const long steps = to_the_end ? std::lround(duration * rate) : compare;
  const auto rig = setting.make(mechanism, 1.0 / rate);
  Observer observer(mechanism, *rig);
  for (long i = 1; i <= steps; i++) {
    rig->step();
    observer.look(*rig);
    if (i == compare)
      trial.error = (observer.measured().position - Eigen::Vector3d(position.x(), position.y(), 0)).norm();
  }
  trial.energy = to_the_end ? observer.energy() : nan;
  trial.gap = to_the_end ? observer.gap() : nan;
}

}  // namespace

Trial run_trial(const Setting& setting, const Mechanism& mechanism, double rate, const Eigen::Vector2d& position) {
  Trial trial;
  try {
    trial.cost = measure_cost(setting, mechanism, rate);
    observe(setting, mechanism, rate, position, trial);
  } catch (const std::exception& error) { trial.trouble = error.what(); }
  return trial;
}

}  // namespace pantin::peers
