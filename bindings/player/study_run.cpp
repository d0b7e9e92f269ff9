#include "player/study_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/closing.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/machine.hpp"
#include "scene/errors.hpp"
#include "scene/headway.hpp"

namespace pantin::player {
namespace {

/// Writes a number so that it reads back as itself.
std::string exact(double x) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", x);
  return digits;
}

bool same_places(const Places& a, const Places& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && norm2(x.second - y.second) == 0.0;
  });
}

/// Follows whether a run keeps its energy. What is wrong is held against what moves on average so far: a fast moment, as
/// of a collision, excuses nothing that is wrong after it.
class EnergyWatch {
 public:
  explicit EnergyWatch(const World& world) : kinetic_(mechanical_energy(world).kinetic) {}

  bool right(const World& world) {
    kinetic_ += mechanical_energy(world).kinetic;
    looks_++;
    const double outside = std::fabs(world.work);
    const double wrong = world.error.energy * std::max(world.largest_kinetic, outside);
    right_ = right_ && (world.error.energy <= nothing || wrong <= tolerable * std::max(kinetic_ / looks_, outside));
    return right_;
  }

 private:
  static constexpr double tolerable = 0.1;
  static constexpr double nothing = 1e-6;  ///< of the largest kinetic energy: as what rests has
  double kinetic_;                         ///< [J] sum over the looks
  double looks_ = 1.0;                     ///< the start is the first
  bool right_ = true;
};

bool has_touched(const World& world) { return world.ledger.given[static_cast<std::size_t>(Source::contact)] != 0.0; }

bool acts_in_steps(const World& world) {
  const auto events = world.choreography.events.ids();
  return has_touched(world) || world.last_act > 0.0 || !world.choreography.past.empty() || !world.breaks.empty() ||
         !world.emitters.ids().empty() ||
         std::any_of(events.begin(), events.end(), [&](EventId id) { return world.choreography.events[id].fired > 0; });
}

}  // namespace

bool same_way(const StudyRun& a, const StudyRun& b) {
  return a.trouble.empty() && b.trouble.empty() &&
         std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(), b.positions.end(), same_places);
}

double processor_time() { return 1e-9 * thread_time(); }

Opener::Opener(const RunOptions& options, const std::string& home)
    : options_(scene_options(options, home)), path_(find_scene(options.scene, home)) {
  options_.threads = 1;
}

std::unique_ptr<Scene> Opener::open() const { return lua::open_scene(path_, options_); }

std::unique_ptr<Scene> Opener::open(const std::string& integrator, double step, double accuracy) const {
  SceneOptions options = options_;
  options.set["scene.integrator"] = integrator;
  options.set["scene.step"] = exact(step);
  options.set["scene.accuracy"] = accuracy > 0.0 ? exact(accuracy) : "nil";
  return lua::open_scene(path_, options);
}

Places places_of(const World& world, Stride stride) {
  Places list;
  for (const PointId id : world.points.ids())
    if (const std::uint64_t serial = world.points[id].serial; serial % stride == 0)
      list.emplace_back(2 * serial, position(world, id));
  for (const BodyId id : world.bodies.ids())
    if (const std::uint64_t serial = world.bodies[id].serial; serial % stride == 0)
      list.emplace_back(2 * serial + 1, world.motion_of(id).x);
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return list;
}

double diagonal_of(const Places& places) {
  if (places.empty()) return 0.0;
  Vec3 lower = places[0].second, upper = lower;
  for (const auto& place : places)
    for (int k = 0; k < 3; k++) {
      lower[k] = std::min(lower[k], place.second[k]);
      upper[k] = std::max(upper[k], place.second[k]);
    }
  return norm(upper - lower);
}

double step_to(Scene& scene, double time) {
  const World& world = scene.world();
  const double start = processor_time();
  Headway headway(world);
  while (world.time < time - 0.5 * world.settings.step && !scene.finished() && !Interrupt::asked()) {
    scene.step();
    require(world.failure.empty(), world.failure);
    headway.check(world, time);
  }
  return processor_time() - start;
}

bool perform(StudyRun& run, const Opener& opener, const std::vector<double>& times, Stride stride, double limit,
             const std::function<void(double part)>& told) {
  std::unique_ptr<Scene> scene;
  std::uint64_t drawn = 0;
  try {
    scene = opener.open(run.integrator, run.step, run.accuracy);
    drawn = scene->world().random.count;
    EnergyWatch energy(scene->world());
    for (const double time : times) {
      run.portions.push_back(step_to(*scene, time));
      run.seconds += run.portions.back();
      run.reached = scene->world().time;
      if (Interrupt::asked() || run.seconds > limit) return false;
      run.finished = scene->finished();
      if (run.finished && run.reached < time - 0.5 * run.step) break;
      run.positions.push_back(places_of(scene->world(), stride));
      if (energy.right(scene->world())) run.right_until = time;
      told(static_cast<double>(run.positions.size()) / static_cast<double>(times.size()));
    }
  } catch (const Interrupted&) { return false; } catch (const Error& error) {
    run.trouble = error.what();
  }
  if (!scene) return true;
  const World& world = scene->world();
  run.steps = world.steps;
  run.stats = world.stats;
  run.worst = world.worst;
  run.overlap = deep_overlap(world).value_or("");
  run.loosely = loosely_solved(world).value_or("");
  run.touched = has_touched(world);
  run.acted_in_steps = acts_in_steps(world);
  run.random_numbers = world.random.count - drawn;
  return true;
}

void perform_again(StudyRun& run, const Opener& opener, const std::vector<double>& times) {
  try {
    const auto scene = opener.open(run.integrator, run.step, run.accuracy);
    for (std::size_t k = 0; k < run.portions.size(); k++) {
      const double seconds = step_to(*scene, times[k]);
      if (Interrupt::asked()) break;
      run.portions[k] = std::min(run.portions[k], seconds);
    }
  } catch (const Interrupted&) {}  // what it took before is good enough
  run.seconds = std::accumulate(run.portions.begin(), run.portions.end(), 0.0);
}

}  // namespace pantin::player
