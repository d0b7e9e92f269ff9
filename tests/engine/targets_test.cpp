// What a new constraint finds far away it draws in critically damped (Barzel and Barr 1988): the violation follows
// (1 + t/τ) exp(-t/τ).
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>

#include "edit/constrain.hpp"
#include "edit/coupling_constraints.hpp"
#include "model/path.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr double tau = 0.2;

PointId particle_at(World& world, Vec3 at) {
  ParticleDef def;
  def.at = at;
  return cases::point_of(world, add_particle(world, def));
}

/// Steps for two seconds; `violation` of 1 at the start must follow the law to 1 %.
void check_approach(World& world, const std::function<double()>& violation) {
  world.settings.gravity = zero3();
  CHECK(violation() == Approx(1.0).epsilon(1e-9));
  while (world.time < 2.0) {
    step(world);
    const double s = world.time / tau, wanted = (1 + s) * std::exp(-s);
    REQUIRE(std::fabs(violation() - wanted) <= 0.01 * wanted + 1e-9);
  }
  CHECK(world.stats.fallback_steps == 0);
}

}  // namespace

TEST_CASE("approach: points to a nail, a position on a rod, a plane and a path") {
  const double step_length = GENERATE(1.0 / 60, 1.0 / 240);
  const int kind = GENERATE(0, 1, 2, 3);
  CAPTURE(step_length, kind);
  World world;
  world.settings.step = step_length;
  const PointId point = particle_at(world, vec(0.5, 1, 0));
  if (kind == 0) add_nail(world, point, vec(0.5, 0, 0), tau);
  if (kind == 1) {
    const ConstraintId rod = add_rod(world, point, vec(0.5, -1, 0));
    world.constraints[rod].time_constant = tau;
    set_length(world, rod, 1.0);
  }
  if (kind == 2) cases::add_on_plane(world, point, vec(0, 2, 0), vec(3, 0, 0), tau);
  if (kind == 3)
    add_on_path(world, point, std::make_shared<const Path>(std::vector<Vec3>{zero3(), vec(1, 0, 0)}, false, false),
                tau);
  check_approach(world, [&] { return position(world, point)[1]; });
}

TEST_CASE("approach: the end of a free chain to a nail") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 4, .pinned = false});
  add_nail(world, chain.tails.back(), vec(3, 0, 0), tau);
  check_approach(world, [&] { return position(world, chain.tails.back())[0] - 3; });
}

TEST_CASE("approach: a string that is too short, and distances and angles outside their limits") {
  const double step_length = GENERATE(1.0 / 60, 1.0 / 240);
  const int kind = GENERATE(0, 1, 2, 3);
  CAPTURE(step_length, kind);
  World world;
  world.settings.step = step_length;
  const PointId a = particle_at(world, zero3()), b = particle_at(world, vec(3, 0, 0));
  const auto distance = [&] { return norm(position(world, b) - position(world, a)); };
  const BodyId body = cases::add_rod_body(world, 1, 1);
  add_nail(world, cases::point_of(world, body, 0));
  const ConstraintId angle = add_limit(world, body, {}, vec(0, 0, 1), {1.0, 2.0, kind == 3 ? tau : 1.0});
  if (kind == 0) add_string(world, {{a, zero3()}, {b, zero3()}}, {2.0, tau});
  if (kind == 1) add_limit(world, a, b, {0.5, 2.0, tau});
  if (kind == 2) add_limit(world, a, b, {4.0, 6.0, tau});
  check_approach(world, [&] {
    if (kind == 3) return 1.0 - world.constraints[angle].angle;
    return std::fabs(distance() - (kind == 2 ? 4.0 : 2.0));
  });
}

TEST_CASE(
    "approach: it ends where what is left is round-off of a length, at the origin and of points without size too") {
  const int kind = GENERATE(0, 1, 2, 3);
  CAPTURE(kind);
  World world;
  world.settings.gravity = zero3();
  const PointId a = particle_at(world, zero3()), b = particle_at(world, vec(3, 0, 0));
  if (kind == 0) {
    const ConstraintId rod = add_rod(world, a, b);
    world.constraints[rod].time_constant = tau;
    set_length(world, rod, 2.0);
  }
  if (kind == 1) add_string(world, {{a, zero3()}, {b, zero3()}}, {2.0, tau});
  if (kind == 2) add_limit(world, a, b, {0.5, 2.0, tau});
  if (kind == 3) {
    PulleyDef rope;
    rope.length = 2.0;
    rope.time_constant = tau;
    add_pulley(world, a, {{}, vec(-1, 0, 0)}, b, {{}, vec(1, 0, 0)}, rope);
  }
  const Attraction& attract = world.constraints.at_slot(0).attract;
  step(world);
  REQUIRE(attract.excess > 0.5);
  advance(world, 40 * tau);
  CHECK(attract.excess == 0.0);
  CHECK(attract.excess_rate == 0.0);
}

TEST_CASE("approach: what was drawn into its range is free in it, and rests") {
  World world;
  world.settings.gravity = zero3();
  const PointId a = particle_at(world, zero3()), b = particle_at(world, vec(3, 0, 0));
  const ConstraintId limit = add_limit(world, a, b, {0.5, 2.0, tau});
  const auto distance = [&] { return norm(position(world, b) - position(world, a)); };
  while (world.time < 13 * tau) step(world);
  CHECK(distance() == Approx(2.0).epsilon(1e-3));
  CHECK(norm(velocity(world, b)) < 1e-3);
  kick(world, b, vec(-1, 0, 0));
  const double before = distance();
  while (world.time < 13 * tau + 0.5) step(world);
  CHECK(distance() == Approx(before - 0.5).epsilon(1e-3));
  CHECK(norm(world.constraints[limit].force) == 0.0);
}
