// What one step does to time and to simple things, and what no step length, gravity or spin may break.
#include "step/step.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "measure/measure.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

TEST_CASE("step: time is a multiple of the step, exactly") {
  World world;
  for (int i = 0; i < 1000; i++) step(world);
  CHECK(world.steps == 1000);
  CHECK(world.time == 1000 * (1.0 / 240));
  set_step(world, 0.5);
  step(world);
  CHECK(world.time == Approx(1000.0 / 240 + 0.5).epsilon(1e-15));
}

TEST_CASE("step: advance ends at the step nearest to the time") {
  World world;
  advance(world, 1.0);
  CHECK(world.steps == 240);
  advance(world, 1.0);
  CHECK(world.steps == 240);
  advance(world, 1.0 + 0.9 / 240);
  CHECK(world.steps == 241);
}

TEST_CASE("step: free particles and bodies fall on a parabola, to round-off") {
  World world;
  world.settings.step = 1.0 / 60;
  ParticleDef def;
  def.velocity = vec(3, 4, 5);
  const PointId ball = cases::point_of(world, add_particle(world, def));
  BodyDef rod;
  rod.velocity = vec(3, 4, 5);
  rod.spin = vec(0, 0, 7);
  const BodyId body = cases::add_rod_body(world, 2, 1, rod);
  const Watched course = watch(world, 2.0);
  const Vec3 fallen = vec(6, 8 - 0.5 * 9.81 * 4, 10);
  CHECK(norm(position(world, ball) - fallen) <= 1e-12);
  CHECK(norm(world.motion_of(body).x - fallen) <= 1e-12);
  CHECK(norm(angular_velocity(world.motion_of(body)) - vec(0, 0, 7)) <= 1e-12);
  CHECK(course.energy_error() <= 1e-13);
}

TEST_CASE("step: a push lasts for one step, a kick is at once") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 0.1;
  ParticleDef def;
  def.mass = 2;
  const PointId ball = cases::point_of(world, add_particle(world, def));
  push(world, ball, vec(10, 0, 0));
  step(world);
  step(world);
  CHECK(norm(velocity(world, ball) - vec(0.5, 0, 0)) <= 1e-15);
  kick(world, ball, vec(0, 4, 0));
  CHECK(norm(velocity(world, ball) - vec(0.5, 2, 0)) <= 1e-15);
  CHECK(world.work == Approx(energy(world).total()).epsilon(1e-12));
}

TEST_CASE("step: a push off the centre turns a body, and its work is counted") {
  World world;
  world.settings.gravity = zero3();
  const BodyId rod = cases::add_rod_body(world, 1, 1);
  for (int i = 0; i < 240; i++) {
    push(world, rod, vec(0, 3, 0), position(world, cases::point_of(world, rod, 1)));
    twist(world, rod, vec(0.2, 0, 0));
    step(world);
  }
  CHECK(norm(momentum(world, everything(world)) - vec(0, 3, 0)) <= 1e-12);
  CHECK(std::fabs(world.work - energy(world).total()) <= 1e-9 * world.largest_kinetic);
  CHECK(world.worst.energy <= 1e-9);
}

TEST_CASE("step: a tenth of a second is not too long") {
  World world;
  world.settings.step = 0.1;
  cases::add_chain(world);
  const double start = energy(world).total();
  double highest = start;
  const Watched course = watch(world, 20.0, [&] { highest = std::fmax(highest, energy(world).total()); });
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-9);
  CHECK(highest - start <= 1e-8 * course.kinetic);
}

// Here the projection may take more than the return gives back in one step, so energy is lost; it is never gained.
TEST_CASE("step: a tenth of a second gives a ring no energy") {
  World world;
  world.settings.step = 0.1;
  cases::add_ring(world, 24);
  const double start = energy(world).total();
  double highest = start;
  const Watched course = watch(world, 20.0, [&] { highest = std::fmax(highest, energy(world).total()); });
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-9);
  CHECK(highest - start <= 1e-9 * course.kinetic);
}

TEST_CASE("step: a hundred thousand times the earth's gravity breaks nothing") {
  World world;
  world.settings.gravity = vec(0, -1e6, 0);
  cases::add_chain(world);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-7);
}

TEST_CASE("step: a rod spun at 10,000 rad/s on its pin keeps its energy") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 1});
  set_spin(world, chain.bodies[0], vec(0, 0, 1e4));
  set_velocity(world, chain.bodies[0], vec(0, 5e3, 0));
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-7);
  CHECK(course.energy_error() <= 1e-8);
}

TEST_CASE("step: a point nailed far from its position is drawn there without a jump") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 3, .pinned = false});
  add_nail(world, chain.heads[0], vec(0, 1, 0), 0.1);
  double jump = 0.0;
  Vec3 last = position(world, chain.heads[0]);
  const Watched course = watch(world, 3.0, [&] {
    const Vec3 now = position(world, chain.heads[0]);
    jump = std::fmax(jump, norm(now - last));
    last = now;
  });
  CHECK(course.failure == "");
  CHECK(jump <= 0.05);
  CHECK(norm(last - vec(0, 1, 0)) <= 1e-9);
}

TEST_CASE("step: what is projected in the visit of its drift has the bits of what is projected in one of its own") {
  World one, two;
  keep_ledger(two);  // which looks at all between drift and projection
  for (World* world : {&one, &two}) {
    for (int i = 0; i < 3; i++) cases::add_chain(*world, {.links = 10 + i, .start = vec(0, 0, i)});
    for (int i = 0; i < 240; i++) step(*world);
  }
  CHECK(state_hash(one) == state_hash(two));
  CHECK(one.stats.projections == two.stats.projections);
  CHECK(one.error.energy == two.error.energy);
}

TEST_CASE("step: an empty world steps") {
  World world;
  step(world);
  CHECK(world.steps == 1);
  CHECK(world.failure == "");
  CHECK(energy(world).total() == 0.0);
}

TEST_CASE("step: none is made by settings that cannot be, and the world stays as it was") {
  World world;
  cases::add_chain(world, {.links = 3});
  step(world);
  const Settings good = world.settings;
  const std::uint64_t before = state_hash(world);
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const auto check = [&](const char* says) {
    CHECK_THROWS_WITH(step(world), Catch::Contains(says));
    CHECK_THROWS_WITH(advance(world, 1.0), Catch::Contains(says));
    world.settings = good;
  };
  for (const double length : {0.0, -1.0, 1e-300, infinity, not_a_number}) {
    world.settings.step = length;
    check("scene: step must be");
  }
  world.settings.gravity = vec(0, not_a_number, 0);
  check("gravity must be finite");
  world.settings.integrator = static_cast<Integrator>(99);
  check("there is no integrator 99");
  world.settings.contact = static_cast<ContactSearch>(99);
  check("there is no contact search 99");
  world.settings.accuracy = -1.0;
  check("accuracy must be > 0 1/s");
  world.settings.box = vec(1, 0, 1);
  check("box must be > 0 m");
  world.settings.tolerance = -1.0;
  check("tolerance must be > 0");
  world.settings.boltzmann = not_a_number;
  check("boltzmann must be > 0 J/K");
  CHECK_THROWS_WITH(advance(world, not_a_number), "advance: until must be finite, got NaN s");
  CHECK(world.steps == 1);
  CHECK(state_hash(world) == before);
  step(world);
  CHECK(world.steps == 2);
}

TEST_CASE("step: none is made within a step, and the next one is when that has failed") {
  const char* const says = "step: a step is under way";
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 3});
  world.behaviours = [&] { step(world); };
  CHECK_THROWS_WITH(step(world), Catch::Contains(says));
  world.behaviours = [&] { advance(world, 1.0); };
  CHECK_THROWS_WITH(step(world), Catch::Contains(says));
  world.behaviours = nullptr;
  FollowDef follow;
  follow.target = [&](double time) {
    if (time > 0.0) step(world);
    return vec(3, 0, 0);
  };
  const ConstraintId held = add_follow(world, chain.tails.back(), follow);
  CHECK_THROWS_WITH(step(world), Catch::Contains(says));
  remove(world, held);
  follow.target = [&](double) {
    step(world);
    return vec(3, 0, 0);
  };
  CHECK_THROWS_WITH(add_follow(world, chain.tails.back(), follow), Catch::Contains(says));
  CHECK(world.steps == 0);
  step(world);
  CHECK(world.steps == 1);
}
