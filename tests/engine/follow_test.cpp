// A hand far away pulls with its limit and never harder, whatever the step.
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "choreography/hands.hpp"
#include "laws/law.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

TEST_CASE("hand: at 50 m it pulls with its limit and no more") {
  const double limit = GENERATE(20.0, 200.0, 1e4), step_length = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 1000);
  CAPTURE(limit, step_length);
  World world;
  world.settings.step = step_length;
  const cases::Chain chain = cases::add_chain(world);
  const std::int32_t hand = add_hand(world, [](double) { return vec(50, 0, 0); });
  grab(world, hand, chain.tails.back(), limit);
  double force = 0.0, first = 0.0;
  const Watched course = watch(world, 5.0, [&] {
    const double now = norm(world.constraints[world.hands[0].grab].force);
    if (world.steps == 1) first = now;
    force = std::fmax(force, now);
  });
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(force <= limit * (1 + 1e-9));
  CHECK(first >= 0.5 * limit);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("hand: one that whips about never pulls harder than its limit") {
  const double limit = GENERATE(20.0, 200.0, 1e4), step_length = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(limit, step_length);
  World world;
  world.settings.step = step_length;
  const cases::Chain chain = cases::add_chain(world);
  const std::int32_t hand = add_hand(world);
  world.input.moves.push_back({.hand = hand, .position = vec(10, 0, 0), .pressed = true});
  step(world);
  grab(world, hand, chain.tails.back(), limit);
  double force = 0.0;
  const Watched course = watch(world, 4.0, [&] {
    force = std::fmax(force, norm(world.constraints[world.hands[0].grab].force));
    const double side = world.steps / 20 % 2 == 0 ? 50.0 : -50.0;
    world.input.moves.push_back({.hand = hand, .position = vec(side, 0.3 * side, 10), .pressed = true});
  });
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(force <= limit * (1 + 1e-9));
}

TEST_CASE("hand: what it lets go of falls freely") {
  World world;
  ParticleDef def;
  const PointId ball = cases::point_of(world, add_particle(world, def));
  const std::int32_t hand = add_hand(world, [](double) { return vec(0, 1, 0); });
  grab(world, hand, ball);
  advance(world, 5.0);
  CHECK(norm(position(world, ball) - vec(0, 1, 0)) <= 0.2);
  CHECK(norm(velocity(world, ball)) <= 1e-3);
  release(world, hand);
  CHECK_FALSE(world.hands[0].grab);
  const double speed = velocity(world, ball)[1];
  step(world);
  CHECK(velocity(world, ball)[1] == Approx(speed - 9.81 / 240).margin(1e-12));
}

TEST_CASE("hand: it moves what connections tie to what it holds, and tears them") {
  Expressions graph;
  const Expr stretch = graph.subtract(graph.square_root(graph.input({Role::distance2, 0, 0, {}})), graph.constant(0.1));
  const Expr energy = graph.scale(graph.multiply(stretch, stretch), 20.0);
  const auto spring = std::make_shared<Law>(central_potential({.name = "thread"}, graph, energy));
  World world;
  world.settings.step = 1.0 / 1000;
  std::vector<ParticleId> knots;
  for (int i = 0; i < 200; i++) {
    ParticleDef def;
    def.at = vec(0.1 * i, 0, 0);
    def.mass = 0.002;
    knots.push_back(add_particle(world, def));
    if (i == 0) continue;
    ConnectionDef tie;
    tie.ends = {{knots[knots.size() - 2]}, {knots.back()}};
    tie.max_length = 0.2;
    add_connection(world, spring, tie);
  }
  add_nail(world, cases::point_of(world, knots.front()));
  const std::int32_t hand = add_hand(world, [](double t) { return vec(19.9 + 20 * t, 0, 0); });
  grab(world, hand, cases::point_of(world, knots.back()));
  advance(world, 1.0);
  CHECK(world.breaks.size() > 0);
  CHECK(world.failure == "");
}
