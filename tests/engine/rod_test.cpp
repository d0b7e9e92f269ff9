// A rod whose length is set anew is drawn in as nails are: its violation is (1 + t/τ) exp(-t/τ) of the first, τ = 0.1 s.
#include <catch2/catch.hpp>
#include <cmath>

#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

PointId particle(World& world, Vec3 at, double mass) {
  ParticleDef def;
  def.at = at;
  def.mass = mass;
  return world.particles[add_particle(world, def)].points.front();
}

double violation(double time) { return (1 + time / 0.1) * std::exp(-time / 0.1); }

}  // namespace

TEST_CASE("rod length: two free particles part along the critically damped approach, without a push from outside") {
  World world;
  set_gravity(world, zero3());
  const PointId a = particle(world, vec(0, 0, 0), 1), b = particle(world, vec(1, 0, 0), 3);
  const ConstraintId rod = add_rod(world, a, b);
  step(world);
  set_length(world, rod, 2.0);
  const double start = world.time;
  for (int i = 0; i < 240; i++) {
    step(world);
    CHECK(norm(position(world, b) - position(world, a)) == Approx(2 - violation(world.time - start)).margin(1e-9));
    CHECK(norm(velocity(world, a) + velocity(world, b) * 3.0) < 1e-12);
  }
  CHECK(world.stats.fallback_steps == 0);
  CHECK(accuracy(world).constraint < 1e-9);
  CHECK(norm(velocity(world, b)) < 0.01);
}

TEST_CASE("rod length: a world end that is set far away draws its point after it") {
  World world;
  set_gravity(world, zero3());
  const PointId a = particle(world, vec(1, 0, 0), 1);
  const ConstraintId rod = add_rod(world, a, zero3());
  set_position(world, rod, vec(-3, 0, 0));
  advance(world, 0.5);
  CHECK(position(world, a)[0] == Approx(-2 + 3 * violation(0.5)).margin(1e-9));
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("rod length: shortening a rod that hangs counts as the work that lifts, to second order in the step") {
  const auto wrong = [](double h) {
    World world;
    set_step(world, h);
    const PointId a = particle(world, vec(0, -1, 0), 2);
    const ConstraintId rod = add_rod(world, a, zero3());
    step(world);
    set_length(world, rod, 0.5);
    advance(world, 4.0);  // in 2 s, 4e-7 J would be missing of the way that is left
    CHECK(world.stats.fallback_steps == 0);
    CHECK(position(world, a)[1] == Approx(-0.5).margin(1e-12));
    return std::fabs(world.work - 2 * 9.81 * 0.5);
  };
  const double coarse = wrong(1.0 / 240), fine = wrong(1.0 / 960);
  CAPTURE(coarse, fine);
  CHECK(coarse < 1e-5);
  CHECK(fine < coarse / 12);
}
