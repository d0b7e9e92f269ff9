// What hands make of a drag, of clicked corners and of strokes.
#include "view/making.hpp"

#include <catch2/catch.hpp>

#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "window/workbench.hpp"

using namespace pantin;
using Catch::Contains;

TEST_CASE("make makes rods that are hinged to what is under their ends, balls and polyhedra", "[view]") {
  Workbench bench;
  const Projected end = bench.seen(bench.tail(3));
  bench.choose(ToolKind::make);
  bench.drag(end, {end.x, end.y + 120});
  CHECK(hinges(bench.world).size() == 4);
  CHECK(bench.world.bodies.ids().size() == 5);
  bench.choose(ToolKind::make, 1);
  bench.drag({100, 600}, {130, 600});
  CHECK(bench.world.particles[particles(bench.world).back()].points.size() == 1);
  const std::size_t corners[] = {8, 13, 4, 6, 20, 12};
  for (std::size_t i = 0; i < 6; i++) {
    bench.choose(ToolKind::make, i + 2);
    bench.drag({200, 200}, {230, 220});
    const BodyId body = bench.world.bodies.ids().back();
    CHECK(bench.world.bodies[body].points.size() == corners[i]);
    CHECK_THAT(bench.said.back(), Contains(tools()[7].variants[i + 2]));
    remove(bench.world, body);
  }
  bench.click({300, 200});
  CHECK(bench.world.bodies.ids().size() == 6);
  CHECK(bench.last_log() == "");
}

TEST_CASE("where something touches, what is made touches: it falls on the floor and rests there", "[view]") {
  Workbench bench(1);
  add_shape(bench.world, small_worlds::shape(BoxShape{vec(50, 0.5, 50)}, vec(0, -0.5, 0)));
  const Projected corner = bench.seen(vec(-1, 1, 0)), other = bench.seen(vec(1, 2, 0));
  for (std::size_t variant = 0; variant < 8; variant++) {
    bench.choose(ToolKind::make, variant);
    bench.drag(corner, other);
    const BodyId body = bench.world.bodies.ids().back();
    REQUIRE(bench.world.bodies[body].shapes.size() == 1);
    for (int i = 0; i < 480; i++) step(bench.world);
    const Vec3 x = bench.world.motion_of(body).x;
    CHECK(x[1] > 0.0);
    CHECK(x[1] < 2.5);
    CHECK(norm(bench.world.motion_of(body).p) < 3.0 * bench.world.motion_of(body).mass);
    remove(bench.world, body);
  }
  CHECK(bench.last_log().empty());
}

TEST_CASE("a box that is dragged from corner to corner has numbers that can be read", "[view]") {
  Workbench bench(1);
  set_plane(bench.world, Plane{2});
  add_shape(bench.world, small_worlds::shape(BoxShape{vec(50, 0.5, 50)}, vec(0, -0.5, 0)));
  bench.world.settings.gravity = zero3();
  bench.choose(ToolKind::make, 2);
  bench.drag(bench.seen(vec(-1.0023, 1.004, 0)), bench.seen(vec(1.0031, 1.999, 0)));
  const BodyId body = bench.world.bodies.ids().back();
  const auto half = std::get<BoxShape>(bench.world.shapes[bench.world.bodies[body].shapes[0]].geometry).half;
  CHECK(half[0] == Approx(1.0).margin(1e-12));
  CHECK(half[1] == Approx(0.5).margin(1e-12));
  CHECK(half[2] == half[1]);
  CHECK(norm(origin(bench.world, body) - vec(0, 1.5, 0)) < 1e-12);
}

namespace {

/// A bench in a plane, with something that touches, and without weight.
struct FlatBench : Workbench {
  FlatBench() : Workbench(1) {
    set_plane(world, Plane{2});
    world.settings.gravity = zero3();
    add_shape(world, small_worlds::shape(BoxShape{vec(50, 0.5, 50)}, vec(0, -5, 0)));
  }
  std::size_t shapes_of_last() const { return world.bodies[world.bodies.ids().back()].shapes.size(); }
};

constexpr std::size_t polygon = 8, chain = 4, ball_hinge = 5;

}  // namespace

TEST_CASE("a polygon is made of corners that are clicked, the first again to close it; Esc forgets them", "[view]") {
  FlatBench bench;
  const std::size_t before = bench.world.bodies.size();
  bench.choose(ToolKind::make, polygon);
  const Vec3 letter[] = {vec(-1, 1, 0), vec(1, 1, 0), vec(1, 1.5, 0), vec(0, 1.5, 0), vec(0, 3, 0), vec(-1, 3, 0)};
  for (const Vec3 corner : letter) bench.click(bench.seen(corner));
  CHECK(bench.world.bodies.size() == before);
  CHECK(bench.person.cancel(bench.world.input));
  bench.frame(1);
  for (const Vec3 corner : letter) bench.click(bench.seen(corner));
  bench.click(bench.seen(letter[0]));
  REQUIRE(bench.world.bodies.size() == before + 1);
  CHECK(bench.shapes_of_last() == 2);
  CHECK(bench.world.motion_of(bench.world.bodies.ids().back()).mass == Approx(1000.0 * 2.5 * 0.5).epsilon(0.02));
  CHECK(bench.last_log().empty());
}

TEST_CASE("a polygon is made of a stroke about it, and one that crosses itself is refused with a word", "[view]") {
  FlatBench bench;
  bench.choose(ToolKind::make, polygon);
  const auto stroke = [&](double height) {  // 1: a circle; less: an eight
    const auto at = [&](double a) { return bench.seen(vec(std::cos(a), 2 + std::sin(height * a), 0)); };
    bench.press(at(0));
    for (double a = 0.1; a < 6.2; a += 0.1) bench.move(at(a));
    bench.release(at(6.2));
    bench.frame(1);
  };
  stroke(1.0);
  CHECK(bench.said.back() == "made a polygon");
  CHECK(bench.shapes_of_last() == 1);
  CHECK(bench.world.motion_of(bench.world.bodies.ids().back()).mass == Approx(1571.0).epsilon(0.03));
  const std::size_t made = bench.world.bodies.size();
  stroke(2.0);
  CHECK_THAT(bench.said.back(), Contains("crosses itself"));
  CHECK(bench.world.bodies.size() == made);
}

TEST_CASE("a hinge that is made in space turns about the axis to the viewer, a ball hinge freely", "[view]") {
  for (const std::size_t variant : {std::size_t{0}, ball_hinge}) {
    Workbench bench(1);
    bench.world.settings.gravity = zero3();
    add_shape(bench.world, small_worlds::shape(BoxShape{vec(50, 0.5, 50)}, vec(0, -5, 0)));
    bench.choose(ToolKind::make, 2);
    bench.drag(bench.seen(vec(-1, 2, 0)), bench.seen(vec(0, 3, 0)));
    const BodyId a = bench.world.bodies.ids().back();
    bench.drag(bench.seen(vec(1, 2, 0)), bench.seen(vec(2, 3, 0)));
    bench.choose(ToolKind::join, variant);
    bench.drag(bench.seen(vec(-0.1, 2.5, 0)), bench.seen(vec(1.1, 2.5, 0)));
    for (int i = 0; i < 960 && hinges(bench.world).empty(); i++) bench.frame(1);
    CHECK(bench.last_log() == "");
    REQUIRE(hinges(bench.world).size() == 1);
    const Particle& ring = bench.world.particles[hinges(bench.world)[0]];
    REQUIRE(ring.axes.size() == (variant == 0 ? 1 : 0));
    if (variant != 0) continue;
    const Constraint& axis = bench.world.constraints[ring.axes[0]];
    const Vec3 of_a = rotate(orientation(bench.world, a), axis.body_a == a ? axis.axis_a : axis.axis_b);
    const double turned = norm(angular_velocity(bench.world.motion_of(a))) * bench.world.settings.step;  // in that step
    CHECK(std::acos(std::fmin(1.0, std::fabs(of_a[2]))) <= turned + 1e-6);
  }
}

TEST_CASE("a chain leads out of what it is tied to, holds its ends, and touches what lies under it", "[view]") {
  FlatBench bench;
  add_shape(bench.world, small_worlds::shape(BoxShape{vec(0.2, 0.2, 0.5)}, vec(0, 1.5, 0)));
  bench.choose(ToolKind::make, 2);
  bench.drag(bench.seen(vec(-2, 2, 0)), bench.seen(vec(-1, 3, 0)));
  const BodyId box = bench.world.bodies.ids().back();
  const std::size_t before = bench.world.bodies.size();
  bench.choose(ToolKind::nail);
  bench.click(bench.seen(vec(-1.5, 2.5, 0)));
  bench.choose(ToolKind::join, chain);
  bench.drag(bench.seen(vec(-1.5, 2.5, 0)), bench.seen(vec(2.56, 2.52, 0)));
  const std::size_t links = bench.world.bodies.size() - before;
  CHECK(links > 5);
  CHECK(hinges(bench.world).size() == links);
  bench.frame(2);
  CHECK(norm(bench.world.motion_of(box).p) < 1e-3 * bench.world.motion_of(box).mass);  // nothing pushes it away
  set_gravity(bench.world, vec(0, -9.81, 0));
  double lowest = infinity;
  for (int i = 0; i < 240; i++) {
    step(bench.world);
    for (const BodyId id : bench.world.bodies.ids())
      if (id != box && std::fabs(bench.world.motion_of(id).x[0]) < 0.2)
        lowest = std::fmin(lowest, bench.world.motion_of(id).x[1]);
  }
  CHECK(lowest > 1.69);  // the block's upper face
  CHECK(bench.world.error.hinge_gap < 1e-6);
  CHECK(bench.last_log().empty());
}

TEST_CASE("a wheel is hinged to the body it is made on, and a motor turns it until a click takes that away", "[view]") {
  Workbench bench(1);
  set_plane(bench.world, Plane{2});
  bench.world.settings.gravity = zero3();
  add_shape(bench.world, small_worlds::shape(BoxShape{vec(50, 0.5, 50)}, vec(0, -5, 0)));
  bench.choose(ToolKind::make, 2);
  bench.drag(bench.seen(vec(-1, 1, 0)), bench.seen(vec(1, 2, 0)));
  const BodyId car = bench.world.bodies.ids().back();
  bench.choose(ToolKind::make, 3);
  bench.drag(bench.seen(vec(0.5, 1.2, 0)), bench.seen(vec(1, 1.2, 0)));
  const BodyId wheel = bench.world.bodies.ids().back();
  CHECK(hinges_of(bench.world, wheel).size() == 1);
  CHECK(hinges_of(bench.world, car) == hinges_of(bench.world, wheel));
  bench.choose(ToolKind::spin, 1);
  const Projected rim = bench.seen(bench.world.motion_of(wheel).x + vec(0.3, 0.1, 0));
  bench.drag(rim, {rim.x + 100, rim.y});
  CHECK_THAT(bench.said.back(), Contains("a motor turns it by"));
  CHECK(bench.world.constraints.size() == 2);
  for (int i = 0; i < 30; i++) step(bench.world);
  CHECK(angular_velocity(bench.world.motion_of(wheel))[2] < 0.0);
  bench.click(bench.seen(bench.world.motion_of(wheel).x + vec(0.3, 0.1, 0)));
  CHECK(bench.world.constraints.size() == 1);
  bench.choose(ToolKind::spin, 1);
  bench.world.log.clear();
  bench.drag(bench.seen(bench.world.motion_of(car).x + vec(-0.8, 0.3, 0)), {400, 300});
  CHECK(bench.world.constraints.size() == 2);
}
