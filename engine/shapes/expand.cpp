#include "shapes/expand.hpp"

#include <array>

#include "shapes/gjk.hpp"

namespace pantin {

namespace {

using Index = std::uint16_t;

constexpr std::size_t next_side(std::size_t side) { return side == 2 ? 0 : side + 1; }

/// A convex polytope of triangles inside the set of differences.
class Polytope {
 public:
  struct Face {
    Vec3 normal;                       ///< outwards, of unit length
    double offset;                     ///< [m]
    std::array<Index, 3> corner;       ///< anticlockwise from outside
    std::array<Index, 3> neighbour;    ///< over the edge from corner i to i + 1
    std::array<std::uint8_t, 3> side;  ///< of the neighbour, that edge
    bool alive;
  };

  /// False where it has no volume.
  bool begin(const std::array<Vec3, 4>& corners);
  /// False where a face would have no area, or it has no room.
  bool add(Index seen, Vec3 point);
  Index nearest() const;
  const Face& face(Index i) const { return faces_[i]; }

 private:
  struct Edge {
    Index face, from, to;
    std::uint8_t side;
  };
  static constexpr std::size_t most_points = 160, most_faces = 640, most_edges = 160;

  bool add_face(Index i, Index j, Index k);
  void bind(Index f, std::size_t side_f, Index g, std::size_t side_g);
  /// Appends the horizon as seen from a point, past one side of a face, in anticlockwise order.
  bool find_horizon(Index face, std::size_t side, Vec3 point);

  std::array<Vec3, most_points> points_;
  std::array<Face, most_faces> faces_;
  std::array<Edge, most_edges> horizon_;
  std::size_t point_count_ = 0, face_count_ = 0, horizon_count_ = 0;
};

bool Polytope::add_face(Index i, Index j, Index k) {
  if (face_count_ == most_faces) return false;
  const Vec3 p = points_[i], u = points_[j] - p, v = points_[k] - p, n = cross(u, v);
  const double square = norm2(n);
  if (!(square > 1e-24 * norm2(u) * norm2(v))) return false;
  Face& face = faces_[face_count_++];
  face.normal = n / std::sqrt(square);
  face.offset = dot(face.normal, p);
  face.corner = {i, j, k};
  face.alive = true;
  return true;
}

void Polytope::bind(Index f, std::size_t side_f, Index g, std::size_t side_g) {
  faces_[f].neighbour[side_f] = g;
  faces_[f].side[side_f] = static_cast<std::uint8_t>(side_g);
  faces_[g].neighbour[side_g] = f;
  faces_[g].side[side_g] = static_cast<std::uint8_t>(side_f);
}

bool Polytope::begin(const std::array<Vec3, 4>& corners) {
  for (const Vec3 corner : corners) points_[point_count_++] = corner;
  const double volume = dot(cross(points_[1] - points_[0], points_[2] - points_[0]), points_[3] - points_[0]);
  if (volume > 0.0) std::swap(points_[1], points_[2]);
  if (!add_face(0, 1, 2) || !add_face(0, 3, 1) || !add_face(0, 2, 3) || !add_face(1, 3, 2)) return false;
  bind(0, 0, 1, 2);
  bind(0, 1, 3, 2);
  bind(0, 2, 2, 0);
  bind(1, 0, 2, 2);
  bind(1, 1, 3, 0);
  bind(2, 1, 3, 1);
  return true;
}

bool Polytope::find_horizon(Index f, std::size_t side, Vec3 point) {
  Face& face = faces_[f];
  if (!face.alive) return true;
  if (dot(face.normal, point) <= face.offset) {
    if (horizon_count_ == most_edges) return false;
    horizon_[horizon_count_++] = {f, face.corner[next_side(side)], face.corner[side], static_cast<std::uint8_t>(side)};
    return true;
  }
  face.alive = false;
  const std::size_t left = next_side(side), right = next_side(left);
  return find_horizon(face.neighbour[left], face.side[left], point) &&
         find_horizon(face.neighbour[right], face.side[right], point);
}

bool Polytope::add(Index seen, Vec3 point) {
  if (point_count_ == most_points) return false;
  const Index w = static_cast<Index>(point_count_);
  points_[point_count_++] = point;
  faces_[seen].alive = false;
  horizon_count_ = 0;
  for (std::size_t side = 0; side < 3; side++)
    if (!find_horizon(faces_[seen].neighbour[side], faces_[seen].side[side], point)) return false;
  if (horizon_count_ < 3) return false;
  const std::size_t first = face_count_;
  for (std::size_t i = 0; i < horizon_count_; i++) {
    const Edge& edge = horizon_[i];
    if (edge.to != horizon_[i + 1 < horizon_count_ ? i + 1 : 0].from) return false;
    if (!add_face(edge.from, edge.to, w)) return false;
    bind(static_cast<Index>(face_count_ - 1), 0, edge.face, edge.side);
  }
  for (std::size_t i = first; i < face_count_; i++)
    bind(static_cast<Index>(i), 1, static_cast<Index>(i + 1 < face_count_ ? i + 1 : first), 2);
  return true;
}

Index Polytope::nearest() const {
  std::size_t best = most_faces;
  for (std::size_t i = 0; i < face_count_; i++)
    if (faces_[i].alive && (best == most_faces || faces_[i].offset < faces_[best].offset)) best = i;
  return static_cast<Index>(best);
}

/// A tetrahedron of points of the set of differences, wide across its first edge.
std::array<Vec3, 4> wide_tetrahedron(const CorePair& pair, Vec3 start) {
  const auto along = [&](Vec3 d) { return pair.lowest(d).w; };
  std::array<Vec3, 4> corners;
  corners[0] = along(start);
  corners[1] = along(-start);
  const Vec3 e = corners[1] - corners[0];
  int thin = 0;
  for (int i = 1; i < 3; i++)
    if (std::fabs(e[i]) < std::fabs(e[thin])) thin = i;
  Vec3 axis = zero3();
  axis[thin] = 1.0;
  const Vec3 u = direction(cross(e, axis)), v = direction(cross(e, u));
  double widest = -1.0;
  for (const Vec3 d : {u, -u, v, -v}) {
    const Vec3 w = along(d);
    const double width = norm2(cross(w - corners[0], e));
    if (width > widest) widest = width, corners[2] = w;
  }
  const Vec3 n = direction(cross(e, corners[2] - corners[0])), low = along(n), high = along(-n);
  corners[3] = dot(n, corners[0] - low) > dot(n, high - corners[0]) ? low : high;
  return corners;
}

}  // namespace

Expanded expand(const CorePair& pair, Vec3 start, double accepted) {
  Expanded expanded;
  Widest& widest = expanded.widest;
  expanded.settled = false;
  Polytope polytope;
  widest.offer(direction(start), dot(direction(start), pair.lowest(direction(start)).w));
  if (!polytope.begin(wide_tetrahedron(pair, direction(start)))) return expanded;
  for (;;) {
    const Index seen = polytope.nearest();
    const Polytope::Face& face = polytope.face(seen);
    const Vec3 w = pair.lowest(-face.normal).w;
    const double bound = face.offset, along = dot(face.normal, w);
    widest.offer(-face.normal, -along);
    if (-widest.gap - bound <= accepted) return expanded.settled = true, expanded;
    if (!(along > bound) || !polytope.add(seen, w)) return expanded;
  }
}

}  // namespace pantin
