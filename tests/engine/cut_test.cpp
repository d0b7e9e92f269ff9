#include "shapes/cut.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <set>

#include "shapes/mass.hpp"
#include "support/balance.hpp"

using namespace pantin;
using HullPtr = std::shared_ptr<const Hull>;

namespace {

double volume(const HullPtr& hull) { return hull ? solid_mass(hull).volume : 0.0; }

HullPtr box(double x, double y, double z) { return polyhedron_of(BoxShape{vec(x, y, z) * 0.5}); }

HullPtr random_hull(BodyMaker& make) {
  std::vector<Vec3> points;
  for (int i = 0; i < 20; i++) points.push_back(make.place(1.0));
  return make_hull(points);
}

/// [m] how far a position is outside of the nearest face, below 0 within.
double outside(const Hull& hull, Vec3 at) {
  double most = -infinity;
  for (const Hull::Face& face : hull.faces) most = std::fmax(most, dot(face.normal, at) - face.offset);
  return most;
}

}  // namespace

TEST_CASE("cut: a corner cut off a box is a tetrahedron of abc/6") {
  const HullPtr whole = box(2, 2, 2),
                rest = behind(whole, direction(vec(1, 1, 1)), dot(direction(vec(1, 1, 1)), vec(1, 1, 0.4)));
  const HullPtr corner = behind(whole, -direction(vec(1, 1, 1)), -dot(direction(vec(1, 1, 1)), vec(1, 1, 0.4)));
  CHECK(volume(corner) == Approx(0.6 * 0.6 * 0.6 / 6).epsilon(1e-13));
  CHECK(corner->faces.size() == 4);
  CHECK(volume(rest) + volume(corner) == Approx(8).epsilon(1e-14));
  CHECK(rest->faces.size() == 7);
}

TEST_CASE("cut: a plane beside a hull, or flush with a face, leaves it whole") {
  const HullPtr whole = box(1, 1, 1);
  CHECK(behind(whole, vec(1, 0, 0), 0.5) == whole);
  CHECK(behind(whole, vec(1, 0, 0), 7.0) == whole);
  CHECK(behind(whole, vec(1, 0, 0), -0.5) == nullptr);
  CHECK(behind(whole, vec(1, 0, 0), -7.0) == nullptr);
}

TEST_CASE("cut: both parts of a hull have their corners on their side, the same in the plane, and its volume") {
  BodyMaker make;
  for (int i = 0; i < 200; i++) {
    const HullPtr whole = random_hull(make);
    const Vec3 normal = direction(make.place(1.0));
    const double offset = make.number(-0.4, 0.4);
    const HullPtr low = behind(whole, normal, offset), high = behind(whole, -normal, -offset);
    REQUIRE((low && high));
    CHECK(volume(low) + volume(high) == Approx(volume(whole)).epsilon(1e-13));
    std::set<std::array<double, 3>> in_low, in_high;
    const auto look = [&](const Hull& part, double side, std::set<std::array<double, 3>>& in_plane) {
      for (const Vec3 v : part.vertices) {
        const double height = side * (dot(normal, v) - offset);
        CHECK(height < 1e-12);
        if (height > -1e-12) in_plane.insert({v[0], v[1], v[2]});
      }
    };
    look(*low, 1.0, in_low);
    look(*high, -1.0, in_high);
    CHECK(in_low == in_high);
  }
}

TEST_CASE("cut: positions in a hull are in the Voronoi cell of the nearest site, and cells fill it") {
  BodyMaker make;
  for (int n : {1, 2, 7, 60}) {
    const HullPtr whole = random_hull(make);
    std::vector<Vec3> sites;
    for (int i = 0; i < n; i++) sites.push_back(make.place(0.5));
    const std::vector<HullPtr> cells = voronoi_cells(whole, sites);
    double sum = 0.0;
    for (const HullPtr& cell : cells) sum += volume(cell);
    CHECK(sum == Approx(volume(whole)).epsilon(1e-12));
    for (int k = 0; k < 500; k++) {
      const Vec3 at = make.place(1.0);
      if (outside(*whole, at) > 0.0) continue;
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < sites.size(); i++)
        if (norm(at - sites[i]) < norm(at - sites[nearest])) nearest = i;
      REQUIRE(cells[nearest]);
      CHECK(outside(*cells[nearest], at) < 1e-12);
    }
  }
}

TEST_CASE("cut: hulls of what is round have all corners on the surface and little less volume") {
  const auto least = [](const Geometry& shape, double part) {
    const HullPtr hull = polyhedron_of(shape);
    CHECK(volume(hull) < solid_mass(shape).volume);
    CHECK(volume(hull) > part * solid_mass(shape).volume);
    return hull;
  };
  const HullPtr ball = least(BallShape{1.0}, 0.97), capsule = least(CapsuleShape{1.0, 2.0}, 0.975),
                cylinder = least(CylinderShape{1.0, 2.0}, 0.997);
  for (const Vec3 v : ball->vertices) CHECK(norm(v) == Approx(1.0).epsilon(1e-15));
  for (const Vec3 v : capsule->vertices)
    CHECK(norm(v - vec(0, 0, std::clamp(v[2], -2.0, 2.0))) == Approx(1.0).epsilon(1e-15));
  for (const Vec3 v : cylinder->vertices) {
    CHECK(std::hypot(v[0], v[1]) == Approx(1.0).epsilon(1e-15));
    CHECK(std::fabs(v[2]) == 2.0);
  }
}

TEST_CASE("cut: what does not move is no polyhedron") { CHECK(polyhedron_of(HalfSpaceShape{}) == nullptr); }
