// Several things are selected, copied, moved and removed as one, by pushed events.
#include "view/selected_things.hpp"

#include <catch2/catch.hpp>

#include "measure/query.hpp"
#include "window/played.hpp"

using namespace pantin;

namespace {

constexpr int width = 960, height = 540;

/// Three boxes in a row, the third nailed, in a paused window.
struct Row : Played {
  Row()
      : Played(R"(
          scene.plane = "xy"
          scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
          for x = -2, 2, 2 do scene:box { size = 0.5, at = vec(x, 0, 0), points = { vec(0, 0, 0) } } end
          scene:nail(scene.bodies[3].points[1]))",
               paused()) {
    camera.look(vec(0, 0, 10), zero3());
  }
  static player::RunOptions paused() {
    player::RunOptions options;
    options.size = {width, height};
    options.paused = true;
    return options;
  }
  Projected seen(Vec3 at) const { return camera.project(at, width, height).value(); }
  Vec3 middle(std::size_t body) const { return world().motion_of(world().bodies.ids().at(body)).x; }
  void with(SDL_Keycode held, SDL_Keycode key) {
    pushed::key(held);
    pushed::tap(key);
    pushed::key(held, false);
    frames(2);
  }
  void drag_between(Vec3 from, Vec3 to, bool shift) {
    const Projected a = seen(from), b = seen(to);
    if (shift) pushed::key(SDLK_LSHIFT);
    drag(a.x, a.y, b.x, b.y);
    if (shift) pushed::key(SDLK_LSHIFT, false);
    frames(1);
  }
  void shift_click(Vec3 at) { drag_between(at, at, true); }

  Camera camera;
};

}  // namespace

TEST_CASE("a box that is drawn with shift selects, and a drag moves all of it as one act", "[window]") {
  Row row;
  row.drag_between(vec(-3, 1, 0), vec(1, -1, 0), true);
  CHECK_THAT(row.player->told(), Catch::Contains("2 things are selected"));
  const Vec3 first = row.middle(0), second = row.middle(1), third = row.middle(2);
  row.drag_between(first, first + vec(0.5, 1, 0), false);
  CHECK(norm(row.middle(0) - first - vec(0.5, 1, 0)) < 0.05);
  CHECK(norm(row.middle(1) - second - (row.middle(0) - first)) < 1e-12);
  CHECK(norm(row.middle(2) - third) == 0.0);
  row.with(SDLK_LCTRL, SDLK_z);
  CHECK(norm(row.middle(0) - first) == 0.0);
  CHECK(norm(row.middle(1) - second) == 0.0);
}

TEST_CASE("clicks with shift select one more or one less, and what is selected is copied and removed as one",
          "[window]") {
  Row row;
  row.shift_click(vec(-2, 0, 0));
  row.shift_click(vec(0, 0, 0));
  row.shift_click(vec(2, 0, 0));
  CHECK_THAT(row.player->told(), Catch::Contains("3 things are selected"));
  row.shift_click(vec(0, 0, 0));
  CHECK_THAT(row.player->told(), Catch::Contains("2 things are selected"));
  row.with(SDLK_LCTRL, SDLK_c);
  const Projected to = row.seen(vec(-2, 1.5, 0));
  pushed::move(to.x, to.y);
  row.frames(2);
  row.with(SDLK_LCTRL, SDLK_v);
  REQUIRE(row.world().bodies.size() == 5);
  CHECK(norm(row.middle(4) - row.middle(3) - vec(4, 0, 0)) < 1e-9);
  pushed::tap(SDLK_DELETE);
  row.frames(2);
  CHECK(row.world().bodies.size() == 3);
  row.with(SDLK_LCTRL, SDLK_z);
  CHECK(row.world().bodies.size() == 5);
  row.with(SDLK_LCTRL, SDLK_z);
  CHECK(row.world().bodies.size() == 3);
}

TEST_CASE("a nail goes along with what is moved, and Esc forgets what is selected", "[window]") {
  Row row;
  row.shift_click(vec(2, 0, 0));
  row.drag_between(vec(2, 0, 0), vec(2, -1, 0), false);
  const Vec3 moved = row.middle(2);
  CHECK(moved[1] == Approx(-1.0).margin(0.05));
  pushed::tap(SDLK_ESCAPE);
  row.frames(2);
  row.drag_between(moved, moved + vec(0, 1, 0), false);
  CHECK(norm(row.middle(2) - moved) == 0.0);
  pushed::tap(SDLK_SPACE);
  row.frames(20);
  CHECK(norm(row.middle(2) - moved) < 1e-6);
}
