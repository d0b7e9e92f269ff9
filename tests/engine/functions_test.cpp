#include "base/functions.hpp"

#include <sleef.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "base/random.hpp"

using namespace pantin;

namespace {
const std::vector<double> numbers = {-700.5, -20.25, -3.0, -1.0, -0.3, -1e-9, 0.0, 1e-9, 0.4, 1.0, 2.5, 30.0, 699.0};

/// Within a few units in the last position of the C library, which is another implementation.
void same_as(double mine, double libm) {
  if (std::isnan(libm))
    CHECK(std::isnan(mine));
  else if (std::isinf(libm) || libm == 0.0)
    CHECK(mine == libm);
  else
    CHECK(std::fabs(mine - libm) <= 4.0 * std::numeric_limits<double>::epsilon() * std::fabs(libm));
}
}  // namespace

TEST_CASE("elementary functions agree with the C library") {
  for (double x : numbers) {
    CAPTURE(x);
    same_as(functions::sin(x), std::sin(x));
    same_as(functions::cos(x), std::cos(x));
    same_as(functions::tan(x), std::tan(x));
    same_as(functions::atan(x), std::atan(x));
    same_as(functions::exp(x), std::exp(x));
    same_as(functions::sinh(x), std::sinh(x));
    same_as(functions::cosh(x), std::cosh(x));
    same_as(functions::tanh(x), std::tanh(x));
    for (double y : numbers) same_as(functions::atan2(x, y), std::atan2(x, y));
  }
}

TEST_CASE("functions of a restricted domain agree, and are NaN outside it") {
  for (double x : {-2.0, -1.0, -0.5, 0.0, 1e-8, 0.99, 1.0, 1.5}) {
    CAPTURE(x);
    same_as(functions::asin(x), std::asin(x));
    same_as(functions::acos(x), std::acos(x));
  }
  for (double x : {-1.0, 0.0, 1e-300, 0.5, 1.0, 10.0, 1e300}) {
    CAPTURE(x);
    same_as(functions::log(x), std::log(x));
    same_as(functions::log2(x), std::log2(x));
    same_as(functions::log10(x), std::log10(x));
    for (double y : {-2.0, 0.0, 0.5, 3.0}) same_as(functions::pow(x, y), std::pow(x, y));
  }
}

TEST_CASE("bad numbers stay bad") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(functions::sin(nan)));
  CHECK(std::isnan(functions::sin(infinity)));
  CHECK(std::isnan(functions::exp(nan)));
  CHECK(functions::exp(-infinity) == 0.0);
  CHECK(functions::exp(1000.0) == infinity);
}

TEST_CASE("a power has the bits of the variant for single numbers") {
  Random random{3, 0};
  for (int i = 0; i < 20000; i++) {
    const double size = std::ldexp(0.5 + random.uniform(), static_cast<int>(120.0 * random.uniform()) - 60);
    const double x = random.uniform() < 0.3 ? -size : size, whole = std::floor(40.0 * random.uniform()) - 20.0;
    const double y = random.uniform() < 0.5 ? whole : 40.0 * random.uniform() - 20.0;
    CAPTURE(x, y);
    const double mine = functions::pow(x, y), other = Sleef_cinz_powd1_u10purec(x, y);
    REQUIRE((std::bit_cast<std::uint64_t>(mine) == std::bit_cast<std::uint64_t>(other) ||
             (std::isnan(mine) && std::isnan(other))));
  }
}
