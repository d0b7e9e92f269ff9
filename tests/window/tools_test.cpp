// Tools in hands: each by presses, moves and releases of a pointer, as a person makes them.
#include "view/tools.hpp"

#include <catch2/catch.hpp>

#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "window/workbench.hpp"

using namespace pantin;
using Catch::Contains;

TEST_CASE("a tool that is chosen again takes its next variant, and tools go round", "[view]") {
  for (const Tool& tool : tools()) CHECK(&tools()[static_cast<std::size_t>(tool.kind)] == &tool);
  ToolChoice choice{ToolKind::make, tools()[7].variants.size() - 1};
  choice.choose(ToolKind::make);
  CHECK(choice.variant == 0);
  choice.move_on(-1);
  CHECK(choice.kind == ToolKind::remove);
  choice = {ToolKind::heat, 1};
  choice.move_on(1);
  CHECK(choice.kind == ToolKind::drag);
  CHECK(choice.variant == 0);
}

TEST_CASE("a stroke cuts the hinges, nails, rods and connections that it crosses, and tells how many", "[view]") {
  Workbench bench(6);
  bench.choose(ToolKind::cut);
  const Projected a = bench.seen(bench.tail(1)), b = bench.seen(bench.tail(3));
  bench.drag({a.x - 8, a.y}, {b.x + 8, b.y});
  CHECK(hinges(bench.world).size() == 2);
  CHECK_THAT(bench.said.back(), Contains("cut 3 hinges"));
  const PointId far = bench.head(0), loose = bench.tail(5);
  add_rod(bench.world, far, position(bench.world, far) + vec(0, -1, 0));
  const Projected middle = bench.seen(position(bench.world, far) + vec(0, -0.5, 0));
  bench.drag({middle.x - 30, middle.y}, {middle.x + 30, middle.y});
  CHECK_THAT(bench.said.back(), Contains("cut 1 rod"));
  bench.click(bench.seen(far));
  CHECK_THAT(bench.said.back(), Contains("cut 1 nail"));
  CHECK(bench.world.constraints.empty());
  bench.click(bench.seen(loose));
  CHECK_THAT(bench.said.back(), Contains("nothing was cut: stroke over"));
  CHECK(bench.last_log().empty());
}

TEST_CASE("join draws the point of the press to that of the release", "[view]") {
  Workbench bench(8);
  bench.choose(ToolKind::join);
  bench.drag(bench.seen(bench.tail(7)), bench.seen(bench.tail(2)));
  const std::size_t before = hinges(bench.world).size();
  for (int i = 0; i < 2000 && bench.world.points[bench.tail(7)].particle != bench.world.points[bench.tail(2)].particle;
       i++)
    step(bench.world);
  CHECK(bench.world.points[bench.tail(7)].particle == bench.world.points[bench.tail(2)].particle);
  CHECK(hinges(bench.world).size() == before);

  Workbench two(1);
  two.choose(ToolKind::join);
  two.drag(two.seen(two.head(0)), two.seen(two.tail(0)));
  CHECK_THAT(two.last_log(), Contains("join by hand 1") && Contains("both points belong to"));
  two.drag(two.seen(two.head(0)), {5, 5});
  CHECK_THAT(two.said.back(), Contains("let go at another thing"));
  two.drag({5, 5}, two.seen(two.tail(0)));
  CHECK_THAT(two.said.back(), Contains("begin at a thing"));
}

TEST_CASE("nail holds a point, and pulls a nail out", "[view]") {
  Workbench bench;
  bench.choose(ToolKind::nail);
  bench.click(bench.seen(bench.tail(3)));
  const Vec3 there = position(bench.world, bench.tail(3));
  for (int i = 0; i < 100; i++) step(bench.world);
  CHECK(norm(position(bench.world, bench.tail(3)) - there) < 1e-9);
  bench.click(bench.seen(bench.tail(3)));
  CHECK_THAT(bench.said.back(), Contains("pulled the nail out"));
  CHECK(bench.world.constraints.ids().size() == 1);
  bench.click({5, 5});
  CHECK_THAT(bench.said.back(), Contains("there is no point"));
}

TEST_CASE("a shape is held where it is seen, by a point that goes when it is let go", "[view]") {
  Workbench bench(1);
  BodyDef def;
  def.at = vec(0.5, 2.5, 0);
  def.shapes = {small_worlds::shape(BoxShape{vec(0.5, 0.5, 0.5)})};
  const BodyId box = add_body(bench.world, def);
  const Vec3 front = def.at + vec(0.3, 0.2, 0.5);
  const Projected at = bench.seen(front);
  bench.press(at);
  bench.frame(2);
  REQUIRE(bench.world.bodies[box].points.size() == 1);
  const PointId grip = bench.world.bodies[box].points[0];
  REQUIRE(bench.world.hands[0].grab);
  CHECK(bench.world.constraints[bench.world.hands[0].grab].a == grip);
  CHECK(norm(bench.world.points[grip].position - (front - def.at)) < 0.02);
  for (int i = 0; i < 60; i++) {
    bench.move({at.x - 6.0 * i, at.y});
    bench.frame();
  }
  CHECK(position(bench.world, grip)[0] < front[0] - 0.5);
  CHECK(norm(position(bench.world, grip) - bench.world.hands[0].position) < 0.05);
  bench.release({at.x - 354.0, at.y});
  bench.frame();
  CHECK_FALSE(bench.world.hands[0].grab);
  CHECK(bench.world.bodies[box].points.empty());
  CHECK(bench.last_log().empty());
}

TEST_CASE("push, spin, nail and remove act on a shape where it is seen", "[view]") {
  Workbench bench(1);
  bench.world.settings.gravity = zero3();
  BodyDef def;
  def.at = vec(0.5, 2.5, 0);
  def.shapes = {small_worlds::shape(BallShape{0.5})};
  const BodyId ball = add_body(bench.world, def);
  const Projected middle = bench.seen(def.at), right = {middle.x + 60, middle.y};
  bench.choose(ToolKind::push);
  bench.drag(middle, right);
  CHECK(bench.world.motion_of(ball).p[0] > 0.0);
  set_velocity(bench.world, ball, zero3());
  bench.choose(ToolKind::spin);
  bench.drag(middle, right);
  CHECK(norm(bench.world.motion_of(ball).angular) > 0.0);
  set_spin(bench.world, ball, zero3());
  bench.choose(ToolKind::nail);
  bench.click(middle);
  CHECK(bench.world.bodies[ball].points.size() == 1);
  CHECK(bench.world.constraints.size() == 2);
  bench.choose(ToolKind::remove);
  bench.click({middle.x, middle.y + 30});
  CHECK_FALSE(bench.world.bodies.alive(ball));
}

TEST_CASE("push and spin act by the length of the drag", "[view]") {
  Workbench bench(1);
  remove(bench.world, bench.world.constraints.ids()[0]);
  bench.world.settings.gravity = zero3();
  const auto momentum_of = [&] { return momentum(bench.world, everything(bench.world)); };
  const Projected at = bench.seen(bench.tail(0));
  bench.choose(ToolKind::push);
  bench.drag(at, {at.x + 50, at.y});
  const Vec3 once = momentum_of();
  CHECK(dot(once, bench.camera.right()) == Approx(norm(once)));
  CHECK_THAT(bench.said.back(), Contains("pushed by"));
  const Projected now = bench.seen(bench.tail(0));
  bench.drag(now, {now.x + 100, now.y});
  CHECK(norm(momentum_of()) == Approx(3 * norm(once)).epsilon(0.02));
  bench.choose(ToolKind::spin);
  const Vec3 before = angular_momentum(bench.world, bench.rods[0]);
  const Projected here = bench.seen(bench.tail(0));
  bench.drag(here, {here.x, here.y + 60});
  CHECK(norm(angular_momentum(bench.world, bench.rods[0]) - before) > 1e-3);
  bench.drag({5, 5}, {50, 50});
  CHECK_THAT(bench.said.back(), Contains("nothing under the cursor"));
}

TEST_CASE("tools keep to the plane of a world that has one", "[view]") {
  Workbench bench(2);
  set_plane(bench.world, Plane{2});
  bench.world.settings.gravity = zero3();
  const auto in_plane = [&] {
    for (const BodyId body : bench.world.bodies.ids()) CHECK(bench.world.motion_of(body).x[2] == 0.0);
    CHECK(bench.last_log().empty());
  };
  bench.choose(ToolKind::push);
  const Projected at = bench.seen(bench.tail(1));
  bench.drag(at, {at.x + 40, at.y + 40});
  CHECK(energy(bench.world).kinetic > 0.0);
  in_plane();
  bench.choose(ToolKind::spin);
  const double before = angular_momentum(bench.world, bench.rods[1])[2];
  const Projected now = bench.seen(bench.tail(1));
  bench.drag(now, {now.x + 80, now.y});
  CHECK(angular_momentum(bench.world, bench.rods[1])[2] < before);
  in_plane();
  for (const std::size_t variant : {std::size_t{0}, std::size_t{2}}) {
    bench.choose(ToolKind::make, variant);
    bench.drag({200, 500}, {260, 540});
    in_plane();
  }
  const Projected tip = bench.seen(bench.tail(1));
  bench.choose(ToolKind::make);
  bench.drag(tip, {tip.x + 60, tip.y + 90});
  in_plane();
  CHECK(hinges(bench.world).size() == 2);
}

TEST_CASE("numbers are shown short", "[view]") {
  CHECK(short_number(0.0) == "0");
  CHECK(short_number(0.1234) == "0.123");
  CHECK(short_number(2040.4) == "2040");
  CHECK(short_number(45.67) == "45.7");
  CHECK(short_number(1.5e-12) == "1.50e-12");
}

TEST_CASE("remove takes the thing under the cursor, and wipes over more", "[view]") {
  Workbench bench;
  bench.choose(ToolKind::remove);
  const auto middle = [&](std::size_t rod) { return bench.seen(bench.world.motion_of(bench.rods[rod]).x); };
  bench.click(middle(2));
  CHECK_FALSE(bench.world.bodies.alive(bench.rods[2]));
  const Projected a = middle(0), b = middle(1);
  bench.drag(a, b);
  CHECK_FALSE(bench.world.bodies.alive(bench.rods[0]));
  CHECK_FALSE(bench.world.bodies.alive(bench.rods[1]));
  CHECK(bench.world.bodies.alive(bench.rods[3]));
  CHECK_THAT(bench.said.back(), Contains("removed 2 things"));
  bench.click({5, 5});
  CHECK_THAT(bench.said.back(), Contains("nothing under the cursor"));
}

TEST_CASE("join ties by rods, ropes and springs, from a thing to a thing or to a place", "[view]") {
  Workbench bench(1);
  add_shape(bench.world, small_worlds::shape(BoxShape{vec(50, 0.5, 50)}, vec(0, -0.5, 0)));
  bench.world.settings.gravity = zero3();
  bench.choose(ToolKind::make, 2);
  bench.drag(bench.seen(vec(-2, 1, 0)), bench.seen(vec(-1, 2, 0)));
  bench.choose(ToolKind::make, 2);
  bench.drag(bench.seen(vec(1, 1, 0)), bench.seen(vec(2, 2, 0)));
  const Projected left = bench.seen(vec(-1.5, 1.5, 0)), right = bench.seen(vec(1.5, 1.5, 0));
  const Projected above = bench.seen(vec(-1.5, 3.2, 0));
  const std::size_t before = bench.world.constraints.size();
  bench.choose(ToolKind::join, 1);
  bench.drag(left, right);
  CHECK_THAT(bench.said.back(), Contains("tied by a rod"));
  CHECK(bench.world.constraints.size() == before + 1);
  bench.choose(ToolKind::join, 2);
  bench.drag(left, above);
  CHECK(bench.world.constraints.size() == before + 2);
  bench.choose(ToolKind::join, 3);
  bench.drag(right, above);
  CHECK(bench.world.connections.size() == 1);
  bench.drag({5, 5}, right);
  CHECK_THAT(bench.said.back(), Contains("begin at a thing"));
  bench.drag(left, {left.x + 2, left.y});
  CHECK_THAT(bench.said.back(), Contains("let go at another"));
  CHECK(bench.last_log() == "");
  for (int i = 0; i < 240; i++) step(bench.world);
  CHECK(bench.world.failure.empty());
}

TEST_CASE("heat shakes what is under it and cool brings it to rest", "[view]") {
  Workbench bench;
  bench.world.settings.gravity = zero3();
  bench.choose(ToolKind::heat);
  const Projected at = bench.seen(bench.tail(3));
  bench.press(at);
  for (int i = 0; i < 30; i++) bench.frame();
  const double hot = energy(bench.world).kinetic;
  CHECK(hot > 1e-4);
  bench.release(bench.seen(bench.tail(3)));
  bench.choose(ToolKind::heat, 1);
  for (int i = 0; i < 240; i++) {
    for (const int rod : {0, 1, 2, 3}) {
      bench.press(bench.seen(bench.tail(rod)));
      bench.frame(1);
      bench.release(bench.seen(bench.tail(rod)));
    }
  }
  CHECK(energy(bench.world).kinetic < 0.2 * hot);
  CHECK(bench.world.failure.empty());
  bench.press({5, 5});
  bench.frame();
  CHECK(bench.world.input.commands.empty());
}

TEST_CASE("two fingers pull at one chain, the same gestures give the same bits, and a lost finger lets go", "[view]") {
  const auto play = [](double other) {
    Workbench bench(8);
    const Projected a = bench.seen(bench.tail(7)), b = bench.seen(bench.tail(3));
    bench.press(a, 1);
    bench.press(b, 2);
    bench.frame();
    CHECK(bench.world.hands.size() == 2);
    CHECK((bench.world.hands[0].grab && bench.world.hands[1].grab));
    for (int i = 1; i <= 60; i++) {
      bench.move({a.x - 2.0 * i, a.y - i}, 1);
      bench.move({b.x + i, b.y - 2.0 * i + other}, 2);
      bench.frame();
    }
    CHECK(bench.world.error.hinge_gap < 1e-9);
    const std::uint64_t hash = state_hash(bench.world);
    bench.gestures.pointers.erase(2);
    bench.frame();
    CHECK(bench.world.hands[0].grab);
    CHECK_FALSE(bench.world.hands[1].grab);
    return hash;
  };
  const std::uint64_t hash = play(0.0);
  CHECK(play(0.0) == hash);
  CHECK(play(0.5) != hash);
}

TEST_CASE("what a hand would do is marked, and changes nothing", "[view]") {
  Workbench bench;
  const std::uint64_t hash = state_hash(bench.world);
  const Viewport viewport{bench.world, bench.stage, bench.camera, width, height};
  for (const Tool& tool : tools()) {
    bench.choose(tool.kind);
    bench.move(bench.seen(bench.tail(1)));
    bench.move({200, 200}, 3);
    bench.frame(0);
    std::vector<Mark> marks;
    bench.person.add_marks(bench.gestures, viewport, false, marks);
    CHECK_FALSE(marks.empty());
  }
  CHECK(state_hash(bench.world) == hash);
  bench.choose(ToolKind::drag);
  bench.press(bench.seen(bench.tail(3)));
  bench.frame();
  bench.move({bench.seen(bench.tail(3)).x, 100});
  bench.frame();
  bool told = false;
  std::vector<Mark> marks;
  bench.person.add_marks(bench.gestures, viewport, false, marks);
  for (const Mark& mark : marks) told |= mark.kind == Mark::Kind::text && mark.text.find(" N of ") != mark.text.npos;
  CHECK(told);
}
