#include "base/subnormals.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

TEST_CASE("subnormals: are 0 while the guard lives, as operands and as results") {
  volatile double least = 2.3e-308, half = 0.5, subnormal = 1e-310, many = 1e20;
  {
    const SubnormalsAreZero guard;
    CHECK(least * half == 0.0);
    CHECK(subnormal * many == 0.0);
  }
  CHECK(least * half > 0.0);
  CHECK(subnormal * many > 0.0);
}

TEST_CASE("subnormals: the corrections that fade along a long chain leave none") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 1000});
  for (int i = 0; i < 5; i++) step(world);
  int found = 0;
  for (const PointId head : chain.heads) {
    const Vec3 force = world.points[head].row_force;
    for (int i = 0; i < 3; i++) found += std::fpclassify(force[i]) == FP_SUBNORMAL;
  }
  CHECK(found == 0);
}
