#include "player/run.hpp"

#include <chrono>
#include <memory>

#include "lua/guard.hpp"
#include "player/closing.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/outputs.hpp"
#include "player/pictures.hpp"
#include "player/progress.hpp"

namespace pantin::player {
namespace {

/// Steps to the end, or to Ctrl-C, which may come in the middle of a script, or to the script's own end. `after` is called after each step.
template <class After>
void run_to(lua::Scene& scene, double until, After after) {
  Progress progress(until);
  World& world = scene.world();
  require(until <= world.time || until - world.time >= 0.5 * world.settings.step, "run: the end, ", until,
          " s, is less than half a step of ", world.settings.step, " s away, so that nothing would move");
  while (world.time < until - 0.5 * world.settings.step && !scene.finished() && !Interrupt::asked()) {
    try {
      scene.step();
    } catch (const lua::Interrupted& error) { return say(error.what()); }
    require(world.failure.empty(), world.failure);
    after();
    progress.show(world.time);
  }
}

}  // namespace

int run(const RunOptions& options, const std::string& home) {
  std::string path = find_scene(options.scene, home);
  Interrupt interrupt;
  Outputs outputs(options);
  auto start = std::chrono::steady_clock::now();
  std::unique_ptr<lua::Scene> scene = lua::Scene::open(path, lua_options(options, home));
  World& world = scene->world();

  std::unique_ptr<Pictures> pictures;
  if (outputs.has(".png") || !outputs.films().empty())
    pictures = std::make_unique<Pictures>(*scene, options.size, outputs.films());
  Times times;
  if (pictures) pictures->add_frames();
  run_to(*scene, options.until.value_or(scene->duration().value_or(usual_duration)), [&] {
    times.add(world);
    if (pictures) pictures->add_frames();
  });

  if (Interrupt::asked()) say(text("stopped at ", world.time, " s; what there is by then is kept"));
  outputs.write_tables(times, world);
  for (const std::string& picture : outputs.temporaries(".png")) pictures->write_picture(picture);
  if (pictures) pictures->finish_films();
  outputs.write_summary(*scene);
  outputs.keep();
  print_closing(*scene, path, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return 0;
}

}  // namespace pantin::player
