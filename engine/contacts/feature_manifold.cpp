// Two convex shapes: their nearest points, and where a face is as near, what lies over it.
#include <algorithm>

#include "contacts/feature_pair.hpp"
#include "contacts/manifold_parts.hpp"

namespace pantin {

namespace {

/// Part of the reach within which gaps are equal, and a corner lies on the border of a face.
constexpr double little = 1e-9;
/// Part of the reach about nearest points within which no other normal holds.
constexpr double where_edges_meet = 1e-2;
/// Cosine above which two points of lines are near each other along the normal of the pair.
constexpr double along_normal = 0.99;

constexpr std::uint32_t nearest_id = 0x80000000u;
enum : std::uint32_t { over_face_of_a = 301, over_face_of_b, along_lines };

struct Line {
  Vec3 from, to;
  double radius;
  std::uint32_t name;
};

struct Interval {
  double from, to;
};

/// Where a line runs beside another, as parts of it.
Interval part_beside(const Line& line, const Line& other) {
  const Vec3 way = other.to - other.from;
  const double square = norm2(way), start = dot(line.from - other.from, way) / square,
               end = dot(line.to - other.from, way) / square;
  if (start == end) return {1.0, 0.0};
  const double at_from = -start / (end - start), at_to = (1.0 - start) / (end - start);
  return {std::fmax(0.0, std::fmin(at_from, at_to)), std::fmin(1.0, std::fmax(at_from, at_to))};
}

/// From x along a direction to the surface about a line [m]; infinite where it passes by, or meets it past the line's ends.
double way_to_surface(Vec3 x, Vec3 along, const Line& line) {
  const Vec3 axis = direction(line.to - line.from), w = x - line.from;
  const Vec3 across = along - axis * dot(axis, along), off = w - axis * dot(axis, w);
  const double a = norm2(across), b = dot(across, off), c = norm2(off) - line.radius * line.radius;
  const double root = b * b - a * c;
  if (!(root >= 0.0 && a > 0.0)) return infinity;
  const double way = (-b - std::sqrt(root)) / a, at = dot(axis, w + along * way), near = little * line.radius;
  return at >= -near && at <= norm(line.to - line.from) + near ? way : infinity;
}

bool has_point_at(const PointList& list, Vec3 on_a, double near) {
  const auto end = list.points.begin() + list.count;
  return std::any_of(list.points.begin(), end,
                     [&](const ManifoldPoint& p) { return norm2(p.on_a - on_a) <= near * near; });
}

/// Both ends of the part in which a round line and another one run along each other; each point lies on both surfaces.
void add_line_points(const FeaturePair& pair, const Line& round, const Line& other, bool round_is_a, Vec3 normal,
                     PointList& list) {
  const bool from_other = other.radius == 0.0;
  const Line &sampled = from_other ? other : round, &beside = from_other ? round : other;
  const Vec3 axis = direction(round.to - round.from);
  const Interval interval = part_beside(sampled, beside);
  if (interval.to - interval.from < as_good_a_face) return;
  for (const double part : {interval.from, interval.to}) {
    const Vec3 x = sampled.from + (sampled.to - sampled.from) * part;
    const Vec3 nearest = beside.from + (beside.to - beside.from) * (dot(x - beside.from, beside.to - beside.from) /
                                                                    norm2(beside.to - beside.from));
    Vec3 away = from_other ? nearest - x : x - nearest;
    away -= axis * dot(axis, away);
    const double distance = norm(away);
    const Vec3 n = away / distance, to_a = round_is_a ? n : -n;
    if (!(dot(to_a, normal) > along_normal)) continue;
    const double gap = (from_other ? distance : way_to_surface(x, -n, other)) - round.radius;
    if (gap > pair.margin) continue;
    const Vec3 on_round = (from_other ? nearest : x) - n * round.radius;
    const std::uint32_t which = (part == 0.0 || part == 1.0 ? 0u : 2u) + (part == interval.from ? 0u : 1u);
    const Vec3 on_a = pair.origin + (round_is_a ? on_round : on_round - n * gap);
    if (has_point_at(list, on_a, as_good_a_face * pair.reach)) continue;  // edges that meet share a corner
    list.add({on_a, to_a, gap, name_of(along_lines, round.name, other.name, which)});
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
  const bool round_is_a = pair.a.feature.kind == Feature::Kind::segment;
  const Feature& round = (round_is_a ? pair.a : pair.b).feature;
  if (round.kind != Feature::Kind::segment) return;
  for_each_line(round, [&](const Line& line) {
    for_each_line((round_is_a ? pair.b : pair.a).feature,
                  [&](const Line& other) { add_line_points(pair, line, other, round_is_a, normal, list); });
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
  return dot(face.normal, lowest - on_plane(face)) - other.core.rounding;
}

void add_face_points(const FeaturePair& pair, bool face_of_a, double least, PointList& list) {
  const Feature& face = side_of(pair, face_of_a).feature;
  const FeatureSide& other = side_of(pair, !face_of_a);
  const Vec3 outwards = face.normal, plane = on_plane(face);
  Loop loop = other.feature.loop;
  clip(loop, other.feature.normal, face, little * pair.reach);
  for (std::uint32_t i = 0; i < loop.count; i++) {
    const Corner& c = loop.corners[i];
    const double gap = dot(outwards, c.x - plane);
    if (gap > pair.margin || gap < least) continue;
    list.add({pair.origin + (face_of_a ? c.x - outwards * gap : c.x), face_of_a ? -outwards : outwards, gap,
              name_of(face_of_a ? over_face_of_a : over_face_of_b, face.number, c.name)});
  }
}

ManifoldPoint nearest_point(const Separation& nearest) {
  return {nearest.on_a, nearest.normal, nearest.distance, nearest_id};
}

namespace {

/// Where edges meet, a face may lie on the other shape within the step: adds what is over it, but for where they meet. What
/// overlaps is left out where the edges press aslant to it: it has to go past them.
void add_open_points(const FeaturePair& pair, bool face_of_a, const Separation& nearest, PointList& list) {
  const Vec3 outwards = side_of(pair, face_of_a).feature.normal, normal = face_of_a ? -outwards : outwards;
  PointList open;
  add_face_points(pair, face_of_a, dot(normal, nearest.normal) < like_the_face ? 0.0 : -infinity, open);
  const double near = where_edges_meet * pair.reach;
  for (std::uint32_t i = 0; i < open.count; i++) {
    const Vec3 on_a = open.points[i].on_a;
    if (norm2(on_a - nearest.on_a) > near * near && !has_point_at(list, on_a, near)) list.add(open.points[i]);
  }
}

}  // namespace

void set_feature_points(const FeaturePair& pair, const Separation& nearest, Manifold& manifold) {
  manifold.count = 0;
  const double little_gap = little * pair.reach, good = nearest.distance - as_good_a_face * pair.reach;
  const double gap_a = face_gap(pair, true), gap_b = face_gap(pair, false);
  PointList list;
  if (gap_a >= good || gap_b >= good) {
    add_face_points(pair, prefers_a(pair, gap_a >= good, gap_b >= good), -infinity, list);
    if (nearest.distance < least_gap(list) - little_gap) list.add(nearest_point(nearest));
    keep_points(list, pair.reach, pair.turn_way, manifold);
    return;
  }
  add_points_along_lines(pair, nearest.normal, list);
  if (std::fabs(nearest.distance - least_gap(list)) > little_gap)
    manifold.points[manifold.count++] = nearest_point(nearest);
  if (pair.a.feature.is_face() || pair.b.feature.is_face()) add_open_points(pair, gap_a >= gap_b, nearest, list);
  keep_points(list, pair.reach, pair.turn_way, manifold);
}

void convex_on_convex(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, Ahead ahead,
                      SeparationCache& cache, Manifold& manifold) {
  manifold.count = 0;
  const Separation nearest = separation(a, at_a, b, at_b, ahead.margin, &cache);
  if (!(nearest.distance <= ahead.margin)) return;
  if (std::holds_alternative<BallShape>(a) || std::holds_alternative<BallShape>(b)) {
    manifold.points[manifold.count++] = nearest_point(nearest);
    return;
  }
  FeaturePair pair;
  pair.origin = at_b.x;
  pair.margin = ahead.margin;
  pair.turn_way = ahead.turn_way;
  pair.reach = std::fmin(reach_of(a), reach_of(b));
  pair.a.core = core_of(a);
  pair.a.pose = {at_a.x - at_b.x, at_a.R};
  pair.b.core = core_of(b);
  pair.b.pose = {zero3(), at_b.R};
  find_feature(pair.a.core, pair.a.pose, -nearest.normal, pair.a.feature);
  find_feature(pair.b.core, pair.b.pose, nearest.normal, pair.b.feature);
  set_feature_points(pair, nearest, manifold);
}

}  // namespace pantin
