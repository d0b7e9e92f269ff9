#include "shapes/mesh.hpp"

#include <catch2/catch.hpp>

#include "base/check.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;

namespace {

using Face = std::array<std::uint32_t, 3>;

/// A roof of two slopes along z, each of one triangle.
std::shared_ptr<const TriangleMesh> roof(double height) {
  return make_mesh({vec(-1, 0, 0), vec(1, 0, 0), vec(0, height, 0), vec(0, height, 1)},
                   std::vector<Face>{{0, 3, 2}, {1, 2, 3}});
}

std::vector<std::uint32_t> indices_in(const auto& shape, const Bounds& box) {
  std::vector<std::uint32_t> found;
  triangles_in(shape, box, [&](const MeshTriangle& triangle) { found.push_back(triangle.index); });
  return found;
}

bool meets(const MeshTriangle& triangle, const Bounds& box) {
  Bounds own;
  for (const Vec3 corner : triangle.corner) {
    own.low = corner < own.low ? corner : own.low;
    own.high = corner > own.high ? corner : own.high;
  }
  return overlap(own, box);
}

}  // namespace

TEST_CASE("mesh: triangles of a box are those of all whose bounds meet it, in rising order") {
  Random random;
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < 200; i++) {
    const Vec3 at = brute::random_vector(random, 5.0);
    for (int k = 0; k < 3; k++) vertices.push_back(at + brute::random_vector(random, 0.5));
    faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto mesh = make_mesh(vertices, faces);
  for (int i = 0; i < 40; i++) {
    const Vec3 at = brute::random_vector(random, 5.0), half = vec(1, 1, 1) * random.uniform();
    const Bounds box{at - half, at + half};
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t k = 0; k < 200; k++)
      if (meets(triangle_of(*mesh, k), box)) wanted.push_back(k);
    CHECK(indices_in(*mesh, box) == wanted);
  }
}

TEST_CASE("mesh: an edge that two triangles share is known, and whether it is a ridge") {
  for (const double height : {0.5, 0.0, -0.5}) {
    const MeshTriangle slope = triangle_of(*roof(height), 0);
    CHECK(slope.convex == std::array<bool, 3>{true, height > 0.0, true});
    CHECK(same(slope.over[1], triangle_of(*roof(height), 1).normal));
    CHECK(same(slope.over[0], slope.normal));
    CHECK(slope.normal[1] > 0.0);
  }
}

TEST_CASE("mesh: vertices at the same place count as one where edges are shared") {
  const auto mesh = make_mesh({vec(-1, 0, 0), vec(0, 0, 1), vec(0, 0, 0), vec(1, 0, 0), vec(0, 0, 0), vec(0, 0, 1)},
                              std::vector<Face>{{0, 1, 2}, {3, 4, 5}});
  CHECK(mesh->triangles[0].neighbour == std::array<std::int32_t, 3>{-1, 1, -1});
  CHECK(mesh->triangles[1].neighbour == std::array<std::int32_t, 3>{-1, 0, -1});
}

TEST_CASE("mesh: an edge of three triangles is shared by none, and all may be touched there") {
  const auto mesh = make_mesh({vec(0, 0, 0), vec(0, 0, 1), vec(1, 0, 0), vec(-1, 0, 0), vec(0, 1, 0)},
                              std::vector<Face>{{0, 1, 2}, {1, 0, 3}, {1, 0, 4}});
  for (const auto& triangle : mesh->triangles) CHECK(triangle.neighbour == std::array<std::int32_t, 3>{-1, -1, -1});
}

TEST_CASE("mesh: triangles without area are left out; nothing else is") {
  const auto mesh = make_mesh({vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(2, 0, 0)},
                              std::vector<Face>{{0, 1, 3}, {0, 1, 2}, {0, 0, 1}});
  CHECK(mesh->triangles.size() == 1);
}

TEST_CASE("mesh: indices out of range, no area at all and vertices that are not finite are refused") {
  const std::vector<Vec3> corners{vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0)};
  CHECK_THROWS_WITH(make_mesh(corners, std::vector<Face>{{0, 1, 3}}), Catch::Contains("vertex 3"));
  CHECK_THROWS_AS(make_mesh(corners, std::vector<Face>{}), Error);
  CHECK_THROWS_AS(make_mesh(corners, std::vector<Face>{{0, 1, 1}}), Error);
  CHECK_THROWS_WITH(make_mesh({vec(0, std::nan(""), 0), vec(1, 0, 0), vec(0, 1, 0)}, std::vector<Face>{{0, 1, 2}}),
                    Catch::Contains("Vertex 1"));
}

TEST_CASE("height field: its triangles face up, and share edges as a mesh of the same triangles does") {
  Random random;
  std::vector<double> heights;
  for (int i = 0; i < 20; i++) heights.push_back(random.uniform());
  const auto field = make_height_field(5, 4, 0.5, heights);
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < 24; i++) {
    for (const Vec3 corner : triangle_of(*field, i).corner) vertices.push_back(corner);
    faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto mesh = make_mesh(vertices, faces);
  for (std::uint32_t i = 0; i < 24; i++) {
    const MeshTriangle one = triangle_of(*field, i), other = triangle_of(*mesh, i);
    CHECK(one.normal[1] > 0.0);
    CHECK(one.convex == other.convex);
    for (std::size_t k = 0; k < 3; k++) CHECK(norm(one.over[k] - other.over[k]) < 1e-15);
  }
  CHECK(same(triangle_of(*field, 0).corner[0], vec(-1, heights[0], -0.75)));
  for (int i = 0; i < 40; i++) {
    const Vec3 at = brute::random_vector(random, 1.5), half = vec(1, 1, 1) * (0.5 * random.uniform());
    CHECK(indices_in(*field, {at - half, at + half}) == indices_in(*mesh, {at - half, at + half}));
  }
}

TEST_CASE("height field: wrong numbers of heights, and heights and spacings that are not finite, are refused") {
  CHECK_THROWS_AS(make_height_field(1, 4, 1.0, {0, 0, 0, 0}), Error);
  CHECK_THROWS_WITH(make_height_field(2, 2, 1.0, {0, 0, 0}), Catch::Contains("3 heights"));
  CHECK_THROWS_WITH(make_height_field(2, 2, 1.0, {0, 0, 0, std::nan("")}), Catch::Contains("Height 4"));
  CHECK_THROWS_WITH(make_height_field(2, 2, 0.0, {0, 0, 0, 0}), Catch::Contains("spacing is 0 m"));
}
