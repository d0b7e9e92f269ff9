#include "peers/pile_trial.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "shapes/distance.hpp"

namespace pantin::peers {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double thread_seconds() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Vec3 own(const Eigen::Vector3d& v) { return vec(v.x(), v.y(), v.z()); }

struct Placed {
  Geometry shape;
  Pose pose;
  Bounds bounds;
};

Placed placed(const SolidDef& solid, const SolidState& state) {
  Placed p{geometry_of(solid), {}, {}};
  const Eigen::Matrix3d R = state.turn.toRotationMatrix();
  p.pose.x = own(state.position);
  for (int i = 0; i < 3; i++) p.pose.R[i] = own(R.col(i));
  p.bounds = bounds_of(p.shape, p.pose);
  return p;
}

double gap_to(const Wall& wall, const Placed& solid) {
  const Vec3 normal = own(wall.normal);
  const Vec3 lowest = support_of_core(solid.shape, transposed_times(solid.pose.R, -normal));
  return dot(normal, solid.pose.to_world(lowest)) - wall.offset - rounding_of(solid.shape);
}

bool jointed(const Mechanism& pile, std::size_t a, std::size_t b) {
  const int i = static_cast<int>(a), j = static_cast<int>(b);
  return std::any_of(pile.joints.begin(), pile.joints.end(), [&](const BallJoint& joint) {
    return (joint.a == i && joint.b == j) || (joint.a == j && joint.b == i);
  });
}

/// A stretch while it is summed up.
struct Sum {
  double time = 0.0, contacts = 0.0, overlap = 0.0;  // [ns], count, [m]
  long steps = 0;
  Stretch mean() const {
    if (steps == 0) return {nan, nan, nan};
    const auto n = static_cast<double>(steps);
    return {time / n, contacts / n, overlap};
  }
};

class Watch {
 public:
  Watch(const Mechanism& pile, Rig& rig) : pile_(pile) {
    rig.read(state_);
    for (std::size_t i = 0; i < state_.size(); i++)
      if ((state_[i].position - pile.solids[i].at).norm() > 1e-5 ||
          state_[i].turn.angularDistance(pile.solids[i].turn) > 1e-5)
        throw std::runtime_error("does not start where it should");
    energy_ = total();
  }

  /// After a step that took so long [ns].
  void look(Rig& rig, long step, double took) {
    rig.read(state_);
    const double time = static_cast<double>(step) / pile_rate;
    const double before = energy_;
    energy_ = total();
    if (!std::isfinite(energy_)) throw std::runtime_error("not finite");
    rise_ = std::max(rise_, energy_ - before);
    gap_ = std::max(gap_, largest_separation(pile_, state_));
    if (fastest() > still) settled_ = time;
    if (start_of_rest_.empty() && time >= pile_rests) start_of_rest_ = state_;
    for (std::size_t i = 0; i < start_of_rest_.size(); i++)
      creep_ = std::max(creep_, (state_[i].position - start_of_rest_[i].position).norm());
    Sum* const sum = time <= pile_moves ? &moving_ : time > pile_rests ? &rest_ : nullptr;
    if (!sum) return;
    sum->time += took;
    sum->contacts += static_cast<double>(rig.contacts());
    sum->steps++;
    if (step % 4 == 0) sum->overlap = std::max(sum->overlap, deepest_overlap(pile_, state_));
  }

  void tell(PileTrial& trial) const {
    const bool ended = trial.simulated >= pile_end;
    trial.moving = moving_.mean();
    trial.rest = rest_.mean();
    trial.creep = ended ? creep_ : nan;
    trial.settled = !ended ? nan : settled_ < pile_end ? settled_ : std::numeric_limits<double>::infinity();
    trial.rise = rise_;
    trial.gap = gap_;
  }

 private:
  double total() const { return kinetic_energy(pile_, state_) + potential_energy(pile_, state_); }

  double fastest() const {
    double most = 0.0;
    for (const SolidState& s : state_) most = std::max(most, s.velocity.norm());
    return most;
  }

  const Mechanism& pile_;
  std::vector<SolidState> state_, start_of_rest_;
  Sum moving_, rest_;
  double energy_ = 0.0, rise_ = 0.0, creep_ = 0.0, settled_ = 0.0, gap_ = 0.0;
};

}  // namespace

Geometry geometry_of(const SolidDef& solid) {
  if (solid.form == Form::ball) return BallShape{solid.size.x()};
  if (solid.form == Form::box) return BoxShape{own(solid.size)};
  if (solid.form == Form::capsule) return CapsuleShape{solid.size.x(), solid.size.z()};
  throw std::invalid_argument("a solid has no shape");
}

std::vector<std::pair<const char*, double*>> PileTrial::numbers() {
  return {{"simulated_s", &simulated},
          {"moving_step_ns", &moving.step},
          {"moving_contacts", &moving.contacts},
          {"moving_overlap_m", &moving.overlap},
          {"rest_step_ns", &rest.step},
          {"rest_contacts", &rest.contacts},
          {"rest_overlap_m", &rest.overlap},
          {"creep_m", &creep},
          {"settled_s", &settled},
          {"rise_J", &rise},
          {"gap_m", &gap},
          {"unsolved", &unsolved}};
}

PileTrial together(const std::vector<PileTrial>& falls) {
  PileTrial all = falls.front();
  const auto n = static_cast<double>(falls.size());
  const auto worst = [](double& most, double x) { most = std::isnan(x) || x > most ? x : most; };
  const auto add = [&](Stretch& sum, const Stretch& s) {
    sum.step += s.step;
    sum.contacts += s.contacts;
    worst(sum.overlap, s.overlap);
  };
  for (std::size_t i = 1; i < falls.size(); i++) {
    const PileTrial& fall = falls[i];
    if (all.trouble.empty()) all.trouble = fall.trouble;
    add(all.moving, fall.moving);
    add(all.rest, fall.rest);
    worst(all.creep, fall.creep);
    worst(all.rise, fall.rise);
    worst(all.gap, fall.gap);
    all.settled += fall.settled;
    all.unsolved += fall.unsolved;
    all.simulated = std::min(all.simulated, fall.simulated);
  }
  for (double* sum : {&all.moving.step, &all.moving.contacts, &all.rest.step, &all.rest.contacts, &all.settled})
    *sum /= n;
  return all;
}

double deepest_overlap(const Mechanism& pile, const std::vector<SolidState>& state) {
  std::vector<Placed> solids;
  for (std::size_t i = 0; i < state.size(); i++) solids.push_back(placed(pile.solids[i], state[i]));
  double deepest = 0.0;
  for (const Wall& wall : pile.walls)
    for (const Placed& solid : solids) deepest = std::max(deepest, -gap_to(wall, solid));
  std::vector<std::size_t> along(solids.size());
  std::iota(along.begin(), along.end(), std::size_t{0});
  const auto low = [&](std::size_t i) { return solids[i].bounds.low[0]; };
  std::sort(along.begin(), along.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  for (std::size_t n = 0; n < along.size(); n++)
    for (std::size_t m = n + 1; m < along.size() && low(along[m]) <= solids[along[n]].bounds.high[0]; m++) {
      const Placed &a = solids[along[n]], &b = solids[along[m]];
      if (!overlap(a.bounds, b.bounds) || jointed(pile, along[n], along[m])) continue;
      deepest = std::max(deepest, -separation(a.shape, a.pose, b.shape, b.pose, 0.0).distance);
    }
  return deepest;
}

PileTrial run_pile(const Setting& setting, const Mechanism& pile, double until, double most) {
  PileTrial trial;
  try {
    const auto rig = setting.make(pile, 1.0 / pile_rate);
    Watch watch(pile, *rig);
    double spent = 0.0;
    const long steps = std::lround(until * pile_rate);
    for (long i = 1; i <= steps && spent < most; i++) {
      const double start = thread_seconds();
      rig->step();
      const double took = thread_seconds() - start;
      spent += took;
      watch.look(*rig, i, 1e9 * took);
      trial.simulated = static_cast<double>(i) / pile_rate;
    }
    watch.tell(trial);
    trial.unsolved = static_cast<double>(rig->unsolved());
  } catch (const std::exception& error) { trial.trouble = error.what(); }
  return trial;
}

}  // namespace pantin::peers
