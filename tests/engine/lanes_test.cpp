#include "base/lanes.hpp"

#include <catch2/catch.hpp>

using namespace pantin;

namespace {
const Vec3 a = vec(1, -2, 3), b = vec(0.5, 4, -1), c = vec(-2, 0.25, 7);
}

TEST_CASE("the cross product is right-handed and at right angles to both") {
  CHECK(same(cross(vec(1, 0, 0), vec(0, 1, 0)), vec(0, 0, 1)));
  CHECK(same(cross(vec(0, 1, 0), vec(0, 0, 1)), vec(1, 0, 0)));
  CHECK(same(cross(a, b), vec(-2 * -1 - 3 * 4, 3 * 0.5 - 1 * -1, 1 * 4 - -2 * 0.5)));
  CHECK(dot(cross(a, b), a) == 0.0);
}

TEST_CASE("the fourth lane stays 0") {
  CHECK(cross(a, b)[3] == 0.0);
  CHECK((matrix(normalised({1, 2, 3, 4})) * a)[3] == 0.0);
  CHECK(rotate(normalised({1, 2, 3, 4}), a)[3] == 0.0);
}

TEST_CASE("hat, outer and axial are the cross product in three dresses") {
  CHECK(same(hat(a) * b, cross(a, b)));
  CHECK(same(axial(outer(a, b)), cross(a, b)));
  CHECK(same(outer(a, b) * c, a * dot(b, c)));
}

TEST_CASE("products with transposed matrices agree with transpose") {
  const Mat3 m{{a, b, c}}, n{{b, c, a}};
  CHECK(same(transposed_times(m, a), transpose(m) * a));
  const Mat3 x = times_transposed(m, n), y = m * transpose(n);
  for (int i = 0; i < 3; i++) CHECK(norm(x[i] - y[i]) < 1e-13);
}

TEST_CASE("a matrix times its inverse is 1") {
  const Mat3 m{{a, b, c}}, unit = m * inverse(m);
  for (int i = 0; i < 3; i++) CHECK(norm(unit[i] - identity33()[i]) < 1e-14);
}

TEST_CASE("a quaternion, its matrix and rotate turn alike") {
  const double s = std::sqrt(0.5);
  const Quat quarter{s, 0, 0, s};  // a quarter turn about z
  CHECK(norm(rotate(quarter, vec(1, 0, 0)) - vec(0, 1, 0)) < 1e-15);
  const Quat q = normalised({0.1, -0.7, 0.4, 0.3});
  CHECK(norm(matrix(q) * a - rotate(q, a)) < 1e-14);
  CHECK(norm(rotate(q * quarter, a) - rotate(q, rotate(quarter, a))) < 1e-14);
  CHECK(norm(rotate(conjugate(q), rotate(q, a)) - a) < 1e-14);
}

TEST_CASE("quaternion finds the rotation of a matrix, whichever component is largest") {
  for (const Quat& raw : {Quat{2, 0.1, 0.2, 0.3}, Quat{0.1, 2, 0.2, 0.3}, Quat{0.1, 0.2, 2, 0.3},
                          Quat{0.1, 0.2, 0.3, 2}, Quat{0, 1, 0, 0}, Quat{0, 0, 0, 1}}) {
    const Quat q = normalised(raw), back = quaternion(matrix(q));
    CHECK(std::fabs(q.w * back.w + q.x * back.x + q.y * back.y + q.z * back.z) == Approx(1.0).epsilon(1e-14));
  }
}

TEST_CASE("direction of zero is the fallback, and NaN is not finite") {
  CHECK(same(direction(zero3(), vec(0, 1, 0)), vec(0, 1, 0)));
  CHECK(norm(direction(a)) == Approx(1.0));
  CHECK(finite(a));
  CHECK_FALSE(finite(vec(0, std::nan(""), 0)));
  CHECK_FALSE(finite(vec(0, 0, infinity)));
}
