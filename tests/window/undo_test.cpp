// What hands did is undone and done again, to the bit, by pushed events.
#include <catch2/catch.hpp>

#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "player/undo.hpp"
#include "window/played_chain.hpp"

using namespace pantin;
using Catch::Matchers::Contains;

namespace {

constexpr int width = PlayedChain::width, height = PlayedChain::height;

/// A player of a chain of six links, paused.
struct Session : PlayedChain {
  explicit Session(const std::string& more = "")
      : PlayedChain(text() + "scene:probe('energy', function() return scene.energy.total end) " + more, paused()) {}
  static player::RunOptions paused() {
    player::RunOptions options;
    options.size = {width, height};
    options.paused = true;
    return options;
  }
  /// Makes a rod below the chain with the tool.
  void make_rod() {
    const Projected from = seen(vec(1, 1, 0)), to = seen(vec(3, 1, 0));
    pushed::tap(SDLK_8);
    frames(1);
    drag(from.x, from.y, to.x, to.y);
  }
  /// Cuts the third hinge with the tool.
  void cut() {
    const Projected at = seen(position(world(), hinges(world())[2]));
    pushed::tap(SDLK_2);
    frames(1);
    pushed::move(at.x, at.y);
    frames(1);
    pushed::button(true, at.x, at.y);
    pushed::button(false, at.x, at.y);
    frames(1);
  }
};

}  // namespace

TEST_CASE("undo puts the scene back to the bit, redo does it again", "[window]") {
  Session session;
  session.steps(5);
  const std::uint64_t before = state_hash(session.world());
  session.cut();
  session.steps(20);
  CHECK(hinges(session.world()).size() == 4);
  const std::uint64_t after = state_hash(session.world());
  const double time = session.world().time;
  session.with_control(SDLK_z);
  CHECK(state_hash(session.world()) == before);
  CHECK(hinges(session.world()).size() == 5);
  CHECK(session.player->times().values.size() == 5);
  session.with_control(SDLK_z, true);
  CHECK(state_hash(session.world()) == after);
  CHECK(session.world().time == time);
  CHECK(session.player->times().values.size() == 25);
  session.with_control(SDLK_z);
  session.cut();
  session.steps(20);
  CHECK(state_hash(session.world()) == after);  // the same act comes to the same bits
}

TEST_CASE("an act that is forgotten is none, and what was undone before it can be done again", "[view]") {
  std::shared_ptr<Scene> scene = lua::open_scene_text("scene:particle {}", "a.lua", "", {});
  player::Undo undo;
  player::Times times;
  StepInput waiting;
  std::string told;
  undo.begin(scene, times, waiting, "nail");
  REQUIRE(undo.undo(scene, times, waiting, told));
  const std::uint64_t failed = undo.begin(scene, times, waiting, "chain");
  CHECK(undo.last() == "chain");
  undo.forget(failed);
  CHECK(undo.last().empty());
  CHECK(undo.redo(scene, times, waiting, told));
  CHECK(told == "redo: nail");
  undo.forget(failed);
  CHECK(undo.last() == "nail");
}

TEST_CASE("an act that fails is told, and undo takes back what was done before it", "[window]") {
  Session session;
  session.cut();
  REQUIRE(hinges(session.world()).size() == 4);
  const Projected head = session.seen(vec(0, 4, 0)), tail = session.seen(vec(1, 4, 0));
  pushed::tap(SDLK_3);
  session.frames(1);
  session.drag(head.x, head.y, tail.x, tail.y);  // ends of one body
  session.steps(1);
  CHECK_THAT(session.player->told(), Contains("join by hand 1") && Contains("both points belong to"));
  CHECK(hinges(session.world()).size() == 4);
  const std::uint64_t after = state_hash(session.world());
  session.with_control(SDLK_z);
  CHECK(session.player->told() == "undo: cut");
  CHECK(hinges(session.world()).size() == 5);
  session.drag(head.x, head.y, tail.x, tail.y);
  session.steps(1);
  session.with_control(SDLK_z, true);
  CHECK(state_hash(session.world()) == after);
  CHECK(session.player->failure().empty());
}

TEST_CASE("undo with nothing done changes nothing, and a hand that held lets go", "[window]") {
  Session session;
  const std::uint64_t start = state_hash(session.world());
  session.with_control(SDLK_z);
  session.with_control(SDLK_z, true);
  CHECK(state_hash(session.world()) == start);
  const Projected tip = session.seen(vec(6, 4, 0));
  pushed::move(tip.x, tip.y);
  session.frames(1);
  pushed::button(true, tip.x, tip.y);
  session.steps(3);
  REQUIRE(session.world().hands.size() == 1);
  CHECK(session.world().hands[0].grab);
  session.with_control(SDLK_z);
  session.steps(1);
  CHECK((session.world().hands.empty() || !session.world().hands[0].grab));
  pushed::button(false, tip.x, tip.y);
  session.steps(3);
  CHECK(session.player->failure().empty());
}

TEST_CASE("undo and redo while paused keep what still waits for a step", "[window]") {
  Session session;
  session.cut();
  session.cut();
  pushed::key(SDLK_LCTRL);
  pushed::tap(SDLK_z);
  pushed::tap(SDLK_z);  // in the same frame
  pushed::key(SDLK_LCTRL, false);
  session.frames(1);
  session.with_control(SDLK_z, true);
  session.steps(1);
  CHECK(hinges(session.world()).size() == 4);
  Session other;
  other.cut();
  const Projected tip = other.seen(vec(6, 4, 0));
  pushed::tap(SDLK_1);
  other.frames(1);
  pushed::move(tip.x, tip.y);
  other.frames(1);
  pushed::button(true, tip.x, tip.y);
  other.frames(1);
  pushed::button(false, tip.x, tip.y);
  other.frames(1);
  other.with_control(SDLK_z);
  other.steps(1);
  CHECK(hinges(other.world()).size() == 4);  // the cut, which came before what was undone
}

TEST_CASE("a play cannot be wound back, and the acts of a scene end with it", "[window]") {
  Session session("scene:play(function(wait) wait(100) end)");
  session.steps(2);
  session.cut();
  session.steps(3);
  session.with_control(SDLK_z);
  CHECK(hinges(session.world()).size() == 4);
  Session other;
  other.cut();
  other.steps(1);
  pushed::tap(SDLK_r);
  other.frames(1);
  CHECK(hinges(other.world()).size() == 5);
}

TEST_CASE("a restart that loses what was done is undone, and done again", "[window]") {
  const std::string more = GENERATE(as<std::string>(), "", "scene:play(function(wait) wait(100) end)");
  Session session(more);
  session.cut();
  session.steps(4);
  const std::uint64_t built = state_hash(session.world());
  pushed::tap(SDLK_r);
  session.frames(4);
  CHECK(session.world().steps == 0);  // it was paused, and stays so
  const std::uint64_t again = state_hash(session.world());
  CHECK(hinges(session.world()).size() == 5);
  pushed::tap(SDLK_r);  // loses nothing
  session.frames(2);
  session.with_control(SDLK_z);
  CHECK(state_hash(session.world()) == built);
  session.with_control(SDLK_z, true);
  CHECK(state_hash(session.world()) == again);
  session.with_control(SDLK_z);
  session.frames(3);
  CHECK(session.world().steps == 4);  // paused, as somebody builds
  session.steps(3);
  CHECK(session.world().steps == 7);
  session.with_control(SDLK_z);
  CHECK(hinges(session.world()).size() == (more.empty() ? 5 : 4));  // a play cannot be wound back
  CHECK(session.player->failure().empty());
}

TEST_CASE("a reload that loses what was built is undone, and the saved file is not reloaded again by that",
          "[window]") {
  Session session;
  session.make_rod();
  session.steps(4);
  REQUIRE(session.world().bodies.size() == 7);
  const std::uint64_t built = state_hash(session.world());
  const std::string more = PlayedChain::text() + "scene.title = 'saved' ";
  session.save(more);
  CHECK(session.world().bodies.size() == 6);
  session.save(more + "--");  // loses nothing
  session.frames(20);
  const std::uint64_t reloaded = state_hash(session.world());
  session.with_control(SDLK_z);
  CHECK(session.player->told() == "undo: reload; paused");
  session.frames(20);
  CHECK(state_hash(session.world()) == built);
  session.with_control(SDLK_z, true);
  CHECK(state_hash(session.world()) == reloaded);
  session.with_control(SDLK_z);
  session.with_control(SDLK_z);
  CHECK(session.world().bodies.size() == 6);
  session.with_control(SDLK_z, true);
  CHECK(state_hash(session.world()) == built);
  session.save(more + "-- once more");
  CHECK(session.world().bodies.size() == 6);
  CHECK(session.player->failure().empty());
}

TEST_CASE("a state that is opened over what was built is undone, and the scene is that of its own file again",
          "[window]") {
  Session session;
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(session.folder.path);
  session.steps(4);
  const std::uint64_t saved = state_hash(session.world());
  session.with_control(SDLK_s);
  session.with_control(SDLK_o);  // loses nothing
  session.with_control(SDLK_z);
  CHECK(session.player->told() == "nothing to undo");
  session.make_rod();
  session.steps(4);
  const std::uint64_t built = state_hash(session.world());
  session.with_control(SDLK_o);
  CHECK(state_hash(session.world()) == saved);
  session.with_control(SDLK_z);
  CHECK(session.player->told() == "undo: opening of a state; paused");
  CHECK(state_hash(session.world()) == built);
  session.with_control(SDLK_z, true);
  CHECK(state_hash(session.world()) == saved);
  session.steps(3);
  const std::uint64_t later = state_hash(session.world());
  pushed::tap(SDLK_r);
  session.frames(2);
  CHECK(state_hash(session.world()) == saved);
  session.with_control(SDLK_z);
  CHECK(session.player->told() == "undo: restart; paused");
  CHECK(state_hash(session.world()) == later);
  session.with_control(SDLK_z);
  CHECK(state_hash(session.world()) == built);
  std::filesystem::current_path(here);
  CHECK(session.player->failure().empty());
}

TEST_CASE("what was done before a parameter rebuilt the scene comes back with the parameter's value", "[window]") {
  Session session("scene:param('n', 1, { min = 1, max = 3, step = 1 })");
  session.cut();
  session.steps(2);
  const std::uint64_t before = state_hash(session.world());
  session.player->set_parameter("n", 2.0);
  session.frames(1);
  CHECK(hinges(session.world()).size() == 5);
  session.with_control(SDLK_z);
  CHECK(state_hash(session.world()) == before);
  CHECK(session.player->scene().parameters()[0].value == SceneValue(1.0));
  session.with_control(SDLK_z);
  CHECK(hinges(session.world()).size() == 5);
}

TEST_CASE("two fingers pull at the chain in the window", "[window]") {
  Session session;
  const auto finger = [&](Uint32 type, SDL_FingerID id, Projected at) {
    SDL_Event event = {};
    event.type = type;
    event.tfinger.touchId = 1;
    event.tfinger.fingerId = id;
    event.tfinger.x = static_cast<float>(at.x / width);
    event.tfinger.y = static_cast<float>(at.y / height);
    SDL_PushEvent(&event);
  };
  const Projected a = session.seen(vec(6, 4, 0)), b = session.seen(vec(3, 4, 0));
  finger(SDL_FINGERDOWN, 1, a);
  finger(SDL_FINGERDOWN, 2, b);
  session.steps(2);
  REQUIRE(session.world().hands.size() == 2);
  for (int i = 1; i <= 40; i++) {
    finger(SDL_FINGERMOTION, 1, {a.x - 2.0 * i, a.y + i});
    finger(SDL_FINGERMOTION, 2, {b.x, b.y + 2.0 * i});
    session.steps(3);
  }
  CHECK((session.world().hands[0].grab && session.world().hands[1].grab));
  CHECK(session.world().error.hinge_gap < 1e-9);
  finger(SDL_FINGERUP, 2, b);
  session.steps(2);
  CHECK(session.world().hands[0].grab);
  CHECK_FALSE(session.world().hands[1].grab);
}
