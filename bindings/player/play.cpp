#include "player/play.hpp"

#include <memory>

#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/outputs.hpp"
#include "player/player.hpp"
#include "player/run.hpp"

namespace pantin::player {
namespace {

/// What `play` does where nothing can be seen.
int play_unseen(RunOptions options, const std::string& home) {
  std::string name = scene_name(find_scene(options.scene, home));
  options.outputs.push_back(name + ".png");
  options.outputs.push_back(name + ".mp4");
  say(text("there is no display to play on: running the scene to ", name, ".png and ", name, ".mp4 instead"));
  return run(options, home);
}

}  // namespace

int play(const RunOptions& given, const std::string& home) {
  RunOptions options = given;
  if (options.scene.empty()) options.scene = "chain";
  std::string path = find_scene(options.scene, home);
  if (!Window::display_available()) return play_unseen(options, home);
  Interrupt interrupt;
  Outputs outputs(options);
  if (!outputs.films().empty())
    throw lua::UsageError("play writes .csv and .png; films are made by `pantin run SCENE --out FILE`");

  Player player(path, options, home);
  while (player.frame()) {}
  outputs.write_tables(player.times(), player.scene().world());
  for (const std::string& picture : outputs.temporaries(".png")) player.write_picture(picture);
  outputs.write_summary(player.scene());
  outputs.keep();
  return player.failure().empty() ? 0 : 1;
}

}  // namespace pantin::player
