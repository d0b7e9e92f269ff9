#include <catch2/catch.hpp>

#include "base/functions.hpp"
#include "model/model.hpp"

using namespace pantin;

namespace {

Mat3 turned(const Mat3& m, const Quat& q) {
  const Mat3 r = matrix(q);
  return times_transposed(r * m, r);
}

double largest_difference(const Mat3& a, const Mat3& b) {
  double d = 0.0;
  for (int i = 0; i < 3; i++) d = std::fmax(d, largest(a[i] - b[i]));
  return d;
}

double determinant(const Mat3& m) { return dot(cross(m[0], m[1]), m[2]); }

const Quat oblique = normalised({0.3, -0.7, 0.2, 0.5});

}  // namespace

TEST_CASE("principal axes of a turned diagonal matrix are its moments and the turn") {
  for (double scale : {1.0, 1e-40, 1e40}) {
    const Mat3 m = turned(diagonal(vec(1, 2, 5) * scale), oblique);
    const Principal p = principal_axes(m, identity33());
    for (int i = 0; i < 3; i++) {
      CHECK(p.moments[i] == Approx((i == 0 ? 1 : i == 1 ? 2 : 5) * scale).epsilon(1e-14));
      CHECK(std::fabs(dot(p.axes[i], matrix(oblique)[i])) == Approx(1.0).epsilon(1e-14));
    }
    CHECK(determinant(p.axes) == Approx(1.0).epsilon(1e-14));
    CHECK(largest_difference(turned(diagonal(p.moments), quaternion(p.axes)), m) < 1e-14 * 5 * scale);
  }
}

TEST_CASE("principal moments come in rising order") {
  const Principal p = principal_axes(diagonal(vec(3, 1, 2)), identity33());
  CHECK(same(p.moments, vec(1, 2, 3)));
  CHECK(determinant(p.axes) == Approx(1.0));
}

TEST_CASE("axes stay near to the last frame") {
  const Mat3 m = turned(diagonal(vec(1, 2, 5)), oblique);
  const Mat3 near = matrix(oblique * normalised({1.0, 0.05, -0.04, 0.03}));
  const Principal p = principal_axes(m, near);
  for (int i = 0; i < 3; i++) CHECK(dot(p.axes[i], near[i]) > 0.98);
  SECTION("also where all moments are equal and any axes would do") {
    CHECK(largest_difference(principal_axes(identity33(), near).axes, near) < 1e-15);
  }
}

TEST_CASE("a matrix of zeros has no moments and keeps the frame") {
  const Principal p = principal_axes(zero33(), matrix(oblique));
  CHECK(same(p.moments, zero3()));
  CHECK(largest_difference(p.axes, matrix(oblique)) == 0.0);
}

TEST_CASE("a tiny element off the diagonal does not overflow") {
  Mat3 m = diagonal(vec(1, 2, 3));
  m[0][1] = m[1][0] = 1e-300;
  const Principal p = principal_axes(m, identity33());
  CHECK(same(p.moments, vec(1, 2, 3)));
}
