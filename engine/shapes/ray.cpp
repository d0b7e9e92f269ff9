#include "shapes/ray.hpp"

#include <algorithm>

#include "shapes/core.hpp"
#include "shapes/near_point.hpp"
#include "shapes/way.hpp"

namespace pantin {

namespace {

using Hit = std::optional<RayHit>;

/// The part of a line within a convex shape (Cyrus and Beck 1978), in its own axes.
struct Chord {
  double enter = -infinity, leave = infinity;
  Vec3 normal = zero3();  ///< where it enters

  void clip(Vec3 n, double offset, Vec3 from, Vec3 along) {
    const double height = dot(n, from) - offset, speed = dot(n, along);
    if (speed == 0.0) {
      if (height > 0.0) enter = infinity;
      return;
    }
    const double part = -height / speed;
    if (speed > 0.0)
      leave = std::min(leave, part);
    else if (part > enter)
      enter = part, normal = n;
  }
  Hit hit(Vec3 along) const {
    if (!(enter <= leave) || enter > 1.0 || leave < 0.0) return {};
    if (enter >= 0.0) return RayHit{enter, normal};
    if (!(leave > 0.0)) return {};
    return RayHit{0.0, -direction(along)};
  }
};

/// The parts of a line within a radius of the origin, of `from` and `along` without what is along an axis.
struct Within {
  double low = infinity, high = -infinity;
};

Within within(double radius, Vec3 from, Vec3 along) {
  const double square = norm2(along);
  if (!(square > 0.0)) return norm2(from) <= radius * radius ? Within{-infinity, infinity} : Within{};
  const double middle = -dot(from, along) / square;
  const Vec3 nearest = from + along * middle;
  const double rest = radius * radius - norm2(nearest);
  if (rest < 0.0) return {};
  const double half = std::sqrt(rest / square);
  return {middle - half, middle + half};
}

/// Adds the round part of a chord: its normal is away from the axis or the centre.
void clip_round(Chord& chord, double radius, Vec3 from, Vec3 along) {
  const Within part = within(radius, from, along);
  if (part.low > chord.enter) chord.enter = part.low, chord.normal = direction(from + along * part.low);
  chord.leave = std::min(chord.leave, part.high);
}

Vec3 without_z(Vec3 v) { return vec(v[0], v[1], 0); }

struct RayAt {
  Vec3 from, along;

  Hit operator()(const BallShape& ball) const {
    Chord chord;
    clip_round(chord, ball.radius, from, along);
    return chord.hit(along);
  }
  Hit operator()(const BoxShape& box) const {
    Chord chord;
    for (int i = 0; i < 3; i++) {
      Vec3 n = zero3();
      n[i] = 1.0;
      chord.clip(n, box.half[i], from, along);
      chord.clip(-n, box.half[i], from, along);
    }
    return chord.hit(along);
  }
  Hit operator()(const CapsuleShape& capsule) const {
    Chord whole, side;
    clip_round(side, capsule.radius, without_z(from), without_z(along));
    side.clip(vec(0, 0, 1), capsule.half, from, along);
    side.clip(vec(0, 0, -1), capsule.half, from, along);
    bool any = side.enter <= side.leave;
    if (any) whole = side;
    for (const double end : {-capsule.half, capsule.half}) {
      Chord ball;
      clip_round(ball, capsule.radius, from - vec(0, 0, end), along);
      if (!(ball.enter <= ball.leave)) continue;
      if (!any || ball.enter < whole.enter) whole.enter = ball.enter, whole.normal = ball.normal;
      whole.leave = any ? std::max(whole.leave, ball.leave) : ball.leave;
      any = true;
    }
    return any ? whole.hit(along) : Hit{};
  }
  Hit operator()(const CylinderShape& cylinder) const {
    Chord chord;
    clip_round(chord, cylinder.radius, without_z(from), without_z(along));
    chord.clip(vec(0, 0, 1), cylinder.half, from, along);
    chord.clip(vec(0, 0, -1), cylinder.half, from, along);
    return chord.hit(along);
  }
  Hit operator()(const std::shared_ptr<const Hull>& hull) const {
    Chord chord;
    for (const Hull::Face& face : hull->faces) chord.clip(face.normal, face.offset, from, along);
    return chord.hit(along);
  }
  Hit operator()(const HalfSpaceShape&) const {
    Chord chord;
    chord.clip(vec(0, 0, 1), 0.0, from, along);
    return chord.hit(along);
  }
  Hit operator()(const std::shared_ptr<const TriangleMesh>& mesh) const {
    return first_met(*mesh, {from, along}, [&](const MeshTriangle& triangle) { return meet(triangle, true); });
  }
  Hit operator()(const std::shared_ptr<const HeightField>& field) const {
    if (triangle_above(*field, from)) return RayHit{0.0, -direction(along)};
    return first_met(*field, {from, along}, [&](const MeshTriangle& triangle) { return meet(triangle, false); });
  }

  /// Signed volumes, so that nothing gets through between triangles that share an edge.
  Hit meet(const MeshTriangle& triangle, bool from_behind) const {
    const double speed = dot(triangle.normal, along), height = dot(triangle.normal, from - triangle.corner[0]);
    if (speed == 0.0 || (speed > 0.0 && !from_behind)) return {};
    const double part = -height / speed;
    if (!(part >= 0.0 && part <= 1.0)) return {};
    const std::array<Vec3, 3> to{triangle.corner[0] - from, triangle.corner[1] - from, triangle.corner[2] - from};
    for (std::size_t i = 0; i < 3; i++) {
      const double side = dot(along, cross(to[i], to[(i + 1) % 3]));
      if (speed > 0.0 ? side < 0.0 : side > 0.0) return {};
    }
    return RayHit{part, speed > 0.0 ? -triangle.normal : triangle.normal};
  }
};

struct InsideAt {
  Vec3 point;

  bool operator()(const HalfSpaceShape&) const { return point[2] <= 0.0; }
  bool operator()(const std::shared_ptr<const Hull>& hull) const {
    return std::all_of(hull->faces.begin(), hull->faces.end(),
                       [&](const Hull::Face& face) { return dot(face.normal, point) <= face.offset; });
  }
  bool operator()(const std::shared_ptr<const TriangleMesh>&) const { return false; }
  bool operator()(const std::shared_ptr<const HeightField>& field) const {
    return triangle_above(*field, point).has_value();
  }
  template <class Convex>
  bool operator()(const Convex& convex) const {
    const Core core = core_of(convex);
    return near_point(core, point).distance <= core.rounding;
  }
};

}  // namespace

std::optional<RayHit> ray(const Geometry& shape, const Pose& pose, Vec3 from, Vec3 to) {
  const Vec3 along = transposed_times(pose.R, to - from);
  if (same(from, to)) return inside(shape, pose, from) ? Hit(RayHit{0.0, vec(0, 0, 1)}) : Hit{};
  Hit hit = std::visit(RayAt{pose.to_local(from), along}, shape);
  if (hit) hit->normal = direction(pose.R * hit->normal);
  return hit;
}

bool inside(const Geometry& shape, const Pose& pose, Vec3 point) {
  return std::visit(InsideAt{pose.to_local(point)}, shape);
}

}  // namespace pantin
