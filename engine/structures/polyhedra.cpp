#include "structures/polyhedra.hpp"

#include <cmath>

#include "base/check.hpp"
#include "base/functions.hpp"
#include "structures/flat.hpp"

namespace pantin::shapes {
namespace {

constexpr double pi = 3.14159265358979323846;
const double golden = (1.0 + std::sqrt(5.0)) / 2.0;

void require_length(const char* shape, const char* name, double value) {
  require(value > 0.0 && std::isfinite(value), shape, ": ", name, " must be > 0 m, got ", value);
}
void require_count(const char* shape, const char* name, int value, int least) {
  require(value >= least && value <= 100'000, shape, ": ", name, " must be a whole number from ", least,
          " to 100000, got ", value);
}
void require_cells(const char* shape, int columns, int rows) {
  require_count(shape, "columns", columns, 1);
  require_count(shape, "rows", rows, 1);
  require(static_cast<double>(columns) * rows <= 1e6, shape, ": at most 1000000 cells, got ", columns, " times ", rows);
}

/// The convex polyhedron round the origin whose edges are all that have the length of the shortest.
Structure convex(const char* shape, std::vector<Vec3> vertices, double shortest, double edge) {
  require_length(shape, "edge", edge);
  Structure s;
  s.vertices = std::move(vertices);
  for (Vec3& v : s.vertices) v = v * (edge / shortest);
  const auto n = static_cast<std::uint32_t>(s.vertices.size());
  for (std::uint32_t a = 0; a < n; a++)
    for (std::uint32_t b = a + 1; b < n; b++)
      if (norm(s.vertices[a] - s.vertices[b]) < 1.01 * edge) s.edges.push_back({a, b});
  s.faces = traced_faces(s, [&](std::uint32_t v) { return s.vertices[v]; });
  return s;
}

/// All changes of signs of (0, a, b), (b, 0, a) and (a, b, 0).
std::vector<Vec3> in_turn(double a, double b) {
  std::vector<Vec3> positions;
  for (const double y : {-a, a})
    for (const double z : {-b, b}) {
      positions.push_back(vec(0, y, z));
      positions.push_back(vec(z, 0, y));
      positions.push_back(vec(y, z, 0));
    }
  return positions;
}

std::vector<Vec3> cube_corners() {
  std::vector<Vec3> positions;
  for (const double z : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double x : {-1.0, 1.0}) positions.push_back(vec(x, y, z));
  return positions;
}

/// Corner i of n on a circle.
double angle_of(int i, int n) { return 2.0 * pi * i / n; }

}  // namespace

Structure tetrahedron(double edge) {
  return convex("tetrahedron", {vec(1, 1, 1), vec(1, -1, -1), vec(-1, 1, -1), vec(-1, -1, 1)}, std::sqrt(8.0), edge);
}

Structure cube(double edge) { return convex("cube", cube_corners(), 2.0, edge); }

Structure octahedron(double edge) {
  return convex("octahedron", {vec(1, 0, 0), vec(-1, 0, 0), vec(0, 1, 0), vec(0, -1, 0), vec(0, 0, 1), vec(0, 0, -1)},
                std::sqrt(2.0), edge);
}

Structure dodecahedron(double edge) {
  std::vector<Vec3> corners = cube_corners();
  const std::vector<Vec3> others = in_turn(1.0 / golden, golden);
  corners.insert(corners.end(), others.begin(), others.end());
  return convex("dodecahedron", std::move(corners), 2.0 / golden, edge);
}

Structure icosahedron(double edge) { return convex("icosahedron", in_turn(1.0, golden), 2.0, edge); }

Structure ring(int sides, double radius) {
  require_count("ring", "sides", sides, 3);
  require_length("ring", "radius", radius);
  Structure s;
  for (int i = 0; i < sides; i++) {
    const double a = angle_of(i, sides);
    s.vertices.push_back(vec(functions::cos(a), functions::sin(a), 0) * radius);
    const auto next = static_cast<std::uint32_t>((i + 1) % sides), here = static_cast<std::uint32_t>(i);
    s.edges.push_back(edge_between(here, next));
  }
  return s;
}

Structure polygon(int sides, double edge) {
  require_count("polygon", "sides", sides, 3);
  require_length("polygon", "edge", edge);
  Structure s = ring(sides, edge / (2.0 * functions::sin(pi / sides)));
  StructureFace face;
  for (std::uint32_t i = 0; i < s.vertices.size(); i++) face.push_back(i);
  s.faces.push_back(std::move(face));
  return s;
}

Structure prism(int sides, double edge, double height) {
  require_count("prism", "sides", sides, 3);
  require_length("prism", "edge", edge);
  require_length("prism", "height", height);
  const double radius = edge / (2.0 * functions::sin(pi / sides));
  const auto n = static_cast<std::uint32_t>(sides);
  std::vector<Vec3> vertices;
  StructureFace bottom, top;
  std::vector<StructureFace> faces(2);
  for (const double y : {-height / 2.0, height / 2.0})
    for (int i = 0; i < sides; i++)
      vertices.push_back(
          vec(radius * functions::sin(angle_of(i, sides)), y, radius * functions::cos(angle_of(i, sides))));
  for (std::uint32_t i = 0; i < n; i++) {
    const std::uint32_t j = (i + 1) % n;
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
    faces.push_back({i, j, n + j, n + i});
  }
  faces[0] = bottom;
  faces[1] = top;
  return make_structure(std::move(vertices), {}, std::move(faces));
}

Structure rod(double length, int pieces) {
  require_count("rod", "pieces", pieces, 1);
  require_length("rod", "length", length);
  Structure s;
  for (int i = 0; i <= pieces; i++) {
    s.vertices.push_back(vec(length * (static_cast<double>(i) / pieces - 0.5), 0, 0));
    if (i > 0) s.edges.push_back({static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i)});
  }
  return s;
}

Structure sheet(int columns, int rows, double edge) {
  require_cells("sheet", columns, rows);
  require_length("sheet", "edge", edge);
  Structure s;
  const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (columns + 1) + x); };
  for (int y = 0; y <= rows; y++)
    for (int x = 0; x <= columns; x++) {
      s.vertices.push_back(vec(x, y, 0) * edge);
      if (x < columns) s.edges.push_back({at(x, y), at(x + 1, y)});
      if (y < rows) s.edges.push_back({at(x, y), at(x, y + 1)});
      if (x < columns && y < rows) s.faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  move_to_middle(s);
  return s;
}

Structure geodesic(int divisions, double radius) {
  require(divisions >= 0 && divisions <= 8, "geodesic: divisions must be a whole number from 0 to 8, got ", divisions);
  require_length("geodesic", "radius", radius);
  Structure s = icosahedron(1.0);
  for (int i = 0; i < divisions; i++) {
    s = subdivided(s);
    for (Vec3& v : s.vertices) v = v / norm(v);
  }
  for (Vec3& v : s.vertices) v = v * (radius / norm(v));
  return s;
}

Structure rotating_squares(int columns, int rows, double edge, double angle) {
  require_cells("rotating_squares", columns, rows);
  require_length("rotating_squares", "edge", edge);
  require(angle >= 0.0 && angle <= pi / 4.0 + 1e-12, "rotating_squares: angle must be from 0 to pi/4 rad, got ", angle);
  const double c = functions::cos(angle), d = functions::sin(angle), spacing = edge * (c + d);
  Structure all;
  for (int y = 0; y < rows; y++)
    for (int x = 0; x < columns; x++) {
      const double turn = (x + y) % 2 == 0 ? 1.0 : -1.0;
      std::vector<Vec3> corners;
      for (const Vec3& corner : {vec(-1, -1, 0), vec(1, -1, 0), vec(1, 1, 0), vec(-1, 1, 0)})
        corners.push_back(vec(x * spacing, y * spacing, 0) +
                          vec(c * corner[0] - turn * d * corner[1], turn * d * corner[0] + c * corner[1], 0) *
                              (edge / 2.0));
      StructureFace face;
      const auto known = [&](int square, int corner) {
        return all.faces[static_cast<std::size_t>(square)][static_cast<std::size_t>(corner)];
      };
      const int here = y * columns + x;
      // A square turned one way meets its neighbours to the left and below at other corners than one turned the other way.
      std::array<std::optional<std::uint32_t>, 4> shared;
      const bool plus = turn > 0.0;
      if (x > 0) shared[plus ? 3 : 0] = known(here - 1, plus ? 2 : 1);
      if (y > 0) shared[plus ? 0 : 1] = known(here - columns, plus ? 3 : 2);
      for (std::size_t k = 0; k < 4; k++) {
        face.push_back(shared[k].value_or(static_cast<std::uint32_t>(all.vertices.size())));
        if (!shared[k]) all.vertices.push_back(corners[k]);
      }
      all.faces.push_back(std::move(face));
    }
  move_to_middle(all);
  return make_structure(std::move(all.vertices), {}, std::move(all.faces));
}

Structure reentrant(int columns, int rows, double rib, double edge, double angle) {
  require_cells("reentrant", columns, rows);
  require_length("reentrant", "edge", edge);
  require(angle > 0.0 && angle < pi / 2.0, "reentrant: angle must be > 0 and < pi/2 rad, got ", angle);
  const double rise = edge * functions::sin(angle), run = edge * functions::cos(angle);
  require(rib > 2.0 * rise && std::isfinite(rib), "reentrant: rib must be > 2 edge sin(angle), ", 2.0 * rise,
          " m, got ", rib);
  Structure s;
  const int width = 2 * columns + 1;
  const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * width + x); };
  for (int y = 0; y <= rows; y++)
    for (int x = 0; x < width; x++) {
      const bool up = (x + y) % 2 == 0;  // a rib goes up from here
      s.vertices.push_back(vec(x * run, y * (rib - rise) + (up ? -0.5 : 0.5) * rise, 0));
      if (x + 1 < width) s.edges.push_back({at(x, y), at(x + 1, y)});
      if (up && y < rows) s.edges.push_back({at(x, y), at(x, y + 1)});
    }
  s = without_loose_ends(s);
  move_to_middle(s);
  add_flat_faces(s);
  return s;
}

}  // namespace pantin::shapes
