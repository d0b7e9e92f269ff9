#include "player/play.hpp"

#include <memory>

#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/outputs.hpp"
#include "player/player.hpp"
#include "player/run.hpp"
#include "scene/errors.hpp"

namespace pantin::player {
namespace {

int play_in_window(const RunOptions& options, const std::string& home) {
  Interrupt interrupt;
  const std::string scene = options.scene.empty() ? "" : find_scene(options.scene, home);
  Outputs outputs(options, scene);
  for (const std::string& path : options.outputs)
    if (!path.ends_with(".csv") && !path.ends_with(".png"))
      throw UsageError("play writes .csv and .png; the rest is made by `pantin run SCENE --out FILE`");
  Player player(scene, options, home);
  while (player.frame()) {}
  if (player.display_lost()) say("the display went away: the play ends here, and what was asked for is written");
  player.end_film();
  player.end_recording();
  outputs.write_tables(player.times(), player.scene().world());
  for (const std::string& picture : outputs.temporaries(".png"))
    outputs.complete(picture, [&] { player.write_picture(picture); });
  outputs.write_summary(player.scene());
  outputs.keep();
  return player.failure().empty() && !player.display_lost() ? 0 : 1;
}

/// What `play` does where nothing can be seen.
int play_unseen(RunOptions options, const std::string& home, const std::string& why) {
  std::string name = scene_name(find_scene(options.scene, home));
  options.outputs.push_back(name + ".png");
  options.outputs.push_back(name + (options.untrusted ? ".glb" : ".mp4"));
  say(text(why, ": running the scene to ", name, ".png and ", options.outputs.back(), " instead"));
  if (!options.record.empty()) say(text("nobody plays, so nothing is recorded: there is no ", options.record));
  return run(options, home);
}

}  // namespace

int play(const RunOptions& given, const std::string& home) {
  RunOptions options = given;
  const std::string shown_without_window = options.scene.empty() ? "chain" : options.scene;
  std::string why = "there is no display to play on";
  try {
    if (const Display display; display.seen()) return play_in_window(options, home);
  } catch (const NoWindow& error) { why = error.what(); }
  options.scene = shown_without_window;
  return play_unseen(options, home, why);
}

}  // namespace pantin::player
