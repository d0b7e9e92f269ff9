#include "shapes/widest.hpp"

#include "shapes/gjk.hpp"

namespace pantin {

namespace {

/// What rounding makes of equal gaps, of the shapes' size.
constexpr double noise = 1e-15;

const Hull& cube() {
  static const std::shared_ptr<const Hull> hull = [] {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; i++) corners.push_back(vec(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    return make_hull(corners);
  }();
  return *hull;
}

/// Faces and edges of a box or a hull; none of others. Those of a box are a cube's, drawn out along its axes.
struct Polyhedron {
  explicit Polyhedron(const Core& core) {
    if (core.kind == Core::Kind::box) hull = &cube(), scale = core.half;
    if (core.kind == Core::Kind::hull) hull = core.hull, scale = vec(1, 1, 1);
  }
  std::size_t faces() const { return hull != nullptr ? hull->faces.size() : 0; }
  std::size_t edges() const { return hull != nullptr ? hull->edges.size() : 0; }
  const Hull* hull = nullptr;
  Vec3 scale = zero3();
};

struct Arc {
  Vec3 from, to;  ///< normals of the faces at an edge, outwards
  Vec3 along;     ///< of the edge
};

/// In axes of its own.
Arc arc_of(const Polyhedron& polyhedron, std::size_t edge) {
  const auto [from, to] = polyhedron.hull->edge_faces[edge];
  const auto [begin, end] = polyhedron.hull->edges[edge];
  const std::vector<Vec3>& vertices = polyhedron.hull->vertices;
  return {polyhedron.hull->faces[from].normal, polyhedron.hull->faces[to].normal,
          (vertices[end] - vertices[begin]) * polyhedron.scale};
}

Arc turned_back(const Arc& arc, const Mat3& R) {
  return {transposed_times(R, arc.from), transposed_times(R, arc.to), transposed_times(R, arc.along)};
}

/// Whether one arc and the opposite of another meet in a point, or nearly: each crosses the other's great circle, on the
/// same side of the sphere.
bool meet(const Arc& a, const Arc& b) {
  constexpr double slack = 1e-9;
  const Vec3 of_a = cross(a.from, a.to), of_b = cross(b.from, b.to);
  const double b_from = -dot(of_a, b.from), b_to = -dot(of_a, b.to);
  const double a_from = dot(of_b, a.from), a_to = dot(of_b, a.to);
  return b_from * b_to <= slack && a_from * a_to <= slack && b_from * a_to >= -slack;
}

void offer_along(Widest& widest, const CorePair& pair, Vec3 n, double slack) {
  widest.offer(n, dot(n, pair.lowest(n).w), slack);
}

void offer_across(Widest& widest, const CorePair& pair, Vec3 u, Vec3 v, double slack) {
  const Vec3 across = cross(u, v);
  const double square = norm2(across);
  if (!(square > 1e-26 * norm2(u) * norm2(v))) return;
  const Vec3 n = across / std::sqrt(square);
  offer_along(widest, pair, n, slack);
  offer_along(widest, pair, -n, slack);
}

}  // namespace

Widest widest_of_boxes(const CorePair& pair) {
  const Vec3 a = pair.a.half, b = pair.b.half, x = pair.x;
  const auto absolute = [](Vec3 v) { return v < 0.0 ? -v : v; };
  const double slack = noise * (norm(a) + norm(b));
  const Vec3 gap_a =
      absolute(x) - a - (absolute(pair.R[0]) * b[0] + absolute(pair.R[1]) * b[1] + absolute(pair.R[2]) * b[2]);
  Widest widest;
  for (int i = 0; i < 3; i++) {
    Vec3 n = zero3();
    n[i] = x[i] > 0.0 ? -1.0 : 1.0;
    widest.offer(n, gap_a[i], slack);
  }
  for (int i = 0; i < 3; i++) {
    const double along = dot(pair.R[i], x);
    widest.offer(along > 0.0 ? -pair.R[i] : pair.R[i], std::fabs(along) - b[i] - dot(absolute(pair.R[i]), a), slack);
  }
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      Vec3 axis = zero3();
      axis[i] = 1.0;
      const Vec3 across = cross(axis, pair.R[j]);
      const double square = norm2(across);
      if (!(square > 1e-26)) continue;
      const Vec3 n = across / std::sqrt(square), on_b = absolute(transposed_times(pair.R, n));
      const double along = dot(n, x);
      widest.offer(along > 0.0 ? -n : n, std::fabs(along) - dot(absolute(n), a) - dot(on_b, b), slack);
    }
  return widest;
}

Widest widest_of_polyhedra(const CorePair& pair) {
  const Polyhedron a(pair.a), b(pair.b);
  const double slack = noise * (size_of(pair.a) + size_of(pair.b));
  Widest widest;
  for (std::size_t i = 0; i < a.faces(); i++) offer_along(widest, pair, -a.hull->faces[i].normal, slack);
  for (std::size_t i = 0; i < b.faces(); i++) offer_along(widest, pair, pair.R * b.hull->faces[i].normal, slack);
  if (pair.a.kind == Core::Kind::point || pair.b.kind == Core::Kind::point) return widest;
  const auto offer_edges = [&](const Polyhedron& polyhedron, const Mat3& R, Vec3 segment) {
    for (std::size_t i = 0; i < polyhedron.edges(); i++) {
      const Arc arc = arc_of(polyhedron, i);
      if (dot(arc.from, segment) * dot(arc.to, segment) <= 0.0)
        offer_across(widest, pair, R * arc.along, R * segment, slack);
    }
  };
  if (pair.a.kind == Core::Kind::segment) return offer_edges(b, pair.R, transposed_times(pair.R, vec(0, 0, 1))), widest;
  if (pair.b.kind == Core::Kind::segment) return offer_edges(a, identity33(), pair.R[2]), widest;
  for (std::size_t i = 0; i < a.edges(); i++) {
    const Arc of_a = turned_back(arc_of(a, i), pair.R);
    for (std::size_t j = 0; j < b.edges(); j++) {
      const Arc of_b = arc_of(b, j);
      if (meet(of_a, of_b)) offer_across(widest, pair, pair.R * of_a.along, pair.R * of_b.along, slack);
    }
  }
  return widest;
}

}  // namespace pantin
