#include "player/study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <tuple>

#include "laws/draws_noise.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/run.hpp"
#include "scene/errors.hpp"

namespace pantin::player {
namespace {

using Told = std::function<void(const std::string&, double)>;

// Of steps: each level has half the step of the one before; the scene's own and its half come first, without which nothing
// can be told.
constexpr int own_level = 2, coarsest = 1 << own_level;
constexpr int levels[] = {2, 3, 1, 0, 4, 5, 6, 7};
constexpr int first_levels[] = {2, 3, 1, 4};
constexpr int three = 3;
constexpr double core = 7.75;                    // times the cost of its own step are the first five levels
constexpr double least_own = 3.5, least = 1.75;  // the first three, and those of other integrators
constexpr double dear = 4.0;  // times that, other integrators are no reason to compare for a shorter time
constexpr double most_comparisons = 120, least_comparisons = 40;  // in time
constexpr double most_places = 40000;                             // that a run notes
constexpr std::size_t most_things = 1000;
constexpr double accuracies[] = {1e-2, 1e-3, 1e-4, 1e-5};  // [1/s]
constexpr double settled = 1e-9;  // of the size: finer steps than those of runs so near to each other show nothing new

// Parts of the budget.
constexpr double for_look = 0.05, for_trial = 0.01, for_core = 0.5, for_surprise = 0.03, for_runs = 0.8,
                 for_ledger = 0.9;

double step_of(double own, int level) { return own * coarsest / std::pow(2.0, level); }

/// The first number from `least_part` to three times that which leaves least of `whole` when it divides it.
long dividing(long whole, long least_part) {
  long best = least_part;
  for (long part = least_part; part <= std::min(whole, 3 * least_part); part++)
    if (whole % part < whole % best) best = part;
  return best;
}

bool is_noisy(const World& world) {
  const auto any = [](const auto& store) {
    const auto ids = store.ids();
    return std::any_of(ids.begin(), ids.end(), [&](auto id) { return draws_noise(*store[id].law); });
  };
  return any(world.connections) || any(world.interactions) || any(world.fields);
}

class Studying {
 public:
  Studying(const RunOptions& options, const std::string& home, double budget, const Told& told)
      : options_(options), opener_(options, home), budget_(budget), told_(told) {
    study_.path = opener_.path();
  }

  Study run() {
    look();
    try_integrators();
    choose_times();
    run_levels();
    run_accuracies();
    end_where_it_ended();
    sort_runs();
    find_movement();
    keep_books();
    run_again();
    compare(study_);
    return std::move(study_);
  }

 private:
  struct Tried {
    std::string integrator;
    double cost = 0.0;        ///< [s] per simulated second with the scene's own step
    bool no_longer = false;   ///< steps than those tried: they take much more, or too long
    bool no_shorter = false;  ///< the same, or they show nothing new
  };

  double spent() const { return processor_time() - begin_; }

  /// What the scene is like as it stands. What goes wrong soon, and no less with short steps, is told at once.
  void look() {
    const auto scene = opener_.open();
    World& world = scene->world();
    study_.title = scene->title();
    study_.step = world.settings.step;
    study_.integrator = name_of(world.settings.integrator);
    study_.energy_return = world.settings.energy_return;
    study_.wanted_until = end_of(*scene, options_.until);
    require(study_.wanted_until >= coarsest * study_.step, "report: the end, ", study_.wanted_until,
            " s, must be at least ", coarsest, " steps of ", study_.step, " s away");
    stride_ = 1 + (world.points.ids().size() + world.bodies.ids().size()) / most_things;
    start_ = places_of(world, stride_);
    study_.things = start_.size();
    study_.size = diagonal_of(start_);
    study_.emits = !world.emitters.ids().empty();
    study_.noisy = is_noisy(world);
    try {
      glance(*scene);
    } catch (const Interrupted&) { throw; } catch (const Error&) {
      const auto finer = opener_.open(study_.integrator, step_of(study_.step, *std::rbegin(levels)), 0.0);
      if (!glance(*finer, world.time)) throw;
    }
    study_.warnings = scene->warnings();
  }

  /// Steps for a little while; false where that does not come to `until` [s].
  bool glance(Scene& scene, double until = std::numeric_limits<double>::infinity()) {
    World& world = scene.world();
    const double begin = processor_time();
    const double end = std::min(until, study_.wanted_until) - 0.5 * world.settings.step;
    while (world.time < end && processor_time() - begin < for_look * budget_) {
      require(!Interrupt::asked(), "report: stopped before there was anything to tell");
      scene.step();
      require(world.failure.empty(), world.failure);
      if (scene.finished()) study_.wanted_until = std::min(study_.wanted_until, world.time);
    }
    return world.time >= end;
  }

  /// The scene's own first. The error of "adaptive" is no matter of the step's length.
  void try_integrators() {
    std::vector<std::string> names = {study_.integrator};
    for (const NamedIntegrator& known : integrators)
      if (const std::string name(known.name); name != study_.integrator && known.integrator != Integrator::adaptive &&
                                              options_.set.find("scene.integrator") == options_.set.end())
        names.push_back(name);
    for (const std::string& name : names) {
      try {
        const auto scene = opener_.open(name, study_.step, 0.0);
        tried_.push_back({name, cost_of(*scene), false, false});
      } catch (const Interrupted&) { throw; } catch (const Error& error) {
        if (name == study_.integrator) throw;
        study_.refused.push_back({name, error.what()});
      }
    }
  }

  /// [s] per simulated second, by the first steps after the very first one, which must succeed.
  double cost_of(Scene& scene) const {
    World& world = scene.world();
    scene.step();
    require(world.failure.empty(), world.failure);
    const double begin = processor_time(), from = world.time;
    try {
      do {
        scene.step();
      } while (world.failure.empty() && world.time < study_.wanted_until &&
               processor_time() - begin < for_trial * budget_);
    } catch (const Interrupted&) { throw; } catch (const Error&) {
    }  // the runs will tell
    return (processor_time() - begin) / std::max(world.time - from, study_.step);
  }

  /// Whole intervals of whole coarsest steps. A scene that takes long is compared for as long as the first levels of all
  /// integrators fit into part of the budget.
  void choose_times() {
    double until = study_.wanted_until, first = 0.0, all = 0.0;  // [s] of processor time per simulated second
    const double own = tried_.front().cost;
    for (const Tried& tried : tried_) {
      if (tried.cost > dear * own) continue;
      first += tried.cost * (&tried == &tried_.front() ? core : least);
      all += tried.cost * (std::exp2(std::size(levels)) - 1) / coarsest;
    }
    if (!options_.until && first * until > for_core * budget_) until = round_time(for_core * budget_ / first);
    const double longest = coarsest * study_.step;
    until = std::max(until, 2.0 * longest);
    const double comparisons = std::clamp(most_places / std::max(1.0, static_cast<double>(study_.things)),
                                          least_comparisons, most_comparisons);
    const long steps = std::lround(std::floor(until / longest + 1e-9));
    const long part = dividing(steps, std::max(1L, std::lround(std::ceil(static_cast<double>(steps) / comparisons))));
    for (long k = part; k <= steps; k += part) study_.times.push_back(static_cast<double>(k) * longest);
    study_.until = study_.times.back();
    const double shortest = least_own * own * study_.until;
    expected_ = std::max(shortest, std::min(budget_, all * study_.until));
    if (shortest > 2.0 * budget_)
      say(text("three runs of ", study_.until, " s take about ", std::ceil(shortest / 60),
               " minutes; a shorter --until less"));
  }

  /// The scene's own integrator first, until three of its runs come to the end, for fewer tell nothing; then all in turn,
  /// level by level, as long as there is time.
  void run_levels() {
    for (const int level : first_levels)
      if (complete(tried_.front()) < three) run_level(tried_.front(), level);
    for (const int level : levels)
      for (Tried& tried : tried_)
        if (!has_run(tried, level)) run_level(tried, level);
  }

  /// Longer steps than the scene's own may cost more.
  void run_level(Tried& tried, int level) {
    bool& over = level < own_level ? tried.no_longer : tried.no_shorter;
    if (over) return;
    const double step = step_of(study_.step, level);
    const double left = for_runs * budget_ - spent(), foretold = foretell(tried, step);
    const bool is_needed = tried.integrator == study_.integrator && complete(tried) < needed();
    over = !is_needed && foretold > left;
    if (over) return;
    double limit = std::min(left, std::max(3.0 * foretold, for_surprise * budget_));
    if (is_needed) limit = level < own_level ? 3.0 * foretold : std::numeric_limits<double>::infinity();
    const Ran ran = run_one(tried.integrator, step, 0.0, limit);
    over = ran != Ran::done || (level > own_level && has_settled(tried.integrator));
    if (level == own_level && ran == Ran::as_another) tried.no_longer = true;
  }

  bool has_run(const Tried& tried, int level) const {
    return std::any_of(study_.runs.begin(), study_.runs.end(), [&](const StudyRun& run) {
      return run.integrator == tried.integrator && run.accuracy == 0.0 && run.step == step_of(study_.step, level);
    });
  }

  /// Runs of the scene's own integrator that are made however long they take: all, where a time is asked for.
  int needed() const { return options_.until ? three : 2; }

  /// [s] that a run will take.
  double foretell(const Tried& tried, double step) const {
    for (const StudyRun& run : study_.runs)
      if (run.integrator == tried.integrator && run.accuracy == 0.0 && run.step == 2.0 * step) return 2.0 * run.seconds;
    return tried.cost * study_.until * study_.step / step;
  }

  /// With the scene's own step, divided by itself.
  void run_accuracies() {
    if (rank("verlet") == tried_.size()) return;
    double seconds = 0.0;
    for (const double accuracy : accuracies) {
      const double left = for_runs * budget_ - spent();
      if (3.0 * seconds > left) return;
      if (run_one("verlet", study_.step, accuracy, left) == Ran::done) seconds = study_.runs.back().seconds;
    }
  }

  enum class Ran { done, as_another, left };

  /// Keeps the run, unless it took too long or went as another integrator's did.
  Ran run_one(const std::string& integrator, double step, double accuracy, double limit) {
    if (Interrupt::asked()) return Ran::left;
    StudyRun run;
    run.integrator = integrator;
    run.step = step;
    run.accuracy = accuracy;
    const std::string what =
        accuracy > 0.0 ? text("accuracy ", accuracy, " per second") : text(integrator, ", step ", step, " s");
    const auto told = [&](double) { told_(what, spent() / expected_); };
    told(0.0);
    if (!perform(run, opener_, study_.times, stride_, limit, told)) return Ran::left;
    study_.random = study_.random || run.random_numbers > 0;
    for (const StudyRun& other : study_.runs)
      if (other.step == step && same_way(other, run)) {
        if (accuracy == 0.0 && step == study_.step)
          study_.refused.push_back({integrator, "the same as " + other.integrator + " in this scene"});
        return Ran::as_another;
      }
    study_.runs.push_back(std::move(run));
    return Ran::done;
  }

  /// Series by series, the longest step first.
  void sort_runs() {
    const auto key = [&](const StudyRun& run) {
      return std::tuple(rank(run.integrator), run.accuracy > 0.0, -run.step, -run.accuracy);
    };
    std::sort(study_.runs.begin(), study_.runs.end(),
              [&](const StudyRun& a, const StudyRun& b) { return key(a) < key(b); });
  }

  int complete(const Tried& tried) const {
    return static_cast<int>(std::count_if(study_.runs.begin(), study_.runs.end(), [&](const StudyRun& run) {
      return run.integrator == tried.integrator && run.accuracy == 0.0 && run.trouble.empty();
    }));
  }

  /// Whether its last two runs hardly differ.
  bool has_settled(const std::string& integrator) const {
    const StudyRun &last = study_.runs.back(), *before = nullptr;
    for (const StudyRun& run : study_.runs)
      if (run.integrator == integrator && run.accuracy == 0.0 && run.step == 2.0 * last.step) before = &run;
    return before && before->trouble.empty() && last.trouble.empty() &&
           distance(last, *before) <= settled * study_.size;
  }

  /// Where the script ended runs, all are compared until the first of them did. What went wrong in all of them is told.
  void end_where_it_ended() {
    std::size_t count = study_.times.size();
    for (const StudyRun& run : study_.runs)
      if (run.finished) count = std::min(count, run.positions.size());
    for (StudyRun& run : study_.runs)
      if (run.portions.size() > count) shorten(run, count);
    study_.times.resize(count);
    const StudyRun* const own = last_of(study_.integrator);
    require(own != nullptr, "report: stopped before there was anything to tell");
    const bool any = std::any_of(study_.runs.begin(), study_.runs.end(),
                                 [](const StudyRun& run) { return run.trouble.empty() && !run.positions.empty(); });
    if (!any && !own->trouble.empty()) throw Error(own->trouble);
    require(any, "report: the script ends the scene after ", own->reached, " s, which is too soon to compare");
    study_.until = study_.times.back();
  }

  void shorten(StudyRun& run, std::size_t count) const {
    run.positions.resize(count);
    run.portions.resize(count);
    run.seconds = std::accumulate(run.portions.begin(), run.portions.end(), 0.0);
    run.reached = count > 0 ? study_.times[count - 1] : 0.0;
  }

  /// The ledger costs time, so it is kept in a run of its own.
  void keep_books() {
    told_("ledger", spent() / expected_);
    if (Interrupt::asked()) return;
    try {
      const auto scene = opener_.open();
      keep_ledger(scene->world());
      for (const double time : study_.times) {
        step_to(*scene, time);
        study_.ledger = ledger_lines(scene->world());
        if (Interrupt::asked() || scene->finished() || spent() > for_ledger * budget_) break;
      }
    } catch (const Interrupted&) {
    } catch (const Error& error) { study_.warnings.push_back(error.what()); }
  }

  /// Short runs again, in turn, as long as there is time: what hinders one of them for a while lengthens none.
  void run_again() {
    for (int round = 0; round < 3; round++)
      for (StudyRun& run : study_.runs) {
        if (!run.trouble.empty() || run.seconds > 0.02 * budget_) continue;
        if (Interrupt::asked() || spent() + 1.5 * run.seconds > budget_) return;
        told_("times", spent() / expected_);
        perform_again(run, opener_, study_.times);
      }
  }

  const StudyRun* last_of(const std::string& integrator) const {
    for (auto run = study_.runs.rbegin(); run != study_.runs.rend(); ++run)
      if (run->integrator == integrator && run->accuracy == 0.0) return &*run;
    return nullptr;
  }

  /// A single thing has no size but the way it goes.
  void find_movement() {
    std::map<std::uint64_t, Vec3> first(start_.begin(), start_.end());
    const StudyRun& run = *last_of(study_.integrator);
    for (std::size_t k = 0; k < run.positions.size() && study_.times[k] <= run.right_until * (1 + 1e-9); k++)
      for (const auto& [serial, place] : run.positions[k]) {
        const Vec3 from = first.emplace(serial, place).first->second;
        study_.moved = std::max(study_.moved, norm(place - from));
      }
    if (study_.size == 0.0) study_.size = study_.moved;
  }

  std::size_t rank(const std::string& integrator) const {
    const auto is = [&](const Tried& tried) { return tried.integrator == integrator; };
    return static_cast<std::size_t>(std::find_if(tried_.begin(), tried_.end(), is) - tried_.begin());
  }

  const RunOptions& options_;
  const Opener opener_;
  const double budget_;
  const Told& told_;
  const double begin_ = processor_time();
  Study study_;
  std::vector<Tried> tried_;
  Places start_;
  Stride stride_ = 1;
  double expected_ = 0.0;  ///< [s] of processor time in all
};

}  // namespace

double round_time(double seconds) {
  const double decade = std::pow(10.0, std::floor(std::log10(seconds)));
  for (const double of_it : {5.0, 2.0})
    if (seconds >= of_it * decade) return of_it * decade;
  return decade;
}

Study study(const RunOptions& options, const std::string& home, double budget, const Told& progress) {
  return Studying(options, home, budget, progress).run();
}

}  // namespace pantin::player
