// What a hand does is in the very next picture.
#include <epoxy/gl.h>

#include <catch2/catch.hpp>
#include <vector>

#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "player/replay.hpp"
#include "view/camera.hpp"
#include "window/played_chain.hpp"

using namespace pantin;

namespace {

constexpr int width = 640, height = 480;

std::vector<unsigned char> picture() {
  std::vector<unsigned char> pixels(4 * static_cast<std::size_t>(width) * height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

/// Pixels within `reach` of a position [pixels from the left and top] that changed.
int changed(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int x, int y, int reach) {
  int count = 0;
  for (int row = y - reach; row <= y + reach; row++)
    for (int column = x - reach; column <= x + reach; column++) {
      const std::size_t at =
          4 * (static_cast<std::size_t>(height - 1 - row) * width + static_cast<std::size_t>(column));
      for (std::size_t i = at; i < at + 3; i++)
        if (a[i] != b[i]) {
          count++;
          break;
        }
    }
  return count;
}

/// A floor in a plane, paused, before a camera at rest.
struct Workshop : Played {
  explicit Workshop(const std::string& record = "") : Played(text(), options(record)) {}
  static std::string text() {
    return R"(
      scene.plane = "xy"
      scene.step = 1 / 60
      scene.camera = { at = vec(0, 2, 10), look_at = vec(0, 2, 0) }
      scene:floor {}
      scene:probe("bodies", function() return #scene.bodies end)
    )";
  }
  static player::RunOptions options(const std::string& record) {
    player::RunOptions options;
    options.size = {width, height};
    options.paused = true;
    options.record = record;
    return options;
  }
  Projected seen(Vec3 position) const {
    Camera camera;
    camera.look(vec(0, 2, 10), vec(0, 2, 0));
    return camera.project(position, width, height).value();
  }
  void drag_from(Vec3 from, Vec3 to) {
    const Projected a = seen(from), b = seen(to);
    drag(a.x, a.y, b.x, b.y);
  }
  /// Takes a tool by its key, which pressed again takes the next of its variants.
  void take(SDL_Keycode key, int variant) {
    pushed::tap(SDLK_1);
    for (int i = 0; i <= variant; i++) pushed::tap(key);
    frames(2);
  }
  /// A box, a wheel on it, and a motor in that.
  void build_cart() {
    take(SDLK_8, 2);
    drag_from(vec(-1, 1, 0), vec(1, 2, 0));
    take(SDLK_8, 3);
    drag_from(vec(0.5, 1.3, 0), vec(0.9, 1.3, 0));
    take(SDLK_6, 1);
    drag_from(vec(0.6, 1.4, 0), vec(1.2, 1.4, 0));
  }
};

}  // namespace

TEST_CASE("window: what is built while it is paused is seen, counts for what is built next, and no time passes",
          "[window]") {
  Workshop shop;
  shop.frames(30);  // until nothing is told any more
  shop.take(SDLK_8, 2);
  const std::vector<unsigned char> before = picture();
  shop.drag_from(vec(-1, 1, 0), vec(1, 2, 0));
  shop.frames(2);
  const Projected middle = shop.seen(vec(0, 1.5, 0));
  CHECK(changed(before, picture(), static_cast<int>(middle.x), static_cast<int>(middle.y), 10) > 300);
  REQUIRE(shop.world().bodies.size() == 1);
  shop.take(SDLK_8, 3);
  shop.drag_from(vec(0.5, 1.3, 0), vec(0.9, 1.3, 0));
  REQUIRE(shop.world().bodies.size() == 2);
  CHECK(hinges(shop.world()).size() == 1);
  shop.take(SDLK_6, 1);
  shop.drag_from(vec(0.6, 1.4, 0), vec(1.2, 1.4, 0));
  CHECK(shop.world().constraints.size() == 1);
  CHECK(shop.world().time == 0.0);
  CHECK(shop.world().log.empty());
}

TEST_CASE("window: acts of a paused scene are undone one by one, and done again to the bit", "[window]") {
  Workshop shop;
  const std::uint64_t empty = state_hash(shop.world());
  shop.build_cart();
  const std::uint64_t built = state_hash(shop.world());
  shop.with_control(SDLK_z);
  CHECK(shop.world().constraints.empty());
  shop.with_control(SDLK_z);
  CHECK(shop.world().bodies.size() == 1);
  shop.with_control(SDLK_z);
  CHECK(state_hash(shop.world()) == empty);
  for (int i = 0; i < 3; i++) shop.with_control(SDLK_y);
  CHECK(state_hash(shop.world()) == built);
  CHECK(shop.world().constraints.size() == 1);
}

TEST_CASE("window: what was built in pauses is played again to the bit, the last pause too", "[window]") {
  std::uint64_t hash = 0;
  Workshop shop("play.rec");
  shop.build_cart();
  shop.steps(10);
  shop.take(SDLK_8, 1);
  shop.drag_from(vec(-2, 3, 0), vec(-1.7, 3, 0));
  shop.steps(65);
  shop.take(SDLK_8, 2);
  shop.drag_from(vec(-2, 3, 0), vec(-1.5, 3.5, 0));
  hash = state_hash(shop.world());
  shop.player->end_recording();
  player::Replay replay(player::read_recording(shop.folder / "play.rec"), Workshop::options(""), sources::folder());
  while (replay.step()) {}
  CHECK(replay.mismatch() == "");
  CHECK(replay.checked() >= 1);
  CHECK(replay.scene().world().bodies.size() == 4);
  CHECK(state_hash(replay.scene().world()) == hash);
}

TEST_CASE("window: what was built is saved as a scene by its keys, and opens as it is", "[window]") {
  Workshop shop;
  shop.build_cart();
  pushed::key(SDLK_LCTRL);
  pushed::key(SDLK_LSHIFT);
  pushed::tap(SDLK_s);
  pushed::key(SDLK_LSHIFT, false);
  pushed::key(SDLK_LCTRL, false);
  shop.frames(2);
  REQUIRE_FALSE(shop.player->said().empty());
  CHECK_THAT(shop.player->said().back().text, Catch::EndsWith("scene-0001.lua"));
  const std::uint64_t built = state_hash(shop.world());
  REQUIRE(shop.player->open(shop.folder / "scene-0001.lua"));
  CHECK(state_hash(shop.world()) == built);
  CHECK(shop.world().constraints.size() == 1);
}

TEST_CASE("window: what was built is saved as a scene where a link of a chain was removed, too", "[window]") {
  player::RunOptions options = Workshop::options("");
  options.size = {PlayedChain::width, PlayedChain::height};
  PlayedChain chain(PlayedChain::text(), options);
  const Projected link = chain.seen(vec(2.5, 4, 0));
  pushed::tap(SDLK_7);
  chain.frames(1);
  chain.click(link.x, link.y);
  REQUIRE(chain.world().bodies.size() == 5);
  chain.with_control(SDLK_s, true);
  chain.frames(2);
  CHECK_THAT(chain.player->said().back().text, Catch::EndsWith("scene-0001.lua"));
  const std::uint64_t built = state_hash(chain.world());
  REQUIRE(chain.player->open(chain.folder / "scene-0001.lua"));
  CHECK(state_hash(chain.world()) == built);
}

TEST_CASE("window: a machine is copied, pasted where the pointer is, mirrored and removed, each as one act",
          "[window]") {
  Workshop shop;
  shop.build_cart();
  const std::uint64_t built = state_hash(shop.world());
  const Projected on = shop.seen(vec(-0.7, 1.7, 0)), there = shop.seen(vec(0, 3.4, 0));
  const auto over = [&](const Projected& at) {
    pushed::move(at.x, at.y);
    shop.frames(2);
  };
  over(on);
  shop.with_control(SDLK_c);
  over(there);
  shop.with_control(SDLK_v);
  CHECK(shop.world().bodies.size() == 4);
  CHECK(hinges(shop.world()).size() == 2);
  CHECK(shop.world().constraints.size() == 2);
  shop.with_control(SDLK_z);
  CHECK(state_hash(shop.world()) == built);
  shop.with_control(SDLK_m);
  REQUIRE(shop.world().bodies.size() == 4);
  const std::vector<BodyId> bodies = shop.world().bodies.ids();
  const auto x = [&](std::size_t i) { return static_cast<double>(shop.world().motion_of(bodies[i]).x[0]); };
  CHECK(x(1) - x(0) == Approx(x(2) - x(3)));
  over(shop.seen(shop.world().motion_of(bodies[2]).x + vec(0, 0.2, 0)));
  pushed::tap(SDLK_DELETE);
  shop.frames(2);
  CHECK(state_hash(shop.world()) == built);
  over(on);
  pushed::tap(SDLK_DELETE);
  shop.frames(2);
  CHECK(shop.world().bodies.empty());
  shop.with_control(SDLK_z);
  CHECK(state_hash(shop.world()) == built);
  CHECK(shop.world().log.empty());
}

TEST_CASE("window: with shift a box is made on the grid, which is seen", "[window]") {
  Workshop shop;
  shop.take(SDLK_8, 2);
  const Projected a = shop.seen(vec(-1.02, 1.03, 0)), b = shop.seen(vec(0.97, 1.98, 0));
  pushed::move(a.x, a.y);
  shop.frames(30);
  const std::vector<unsigned char> before = picture();
  pushed::key(SDLK_LSHIFT);
  shop.frames(2);
  CHECK(changed(before, picture(), static_cast<int>(a.x), static_cast<int>(a.y), 40) > 40);
  shop.drag(a.x, a.y, b.x, b.y);
  pushed::key(SDLK_LSHIFT, false);
  shop.frames(2);
  REQUIRE(shop.world().bodies.size() == 1);
  const Vec3 at = shop.world().motion_of(shop.world().bodies.ids()[0]).x;
  CHECK(norm(at - vec(0, 1.5, 0)) < 1e-12);
}

TEST_CASE("window: what the pointer takes hold of, and where it drags it, is in the next picture", "[window]") {
  Played played(R"(
    scene.gravity = vec(0, 0, 0)
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    local ball = scene:particle { mass = 1e-3, at = vec(0, 0, 0), radius = 0.5, color = "#c33" }
  )",
                5.0, {width, height});
  pushed::move(width / 2, height / 2);
  played.frames(3);
  pushed::button(true, width / 2, height / 2);
  played.frames(1);
  REQUIRE(played.world().hands.size() == 1);
  CHECK(played.world().hands[0].grab);
  const std::vector<unsigned char> before = picture();
  const Vec3 position = played.world().hands[0].position;
  pushed::move(width / 2 + 100, height / 2 - 80);
  played.frames(1);
  const std::vector<unsigned char> after = picture();
  CHECK(norm(played.world().hands[0].position - position) > 0.1);
  CHECK(changed(before, after, width / 2 + 100, height / 2 - 80, 40) > 50);
}
