// A convex shape on triangles: each as a face with solid behind it, whose edges and corners are touched only where they
// stick out.
#include "contacts/feature_pair.hpp"
#include "contacts/manifold_parts.hpp"
#include "contacts/triangle_prism.hpp"
#include "shapes/mesh.hpp"

namespace pantin {

namespace {

/// Sine up to which a normal does not lean, and cosine lost up to which it is that of the front.
constexpr double no_lean = 1e-6, same_normal = 1e-10;
/// Length of what is left of a normal along a triangle, below which it is the front's.
constexpr double no_rest = 1e-3;
/// Part of the size within which points are one.
constexpr double same_place = 1e-7;

struct ToldPoint {
  Vec3 on_b, normal;
};

/// Kept from call to call, so that none asks for memory.
struct MeshScratch {
  TrianglePrism prism;
  std::vector<ToldPoint> told;
};

struct OnTriangles {
  const Geometry& a;
  const Pose &at_a, &at_b;
  double margin, size, thickness;  ///< [m]
  ManifoldSink& sink;
  MeshScratch& scratch;
};

/// What becomes of nearest points: they stay, the front's normal takes the place of theirs, or a neighbour tells them.
enum class Handling { stay, front, neighbour };

/// By the normal and the nearest point of the triangle, in the mesh's axes: whether the normal is one of those that belong
/// to the edges and corners there.
Handling handling_of(const MeshTriangle& t, Vec3 normal, Vec3 on_b, bool overlapping, double near) {
  Vec3 rest = normal;
  bool leans = false, leans_over_flat = false;
  for (std::size_t i = 0; i < 3; i++) {
    const Vec3 along = direction(t.corner[(i + 1) % 3] - t.corner[i]), outwards = cross(along, t.normal);
    const double lean = dot(normal, outwards);
    if (lean <= no_lean || dot(outwards, t.corner[i] - on_b) > near) continue;
    leans = true;
    if (!t.convex[i]) {
      leans_over_flat = true;
      rest -= outwards * lean;
      continue;
    }
    const bool rim = dot(t.over[i], t.normal) >= 1.0 - same_normal;
    const double away = rim ? dot(normal, t.normal) + 2.0 * no_lean : dot(normal, cross(t.over[i], along));
    if (away <= no_lean) return Handling::neighbour;
  }
  if (!leans) return Handling::front;
  if (!leans_over_flat) return Handling::stay;
  if (norm(rest - t.normal * dot(rest, t.normal)) < no_rest) return Handling::front;
  return overlapping ? Handling::stay : Handling::neighbour;
}

/// Lowest and highest point of a over the front [m].
struct Extent {
  double low, high;
};

Extent extent_over(const FeatureSide& a, Vec3 normal) {
  const auto height = [&](Vec3 along) {
    return dot(normal, a.pose.to_world(support(a.core, transposed_times(a.pose.R, along))));
  };
  return {height(-normal) - a.core.rounding, height(normal) + a.core.rounding};
}

void set_front_points(const FeaturePair& pair, const Separation& nearest, Manifold& manifold) {
  const Vec3 normal = pair.b.feature.normal;
  PointList list;
  add_face_points(pair, false, -infinity, list);
  if (dot(nearest.normal, normal) >= 1.0 - same_normal && nearest.distance < least_gap(list) - 1e-9 * pair.size) {
    ManifoldPoint point = nearest_point(nearest);
    point.normal = normal;
    list.add(point);
  }
  keep_points(list, pair.size, manifold);
}

/// The points of one triangle; it is set in the prism, its first corner the origin.
void set_triangle_points(const OnTriangles& on, const MeshTriangle& t, Manifold& manifold) {
  manifold.count = 0;
  FeaturePair pair;
  pair.origin = on.at_b.to_world(t.corner[0]);
  pair.margin = on.margin;
  pair.size = on.size;
  pair.a.core = core_of(on.a);
  pair.a.pose = {on.at_a.x - pair.origin, on.at_a.R};
  const Vec3 front = on.at_b.R * t.normal;
  const Extent extent = extent_over(pair.a, front);
  const double deepest = std::fmax(on.thickness, 0.5 * (extent.high - extent.low));
  if (extent.low > on.margin || extent.high < 0.0 || -extent.low > deepest) return;

  on.scratch.prism.set({zero3(), t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]}, t.normal, on.thickness);
  SeparationCache cache{front};
  const Pose at_triangle = {pair.origin, on.at_b.R};
  const Separation nearest = separation(on.a, on.at_a, on.scratch.prism.geometry(), at_triangle, on.margin, &cache);
  if (!(nearest.distance <= on.margin)) return;

  pair.b.core = core_of(on.scratch.prism.geometry());
  pair.b.pose = {zero3(), on.at_b.R};
  find_face(on.scratch.prism.hull(), pair.b.pose, 0, pair.b.feature);
  Handling handling = Handling::front;
  if (extent.low < nearest.distance - as_good_a_face * on.size)
    handling = handling_of(t, transposed_times(on.at_b.R, nearest.normal), on.at_b.to_local(nearest.on_b),
                           nearest.distance < 0.0, as_good_a_face * on.size);
  if (handling == Handling::neighbour) return;
  find_feature(pair.a.core, pair.a.pose, handling == Handling::front ? -front : -nearest.normal, pair.a.feature);
  if (handling == Handling::front)
    set_front_points(pair, nearest, manifold);
  else
    set_feature_points(pair, nearest, manifold);
}

/// Leaves out what a neighbour told at a common edge or corner.
void drop_told(const OnTriangles& on, Manifold& manifold) {
  const double near = same_place * on.size;
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < manifold.count; i++) {
    const ManifoldPoint point = manifold.points[i];
    const Vec3 on_b = point.on_a - point.normal * point.gap;
    bool told = false;
    for (const ToldPoint& other : on.scratch.told)
      told = told || (norm2(other.on_b - on_b) <= near * near && dot(other.normal, point.normal) >= 1.0 - same_normal);
    if (told) continue;
    manifold.points[kept++] = point;
    on.scratch.told.push_back({on_b, point.normal});
  }
  manifold.count = kept;
}

void tell_triangle(const OnTriangles& on, const MeshTriangle& t) {
  Manifold manifold;
  set_triangle_points(on, t, manifold);
  drop_told(on, manifold);
  if (manifold.count > 0) on.sink.take(manifold, t.index);
}

}  // namespace

void convex_on_triangles(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double margin,
                         ManifoldSink& sink) {
  thread_local MeshScratch scratch;
  scratch.told.clear();
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
}

}  // namespace pantin
