// Scenes in a plane: the same motion as in space where that stays in the plane, and nothing ever leaves it.
#include "model/plane.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "articulates/articulate.hpp"
#include "base/parallel.hpp"
#include "edit/constrain.hpp"
#include "measure/ledger_closure.hpp"
#include "measure/measure.hpp"
#include "model/weigh.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/hard_cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"
#include "world/ledger.hpp"

using namespace pantin;

namespace {

constexpr Plane xy{2};

/// Centre of the last link of a chain after 1 s, [m].
Vec3 chain_end(int links, double step, bool flat) {
  World world;
  world.settings.step = step;
  if (flat) set_plane(world, xy);
  const cases::Chain chain = cases::add_chain(world, {.links = links});
  advance(world, 1.0);
  CHECK(world.worst.energy <= 1e-9);
  return world.motion_of(chain.bodies.back()).x;
}

/// Largest error of the end of a chain of two against its equations of motion, [m].
double pendulum_error(double step) {
  const reference::PlaneChain plane = reference::plane_chain(2);
  const Eigen::Vector2d exact = reference::centre(plane, reference::advance(plane, 1.0, 100), 1);
  return norm(chain_end(2, step, true) - vec(exact.x(), exact.y(), 0));
}

/// Rotating squares that a corner is dragged open of, for some steps.
void drag_squares(World& world, bool flat, int threads) {
  if (flat) set_plane(world, xy);
  world.workers = std::make_unique<Workers>(threads);
  const cases::Squares squares = cases::add_squares(world, 12, 0.2);
  const Vec3 start = position(world, squares.corner), speed = squares.away * 0.24;
  add_follow(world, squares.corner, {.target = [=](double t) { return start + speed * t; }});
  for (int i = 0; i < 20; i++) step(world);
}

}  // namespace

TEST_CASE("plane: a pendulum of two rods moves by its equations of motion, with an error of second order") {
  const double coarse = pendulum_error(1.0 / 500), fine = pendulum_error(1.0 / 2000);
  CHECK(fine <= 2e-5);
  CHECK(coarse / fine == Approx(16.0).epsilon(0.1));
}

TEST_CASE("plane: a chain moves in it as it does in space") {
  const int links = GENERATE(2, 10);
  const double step = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(links, step);
  CHECK(norm(chain_end(links, step, true) - chain_end(links, step, false)) <= 1e-7);
}

TEST_CASE("plane: squares are dragged open in one iteration a step, with the same bits on two threads") {
  World space, flat, again;
  drag_squares(space, false, 1);
  drag_squares(flat, true, 1);
  drag_squares(again, true, 2);
  CHECK(state_hash(flat) == state_hash(again));
  CHECK(flat.worst.hinge_gap <= 3e-11);
  CHECK(flat.stats.newton_iterations <= space.stats.newton_iterations);
  CHECK(flat.stats.factorisations <= space.stats.factorisations);
  for (const BodyId body : flat.bodies.ids()) CHECK(flat.motion_of(body).x[2] == 0.0);
}

TEST_CASE("plane: a body in it has the moment about the normal alone") {
  const MassPoint points[] = {{vec(1, 0, 5), 1.0}, {vec(-1, 0, -3), 1.0}, {vec(0, 2, 0), 0.0}};
  const Weighed w = weigh("body", points, {}, Quat{}, vec(0, 0, 1));
  CHECK(same(w.moments, vec(0, 0, 2)));
  CHECK(same(w.centre, vec(0, 0, 1)));
  CHECK(w.freedom == Freedom::rigid);
  const MassPoint upright[] = {{vec(1, 1, 0), 1.0}, {vec(1, 1, 2), 1.0}};
  CHECK(weigh("body", upright, {}, Quat{}, vec(0, 0, 1)).freedom == Freedom::point);
}

TEST_CASE("plane: every kind of row is solved in it, and the ledger closes") {
  for (int normal = 0; normal < 3; normal++) {
    CAPTURE(normal);
    World world;
    const auto turned = [&](double x, double y) {  // the plane's own x and y
      Vec3 v = zero3();
      v[(normal + 1) % 3] = x;
      v[(normal + 2) % 3] = y;
      v[normal] = 0.7;
      return v;
    };
    set_plane(world, {normal});
    set_gravity(world, turned(0, -9.81));
    keep_ledger(world);
    BodyDef def;
    def.mass = 1.0;
    def.inertia = diagonal(vec(0.1, 0.1, 0.1));
    std::vector<BodyId> bodies;
    for (int i = 0; i < 5; i++) {
      def.at = turned(i < 4 ? i : 5, 0);
      def.points.clear();
      for (const double x : {-0.5, 0.5}) {
        PointDef p;
        p.at = turned(x, 0) - turned(0, 0);
        def.points.push_back(p);
      }
      bodies.push_back(add_body(world, def));
    }
    const auto head = [&](std::size_t i) { return cases::point_of(world, bodies[i], 0); };
    const auto tail = [&](std::size_t i) { return cases::point_of(world, bodies[i], 1); };
    add_nail(world, head(0));
    for (std::size_t i = 1; i < 4; i++) {
      const PointId pair[] = {tail(i - 1), head(i)};
      add_hinge(world, pair);
    }
    add_weld(world, bodies[1], bodies[2]);
    const Vec3 axis = world.plane.about(vec(1, 1, 1));
    LimitDef limit;
    limit.min = -1.0;
    limit.max = 1.0;
    add_limit(world, bodies[0], {}, axis, limit);
    MotorDef motor;
    motor.axis = axis;
    motor.speed = 3.0;
    motor.max_torque = 5.0;
    add_motor(world, bodies[3], bodies[2], motor);
    add_rod(world, tail(3), head(4));
    cases::add_on_plane(world, tail(4), world.plane.along(turned(2, 3)));
    StringDef string;
    string.length = 3.0;
    add_string(world, {{head(2), zero3()}, {tail(4), zero3()}}, string);
    std::vector<Vec3> before;
    for (const BodyId body : bodies) before.push_back(world.motion_of(body).x);
    for (int i = 0; i < 480; i++) {
      step(world);
      for (std::size_t k = 0; k < bodies.size(); k++) {
        const Motion& m = world.motion_of(bodies[k]);
        REQUIRE(m.x[normal] == before[k][normal]);
        REQUIRE(same(m.p, world.plane.along(m.p)));
        REQUIRE(same(m.angular, world.plane.about(m.angular)));
      }
    }
    CHECK(world.failure == "");
    CHECK(world.error.constraint <= 1e-8);
    CHECK(closure(world) <= 1e-10);
  }
}
