// A free asymmetric top that flips over: momentum, energy and the timing of its flips.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/lanes.hpp"
#include "measure/measure.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"

using namespace pantin;

TEST_CASE("top: energy and angular momentum stay for 100 s") {
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

TEST_CASE("top: it spins the same wherever it is") {
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
