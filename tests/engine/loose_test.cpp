// Bodies that nothing ties keep the inertia that they were given, and turn at the fourth order; those that are tied are told
// of where theirs is too small.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/lanes.hpp"
#include "edit/edit.hpp"
#include "forces/integrator.hpp"
#include "measure/measure.hpp"
#include "model/weigh.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"
#include "world/ledger.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

BodyDef spinning(Vec3 moments, Vec3 spin) {
  BodyDef def;
  def.mass = 1.0;
  def.inertia = diagonal(moments);
  def.spin = spin;
  def.name = "needle";
  return def;
}

Eigen::Vector3d eigen(Vec3 v) { return {v[0], v[1], v[2]}; }

/// Distance of its axes from those of the reference.
double axes_error(const World& world, BodyId body, const reference::State& expected) {
  const Quat q = orientation(world, body);
  const double w = expected(0), x = expected(1), y = expected(2), z = expected(3);
  const double along = q.w * w + q.x * x + q.y * y + q.z * z;
  const double sign = along < 0.0 ? -1.0 : 1.0;
  return 2.0 * std::sqrt(std::pow(q.w - sign * w, 2) + std::pow(q.x - sign * x, 2) + std::pow(q.y - sign * y, 2) +
                         std::pow(q.z - sign * z, 2));
}

struct Turned {
  double error, momentum, energy;  // momentum and energy relative
};

Turned turned(Vec3 moments, Vec3 spin, double time, double step_length, Integrator integrator = Integrator::verlet) {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = step_length;
  const BodyId body = add_body(world, spinning(moments, spin));
  set_integrator(world, integrator);
  const Vec3 start = angular_momentum(world, body);
  double momentum = 0.0;
  const Watched course =
      watch(world, time, [&] { momentum = std::fmax(momentum, norm(angular_momentum(world, body) - start)); });
  CHECK(course.failure == "");
  CHECK(course.finite);
  for (int i = 0; i < 3; i++) CHECK(world.motion_of(body).inertia[i] == Approx(moments[i]).epsilon(1e-15));
  CHECK(world.log.empty());
  const reference::State expected =
      reference::free_body(eigen(moments), eigen(spin), Eigen::Vector3d::Zero(), time, 2000);
  return {axes_error(world, body, expected), momentum / norm(start), course.energy_error()};
}

}  // namespace

TEST_CASE("loose: needles and tops turn at the fourth order about what they were given") {
  struct Case {
    Vec3 moments, spin;
    Integrator integrator;
  };
  const Case c = GENERATE(Case{vec(1, 2, 3), vec(0.3, 2, 0.1), Integrator::verlet},
                          Case{vec(1, 2, 3 - 1e-9), vec(3, 1, 2), Integrator::verlet},
                          Case{vec(1e-4, 1, 1.00005), vec(30, 0.5, 0.2), Integrator::verlet},
                          Case{vec(1e-6, 1, 1 + 3e-7), vec(30, 2, 3), Integrator::verlet},
                          Case{vec(1e-9, 1, 1 + 5e-10), vec(30, 2, 3), Integrator::verlet},
                          Case{vec(1e-4, 1, 1.00005), vec(30, 0.5, 0.2), Integrator::suzuki4});
  CAPTURE(static_cast<double>(c.moments[0]), name_of(c.integrator));
  const Turned coarse = turned(c.moments, c.spin, 2.0, 1.0 / 120, c.integrator);
  const Turned fine = turned(c.moments, c.spin, 2.0, 1.0 / 240, c.integrator);
  CHECK(std::log2(coarse.error / fine.error) == Approx(4.0).margin(0.4));
  CHECK(fine.error <= 3e-4);
  CHECK(fine.momentum <= 1e-12);
  CHECK(fine.energy <= 1e-11);
}

TEST_CASE("loose: a needle spins its second as the reference does") {
  const Turned needle = turned(vec(1e-4, 1, 1.00005), vec(30, 0.5, 0.2), 1.0, 1.0 / 480);
  CHECK(needle.error <= 3e-5);
}

TEST_CASE("loose: a spin too fast for one step keeps angular momentum, and energy") {
  struct Case {
    Vec3 moments, spin;
    bool keeps_energy;
  };
  const Case c =
      GENERATE(Case{vec(1, 2, 3), vec(1e4, 1e4, 3e3), true}, Case{vec(1e-4, 1, 1.00005), vec(1e4, 5, 2), true},
               Case{vec(1, 1, 2), vec(1e4, 20, 30), true}, Case{vec(1, 2, 3), vec(1e8, 1e7, 1e7), false});
  World world;
  world.settings.gravity = zero3();
  const BodyId body = add_body(world, spinning(c.moments, c.spin));
  const Vec3 start = angular_momentum(world, body);
  const Watched course = watch(world, 0.5);
  CHECK(course.failure == "");
  CHECK(norm(angular_momentum(world, body) - start) <= 1e-12 * norm(start));
  if (c.keeps_energy) CHECK(course.energy_error() <= 1e-11);
}

TEST_CASE("loose: a constant torque turns at the second order, and its work closes the balance") {
  const Vec3 moments = vec(0.01, 2, 2.005), spin = vec(3, 1, 0.2), torque = vec(0.05, -0.2, 0.7);
  const auto error = [&](double step_length) {
    World world;
    world.settings.step = step_length;
    world.settings.gravity = zero3();
    const BodyId body = add_body(world, spinning(moments, spin));
    const Vec3 start = angular_momentum(world, body);
    const double before = energy(world).kinetic;
    while (world.time < 1.0 - 0.5 * step_length) {
      twist(world, body, torque);
      step(world);
    }
    CHECK(norm(angular_momentum(world, body) - start - torque) <= 1e-12);
    const double work = world.ledger.given[static_cast<std::size_t>(Source::event)];
    CHECK(energy(world).kinetic - before == Approx(work).epsilon(1e-10));
    return axes_error(world, body, reference::free_body(eigen(moments), eigen(spin), eigen(torque), 1.0, 500));
  };
  const double coarse = error(1.0 / 120), fine = error(1.0 / 240);
  CHECK(fine <= 3e-4);
  CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.3));
}

TEST_CASE("loose: the accuracy that is asked for is kept by few sub-steps") {
  const Vec3 moments = vec(1e-4, 1, 1.00005), spin = vec(30, 0.5, 0.2);
  World world;
  world.settings.gravity = zero3();
  const BodyId body = add_body(world, spinning(moments, spin));
  set_accuracy(world, 1e-6);
  const Watched course = watch(world, 1.0);
  CHECK(course.failure == "");
  const double error =
      axes_error(world, body, reference::free_body(eigen(moments), eigen(spin), Eigen::Vector3d::Zero(), 1.0, 4000));
  CHECK(error <= 2e-6);
  CHECK(world.motion_of(body).sub_steps.count <= 8);
}

TEST_CASE("loose: a hinged body is lifted as far as it is needed, is told of, and gets its own inertia back") {
  World world;
  keep_ledger(world);
  PointDef end;
  end.at = vec(0.5, 0.1, 0);
  BodyDef def = spinning(vec(1e-6, 1, 1), vec(4, 1, 0.5));
  def.points = {end};
  const BodyId body = add_body(world, def);
  step(world);
  CHECK(world.motion_of(body).inertia[0] == 1e-6);
  CHECK(world.log.empty());
  const ConstraintId nail = add_nail(world, world.bodies[body].points[0]);
  const Watched tied = watch(world, world.time + 0.5);
  CHECK(tied.failure == "");
  CHECK(tied.gap <= 1e-10);
  CHECK(world.motion_of(body).inertia[0] == least_inertia);
  CHECK(lift(world, body) == Approx(least_inertia - 1e-6));
  REQUIRE(world.log.size() == 1);
  CHECK(world.log[0].kind == "warning");
  CHECK_THAT(world.log[0].text, Contains("needle") && Contains("is 1e-06 kg m²") && Contains("moves with 1e-04 kg m²"));

  remove(world, nail);
  const Vec3 before = angular_velocity(world.motion_of(body));
  const double work = world.work, kinetic = energy(world).kinetic + energy(world).potential;
  step(world);
  CHECK(world.motion_of(body).inertia[0] == 1e-6);
  CHECK(lift(world, body) == 0.0);
  CHECK(norm(angular_velocity(world.motion_of(body)) - before) <= 0.1 * norm(before));
  CHECK(energy(world).kinetic + energy(world).potential - kinetic == Approx(world.work - work).margin(1e-11));
  add_nail(world, world.bodies[body].points[0]);
  step(world);
  CHECK(world.log.size() == 1);
}

TEST_CASE("loose: one warning tells how many bodies were lifted, and what is large enough is not") {
  World world;
  PointDef end;
  end.at = vec(0.5, 0, 0);
  for (const double least : {1e-6, 1e-7, 1e-8, 1e-4, 1e-2}) {
    BodyDef def = spinning(vec(least, 1, 1), zero3());
    def.points = {end};
    add_nail(world, world.bodies[add_body(world, def)].points[0]);
  }
  step(world);
  REQUIRE(world.log.size() == 1);
  CHECK_THAT(world.log[0].text, Contains("and 2 other bodies"));
}

TEST_CASE("loose: a top that flips over keeps energy and angular momentum for 100 s, and flips when it should") {
  World world;
  const BodyId top = cases::add_top(world);
  const Vec3 start = angular_momentum(world, top);
  double drift = 0.0;
  const Watched course =
      watch(world, 100.0, [&] { drift = std::fmax(drift, norm(angular_momentum(world, top) - start)); });
  CHECK(course.failure == "");
  CHECK(drift <= 1e-12 * norm(start));
  CHECK(course.energy_error() <= 1e-11);
  const Mat3 frame = matrix(orientation(world, top));
  const Vec3 spin = transposed_times(frame, angular_velocity(world.motion_of(top)));
  const Eigen::Vector3d expected = reference::top(100.0, 1000);
  CHECK(norm(spin - vec(expected.x(), expected.y(), expected.z())) <= 1e-8);
}

TEST_CASE("loose: a top spins the same wherever it is") {
  World near_world, far_world;
  const BodyId near_top = cases::add_top(near_world);
  far_world.settings.gravity = zero3();
  const Vec3 offset = vec(0.5, -1, 2);
  BodyDef def;
  def.mass = 1.0;
  def.inertia = diagonal(vec(1, 2, 3));
  def.spin = vec(0.01, 1, 0.01);
  const BodyId far_top = add_body(far_world, def);
  set_origin(far_world, far_top, offset);
  watch(near_world, 20.0);
  watch(far_world, 20.0);
  CHECK(norm(angular_velocity(near_world.motion_of(near_top)) - angular_velocity(far_world.motion_of(far_top))) <=
        1e-12);
  CHECK(norm(far_world.motion_of(far_top).x - offset) <= 1e-12);
}
