// Two boxes: the axis of least overlap among fifteen (Gottschalk, Lin and Manocha 1996), then the incident face clipped
// against the reference face, or the point where two edges cross.
#include "contacts/manifold_parts.hpp"

namespace pantin {

namespace {

/// Parts of the size by which a face must be better than one before it, and an edge pair better than the best face.
constexpr double face_advantage = 1e-6, edge_advantage = 1e-5, edge_advantage_of_gap = 0.02;
/// Square of the sine below which two edges count as parallel.
constexpr double parallel_edges = 1e-12;
/// Part of the size within which a corner lies on the border of the reference face.
constexpr double on_border = 1e-9;
/// Part of the size within which a point is the crossing of two edges, unless the cosine of their normals is more than this.
constexpr double at_crossing = 1e-3, same_direction_of_crossing = 1.0 - 1e-4;

constexpr std::uint32_t edge_pair_id = 0x40000000u;

Vec3 absolute_lanes(Vec3 v) { return v < 0.0 ? -v : v; }
Vec3 rotate_lanes_back(Vec3 v) { return __builtin_shufflevector(v, v, 2, 0, 1, 3); }

struct BoxPair {
  const Vec3 half_a, half_b;
  const Pose &at_a, &at_b;
  double margin, turn_way, size;  ///< [m]
  Vec3 between;                   ///< from the centre of b to that of a
  Mat3 b_in_a;                    ///< axes of b in those of a
  Vec3 centre_in_a;               ///< `between` in axes of a
};

/// The axes on which the boxes are farthest apart: 0 … 5 of faces, of a then of b; 3 i + j of edges i of a and j of b.
struct BestAxes {
  double face_gap = -infinity, edge_gap = -infinity;
  int face = -1, edge = -1;
};

/// False where an axis parts the boxes by more than the margin.
bool find_face_axis(const BoxPair& pair, BestAxes& best) {
  const Mat3& m = pair.b_in_a;
  const Mat3 q = {{absolute_lanes(m[0]), absolute_lanes(m[1]), absolute_lanes(m[2])}};
  const Vec3 centre_in_b = transposed_times(m, pair.centre_in_a);
  const Vec3 gap_a = absolute_lanes(pair.centre_in_a) - pair.half_a - q * pair.half_b;
  const Vec3 gap_b = absolute_lanes(centre_in_b) - pair.half_b - transposed_times(q, pair.half_a);
  for (int axis = 0; axis < 6; axis++) {
    const double gap = axis < 3 ? gap_a[axis] : gap_b[axis - 3];
    if (gap > pair.margin) return false;
    if (best.face < 0 || gap > best.face_gap + face_advantage * pair.size) {
      best.face_gap = gap;
      best.face = axis;
    }
  }
  return true;
}

/// The same for the nine axes across edges, in lanes the three edges of a with one of b.
bool find_edge_axis(const BoxPair& pair, BestAxes& best) {
  const Mat3& m = pair.b_in_a;
  const Mat3 q = {{absolute_lanes(m[0]), absolute_lanes(m[1]), absolute_lanes(m[2])}};
  const Vec3 ha = pair.half_a, ha1 = rotate_lanes(ha), ha2 = rotate_lanes_back(ha);
  for (int j = 0; j < 3; j++) {
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const Vec3 square = m[j] * m[j];
    const Vec3 length2 = rotate_lanes(square) + rotate_lanes_back(square);
    const Vec3 apart = absolute_lanes(cross(m[j], pair.centre_in_a)) -
                       (ha1 * rotate_lanes_back(q[j]) + ha2 * rotate_lanes(q[j])) -
                       (q[j2] * pair.half_b[j1] + q[j1] * pair.half_b[j2]);
    const Vec3 gaps = apart / square_root(length2);
    for (int i = 0; i < 3; i++) {
      if (length2[i] < parallel_edges) continue;
      if (gaps[i] > pair.margin) return false;
      if (best.edge < 0 || gaps[i] > best.edge_gap + face_advantage * pair.size) {
        best.edge_gap = gaps[i];
        best.edge = 3 * i + j;
      }
    }
  }
  return true;
}

/// Of the crossing of two edges. False where their nearest points are not within them, though the boxes are apart.
bool add_edge_point(const BoxPair& pair, int edge, Manifold& manifold) {
  const int i = edge / 3, j = edge % 3;
  const Mat3 &a = pair.at_a.R, &b = pair.at_b.R;
  Vec3 normal = direction(cross(a[i], b[j]));
  if (dot(normal, pair.between) < 0.0) normal = -normal;
  Vec3 middle_a = zero3(), middle_b = zero3();
  std::uint32_t signs = 0;
  for (int k = 0; k < 3; k++) {
    if (k != i) {
      const bool up = dot(normal, a[k]) < 0.0;
      middle_a += a[k] * (up ? pair.half_a[k] : -pair.half_a[k]);
      signs |= (up ? 1u : 0u) << k;
    }
    if (k != j) {
      const bool up = dot(normal, b[k]) > 0.0;
      middle_b += b[k] * (up ? pair.half_b[k] : -pair.half_b[k]);
      signs |= (up ? 8u : 0u) << k;
    }
  }
  const Vec3 w = pair.between + middle_a - middle_b;
  const double cosine = dot(a[i], b[j]), along_a = dot(a[i], w), along_b = dot(b[j], w);
  const double scale = 1.0 / norm2(cross(a[i], b[j]));
  const double s = (cosine * along_b - along_a) * scale, t = (along_b - cosine * along_a) * scale;
  const double s_within = std::fmin(std::fmax(s, -pair.half_a[i]), pair.half_a[i]);
  const double t_within = std::fmin(std::fmax(t, -pair.half_b[j]), pair.half_b[j]);
  const double gap = dot(normal, w);
  if (gap > 0.0 && std::fmax(std::fabs(s - s_within), std::fabs(t - t_within)) > on_border * pair.size) return false;
  const auto number = static_cast<std::uint32_t>(edge);
  manifold.points[manifold.count++] = {pair.at_a.x + middle_a + a[i] * s_within, normal, gap,
                                       edge_pair_id | number << 8 | signs};
  return true;
}

/// A corner of the incident face, or what clipping made of it: x, y in the plane of the reference face, z the height over it.
/// What it is called by: its corner of the box (below 8), or the two edges it lies on; `edge` is the one that begins there:
/// one of twelve of the incident box, or 12 + a side of the reference face.
struct ClipPoint {
  double x, y, z;
  std::uint32_t name, edge;
};

std::uint32_t crossing_name(std::uint32_t edge, std::uint32_t side) {
  return 8 + (edge < side ? edge * 16 + side : side * 16 + edge);
}

struct ClipPolygon {
  std::uint32_t count = 0;
  std::array<ClipPoint, 12> points;
};

/// What lies within side (0 … 3: +x, -x, +y, -y) of the reference face; corners on the border within `near` stay as they are.
void clip_by_side(ClipPolygon& polygon, std::uint32_t side, double limit, double near) {
  std::array<double, 12> out;
  double most = -infinity;
  for (std::uint32_t i = 0; i < polygon.count; i++) {
    const double along = side < 2 ? polygon.points[i].x : polygon.points[i].y;
    out[i] = (side % 2 == 0 ? along : -along) - limit;
    most = out[i] > most ? out[i] : most;
  }
  if (most <= near) return;
  ClipPolygon rest;
  for (std::uint32_t i = 0; i < polygon.count; i++) {
    const std::uint32_t next = i + 1 < polygon.count ? i + 1 : 0;
    const ClipPoint &from = polygon.points[i], &to = polygon.points[next];
    if (out[i] <= near) rest.points[rest.count++] = from;
    if (out[i] <= near && out[next] > near && out[i] >= -near) rest.points[rest.count - 1].edge = 12 + side;
    if ((out[i] < -near && out[next] > near) || (out[i] > near && out[next] < -near)) {
      const double part = out[i] / (out[i] - out[next]);
      rest.points[rest.count++] = {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                                   from.z + part * (to.z - from.z), crossing_name(from.edge, 12 + side),
                                   out[i] > 0.0 ? from.edge : 12 + side};
    }
  }
  polygon.count = rest.count;
  std::copy_n(rest.points.begin(), rest.count, polygon.points.begin());
}

/// A face of a box: of axis f, on its positive side or the other.
struct BoxFace {
  int axis;
  bool positive;
  std::uint32_t number() const { return static_cast<std::uint32_t>(2 * axis) + (positive ? 1u : 0u); }
};

/// The face that looks most against a direction, the first of equals.
BoxFace face_against(const Mat3& axes, Vec3 normal) {
  int best = 0;
  double most = -1.0;
  for (int k = 0; k < 3; k++) {
    const double c = std::fabs(dot(axes[k], normal));
    if (c > most + face_advantage) {
      most = c;
      best = k;
    }
  }
  return {best, dot(axes[best], normal) < 0.0};
}

/// Corners of a face of the incident box over the reference face, anticlockwise or clockwise; `centre` is from the centre of
/// the reference box to that of the incident one.
ClipPolygon face_over(const Mat3& incident, Vec3 half, BoxFace face, Vec3 centre, const Mat3& reference, int f,
                      Vec3 normal, double height) {
  const int g = face.axis, u = (g + 1) % 3, v = (g + 2) % 3, p = (f + 1) % 3, q = (f + 2) % 3;
  const auto over = [&](Vec3 w) { return vec(dot(w, reference[p]), dot(w, reference[q]), dot(w, normal)); };
  const Vec3 middle = over(centre) - vec(0, 0, height) + over(incident[g]) * (face.positive ? half[g] : -half[g]);
  const Vec3 along_u = over(incident[u]) * half[u], along_v = over(incident[v]) * half[v];
  const std::uint32_t bit = 1, up = face.positive ? 1 : 0, on_u = bit << u, on_v = bit << v, base = up << g;
  const auto edges_u = static_cast<std::uint32_t>(4 * u) + 2 * up, edges_v = static_cast<std::uint32_t>(4 * v) + up;
  ClipPolygon polygon;
  polygon.count = 4;
  const auto put = [&](std::size_t i, Vec3 at, std::uint32_t corner, std::uint32_t edge) {
    polygon.points[i] = {at[0], at[1], at[2], corner, edge};
  };
  put(0, middle - along_u - along_v, base, edges_u);
  put(1, middle + along_u - along_v, base | on_u, edges_v + 2);
  put(2, middle + along_u + along_v, base | on_u | on_v, edges_u + 1);
  put(3, middle - along_u + along_v, base | on_v, edges_v);
  return polygon;
}

/// Adds the points of the incident face over the best face, but the `crossing` of an edge pair, where there is one. Beside a pair
/// that presses aslant to the face those that overlap are left out: one has to go past them.
void add_face_points(const BoxPair& pair, int axis, const ManifoldPoint* crossing, PointList& list) {
  const bool of_a = axis < 3;
  const int f = axis % 3, p = (f + 1) % 3, q = (f + 2) % 3;
  const Pose &reference = of_a ? pair.at_a : pair.at_b, &incident = of_a ? pair.at_b : pair.at_a;
  const Vec3 half = of_a ? pair.half_a : pair.half_b, incident_half = of_a ? pair.half_b : pair.half_a;
  const Vec3 centre = of_a ? -pair.between : pair.between;
  const BoxFace face = {f, dot(centre, reference.R[f]) > 0.0};
  const Vec3 outwards = face.positive ? reference.R[f] : -reference.R[f];
  const BoxFace other = face_against(incident.R, outwards);

  ClipPolygon polygon = face_over(incident.R, incident_half, other, centre, reference.R, f, outwards, half[f]);
  const double near = on_border * pair.size;
  for (std::uint32_t side = 0; side < 4; side++) clip_by_side(polygon, side, half[side < 2 ? p : q], near);

  const Vec3 normal = of_a ? -outwards : outwards;
  const double like = crossing ? dot(normal, crossing->normal) : 1.0;
  const std::uint32_t faces = ((of_a ? 0u : 6u) + face.number()) << 16;
  for (std::uint32_t i = 0; i < polygon.count; i++) {
    const ClipPoint& c = polygon.points[i];
    if (c.z > pair.margin || (like < like_the_face && c.z < 0.0)) continue;
    const Vec3 on_reference = reference.x + (outwards * half[f] + reference.R[p] * c.x + reference.R[q] * c.y);
    const Vec3 on_a = of_a ? on_reference : on_reference + outwards * c.z;
    if (like < same_direction_of_crossing && norm(on_a - crossing->on_a) < at_crossing * pair.size) continue;
    const bool own_corner = c.name >= crossing_name(12, 12);
    list.add({on_a, normal, c.z, faces | (own_corner ? other.number() << 12 : 0u) | c.name});
  }
}

}  // namespace

void box_on_box(const BoxShape& a, const Pose& at_a, const BoxShape& b, const Pose& at_b, Ahead ahead,
                SeparationCache& cache, Manifold& manifold) {
  manifold.count = 0;
  BoxPair pair = {
      a.half,          b.half, at_a, at_b, ahead.margin, ahead.turn_way, std::fmin(largest(a.half), largest(b.half)),
      at_a.x - at_b.x, {},     {}};
  pair.centre_in_a = transposed_times(at_a.R, pair.between);
  for (int j = 0; j < 3; j++) pair.b_in_a[j] = transposed_times(at_a.R, at_b.R[j]);

  BestAxes best;
  if (!find_face_axis(pair, best) || !find_edge_axis(pair, best)) return;
  const double edge_threshold =
      best.face_gap + edge_advantage * pair.size + edge_advantage_of_gap * std::fabs(best.face_gap);
  const bool edge_pair = best.edge >= 0 && best.edge_gap > edge_threshold && add_edge_point(pair, best.edge, manifold);
  PointList list;
  add_face_points(pair, best.face, edge_pair ? &manifold.points[0] : nullptr, list);
  const double gap = std::fmax(best.face_gap, best.edge_gap);
  if (!edge_pair && gap > 0.0 && least_gap(list) > gap + on_border * pair.size) {
    const Separation nearest = separation(a, at_a, b, at_b, pair.margin, &cache);
    if (nearest.distance <= pair.margin && nearest.distance < least_gap(list) - on_border * pair.size)
      manifold.points[manifold.count++] = nearest_point(nearest);
  }
  keep_points(list, pair.size, pair.turn_way, manifold);
}

}  // namespace pantin
