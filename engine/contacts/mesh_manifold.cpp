// A convex shape on triangles: each as a face with solid behind it, whose edges and corners are touched only where they
// stick out.
#include <algorithm>
#include <utility>

#include "base/stable.hpp"
#include "contacts/feature_pair.hpp"
#include "contacts/manifold_parts.hpp"
#include "contacts/triangle_prism.hpp"
#include "shapes/mesh.hpp"

namespace pantin {

namespace {

/// Sine up to which a normal does not lean, and part of the cosine up to which two are the same.
constexpr double no_lean = 1e-6, same_face_normal = 1e-10;
/// Parts of the reach within which points are one, and gaps are equal.
constexpr double same_place = 1e-7, same_depth = 1e-9;
/// Part of the reach within which one overlap is told for several triangles.
constexpr double nearby = 0.25;

struct ToldPoint {
  Vec3 on_b, normal;
  bool overlaps;
};

/// A triangle that is overlapped but has no point that overlaps: the way out of it leads over its edges.
struct LostTriangle {
  ManifoldPoint point;  ///< of what is in it, along its front's normal
  double upright;       ///< cosine between the way out and that normal
  std::uint32_t index;
};

/// A point and the triangle that it is of.
struct TrianglePoint {
  ManifoldPoint point;
  std::uint32_t index;
};

/// Kept from call to call, so that none asks for memory.
struct MeshScratch {
  TrianglePrism prism;
  std::vector<TrianglePoint> points;
  std::vector<ToldPoint> told;
  std::vector<LostTriangle> lost;
};

struct OnTriangles {
  const Geometry& a;
  const Pose &at_a, &at_b;
  double margin, reach, thickness;  ///< [m]
  ManifoldSink& sink;
  MeshScratch& scratch;
};

/// Lowest and highest point of a convex shape over a plane through x [m].
struct Extent {
  double low, high;
};

Extent extent_over(const FeatureSide& a, Vec3 normal, Vec3 x) {
  const auto height = [&](Vec3 along) {
    return dot(normal, a.pose.to_world(support(a.core, transposed_times(a.pose.R, along))) - x);
  };
  return {height(-normal) - a.core.rounding, height(normal) + a.core.rounding};
}

/// A triangle in world axes, from its first corner.
MeshTriangle turned_triangle(const MeshTriangle& t, const Mat3& R) {
  MeshTriangle turned = t;
  turned.normal = R * t.normal;
  for (std::size_t i = 0; i < 3; i++) {
    turned.corner[i] = R * (t.corner[i] - t.corner[0]);
    turned.over[i] = R * t.over[i];
  }
  return turned;
}

/// What becomes of nearest points: they stay, the front's normal takes the place of theirs, or a neighbour tells them.
enum class Handling { stay, front, neighbour };

/// Of a normal that leans over a convex edge. Where shapes overlap, the way out of one triangle may lead into the next: the
/// front that lets out first tells them.
Handling over_ridge(const FeatureSide& a, const MeshTriangle& t, std::size_t edge, Vec3 along,
                    const Separation& nearest) {
  const Vec3 normal = nearest.normal, over = t.over[edge];
  if (dot(over, t.normal) >= 1.0 - same_face_normal)
    return dot(normal, t.normal) < -no_lean ? Handling::neighbour : Handling::stay;
  if (dot(normal, cross(over, along)) > no_lean) return Handling::stay;
  if (nearest.distance >= 0.0) return Handling::neighbour;
  const bool lets_out_first = extent_over(a, t.normal, t.corner[edge]).low >= extent_over(a, over, t.corner[edge]).low;
  return lets_out_first ? Handling::front : Handling::neighbour;
}

/// Whether the normal belongs to the edges and corners that the nearest point lies on; on_b from the first corner.
Handling handling_of(const FeatureSide& a, const MeshTriangle& t, const Separation& nearest, Vec3 on_b, double near) {
  bool over_convex = false, over_flat = false;
  for (std::size_t i = 0; i < 3; i++) {
    const Vec3 along = direction(t.corner[(i + 1) % 3] - t.corner[i]), outwards = cross(along, t.normal);
    if (dot(nearest.normal, outwards) <= no_lean || dot(outwards, t.corner[i] - on_b) > near) continue;
    const Handling handling = t.convex[i] ? over_ridge(a, t, i, along, nearest) : Handling::front;
    if (handling == Handling::neighbour) return handling;
    over_convex = over_convex || handling == Handling::stay;
    over_flat = over_flat || handling == Handling::front;
  }
  if (!over_convex) return Handling::front;
  return over_flat && nearest.distance >= 0.0 ? Handling::neighbour : Handling::stay;
}

/// What of the feature is over the front, and the lowest point of the shape where that is.
void set_front_points(const FeaturePair& pair, Manifold& manifold) {
  const FeatureSide& a = pair.a;
  const Vec3 normal = pair.b.feature.normal;
  const Vec3 lowest = a.pose.to_world(support(a.core, transposed_times(a.pose.R, -normal))) - normal * a.core.rounding;
  const double gap = dot(normal, lowest), near = same_depth * pair.reach;
  PointList list;
  add_face_points(pair, false, -infinity, list);
  Loop loop;
  loop.add({lowest, 0, 0});
  clip(loop, normal, pair.b.feature, near);
  if (loop.count > 0 && gap < least_gap(list) - near)
    list.add(nearest_point({gap, normal, pair.origin + lowest, zero3()}));
  keep_points(list, pair.reach, 0.0, manifold);
}

bool overlaps_at_all(const Manifold& manifold) {
  const auto end = manifold.points.begin() + manifold.count;
  return std::any_of(manifold.points.begin(), end, [](const ManifoldPoint& p) { return p.gap < 0.0; });
}

/// Keeps a triangle without points that overlap, where the shapes do.
void keep_lost(const OnTriangles& on, const FeaturePair& pair, const MeshTriangle& t, const Separation& nearest) {
  if (nearest.distance >= -same_depth * on.reach) return;
  const double height = dot(t.normal, nearest.on_a - pair.origin);
  const ManifoldPoint within = nearest_point({height, t.normal, nearest.on_a, zero3()});
  on.scratch.lost.push_back({within, dot(nearest.normal, t.normal), t.index});
}

/// Of a triangle that has no edge to be touched from its sides: the front tells all.
void set_flat_points(const OnTriangles& on, FeaturePair& pair, const MeshTriangle& t, double low, Manifold& manifold) {
  find_feature(pair.a.core, pair.a.pose, -t.normal, pair.a.feature);
  set_front_points(pair, manifold);
  if (low >= -same_depth * on.reach || overlaps_at_all(manifold)) return;
  SeparationCache cache{t.normal};
  keep_lost(on, pair, t,
            separation(on.a, on.at_a, on.scratch.prism.geometry(), {pair.origin, identity33()}, 0.0, &cache));
}

void set_ridged_points(const OnTriangles& on, FeaturePair& pair, const MeshTriangle& t, double low,
                       Manifold& manifold) {
  SeparationCache cache{t.normal};
  const Separation nearest =
      separation(on.a, on.at_a, on.scratch.prism.geometry(), {pair.origin, identity33()}, on.margin, &cache);
  if (!(nearest.distance <= on.margin)) return;
  const double near = as_good_a_face * on.reach;
  const Handling handling = low >= nearest.distance - near
                                ? Handling::front
                                : handling_of(pair.a, t, nearest, nearest.on_b - pair.origin, near);
  if (handling == Handling::neighbour) return;
  find_feature(pair.a.core, pair.a.pose, handling == Handling::front ? -t.normal : -nearest.normal, pair.a.feature);
  if (handling == Handling::front)
    set_front_points(pair, manifold);
  else
    set_feature_points(pair, nearest, manifold);
  if (!overlaps_at_all(manifold)) keep_lost(on, pair, t, nearest);
}

/// The points of one triangle. What has passed through a front by less than its thickness, or half of its extent, goes back.
void set_triangle_points(const OnTriangles& on, const MeshTriangle& in_mesh, Manifold& manifold) {
  manifold.count = 0;
  FeaturePair pair;
  pair.origin = on.at_b.to_world(in_mesh.corner[0]);
  pair.margin = on.margin;
  pair.turn_way = 0.0;
  pair.reach = on.reach;
  pair.a.core = core_of(on.a);
  pair.a.pose = {on.at_a.x - pair.origin, on.at_a.R};
  const MeshTriangle t = turned_triangle(in_mesh, on.at_b.R);
  const Extent extent = extent_over(pair.a, t.normal, zero3());
  const double deepest = std::fmax(on.thickness, 0.5 * (extent.high - extent.low));
  if (extent.low > on.margin || extent.high < 0.0 || -extent.low > deepest) return;
  const std::size_t lost = on.scratch.lost.size();

  on.scratch.prism.set(t.corner, t.normal, on.thickness);
  pair.b.core = core_of(on.scratch.prism.geometry());
  find_face(on.scratch.prism.hull(), pair.b.pose, 0, pair.b.feature);
  const bool ridged = t.convex[0] || t.convex[1] || t.convex[2];
  (ridged ? set_ridged_points : set_flat_points)(on, pair, t, extent.low, manifold);
  if (manifold.count == 0 && on.scratch.lost.size() == lost) return;
  const double risen = std::fmax(0.0, dot(on.sink.motion_even_if_held().displacement, t.normal));
  if (risen - extent.low > 0.5 * deepest) on.sink.tell_behind();
}

/// Leaves out what a neighbour told at a common edge or corner.
void drop_told(const OnTriangles& on, Manifold& manifold) {
  const double near = same_place * on.reach;
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < manifold.count; i++) {
    const ManifoldPoint point = manifold.points[i];
    const Vec3 on_b = point.on_a - point.normal * point.gap;
    bool told = false;
    for (const ToldPoint& other : on.scratch.told)
      told = told ||
             (norm2(other.on_b - on_b) <= near * near && dot(other.normal, point.normal) >= 1.0 - same_face_normal);
    if (told) continue;
    manifold.points[kept++] = point;
    on.scratch.told.push_back({on_b, point.normal, point.gap < 0.0});
  }
  manifold.count = kept;
}

/// Moves those that lie in one plane with the first, along its normal, to the end. Returns how many do not.
std::size_t part_plane(std::vector<TrianglePoint>& points, double near) {
  const ManifoldPoint first = points.front().point;
  const auto on_b = [](const ManifoldPoint& p) { return p.on_a - p.normal * p.gap; };
  const auto others = partition_stably(points.begin(), points.end(), [&](const TrianglePoint& p) {
    return dot(p.point.normal, first.normal) < 1.0 - same_face_normal ||
           std::fabs(dot(first.normal, on_b(p.point) - on_b(first))) > near;
  });
  return static_cast<std::size_t>(others - points.begin());
}

void tell_one(const OnTriangles& on, const TrianglePoint& p) {
  Manifold manifold;
  manifold.points[manifold.count++] = p.point;
  on.sink.take(manifold, p.index);
}

/// Triangles in one plane are as one face: four of all their points are told, from the outermost of the deepest.
void tell_points(const OnTriangles& on) {
  std::vector<TrianglePoint>& points = on.scratch.points;
  while (!points.empty()) {
    const std::size_t rest = part_plane(points, same_place * on.reach), count = points.size() - rest;
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(rest);
    Vec3 middle = zero3();
    for (auto p = first; p != points.end(); ++p) middle += p->point.on_a / static_cast<double>(count);
    std::sort(first, points.end(), [&](const TrianglePoint& p, const TrianglePoint& q) {
      const double of_p = norm2(p.point.on_a - middle), of_q = norm2(q.point.on_a - middle);
      return of_p != of_q ? of_p > of_q : std::pair(p.index, p.point.id) < std::pair(q.index, q.point.id);
    });
    PointList list;
    for (std::uint32_t i = 0; i < count; i++) {
      list.add(first[i].point);
      list.points[list.count - 1].id = i;
    }
    Manifold kept;
    keep_points(list, on.reach, 0.0, kept);
    for (std::uint32_t i = 0; i < kept.count; i++) tell_one(on, first[kept.points[i].id]);
    points.resize(rest);
  }
}

void tell_triangle(const OnTriangles& on, const MeshTriangle& t) {
  Manifold manifold;
  set_triangle_points(on, t, manifold);
  drop_told(on, manifold);
  for (std::uint32_t i = 0; i < manifold.count; i++) on.scratch.points.push_back({manifold.points[i], t.index});
}

/// The most upright of lost triangles first, unless another one has told of an overlap nearby.
void tell_lost(const OnTriangles& on) {
  std::vector<LostTriangle>& lost = on.scratch.lost;
  std::sort(lost.begin(), lost.end(), [](const LostTriangle& a, const LostTriangle& b) {
    return a.upright != b.upright ? a.upright > b.upright : a.index < b.index;
  });
  const double near = nearby * on.reach;
  for (const LostTriangle& l : lost) {
    const Vec3 on_a = l.point.on_a;
    const auto is_near = [&](const ToldPoint& other) {
      return other.overlaps && norm2(other.on_b - on_a) <= near * near;
    };
    if (std::any_of(on.scratch.told.begin(), on.scratch.told.end(), is_near)) continue;
    on.scratch.told.push_back({on_a - l.point.normal * l.point.gap, l.point.normal, true});
    on.scratch.points.push_back({l.point, l.index});
  }
}

}  // namespace

void convex_on_triangles(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double margin,
                         ManifoldSink& sink) {
  thread_local MeshScratch scratch;
  scratch.points.clear();
  scratch.told.clear();
  scratch.lost.clear();
  const OnTriangles on = {a, at_a, at_b, margin, reach_of(a), thickness_of(a), sink, scratch};
  const Pose in_mesh = {at_b.to_local(at_a.x),
                        {{transposed_times(at_b.R, at_a.R[0]), transposed_times(at_b.R, at_a.R[1]),
                          transposed_times(at_b.R, at_a.R[2])}}};
  Bounds box = bounds_of(a, in_mesh);
  box.low -= vec(margin, margin, margin);
  box.high += vec(margin, margin, margin);
  const auto tell = [&on](const MeshTriangle& triangle) { tell_triangle(on, triangle); };
  if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&b)) triangles_in(**mesh, box, tell);
  if (const auto* field = std::get_if<std::shared_ptr<const HeightField>>(&b)) triangles_in(**field, box, tell);
  tell_lost(on);
  tell_points(on);
}

}  // namespace pantin
