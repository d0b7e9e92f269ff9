#pragma once
// What the panels see, and what they may ask for.
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "player/pacing.hpp"
#include "player/recording.hpp"
#include "player/table.hpp"
#include "scene/scene.hpp"
#include "view/views.hpp"

namespace pantin::player {

/// What a person asked of the program in the panels, in one frame.
struct Wishes {
  bool pause = false, step = false, restart = false;
  bool browse = false, next = false, previous = false;  ///< the browser, and the scenes beside this one
  bool save_table = false;                              ///< the probes, as .csv
  bool save_state = false, open_state = false;          ///< the present one; the one that was saved last
  bool save_scene = false;                              ///< with what was built, as Lua
  bool picture = false, film = false;                   ///< take one; begin or end one
  std::optional<FieldEdit> edit;
  std::optional<double> speed;  ///< times the scene's pace
  std::optional<std::pair<std::string, SceneValue>> parameter;
  std::string told;  ///< why what was asked for is not what is done
};

/// Range of the speed, times the scene's pace.
inline constexpr double slowest = 1.0 / 64.0, fastest = 64.0;

/// Something the program said; the same again is counted.
struct Said {
  std::string text;
  std::uint64_t times = 1;
  bool good = false;  ///< nothing went wrong
};

/// Names a state of the scene, so that a panel need not read again what it knows.
struct SeenState {
  std::uint64_t steps = ~0ull, changes = 0;
  bool operator==(const SeenState&) const = default;
};

struct Desk {
  Scene& scene;
  const Times& times;
  const Pacing& pacing;
  const std::deque<Said>& said;  ///< oldest first
  AnyId& chosen;                 ///< what the inspector shows
  AnyId hovered;                 ///< under the pointer
  Views& views;                  ///< those that are on
  bool& film_panels;             ///< films show panels, too
  Wishes wishes;
  double speed = 1.0;  ///< times the scene's pace
  bool paused = false;
  bool quick = true;  ///< the scene opens so quickly that it may be opened again in each frame
  bool filming = false;
  std::uint64_t changes = 0;          ///< made to the scene between its steps, so far
  float width = 0.0f, height = 0.0f;  ///< [px]

  bool dark() const { return views.on(View::dark); }
  const World& world() const { return scene.world(); }
  SeenState seen() const { return {world().steps, changes}; }
};

}  // namespace pantin::player
