// Play in the window, with all a person can do, recorded and played again without one.

#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "player/replay.hpp"
#include "window/played_chain.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

const std::string chain = R"(
  local count = scene:param("links", 6, { min = 2, max = 12 })
  scene:param("gravity", 9.81, { on_change = function(g) scene.gravity = vec(0, -g, 0) end })
)" + PlayedChain::text("count") +
                          R"(
  for i = 1, 5 do scene:particle { at = vec(i, 1, 0) } end
  scene:button("kick", function() previous.velocity = vec(0, 5 * math.random(), 0) end)
  scene:on("key", "o", function() error "oh" end)
)";

/// A recorded player that nobody sees.
struct Recorded : PlayedChain {
  explicit Recorded(const std::string& source = chain) : PlayedChain(source, recorded()) {}
  static player::RunOptions recorded() {
    player::RunOptions options;
    options.size = {width, height};
    options.record = "play.rec";
    return options;
  }
  void tap(SDL_Keycode key) {
    pushed::tap(key);
    frames(2);
  }
  /// Uses a tool from one position to another.
  void use(SDL_Keycode tool, Vec3 from, Vec3 to) {
    tap(tool);
    const Projected a = seen(from), b = seen(to);
    pushed::move(a.x, a.y);
    frames(1);
    pushed::button(true, a.x, a.y);
    frames(1);
    for (int i = 1; i <= 6; i++) {
      pushed::move(a.x + (b.x - a.x) * i / 6, a.y + (b.y - a.y) * i / 6);
      frames(1);
    }
    pushed::button(false, b.x, b.y);
    frames(3);
  }
  void finger(Uint32 type, SDL_FingerID id, Vec3 position) {
    SDL_Event event = {};
    const Projected at = seen(position);
    event.type = type;
    event.tfinger.touchId = 1;
    event.tfinger.fingerId = id;
    event.tfinger.x = static_cast<float>(at.x / width);
    event.tfinger.y = static_cast<float>(at.y / height);
    SDL_PushEvent(&event);
  }
  /// For so many seconds of the scene.
  void play_on(double seconds) {
    const double until = world().time + seconds;
    for (int i = 0; i < 400 && world().time < until; i++) frames(1);
    REQUIRE(world().time >= until);
  }
  Vec3 tip() const { return position(world(), world().points.ids().back()); }
  Vec3 hinge(std::size_t i) const { return position(world(), hinges(world()).at(i)); }
  /// Plays it again and checks that all is as it was.
  void check() {
    player->end_recording();
    player::RunOptions options;
    options.headless = true;
    player::Replay replay(player::read_recording(folder / "play.rec"), options, sources::folder());
    while (replay.step()) {}
    CHECK(replay.mismatch() == "");
    CHECK(replay.checked() > 0);
    CHECK(replay.scene().world().time == world().time);
    CHECK(state_hash(replay.scene().world()) == state_hash(world()));
  }
};

}  // namespace

TEST_CASE("a recording of the window with all tools, undo, parameters and restarts is played again to the bit",
          "[window]") {
  Recorded recorded;
  recorded.use(SDLK_1, recorded.tip(), vec(2, 3, 0));
  recorded.use(SDLK_2, recorded.hinge(2) - vec(0, 0.5, 0), recorded.hinge(2) + vec(0, 0.5, 0));
  recorded.with_control(SDLK_z);
  recorded.with_control(SDLK_y);
  recorded.use(SDLK_3, recorded.tip(), recorded.hinge(0));
  recorded.use(SDLK_4, recorded.hinge(1), recorded.hinge(1));
  recorded.use(SDLK_5, recorded.tip(), recorded.tip() + vec(1, 1, 0));
  recorded.use(SDLK_6, recorded.hinge(0), recorded.hinge(0) + vec(1, 0, 0));
  recorded.player->set_parameter("gravity", 3.0);
  recorded.use(SDLK_8, vec(4, 0, 0), vec(5, 0, 0));
  recorded.use(SDLK_9, vec(2, 1, 0), vec(3, 1, 0));
  recorded.use(SDLK_7, recorded.hinge(0), recorded.hinge(0));
  recorded.with_control(SDLK_z);
  recorded.player->set_parameter("links", 4.0);
  recorded.frames(20);
  recorded.tap(SDLK_o);
  CHECK_THAT(recorded.player->failure(), Contains("oh"));
  recorded.tap(SDLK_r);
  recorded.frames(20);
  recorded.use(SDLK_2, recorded.hinge(2) - vec(0, 0.5, 0), recorded.hinge(2) + vec(0, 0.5, 0));
  recorded.player->set_parameter("links", 5.0);
  recorded.frames(10);
  recorded.tap(SDLK_r);
  recorded.frames(10);
  recorded.with_control(SDLK_z);
  recorded.frames(10);
  recorded.player->set_parameter("gravity", 2.0);
  recorded.tap(SDLK_r);
  recorded.frames(10);
  recorded.with_control(SDLK_z);
  recorded.frames(10);
  recorded.with_control(SDLK_y);
  recorded.tap(SDLK_SPACE);
  recorded.tap(SDLK_PERIOD);
  recorded.use(SDLK_1, recorded.tip(), recorded.tip() + vec(-1, 0, 0));
  recorded.with_control(SDLK_z);
  recorded.tap(SDLK_SPACE);
  recorded.play_on(1.1);  // over a second's hash
  recorded.check();
}

TEST_CASE("a recording goes on where a file is saved while two fingers drag", "[window]") {
  Recorded recorded;
  recorded.finger(SDL_FINGERDOWN, 1, recorded.tip());
  recorded.finger(SDL_FINGERDOWN, 2, recorded.hinge(2));
  recorded.frames(10);
  REQUIRE((recorded.world().hands.at(0).grab && recorded.world().hands.at(1).grab));
  recorded.save(chain + "scene.title = 'saved'");
  CHECK((recorded.world().hands.at(0).grab && recorded.world().hands.at(1).grab));
  for (int i = 1; i <= 20; i++) {
    recorded.finger(SDL_FINGERMOTION, 1, vec(4 - 0.05 * i, 1, 0));
    recorded.finger(SDL_FINGERMOTION, 2, vec(2, 3 + 0.05 * i, 0));
    recorded.frames(1);
  }
  CHECK((recorded.world().hands.at(0).grab && recorded.world().hands.at(1).grab));
  CHECK(recorded.world().error.hinge_gap < 1e-9);
  recorded.finger(SDL_FINGERUP, 1, vec(3, 1, 0));
  recorded.play_on(1.1);
  CHECK_FALSE(recorded.world().hands.at(0).grab);
  recorded.check();
}

TEST_CASE("a recording goes on over a scene that opens another with parameters", "[window]") {
  Recorded recorded(chain + R"(
    if count == 6 then scene:on("key", "u", function() scene:open("scene.lua", { links = 4 }) end) end
    if count == 4 then scene:on("key", "u", function() scene:open("other.lua", { speed = 2 }) end) end)");
  support::write_file(recorded.folder / "other.lua",
                      "local v = scene:param('speed', 1) scene:particle { velocity = vec(v, math.random(), 0) }");
  recorded.use(SDLK_1, recorded.tip(), vec(2, 3, 0));
  recorded.play_on(1.1);
  recorded.tap(SDLK_u);
  recorded.frames(10);
  CHECK(recorded.world().bodies.size() == 4);
  recorded.use(SDLK_1, recorded.tip(), vec(2, 3, 0));
  recorded.with_control(SDLK_z);
  recorded.tap(SDLK_u);
  recorded.frames(10);
  CHECK(recorded.world().bodies.empty());
  recorded.play_on(1.1);
  recorded.check();
}

TEST_CASE("a recording in which a reload is undone is played again to the bit", "[window]") {
  Recorded recorded;
  recorded.use(SDLK_8, vec(4, 0, 0), vec(5, 0, 0));
  recorded.frames(10);
  const std::size_t built = recorded.world().bodies.size();
  recorded.save(chain + "scene.title = 'saved'");
  recorded.frames(10);
  CHECK(recorded.world().bodies.size() < built);
  recorded.with_control(SDLK_z);
  CHECK(recorded.world().bodies.size() == built);
  recorded.tap(SDLK_SPACE);
  recorded.play_on(1.1);  // over a second's hash
  recorded.check();
}

TEST_CASE("a saved file with an error leaves the recording as it is", "[window]") {
  Recorded recorded;
  recorded.frames(20);
  support::write_file(recorded.folder / "scene.lua", chain + "\nlocal x = nothing.here");
  for (int i = 0; i < 100 && recorded.player->said().empty(); i++) recorded.frames(1);
  REQUIRE_FALSE(recorded.player->said().empty());
  CHECK_THAT(recorded.player->said().back().text, Contains("scene.lua:"));
  recorded.save(chain + "scene.title = 'saved'");
  recorded.play_on(1.1);  // over a second's hash
  recorded.check();
}
