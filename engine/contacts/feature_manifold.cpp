// Two convex shapes: their nearest points, and where a face is as near, what lies over it.
#include "contacts/feature_pair.hpp"
#include "contacts/manifold_parts.hpp"

namespace pantin {

namespace {

/// Part of the size within which gaps are equal, and a corner lies on the border of a face.
constexpr double little = 1e-9;
/// Cosine above which two points of lines are near each other along the normal of the pair.
constexpr double along_normal = 0.99;

constexpr std::uint32_t nearest_id = 0x80000000u;
enum Names : std::uint32_t { over_face_of_a = 301, over_face_of_b, along_lines };

struct Line {
  Vec3 from, to;
  double radius;
  std::uint32_t name;
};

Vec3 nearest_on(const Line& line, Vec3 x) {
  const Vec3 way = line.to - line.from;
  const double part = dot(x - line.from, way) / norm2(way);
  return line.from + way * std::fmin(std::fmax(part, 0.0), 1.0);
}

/// Both ends of the part of line a that runs along line b.
void add_line_points(const FeaturePair& pair, const Line& a, const Line& b, Vec3 normal, PointList& list) {
  const Vec3 way = a.to - a.from;
  const double square = norm2(way);
  if (!(square > 0.0) || !(norm2(b.to - b.from) > 0.0)) return;
  const double from = dot(b.from - a.from, way) / square, to = dot(b.to - a.from, way) / square;
  const double start = std::fmax(0.0, std::fmin(from, to)), end = std::fmin(1.0, std::fmax(from, to));
  if (end - start < as_good_a_face) return;
  for (const double part : {start, end}) {
    const Vec3 x = a.from + way * part, between = x - nearest_on(b, x);
    const double distance = norm(between), gap = distance - a.radius - b.radius;
    if (gap > pair.margin || !(dot(between, normal) > along_normal * distance)) continue;
    const std::uint32_t which = part == 0.0 ? 0 : part == 1.0 ? 1 : part == from ? 2 : 3;
    const Vec3 n = between / distance;
    list.add({pair.origin + x - n * a.radius, n, gap, name_of(along_lines, a.name, b.name, which)});
  }
}

template <class Use>
void for_each_line(const Feature& feature, Use use) {
  if (feature.kind == Feature::Kind::segment) use(Line{feature.line[0], feature.line[1], feature.radius, 0});
  if (feature.kind != Feature::Kind::polygon) return;
  const Loop& loop = feature.loop;
  for (std::uint32_t i = 0; i < loop.count; i++)
    use(Line{loop.corners[i].x, loop.corners[i + 1 < loop.count ? i + 1 : 0].x, 0.0, loop.corners[i].edge});
}

/// Of a segment that lies along another one, or along an edge.
void add_points_along_lines(const FeaturePair& pair, Vec3 normal, PointList& list) {
  const Feature &a = pair.a.feature, &b = pair.b.feature;
  if (a.kind != Feature::Kind::segment && b.kind != Feature::Kind::segment) return;
  for_each_line(a, [&](const Line& line_a) {
    for_each_line(b, [&](const Line& line_b) { add_line_points(pair, line_a, line_b, normal, list); });
  });
}

const FeatureSide& side_of(const FeaturePair& pair, bool a) { return a ? pair.a : pair.b; }

Vec3 on_plane(const Feature& face) { return face.kind == Feature::Kind::disc ? face.centre : face.loop.corners[0].x; }

/// Where the caps of two cylinders meet that of either; a disc is clipped at its rim exactly only as the one clipped against.
bool prefers_a(const FeaturePair& pair, bool good_a, bool good_b) {
  const bool only_b_is_disc = pair.a.feature.kind != Feature::Kind::disc && pair.b.feature.kind == Feature::Kind::disc;
  return good_a && !(good_b && only_b_is_disc);
}

}  // namespace

double face_gap(const FeaturePair& pair, bool face_of_a) {
  const Feature& face = side_of(pair, face_of_a).feature;
  if (!face.is_face()) return -infinity;
  const FeatureSide& other = side_of(pair, !face_of_a);
  const Vec3 lowest = other.pose.to_world(support(other.core, transposed_times(other.pose.R, -face.normal)));
  return dot(face.normal, lowest - on_plane(face));
}

void add_face_points(const FeaturePair& pair, bool face_of_a, double least, PointList& list) {
  const Feature& face = side_of(pair, face_of_a).feature;
  const FeatureSide& other = side_of(pair, !face_of_a);
  const Vec3 outwards = face.normal, plane = on_plane(face);
  Loop loop = other.feature.loop;
  clip(loop, other.feature.normal, face, little * pair.size);
  for (std::uint32_t i = 0; i < loop.count; i++) {
    const Corner& c = loop.corners[i];
    const double height = dot(outwards, c.x - plane), gap = height - other.core.rounding;
    if (gap > pair.margin || gap < least) continue;
    const Vec3 on_a = face_of_a ? c.x - outwards * height : c.x - outwards * other.core.rounding;
    list.add({pair.origin + on_a, face_of_a ? -outwards : outwards, gap,
              name_of(face_of_a ? over_face_of_a : over_face_of_b, face.number, c.name)});
  }
}

ManifoldPoint nearest_point(const Separation& nearest) {
  return {nearest.on_a, nearest.normal, nearest.distance, nearest_id};
}

void set_feature_points(const FeaturePair& pair, const Separation& nearest, Manifold& manifold) {
  manifold.count = 0;
  const double distance = nearest.distance + pair.a.core.rounding + pair.b.core.rounding;
  const double gap_a = face_gap(pair, true), gap_b = face_gap(pair, false);
  const double good = distance - as_good_a_face * pair.size;
  PointList list;
  if (gap_a >= good || gap_b >= good) {
    add_face_points(pair, prefers_a(pair, gap_a >= good, gap_b >= good), -infinity, list);
    if (nearest.distance < least_gap(list) - little * pair.size) list.add(nearest_point(nearest));
    keep_points(list, pair.size, manifold);
    return;
  }
  add_points_along_lines(pair, nearest.normal, list);
  if (nearest.distance < least_gap(list) - little * pair.size)
    manifold.points[manifold.count++] = nearest_point(nearest);
  // Where edges meet, a face may lie on the other shape within the step.
  if (pair.a.feature.is_face() || pair.b.feature.is_face()) add_face_points(pair, gap_a >= gap_b, 0.0, list);
  keep_points(list, pair.size, manifold);
}

void convex_on_convex(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double margin,
                      SeparationCache& cache, Manifold& manifold) {
  manifold.count = 0;
  const Separation nearest = separation(a, at_a, b, at_b, margin, &cache);
  if (!(nearest.distance <= margin)) return;
  if (std::holds_alternative<BallShape>(a) || std::holds_alternative<BallShape>(b)) {
    manifold.points[manifold.count++] = nearest_point(nearest);
    return;
  }
  FeaturePair pair;
  pair.origin = at_b.x;
  pair.margin = margin;
  pair.size = std::fmin(reach_of(a), reach_of(b));
  pair.a.core = core_of(a);
  pair.a.pose = {at_a.x - at_b.x, at_a.R};
  pair.b.core = core_of(b);
  pair.b.pose = {zero3(), at_b.R};
  find_feature(pair.a.core, pair.a.pose, -nearest.normal, pair.a.feature);
  find_feature(pair.b.core, pair.b.pose, nearest.normal, pair.b.feature);
  set_feature_points(pair, nearest, manifold);
}

}  // namespace pantin
