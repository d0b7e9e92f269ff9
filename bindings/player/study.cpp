#include "player/study.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

#include "laws/law.hpp"
#include "lua/guard.hpp"
#include "lua/headway.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/run.hpp"
#include "player/summary.hpp"

namespace pantin::player {
namespace {

using Clock = std::chrono::steady_clock;
using Told = std::function<void(const std::string&, double)>;

constexpr int coarsest = 4;      // times the scene's own step
constexpr int levels = 8;        // each with half the step of the one before
constexpr int least_levels = 4;  // that every study has time for
constexpr int comparisons = 40;  // times at most
constexpr std::size_t most_things = 2000;
constexpr double accuracies[] = {1e-2, 1e-3, 1e-4, 1e-5};  // [1/s]

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Writes a number so that it reads back as itself.
std::string exact(double x) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", x);
  return digits;
}

/// Points and centres of bodies whose serial is a multiple of `stride`, in the order of their serials.
Places places_of(const World& world, std::uint64_t stride) {
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

bool same_places(const Places& a, const Places& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && norm2(x.second - y.second) == 0.0;
  });
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

bool draws_noise(const Law& law) {
  const std::vector<Input>& inputs = law.graph.inputs();
  return (law.called && law.timed) || (law.also && draws_noise(*law.also)) ||
         std::any_of(inputs.begin(), inputs.end(), [](const Input& input) { return input.role == Role::noise; });
}

class Studying {
 public:
  Studying(const RunOptions& options, const std::string& home, double budget, const Told& told)
      : options_(options), home_(home), budget_(budget), told_(told) {
    study_.path = find_scene(options.scene, home);
  }

  Study run() {
    look();
    choose_times();
    find_integrators();
    run_levels();
    run_accuracies();
    require(!Interrupt::asked(), "report: stopped before there was anything to tell");
    std::stable_sort(study_.runs.begin(), study_.runs.end(),
                     [&](const StudyRun& a, const StudyRun& b) { return rank(a.integrator) < rank(b.integrator); });
    find_movement();
    keep_books();
    compare(study_);
    return std::move(study_);
  }

 private:
  /// An empty integrator leaves the scene its own, and its accuracy.
  std::unique_ptr<lua::Scene> open(const std::string& integrator, double step, double accuracy = 0.0) const {
    lua::SceneOptions options = lua_options(options_, home_);
    if (!integrator.empty()) {
      options.set["scene.integrator"] = integrator;
      options.set["scene.accuracy"] = accuracy > 0.0 ? exact(accuracy) : "nil";
    }
    if (step > 0.0) options.set["scene.step"] = exact(step);
    return lua::Scene::open(study_.path, options);
  }

  /// What the scene is like as it stands, and for about a second, what it costs.
  void look() {
    const auto scene = open("", 0.0);
    World& world = scene->world();
    const RunOptions& o = options_;
    study_.title = scene->title();
    study_.step = world.settings.step;
    study_.integrator = name_of(world.settings.integrator);
    study_.energy_return = world.settings.energy_return;
    study_.wanted_until = o.until.value_or(scene->duration().value_or(usual_duration));
    require(study_.wanted_until >= coarsest * study_.step, "report: the end, ", study_.wanted_until,
            " s, must be at least ", coarsest, " steps of ", study_.step, " s away");
    stride_ = 1 + (world.points.ids().size() + world.bodies.ids().size()) / most_things;
    start_ = places_of(world, stride_);
    study_.things = start_.size();
    study_.size = diagonal_of(start_);
    const Clock::time_point begin = Clock::now();
    const double seconds = std::min(1.5, 0.05 * budget_);
    while (world.time < study_.wanted_until - 0.5 * study_.step && since(begin) < seconds && !Interrupt::asked()) {
      scene->step();
      require(world.failure.empty(), world.failure);
      if (scene->finished()) study_.wanted_until = world.time;
    }
    cost_ = since(begin) / world.time;
    study_.warnings = scene->warnings();
    study_.emits = !world.emitters.ids().empty();
    const auto is_noisy = [](const auto& store) {
      const auto ids = store.ids();
      return std::any_of(ids.begin(), ids.end(), [&](auto id) { return draws_noise(*store[id].law); });
    };
    study_.noisy = is_noisy(world.connections) || is_noisy(world.interactions) || is_noisy(world.fields);
  }

  /// Whole intervals of whole coarsest steps. A scene that takes long is compared for as long as the first levels of all
  /// integrators fit into most of the budget.
  void choose_times() {
    double until = study_.wanted_until;
    const double per_second =
        cost_ * (std::pow(2.0, least_levels) / coarsest) * static_cast<double>(integrators.size());
    if (!options_.until) until = std::min(until, 0.7 * budget_ / per_second);
    const double longest = coarsest * study_.step;
    until = std::max(until, 2.0 * longest);
    const double interval = longest * std::max(1.0, std::ceil(until / longest / comparisons - 1e-9));
    const int count = std::max(1, static_cast<int>(std::floor(until / interval + 1e-9)));
    for (int k = 1; k <= count; k++) study_.times.push_back(k * interval);
    study_.until = study_.times.back();
  }

  void find_integrators() {
    for (const NamedIntegrator& known : integrators) {
      const std::string name(known.name);
      if (const auto given = options_.set.find("scene.integrator");
          given != options_.set.end() && given->second != name)
        continue;
      try {
        const auto scene = open(name, 0.0);
        scene->step();
        require(scene->world().failure.empty(), scene->world().failure);
        tried_.push_back(name);
      } catch (const lua::Interrupted&) { throw; } catch (const Error& error) {
        if (name == study_.integrator) throw;
        study_.refused.push_back({name, error.what()});
      }
    }
  }

  /// From the longest step to the shortest, all integrators in turn, as long as there is time.
  void run_levels() {
    std::vector<std::string> open_ones = tried_;
    for (int level = 0; level < levels; level++) {
      const double step = coarsest * study_.step / std::pow(2.0, level);
      std::vector<std::string> next;
      for (const std::string& integrator : open_ones) {
        const StudyRun* const before = last_of(integrator);
        if (level >= 3 && before && since(begin_) + 2.2 * before->seconds > budget_) continue;
        if (Interrupt::asked()) return;
        told_(text(integrator, ", step ", step, " s"), since(begin_) / budget_);
        StudyRun run = run_one(integrator, step);
        if (const StudyRun* const same = same_as(run)) {
          study_.refused.push_back({integrator, "the same as " + same->integrator + " in this scene"});
          continue;
        }
        study_.runs.push_back(std::move(run));
        next.push_back(integrator);
      }
      open_ones = next;
    }
  }

  /// With the scene's own step, divided by itself.
  void run_accuracies() {
    if (std::find(tried_.begin(), tried_.end(), "verlet") == tried_.end()) return;
    double seconds = 0.0;
    for (const double accuracy : accuracies) {
      if (Interrupt::asked() || since(begin_) + 3.2 * seconds > budget_) return;
      StudyRun run = run_one("verlet", study_.step, accuracy);
      seconds = run.seconds;
      if (!same_as(run)) study_.runs.push_back(std::move(run));
    }
  }

  /// The ledger costs time, so it is kept in a run of its own, of a fifth of the budget at most.
  void keep_books() {
    told_("ledger", since(begin_) / budget_);
    const auto scene = open("", 0.0);
    keep_ledger(scene->world());
    const Clock::time_point begin = Clock::now();
    try {
      for (const double time : study_.times) {
        step_to(*scene, time);
        if (Interrupt::asked() || scene->finished() || since(begin) > 0.2 * budget_) break;
      }
    } catch (const lua::Interrupted&) { throw; } catch (const Error& error) {
      study_.warnings.push_back(error.what());
    }
    study_.ledger = ledger(scene->world());
    study_.ledger["until"] = scene->world().time;
  }

  /// A run of another integrator with the same step that went the very same way, or null.
  const StudyRun* same_as(const StudyRun& run) const {
    for (const StudyRun& other : study_.runs)
      if (other.step == run.step && !(other.integrator == run.integrator && other.accuracy == run.accuracy) &&
          other.places.size() == run.places.size() &&
          std::equal(run.places.begin(), run.places.end(), other.places.begin(), same_places))
        return &other;
    return nullptr;
  }

  const StudyRun* last_of(const std::string& integrator) const {
    for (auto run = study_.runs.rbegin(); run != study_.runs.rend(); ++run)
      if (run->integrator == integrator && run->accuracy == 0.0) return &*run;
    return nullptr;
  }

  StudyRun run_one(const std::string& integrator, double step, double accuracy = 0.0) {
    StudyRun run;
    run.integrator = integrator;
    run.step = step;
    run.accuracy = accuracy;
    const auto scene = open(integrator, step, accuracy);
    const std::string what =
        accuracy > 0.0 ? text("accuracy ", accuracy, " per second") : text(integrator, ", step ", step, " s");
    World& world = scene->world();
    const std::uint64_t drawn = world.random.count;
    try {
      for (const double time : study_.times) {
        run.seconds += step_to(*scene, time);
        run.reached = world.time;
        if (Interrupt::asked() || scene->finished()) break;
        run.places.push_back(places_of(world, stride_));
        told_(what, since(begin_) / budget_);
      }
    } catch (const lua::Interrupted&) { throw; } catch (const Error& error) {
      run.trouble = error.what();
    }
    run.steps = world.steps;
    run.stats = world.stats;
    run.worst = world.worst;
    run.random_numbers = world.random.count - drawn;
    study_.random = study_.random || run.random_numbers > 0;
    return run;
  }

  /// [s] of the clock.
  static double step_to(lua::Scene& scene, double time) {
    const World& world = scene.world();
    const Clock::time_point start = Clock::now();
    lua::Headway headway(world, time);
    while (world.time < time - 0.5 * world.settings.step && !scene.finished() && !Interrupt::asked()) {
      scene.step();
      require(world.failure.empty(), world.failure);
      headway.check(world);
    }
    return since(start);
  }

  /// A single thing has no size but the way it goes.
  void find_movement() {
    std::map<std::uint64_t, Vec3> first(start_.begin(), start_.end());
    for (const Places& places : last_of(study_.integrator)->places)
      for (const auto& [serial, place] : places) {
        const Vec3 from = first.emplace(serial, place).first->second;
        study_.moved = std::max(study_.moved, norm(place - from));
      }
    if (study_.size == 0.0) study_.size = study_.moved;
  }

  std::size_t rank(const std::string& integrator) const {
    return static_cast<std::size_t>(std::find(tried_.begin(), tried_.end(), integrator) - tried_.begin());
  }

  const RunOptions& options_;
  const std::string& home_;
  const double budget_;
  const Told& told_;
  const Clock::time_point begin_ = Clock::now();
  Study study_;
  std::vector<std::string> tried_;
  Places start_;
  std::uint64_t stride_ = 1;
  double cost_ = 0.0;  ///< [s] per simulated second with the scene's own step
};

}  // namespace

Study study(const RunOptions& options, const std::string& home, double budget, const Told& progress) {
  return Studying(options, home, budget, progress).run();
}

}  // namespace pantin::player
