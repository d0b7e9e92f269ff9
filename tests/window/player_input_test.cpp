#include "view/player_input.hpp"

#include <catch2/catch.hpp>

#include "step/step.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;

namespace {

constexpr int width = 1280, height = 720;

// A chain of four rods, looked at by the first camera, and one person.
struct Play {
  World world;
  std::vector<BodyId> rods = small_worlds::chain(world, 4);
  Stage stage = find_stage(world);
  Camera camera = first_camera(stage, 1280.0 / 720.0);
  std::int32_t hands = 0;
  PlayerInput person{[this] { return hands++; }};
  Gestures gestures;

  PointId tail() const { return world.bodies[rods[3]].points[1]; }
  Projected seen(Vec3 position) const { return camera.project(position, width, height).value(); }

  void event(PointerEvent::Kind kind, PointerEvent::Button button, double x, double y, PointerId id = 0) {
    Pointer& pointer = gestures.pointers[id];
    PointerEvent e;
    e.kind = kind;
    e.button = button;
    e.pointer = id;
    e.dx = x - pointer.x;
    e.dy = y - pointer.y;
    e.x = pointer.x = x;
    e.y = pointer.y = y;
    e.control = gestures.control;
    e.shift = gestures.shift;
    const bool down = kind == PointerEvent::Kind::press;
    if (kind != PointerEvent::Kind::move && button == PointerEvent::Button::left) pointer.left = down;
    if (kind != PointerEvent::Kind::move && button == PointerEvent::Button::right) pointer.right = down;
    if (kind != PointerEvent::Kind::move && button == PointerEvent::Button::middle) pointer.middle = down;
    gestures.events.push_back(e);
  }
  void move(double x, double y, PointerId id = 0) {
    event(PointerEvent::Kind::move, PointerEvent::Button::none, x, y, id);
  }
  void press(double x, double y, PointerEvent::Button button = PointerEvent::Button::left, PointerId id = 0) {
    event(PointerEvent::Kind::press, button, x, y, id);
  }
  void release(double x, double y, PointerEvent::Button button = PointerEvent::Button::left, PointerId id = 0) {
    event(PointerEvent::Kind::release, button, x, y, id);
  }
  Actions apply(bool on_panel = false) {
    const Actions a = person.apply(gestures, {world, stage, width, height, on_panel, 1.0 / 60.0, camera, world.input});
    gestures.events.clear();
    gestures.keys.clear();
    return a;
  }
};

}  // namespace

TEST_CASE("a left press grabs the point under the pointer, and dragging pulls it along the screen", "[view]") {
  Play play;
  const Projected at = play.seen(position(play.world, play.tail()));
  play.move(at.x + 4, at.y);
  play.apply();
  CHECK(play.person.highlight() == play.tail());
  play.press(at.x + 4, at.y);
  play.apply();
  REQUIRE(play.world.input.commands.size() == 1);
  CHECK(play.world.input.commands[0].kind == Command::Kind::grab);
  CHECK(play.world.input.commands[0].point == play.tail());
  CHECK(norm(play.world.input.moves.back().position - position(play.world, play.tail())) < 1e-9);
  step(play.world);
  play.move(at.x + 4 - 100, at.y - 60);
  play.apply();
  const Vec3 target = play.world.input.moves.back().position;
  const Projected moved = play.seen(target);
  CHECK(moved.x == Approx(at.x - 100));
  CHECK(moved.y == Approx(at.y - 60));
  CHECK(moved.depth == Approx(at.depth));
  for (int i = 0; i < 240; i++) step(play.world);
  CHECK(norm(position(play.world, play.tail()) - target) < 0.2);
  play.release(at.x - 96, at.y - 60);
  play.apply();
  CHECK(play.world.input.commands.back().kind == Command::Kind::release);
  step(play.world);
  CHECK_FALSE(play.world.hands[0].grab);
}

TEST_CASE("each finger is a hand of its own", "[view]") {
  Play play;
  const PointId one = play.tail(), two = play.world.bodies[play.rods[1]].points[1];
  const Projected a = play.seen(position(play.world, one)), b = play.seen(position(play.world, two));
  play.press(a.x, a.y, PointerEvent::Button::left, 1);
  play.press(b.x, b.y, PointerEvent::Button::left, 2);
  play.apply();
  REQUIRE(play.world.input.commands.size() == 2);
  CHECK(play.world.input.commands[0].hand != play.world.input.commands[1].hand);
  step(play.world);
  REQUIRE(play.world.hands.size() == 2);
  CHECK(play.world.hands[0].grab);
  CHECK(play.world.hands[1].grab);
}

TEST_CASE("x and ctrl-click cut the hinge under the pointer", "[view]") {
  Play play;
  const PointId joint = play.world.bodies[play.rods[1]].points[1];
  const ParticleId hinge = play.world.points[joint].particle;
  const Projected at = play.seen(position(play.world, joint));
  play.move(at.x, at.y);
  SECTION("x") { play.gestures.keys = {"x"}; }
  SECTION("ctrl-click") {
    play.gestures.control = true;
    play.press(at.x, at.y);
  }
  play.apply();
  step(play.world);
  CHECK_FALSE(play.world.particles.alive(hinge));
}

TEST_CASE("pressing where nothing is, or on a panel, grabs nothing", "[view]") {
  Play play;
  const Projected at = play.seen(position(play.world, play.tail()));
  play.press(8, 8);
  play.apply();
  CHECK(play.world.input.commands.empty());
  play.press(at.x, at.y);
  play.apply(true);
  CHECK(play.world.input.commands.empty());
  play.gestures.keys = {"x"};
  play.move(8, 8);
  play.apply();
  CHECK(play.world.input.commands.empty());
}

TEST_CASE("right turns, middle shifts, the wheel zooms and f frames", "[view]") {
  Play play;
  const Camera before = play.camera;
  play.press(400, 300, PointerEvent::Button::right);
  play.move(450, 320);
  play.apply();
  CHECK(play.camera.yaw != before.yaw);
  CHECK(play.camera.pitch > before.pitch);
  CHECK(same(play.camera.target, before.target));
  play.release(450, 320, PointerEvent::Button::right);
  play.press(450, 320, PointerEvent::Button::middle);
  play.move(480, 320);
  play.apply();
  CHECK_FALSE(same(play.camera.target, before.target));
  CHECK(play.camera.distance == before.distance);
  play.release(480, 320, PointerEvent::Button::middle);
  PointerEvent wheel;
  wheel.kind = PointerEvent::Kind::wheel;
  wheel.dy = 1.0;
  play.gestures.events.push_back(wheel);
  play.apply();
  CHECK(play.camera.distance < before.distance);
  play.gestures.keys = {"f"};
  play.apply();
  CHECK(norm(play.camera.target - vec(2, 4, 0)) < 1e-9);
}

TEST_CASE("f frames what plays, and pressed again also what fell far away", "[view]") {
  Play play;
  small_worlds::particle(play.world, vec(0, -1e4, 0));
  play.gestures.keys = {"f"};
  play.apply();
  CHECK(norm(play.camera.target - vec(2, 4, 0)) < 1e-9);
  const double near = play.camera.distance;
  play.gestures.keys = {"f"};
  play.apply();
  CHECK(play.camera.distance > 100.0 * near);
  play.gestures.keys = {"f"};
  play.apply();
  CHECK(play.camera.distance == Approx(near));
}

TEST_CASE("keys ask the program, and those that it has no use for reach the scene", "[view]") {
  Play play;
  play.gestures.keys = {"space", ".", "r", "s", "h", "escape", "j"};
  const Actions a = play.apply();
  CHECK((a.pause && a.step && a.restart && a.picture && a.help && a.quit));
  REQUIRE(play.world.input.commands.size() == 1);
  CHECK(play.world.input.commands[0].kind == Command::Kind::key);
  CHECK(play.world.input.commands[0].name == "j");
  const Actions none = play.apply();
  CHECK_FALSE((none.pause || none.step || none.restart || none.picture || none.help || none.quit));
}

TEST_CASE("what is held may be removed, and a world built anew forgets the hands", "[view]") {
  Play play;
  const Projected at = play.seen(position(play.world, play.tail()));
  play.press(at.x, at.y);
  play.apply();
  step(play.world);
  remove(play.world, play.rods[3]);
  play.move(at.x, at.y + 5);
  play.apply();
  step(play.world);
  CHECK(play.world.failure.empty());
  play.person.reset();
  CHECK_FALSE(play.person.highlight());
}

TEST_CASE("hands: one that an undo took away is made again where its pointer goes on") {
  Play play;
  play.move(10, 10);
  play.apply();
  play.press(20, 20, PointerEvent::Button::left, 5);
  play.apply();
  REQUIRE(play.world.input.moves.back().hand == 1);
  play.world.hands.resize(1);
  play.person.let_go(play.world, play.world.input);
  play.world.input = {};
  play.apply();
  CHECK(play.world.input.moves.size() == 1);
  play.press(20, 20, PointerEvent::Button::left, 5);
  play.apply();
  CHECK(play.world.input.moves.back().hand == 2);
}
