#include "laws/noise.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace pantin;

namespace {

// Mean of f over many numbers, one for each k.
double mean(int n, const std::function<double(std::uint64_t)>& f) {
  double total = 0.0;
  for (int k = 0; k < n; k++) total += f(static_cast<std::uint64_t>(k));
  return total / n;
}

constexpr int count = 20000;
const double error = 4.5 / std::sqrt(double(count));  // of a mean of numbers of variance 1

}  // namespace

TEST_CASE("noise is normal over each thing that it depends on") {
  const std::function<double(std::uint64_t)> over[] = {
      [](std::uint64_t k) { return normal(k, 1, 2, 3, 0); }, [](std::uint64_t k) { return normal(1, k, 2, 3, 0); },
      [](std::uint64_t k) { return normal(1, 1, k, k, 0); }, [](std::uint64_t k) { return normal(1, 1, 2, k, 0); },
      [](std::uint64_t k) { return normal(1, 1, 2, 3, static_cast<std::uint32_t>(k)); }};
  for (const auto& f : over) {
    CHECK(std::fabs(mean(count, f)) < error);
    CHECK(std::fabs(mean(count, [&](std::uint64_t k) { return f(k) * f(k) - 1.0; })) < std::sqrt(2.0) * error);
    CHECK(std::fabs(mean(count, [&](std::uint64_t k) { return std::pow(f(k), 4) - 3.0; })) < std::sqrt(96.0) * error);
    CHECK(std::fabs(mean(count, [&](std::uint64_t k) { return f(k) * f(k + 1); })) < error);
  }
}

TEST_CASE("noise of different seeds, instants, pairs and indices is independent") {
  const auto correlation = [](const std::function<double(std::uint64_t)>& other) {
    return std::fabs(mean(count, [&](std::uint64_t k) { return normal(1, k, 2, 3, 0) * other(k); }));
  };
  CHECK(correlation([](std::uint64_t k) { return normal(2, k, 2, 3, 0); }) < error);
  CHECK(correlation([](std::uint64_t k) { return normal(1, k + 1, 2, 3, 0); }) < error);
  CHECK(correlation([](std::uint64_t k) { return normal(1, k, 2, 4, 0); }) < error);
  CHECK(correlation([](std::uint64_t k) { return normal(1, k, 1, 3, 0); }) < error);
  CHECK(correlation([](std::uint64_t k) { return normal(1, k, 2, 3, 1); }) < error);
}

TEST_CASE("noise is the same whichever particle comes first, and whenever it is asked") {
  CHECK(normal(1, 2, 3, 4, 5) == normal(1, 2, 4, 3, 5));
  CHECK(normal(1, 2, 3, 4, 5) != normal(1, 2, 3, 4, 6));
}
