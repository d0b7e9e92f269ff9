#pragma once
// A player in a window that nobody sees.
#include <SDL.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "player/player.hpp"
#include "support/process.hpp"
#include "support/sources.hpp"
#include "window/pushed.hpp"

namespace pantin {

/// A player of a text, in a window that nobody sees.
struct Played {
  support::Folder folder;
  std::unique_ptr<player::Player> player;
  int saved = 0;

  /// The browser where the text is empty; it finds the text's scene in `folder`, and keeps its pictures there.
  explicit Played(const std::string& source, double script_limit = 5.0, player::Size size = {640, 360})
      : Played(source, options_of(script_limit, size)) {}
  /// What is recorded is in `folder`.
  Played(const std::string& source, player::RunOptions options) {
    pushed::no_screen();
    // OpenGL's own cache stays where it is: shaders take their time.
    if (const char* home = std::getenv("HOME"))
      setenv("MESA_SHADER_CACHE_DIR", (std::string(home) + "/.cache").c_str(), 0);
    setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    if (!source.empty()) support::write_file(folder / "scene.lua", source);
    options.scenes = folder.path;
    if (!options.record.empty()) options.record = folder / options.record;
    player = std::make_unique<player::Player>(source.empty() ? "" : folder / "scene.lua", options, sources::folder());
    frames(3);
  }
  static player::RunOptions options_of(double script_limit, player::Size size) {
    player::RunOptions options;
    options.size = size;
    options.script_limit = script_limit;
    return options;
  }
  void frames(int n) {
    for (int i = 0; i < n; i++) REQUIRE(player->frame());
  }
  void click(double x, double y) { drag(x, y, x, y); }
  // Each part in a frame of its own, as a person is slower than frames.
  void drag(double x0, double y0, double x1, double y1) {
    pushed::move(x0, y0);
    frames(2);
    pushed::button(true, x0, y0);
    frames(2);
    pushed::move(x1, y1);
    frames(2);
    pushed::button(false, x1, y1);
    frames(2);
  }
  /// Steps of a scene that is paused.
  void steps(int n) {
    for (int i = 0; i < n; i++) {
      pushed::tap(SDLK_PERIOD);
      frames(1);
    }
  }
  void with_control(SDL_Keycode key, bool shift = false) {
    pushed::key(SDLK_LCTRL);
    if (shift) pushed::key(SDLK_LSHIFT);
    pushed::tap(key);
    if (shift) pushed::key(SDLK_LSHIFT, false);
    pushed::key(SDLK_LCTRL, false);
    frames(1);
  }
  /// Saves the scene, whose title becomes "saved", and waits until it goes on with that.
  void save(const std::string& text) {
    const std::string path = folder / "scene.lua";
    support::write_file(path, text);
    std::filesystem::last_write_time(path,
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++saved));
    for (int i = 0; i < 200 && player->scene().title() != "saved"; i++) frames(1);
    REQUIRE(player->scene().title() == "saved");
  }
  double result(const std::string& name) const { return std::get<double>(player->scene().results().at(name)); }
  const World& world() const { return player->scene().world(); }
};

}  // namespace pantin
