#include "articulates/solve/sub_steps.hpp"

#include <catch2/catch.hpp>

using namespace pantin;

TEST_CASE("sub-steps: an error of second order asks for as many as it takes, and says where the most are too few") {
  const double accuracy = 1e-4;
  SubSteps n{1};
  CHECK(adapt(n, 15.9 * accuracy, accuracy));
  CHECK(n.count == 4);

  // From a count that touching asked for, which is no power of two: by as much as is left, and no further.
  n = {3};
  CHECK(adapt(n, 0.99 * (256.0 / 3.0) * (256.0 / 3.0) * accuracy, accuracy));
  CHECK(n.count == sub_step_limit);
  n = {3};
  CHECK_FALSE(adapt(n, 1.01 * (256.0 / 3.0) * (256.0 / 3.0) * accuracy, accuracy));
  CHECK(n.count == sub_step_limit);
}
