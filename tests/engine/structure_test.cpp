#include "structures/structure.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "base/check.hpp"
#include "structures/lattice.hpp"
#include "structures/polyhedra.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

double longest_edge(const Structure& s) {
  double length = 0.0;
  for (const StructureEdge& e : s.edges) length = std::fmax(length, norm(s.vertices[e[0]] - s.vertices[e[1]]));
  return length;
}
double shortest_edge(const Structure& s) {
  double length = infinity;
  for (const StructureEdge& e : s.edges) length = std::fmin(length, norm(s.vertices[e[0]] - s.vertices[e[1]]));
  return length;
}
std::map<std::size_t, int> faces_by_sides(const Structure& s) {
  std::map<std::size_t, int> count;
  for (const StructureFace& face : s.faces) count[face.size()]++;
  return count;
}
void check_counts(const Structure& s, std::size_t vertices, std::size_t edges, std::size_t faces) {
  CHECK(s.vertices.size() == vertices);
  CHECK(s.edges.size() == edges);
  CHECK(s.faces.size() == faces);
}
void check_edges(const Structure& s, double shortest, double longest) {
  CHECK(shortest_edge(s) == Approx(shortest).epsilon(1e-13));
  CHECK(longest_edge(s) == Approx(longest).epsilon(1e-13));
}
void check_moment(const MassDistribution& m, double expected) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) CHECK(m.inertia[i][j] == Approx(i == j ? expected : 0.0).epsilon(1e-13).margin(1e-13));
}
template <class Make>
std::string message(const Make& make) {
  try {
    make();
  } catch (const Error& error) { return error.what(); }
  return "";
}

const double root2 = std::sqrt(2.0), root5 = std::sqrt(5.0), golden = (1 + root5) / 2;

}  // namespace

TEST_CASE("regular polyhedra: counts, edges, closed surfaces, volumes") {
  struct Row {
    const char* name;
    Structure s;
    std::size_t vertices, edges, faces;
    double volume, moment;  // of edge 1 and mass 1
  };
  // Moments of uniform solids: Satterly, Am. J. Phys. 26 (1958) 452.
  const Row rows[] = {
      {"tetrahedron", shapes::tetrahedron(1), 4, 6, 4, 1 / (6 * root2), 1.0 / 20},
      {"cube", shapes::cube(1), 8, 12, 6, 1, 1.0 / 6},
      {"octahedron", shapes::octahedron(1), 6, 12, 8, root2 / 3, 1.0 / 10},
      {"dodecahedron", shapes::dodecahedron(1), 20, 30, 12, (15 + 7 * root5) / 4, (39 * golden + 28) / 150},
      {"icosahedron", shapes::icosahedron(1), 12, 30, 20, 5 * (3 + root5) / 12, golden * golden / 10},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    check_counts(row.s, row.vertices, row.edges, row.faces);
    check_edges(row.s, 1, 1);
    CHECK(euler_characteristic(row.s) == 2);
    CHECK(is_closed(row.s));
    CHECK(volume(row.s).value() == Approx(row.volume).epsilon(1e-13));
    check_moment(distribution(row.s, MassIn::solid, 1), row.moment);
    const Structure twice = scaled(row.s, vec(2, 2, 2)), other = dual(dual(row.s));
    CHECK(volume(twice).value() == Approx(8 * row.volume).epsilon(1e-13));
    check_counts(other, row.vertices, row.edges, row.faces);
    CHECK(volume(other).value() > 0.0);
    CHECK(volume(mirrored(row.s, vec(1, 2, 3), vec(0, 1, 0))).value() == Approx(row.volume).epsilon(1e-12));
    CHECK(volume(scaled(row.s, vec(-1, 1, 1))).value() == Approx(row.volume).epsilon(1e-12));
  }
  check_counts(dual(shapes::cube(1)), 6, 12, 8);
  check_counts(dual(shapes::icosahedron(1)), 20, 30, 12);
}

TEST_CASE("a truncated icosahedron is C60") {
  const Structure c60 = truncated(shapes::icosahedron(3), 1.0 / 3);
  check_counts(c60, 60, 90, 32);
  check_edges(c60, 1, 1);
  CHECK(faces_by_sides(c60) == std::map<std::size_t, int>{{5, 12}, {6, 20}});
  CHECK(euler_characteristic(c60) == 2);
  CHECK(volume(c60).value() == Approx((125 + 43 * root5) / 4).epsilon(1e-13));
}

TEST_CASE("shapes: counts, edges, Euler characteristic") {
  const Structure prism = shapes::prism(6, 1, 2), hexagon = shapes::polygon(6, 1), ring = shapes::ring(12, 2),
                  rod = shapes::rod(3, 6), sheet = shapes::sheet(4, 3, 0.5), ball = shapes::geodesic(2, 1);
  check_counts(prism, 12, 18, 8);
  check_edges(prism, 1, 2);
  CHECK(euler_characteristic(prism) == 2);
  CHECK(volume(prism).value() == Approx(3 * std::sqrt(3.0)).epsilon(1e-13));
  check_counts(hexagon, 6, 6, 1);
  check_edges(hexagon, 1, 1);
  CHECK(euler_characteristic(hexagon) == 1);
  CHECK(area(hexagon).value() == Approx(1.5 * std::sqrt(3.0)).epsilon(1e-13));
  CHECK(!volume(hexagon));
  check_counts(ring, 12, 12, 0);
  check_edges(ring, 4 * std::sin(std::acos(-1.0) / 12), 4 * std::sin(std::acos(-1.0) / 12));
  CHECK(euler_characteristic(ring) == 0);
  CHECK(!area(ring));
  check_counts(rod, 7, 6, 0);
  check_edges(rod, 0.5, 0.5);
  CHECK(euler_characteristic(rod) == 1);
  check_counts(sheet, 20, 31, 12);
  check_edges(sheet, 0.5, 0.5);
  CHECK(euler_characteristic(sheet) == 1);
  CHECK(area(sheet).value() == Approx(3));
  check_counts(ball, 162, 480, 320);
  CHECK(euler_characteristic(ball) == 2);
  for (Vec3 v : ball.vertices) CHECK(norm(v) == Approx(1).epsilon(1e-14));
  CHECK(shortest_edge(ball) > 0.27);
  CHECK(longest_edge(ball) < 0.33);
}

TEST_CASE("rotating squares and bow ties") {
  for (const double angle : {0.0, 0.3, std::acos(-1.0) / 4}) {
    const Structure squares = shapes::rotating_squares(4, 3, 2, angle);
    check_edges(squares, 2, 2);
    CHECK(squares.faces.size() == 12);
    CHECK(squares.vertices.size() == 12 * 4 - 17);  // 9 + 8 shared corners
    CHECK(area(squares).value() == Approx(48));
    const double width = 2 * 4 * (std::cos(angle) + std::sin(angle));
    double low = 0, high = 0;
    for (Vec3 v : squares.vertices) low = std::fmin(low, v[0]), high = std::fmax(high, v[0]);
    CHECK(high - low == Approx(width).epsilon(1e-13));
  }
  // Four squares close a ring round one hole.
  CHECK(euler_characteristic(shapes::rotating_squares(2, 2, 1, 0.3)) == 0);

  const double slant = 0.4;
  const Structure ties = shapes::reentrant(3, 4, 2, 1, slant);
  check_edges(ties, 1, 2);
  CHECK(euler_characteristic(ties) == 1);
  CHECK(faces_by_sides(ties) == std::map<std::size_t, int>{{6, static_cast<int>(ties.faces.size())}});
  const double cell = 2 * std::cos(slant) * (2 - std::sin(slant));
  CHECK(area(ties).value() == Approx(cell * static_cast<double>(ties.faces.size())).epsilon(1e-13));
  CHECK(ties.faces.size() == 3 * 4 - 2);
}

TEST_CASE("lattices: edges, neighbours, Euler characteristic") {
  const std::map<std::string, std::size_t> neighbours = {{"cubic", 6},     {"fcc", 12},   {"bcc", 8},
                                                         {"diamond", 4},   {"square", 4}, {"triangular", 6},
                                                         {"honeycomb", 3}, {"kagome", 4}};
  REQUIRE(lattice_kinds().size() == neighbours.size());
  for (const std::string& kind : lattice_kinds()) {
    INFO(kind);
    const Structure s = lattice(kind, {4, 4, 4}, 0.7);
    check_edges(s, 0.7, 0.7);
    std::vector<std::size_t> degree(s.vertices.size(), 0);
    for (const StructureEdge& e : s.edges) degree[e[0]]++, degree[e[1]]++;
    CHECK(*std::max_element(degree.begin(), degree.end()) == neighbours.at(kind));
    CHECK(*std::min_element(degree.begin(), degree.end()) >= (kind == "bcc" ? 1 : 2));
    // A flat one is a disc; one in space a graph.
    CHECK(euler_characteristic(s) ==
          (s.faces.empty() ? static_cast<std::int64_t>(s.vertices.size()) - static_cast<std::int64_t>(s.edges.size())
                           : 1));
  }
  check_counts(lattice("cubic", {2, 3, 4}, 1), 3 * 4 * 5, 2 * 4 * 5 + 3 * 3 * 5 + 3 * 4 * 4, 0);
  check_counts(lattice("fcc", {1, 1, 1}, 1), 14, 36, 0);
  check_counts(lattice("bcc", {1, 1, 1}, 1), 9, 8, 0);
  check_counts(lattice("diamond", {1, 1, 1}, 1), 10, 12, 0);  // adamantane
  CHECK(faces_by_sides(lattice("kagome", {3, 3, 1}, 1)).size() == 2);
  CHECK(faces_by_sides(lattice("honeycomb", {3, 3, 1}, 1)).begin()->first == 6);
}

TEST_CASE("moments of points, thin rods, sheets and solids") {
  const Structure cube = shapes::cube(2), rod = shapes::rod(3, 1);
  check_moment(distribution(cube, MassIn::points, 8), 16);
  // Twelve rods of mass 1/12 and length 2: about each axis 4 along it at distance root 2, 8 across.
  check_moment(distribution(cube, MassIn::edges, 12), 4 * 2 + 8 * (4.0 / 12 + 1));
  // Six plates of mass 1: two across the axis, four along it at distance 1.
  check_moment(distribution(cube, MassIn::faces, 6), 2 * (8.0 / 12) + 4 * (4.0 / 12 + 1));
  check_moment(distribution(cube, MassIn::solid, 6), 4);
  CHECK(distribution(rod, MassIn::edges, 2).inertia[1][1] == Approx(2 * 9 / 12.0).epsilon(1e-14));
  CHECK(distribution(rod, MassIn::edges, 2).inertia[0][0] == 0.0);
  // A triangle: its own moments m a²/24 in the plane, twice that across it.
  const Structure triangle = shapes::polygon(3, 2);
  const MassDistribution plate = distribution(triangle, triangle.faces[0], 3);
  CHECK(plate.inertia[0][0] == Approx(3 * 4 / 24.0).epsilon(1e-13));
  CHECK(plate.inertia[2][2] == Approx(3 * 4 / 12.0).epsilon(1e-13));
  // Far from the origin, the same.
  check_moment(distribution(moved(cube, vec(1000, -2000, 500)), MassIn::solid, 6), 4);
  CHECK_THAT(message([&] { distribution(rod, MassIn::solid, 1); }), Contains("needs a closed surface"));
  CHECK_THAT(message([&] { distribution(rod, MassIn::faces, 1); }), Contains("needs faces of some area"));
}

TEST_CASE("structures are divided, joined and chosen from") {
  const Structure cube = shapes::cube(1), fine = subdivided(cube);
  check_counts(fine, 26, 48, 24);
  check_edges(fine, 0.5, 0.5);
  CHECK(volume(fine).value() == Approx(1).epsilon(1e-14));
  check_counts(subdivided(shapes::rod(1, 1)), 3, 2, 0);

  const Structure two = joined(cube, moved(cube, vec(1, 0, 0)), 1e-9);
  check_counts(two, 12, 20, 11);
  CHECK(!volume(two));
  check_counts(joined(cube, moved(cube, vec(3, 0, 0)), 1e-9), 16, 24, 12);
  check_counts(joined(cube, cube, 0), 8, 12, 6);

  const auto above = [&](std::uint32_t v) { return cube.vertices[v][1] > 0; };
  const Selection top = selected(cube, Part::vertices, above);
  check_counts(top.structure, 4, 4, 1);
  CHECK(top.parts.size() == 4);
  check_counts(selected(cube, Part::faces, [](std::uint32_t f) { return f < 2; }).structure, 6, 7, 2);
  check_counts(selected(cube, Part::edges, [](std::uint32_t e) { return e == 5; }).structure, 2, 1, 0);
  check_counts(selected(cube, Part::vertices, [](std::uint32_t) { return false; }).structure, 0, 0, 0);
  const Structure turned = rotated(cube, {std::sqrt(0.5), 0, std::sqrt(0.5), 0});
  CHECK(volume(turned).value() == Approx(1).epsilon(1e-14));
}

TEST_CASE("bad structures are refused") {
  const std::vector<Vec3> three = {vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0)};
  CHECK_THAT(message([&] { make_structure({vec(0, std::numeric_limits<double>::quiet_NaN(), 0)}, {}, {}); }),
             Contains("vertex 1 must be finite, got (0, NaN, 0) m"));
  CHECK_THAT(message([&] { make_structure(three, {{0, 3}}, {}); }), Contains("edge 1 has a vertex 4, but there are 3"));
  CHECK_THAT(message([&] { make_structure(three, {{1, 1}}, {}); }), Contains("from vertex 2 to itself"));
  CHECK_THAT(message([&] { make_structure(three, {{0, 1}, {1, 0}}, {}); }), Contains("is there already"));
  CHECK_THAT(message([&] { make_structure(three, {}, {{0, 1}}); }), Contains("three or more"));
  CHECK_THAT(message([&] { make_structure(three, {}, {{0, 1, 0}}); }), Contains("vertex 1 twice"));
  CHECK_THAT(message([&] { shapes::cube(0); }), Contains("edge must be > 0 m, got 0"));
  CHECK_THAT(message([&] { shapes::prism(2, 1, 1); }), Contains("sides must be a whole number from 3"));
  CHECK_THAT(message([&] { lattice("cubical", {}, 1); }), Contains("unknown kind 'cubical'. Known are cubic"));
  CHECK_THAT(message([&] { lattice("fcc", {10000, 10000, 10000}, 1); }), Contains("at most 4000000 vertices"));
  CHECK_THAT(message([&] { lattice("fcc", {0, 1, 1}, 1); }), Contains("cells must be 1 or more"));
  CHECK_THAT(message([&] { scaled(shapes::cube(1), vec(1, 0, 1)); }), Contains("not 0"));
  CHECK_THAT(message([&] { truncated(shapes::cube(1), 0.5); }), Contains("< 1/2"));
  CHECK_THAT(message([&] { dual(shapes::ring(4, 1)); }), Contains("no faces"));
}
