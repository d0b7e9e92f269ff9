#include "player/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "lua/scene/open.hpp"
#include "player/animation.hpp"
#include "player/closing.hpp"
#include "player/confine.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/outputs.hpp"
#include "player/pictures.hpp"
#include "player/progress.hpp"
#include "player/saved_state.hpp"
#include "player/trajectory.hpp"
#include "scene/errors.hpp"
#include "scene/headway.hpp"
#include "scene/memory.hpp"

namespace pantin::player {
namespace {

constexpr double usual_duration = 10.0;        ///< [s] where neither the command line nor the scene says
constexpr double animation_frame_rate = 30.0;  ///< [1/s] of .glb, between whose frames programs interpolate

/// Tells what ended amid an event as soon as it did.
class BrokenOff {
 public:
  explicit BrokenOff(const Scene& scene) : scene_(scene) {}
  void look() {
    if (told_ || scene_.broken_off().empty()) return;
    told_ = true;
    say(scene_.broken_off());
    say(text("what the event had still to do is not done; the run goes on at ", scene_.world().time, " s"));
  }

 private:
  const Scene& scene_;
  bool told_ = false;
};

/// Steps to the end, or to Ctrl-C, which may come in the middle of a script, or to the script's own end. `after` is called after each step.
template <class After>
void step_to_end(Scene& scene, const RunOptions& options, After after) {
  World& world = scene.world();
  double until = end_of(scene, options.until);
  Progress progress(world.time);
  require(until <= world.time || until - world.time >= 0.5 * world.settings.step, "run: the end, ", until,
          " s, is less than half a step of ", world.settings.step, " s away, so that nothing would move");
  Headway headway(world);
  BrokenOff broken_off(scene);
  MemoryLimit memory(options.memory_limit);
  while (world.time < until - 0.5 * world.settings.step && !scene.finished() && !Interrupt::asked()) {
    try {
      scene.step();
    } catch (const Interrupted& error) { return say(error.what()); }
    broken_off.look();
    require(world.failure.empty(), world.failure);
    until = end_of(scene, options.until);
    headway.check(world, until);
    memory.check();
    after();
    progress.show(world.time, until);
  }
}

/// All that is written frame by frame.
class Frames {
 public:
  Frames(const Scene& scene, const RunOptions& options, const Outputs& outputs) : scene_(scene) {
    for (const std::string& path : outputs.temporaries(".xyz"))
      trajectories_.emplace_back(path, usual_frame_rate, scene.pace());
    if (outputs.has(".glb")) animation_.emplace(scene.world(), animation_frame_rate, scene.pace());
    if (outputs.has(".png") || !outputs.films().empty())
      pictures_ = std::make_unique<Pictures>(scene, options.size, options.views, outputs.films());
    add();
  }

  /// Call it after each step.
  void add() {
    if (pictures_) pictures_->add_frames();
    if (animation_) animation_->add_frames(scene_.world());
    for (Trajectory& trajectory : trajectories_) trajectory.add_frames(scene_.world());
  }

  void finish(Outputs& outputs) {
    const auto each = [&](const std::vector<std::string>& paths, auto write) {
      for (const std::string& path : paths) outputs.complete(path, [&] { write(path); });
    };
    each(outputs.temporaries(".png"), [&](const std::string& path) { pictures_->write_picture(path); });
    each(outputs.films(), [&](const std::string& path) { pictures_->finish_film(path); });
    each(outputs.temporaries(".glb"), [&](const std::string& path) { animation_->write(path, scene_.title()); });
    for (Trajectory& trajectory : trajectories_) outputs.complete(trajectory.path(), [&] { trajectory.finish(); });
  }

 private:
  const Scene& scene_;
  std::unique_ptr<Pictures> pictures_;
  std::optional<Animation> animation_;
  std::vector<Trajectory> trajectories_;
};

std::unique_ptr<Frames> begin_frames(const Scene& scene, const RunOptions& options, const Outputs& outputs) {
  try {
    return std::make_unique<Frames>(scene, options, outputs);
  } catch (const Error& error) { throw Error(outputs.in_own_names(error.what())); }
}

/// Saves the state once its time has come.
class SavesAt {
 public:
  SavesAt(std::optional<double> time, Scene& scene, Outputs& outputs)
      : time_(time.value_or(infinity)), scene_(scene), outputs_(outputs) {
    look();
  }
  void look() {
    const World& world = scene_.world();
    if (world.time < time_ - 0.5 * world.settings.step) return;
    outputs_.write_state(scene_);
    time_ = infinity;
    if (const std::string why = scene_.why_not_restore(); !why.empty())
      say(text("the state: ", why, " nor kept in a file; opening the file runs the scene again up to ", world.time,
               " s"));
  }
  bool waits() const { return std::isfinite(time_); }
  void check() const {
    require(!waits(), "the run ended at ", scene_.world().time, " s, before the state was to be saved at ", time_,
            " s");
  }

 private:
  double time_;  ///< [s] infinite: none is to be saved any more
  Scene& scene_;
  Outputs& outputs_;
};

std::unique_ptr<Scene> open(const RunOptions& options, const std::string& path, const std::string& home) {
  const SceneOptions opened = scene_options(options, home);
  if (!options.from.empty()) return open_saved(path, options.scene, opened);
  return path.ends_with(state_ending) ? open_saved(path, "", opened) : lua::open_scene(path, opened);
}

void check_probes(const RunOptions& options, const World& world) {
  std::string all;
  for (const Probe& probe : world.probes) all += (all.empty() ? "" : ", ") + probe.name;
  for (const std::string& name : options.table.when)
    if (std::ranges::none_of(world.probes, [&](const Probe& probe) { return probe.name == name; }))
      throw UsageError(
          text("--when ", name, ": the scene has no such probe at its start; it has ", all.empty() ? "none" : all));
}

}  // namespace

double end_of(const Scene& scene, std::optional<double> wanted) {
  return wanted.value_or(scene.duration().value_or(usual_duration));
}

int run(const RunOptions& options, const std::string& home) {
  std::string path = options.from.empty() ? find_scene(options.scene, home) : options.from;
  Interrupt interrupt;
  Outputs outputs(options, path);
  auto start = std::chrono::steady_clock::now();
  if (options.untrusted) confine(reach_of(options, path, home));
  std::unique_ptr<Scene> scene = open(options, path, home);
  World& world = scene->world();
  check_probes(options, world);
  if (options.until && *options.until < world.time - 0.5 * world.settings.step)
    throw UsageError(text("--until ", *options.until, " s: ", path, " is at ", world.time, " s already"));
  const std::unique_ptr<Frames> frames = begin_frames(*scene, options, outputs);
  Times times;
  SavesAt saves(options.save_at, *scene, outputs);
  std::string failure;
  try {
    step_to_end(*scene, options, [&] {
      times.add(world);
      frames->add();
      saves.look();
    });
    saves.check();
  } catch (const Error& error) {
    if (world.steps == 0) throw;
    failure = outputs.in_own_names(error.what());
    say(failure);
  }

  if (saves.waits()) outputs.drop_state();
  if (Interrupt::asked() || !failure.empty())
    say(text("stopped at ", world.time, " s", outputs.any() ? "; what there is by then is kept" : ""));
  outputs.write_tables(times, world);
  frames->finish(outputs);
  outputs.write_summary(*scene, failure.empty() ? scene->broken_off() : failure);
  outputs.keep();
  if (!failure.empty()) return 1;
  print_closing(*scene, path, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return scene->broken_off().empty() ? 0 : 1;
}

}  // namespace pantin::player
