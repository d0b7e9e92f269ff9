#include "shapes/convex_parts.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/check.hpp"
#include "base/random.hpp"

using namespace pantin;

namespace {

using Loop = std::vector<Vec3>;
const Vec3 up = vec(0, 0, 1);

double area(const Loop& loop) {
  double sum = 0.0;
  for (std::size_t i = 2; i < loop.size(); i++) sum += 0.5 * dot(cross(loop[i - 1] - loop[0], loop[i] - loop[0]), up);
  return sum;
}

bool is_convex(const Loop& loop) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; i++)
    if (dot(cross(loop[(i + 1) % n] - loop[i], loop[(i + 2) % n] - loop[(i + 1) % n]), up) <= 0.0) return false;
  return true;
}

void check_parts(const Loop& outline) {
  double sum = 0.0;
  for (const Loop& part : convex_parts(outline, up)) {
    CHECK(is_convex(part));
    sum += area(part);
  }
  CHECK(sum == Approx(std::fabs(area(outline))).epsilon(1e-12));
}

}  // namespace

TEST_CASE("a convex outline is one part, from its first corner, anticlockwise") {
  const Loop square = {vec(0, 0, 0), vec(1, 0, 0), vec(1, 1, 0), vec(0, 1, 0)};
  Loop clockwise = {square[0], square[3], square[2], square[1]};
  for (const Loop& outline : {square, clockwise}) {
    const auto parts = convex_parts(outline, up);
    REQUIRE(parts.size() == 1);
    REQUIRE(parts[0].size() == 4);
    for (std::size_t i = 0; i < 4; i++) CHECK(norm(parts[0][i] - square[i]) == 0.0);
  }
}

TEST_CASE("an L is two parts, a star of five points at most five, and their areas are the outline's") {
  const Loop letter = {vec(0, 0, 0), vec(2, 0, 0), vec(2, 1, 0), vec(1, 1, 0), vec(1, 3, 0), vec(0, 3, 0)};
  CHECK(convex_parts(letter, up).size() == 2);
  check_parts(letter);
  Loop star;
  for (int i = 0; i < 10; i++) {
    const double angle = 0.6283185307179586 * i, r = i % 2 == 0 ? 1.0 : 0.4;
    star.push_back(vec(r * std::cos(angle), r * std::sin(angle), 0));
  }
  CHECK(convex_parts(star, up).size() <= 5);
  check_parts(star);
}

TEST_CASE("outlines of random radius about a point are divided without a gap") {
  for (std::uint64_t seed = 0; seed < 200; seed++) {
    Random random{seed};
    Loop outline;
    const int n = 5 + static_cast<int>(seed % 40);
    for (int i = 0; i < n; i++) {
      const double angle = 6.283185307179586 * i / n, r = 0.2 + random.uniform();
      outline.push_back(vec(r * std::cos(angle), r * std::sin(angle), 0.3));
    }
    check_parts(outline);
  }
}

TEST_CASE("corners on a straight line are left out") {
  const Loop square = {vec(0, 0, 0), vec(0.5, 0, 0), vec(1, 0, 0), vec(1, 1, 0), vec(0, 1, 0), vec(0, 0.5, 0)};
  const auto parts = convex_parts(square, up);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].size() == 4);
}

TEST_CASE("an outline that crosses itself or has no area is refused") {
  const Loop bow = {vec(0, 0, 0), vec(1, 1, 0), vec(1, 0, 0), vec(0, 1, 0)};
  CHECK_THROWS_WITH(convex_parts(bow, up), "the outline crosses itself");
  const Loop line = {vec(0, 0, 0), vec(1, 1, 0), vec(2, 2, 0), vec(0.5, 0.5, 0)};
  CHECK_THROWS_WITH(convex_parts(line, up), "the outline has no area");
}
