#include "shapes/shape.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "shapes/core.hpp"
#include "shapes/mesh.hpp"

namespace pantin {

namespace {

using HullPtr = std::shared_ptr<const Hull>;
using MeshPtr = std::shared_ptr<const TriangleMesh>;
using FieldPtr = std::shared_ptr<const HeightField>;

Bounds about(Vec3 centre, Vec3 half) { return {centre - half, centre + half}; }
Vec3 absolute(Vec3 v) { return v < 0.0 ? -v : v; }

/// Of a box with these bounds in axes of its own.
Bounds turned(const Bounds& own, const Pose& pose) {
  const Vec3 half = (own.high - own.low) * 0.5;
  return about(pose.to_world((own.low + own.high) * 0.5),
               absolute(pose.R[0]) * half[0] + absolute(pose.R[1]) * half[1] + absolute(pose.R[2]) * half[2]);
}

Bounds own_bounds(const HeightField& field) {
  const double x = 0.5 * field.spacing * (field.columns - 1), z = 0.5 * field.spacing * (field.rows - 1);
  return {vec(-x, field.lowest, -z), vec(x, field.highest, z)};
}

struct BoundsOf {
  const Pose& pose;

  Bounds operator()(const BallShape& ball) const { return about(pose.x, vec(ball.radius, ball.radius, ball.radius)); }
  Bounds operator()(const BoxShape& box) const { return turned({-box.half, box.half}, pose); }
  Bounds operator()(const CapsuleShape& capsule) const {
    return about(pose.x, absolute(pose.R[2]) * capsule.half + vec(capsule.radius, capsule.radius, capsule.radius));
  }
  Bounds operator()(const CylinderShape& cylinder) const {
    Vec3 half = absolute(pose.R[2]) * cylinder.half;
    for (int i = 0; i < 3; i++) {
      const double x = pose.R[0][i], y = pose.R[1][i];
      half[i] += cylinder.radius * std::sqrt(x * x + y * y);
    }
    return about(pose.x, half);
  }
  Bounds operator()(const HullPtr& hull) const {
    Bounds bounds;
    const Mat3 rows = transpose(pose.R);
    for (int i = 0; i < 3; i++) {
      bounds.low[i] = dot(rows[i], hull->vertices[farthest(*hull, -rows[i])]);
      bounds.high[i] = dot(rows[i], hull->vertices[farthest(*hull, rows[i])]);
    }
    return {bounds.low + pose.x, bounds.high + pose.x};
  }
  Bounds operator()(const HalfSpaceShape&) const {
    return {vec(-infinity, -infinity, -infinity), vec(infinity, infinity, infinity)};
  }
  Bounds operator()(const MeshPtr& mesh) const { return turned(mesh->bounds, pose); }
  Bounds operator()(const FieldPtr& field) const { return turned(own_bounds(*field), pose); }
};

struct ReachOf {
  double operator()(const BallShape& ball) const { return ball.radius; }
  double operator()(const BoxShape& box) const { return norm(box.half); }
  double operator()(const CapsuleShape& capsule) const { return capsule.radius + capsule.half; }
  double operator()(const CylinderShape& c) const { return std::sqrt(c.radius * c.radius + c.half * c.half); }
  double operator()(const HullPtr& hull) const { return hull->reach; }
  double operator()(const HalfSpaceShape&) const { return infinity; }
  double operator()(const MeshPtr& mesh) const {
    double reach2 = 0.0;
    for (const Vec3 v : mesh->vertices) reach2 = std::max(reach2, norm2(v));
    return std::sqrt(reach2);
  }
  double operator()(const FieldPtr& field) const {
    const Bounds own = own_bounds(*field);
    return norm(vec(own.high[0], std::max(std::fabs(field->lowest), std::fabs(field->highest)), own.high[2]));
  }
};

struct ThicknessOf {
  double operator()(const BallShape& ball) const { return 2.0 * ball.radius; }
  double operator()(const BoxShape& box) const { return 2.0 * std::min({box.half[0], box.half[1], box.half[2]}); }
  double operator()(const CapsuleShape& capsule) const { return 2.0 * capsule.radius; }
  double operator()(const CylinderShape& cylinder) const { return 2.0 * std::min(cylinder.radius, cylinder.half); }
  double operator()(const HullPtr& hull) const { return hull->thickness; }
  double operator()(const HalfSpaceShape&) const { return infinity; }
  double operator()(const MeshPtr&) const { return infinity; }
  double operator()(const FieldPtr&) const { return infinity; }
};

bool length(double x) { return x >= 1e-12 && x <= 1e12; }

struct CheckShape {
  void operator()(const BallShape& ball) const {
    require(length(ball.radius), "A ball's radius is ", ball.radius, " m; it must be 1e-12 m … 1e12 m.");
  }
  void operator()(const BoxShape& box) const {
    for (int i = 0; i < 3; i++)
      require(length(box.half[i]), "Half a box's edge is ", box.half[i], " m; it must be 1e-12 m … 1e12 m.");
  }
  void operator()(const CapsuleShape& capsule) const {
    require(length(capsule.radius), "A capsule's radius is ", capsule.radius, " m; it must be 1e-12 m … 1e12 m.");
    require(length(capsule.half), "Half a capsule's segment is ", capsule.half, " m; it must be 1e-12 m … 1e12 m.");
  }
  void operator()(const CylinderShape& cylinder) const {
    require(length(cylinder.radius), "A cylinder's radius is ", cylinder.radius, " m; it must be 1e-12 m … 1e12 m.");
    require(length(cylinder.half), "Half a cylinder's length is ", cylinder.half, " m; it must be 1e-12 m … 1e12 m.");
  }
  void operator()(const HalfSpaceShape&) const {}
  template <class Shared>
  void operator()(const std::shared_ptr<Shared>& shared) const {
    require(shared != nullptr, "A hull, mesh or height field is missing: it must be made before it is used.");
  }
};

}  // namespace

Quat turn_to(Vec3 d) {
  if (d[2] < -0.999999) return {0.0, 1.0, 0.0, 0.0};
  return normalised({1.0 + d[2], -d[1], d[0], 0.0});
}

bool is_convex(const Geometry& shape) {
  return !std::holds_alternative<HalfSpaceShape>(shape) && !std::holds_alternative<MeshPtr>(shape) &&
         !std::holds_alternative<FieldPtr>(shape);
}

bool is_one_sided(const Geometry& shape) { return std::holds_alternative<MeshPtr>(shape); }

Bounds bounds_of(const Geometry& shape, const Pose& pose) { return std::visit(BoundsOf{pose}, shape); }
double reach_of(const Geometry& shape) { return std::visit(ReachOf{}, shape); }
Vec3 turn_of(const Geometry& shape, const Pose& pose, Vec3 turn) {
  if (std::holds_alternative<BallShape>(shape)) return zero3();
  const bool round = std::holds_alternative<CapsuleShape>(shape) || std::holds_alternative<CylinderShape>(shape);
  return round ? turn - pose.R[2] * dot(pose.R[2], turn) : turn;
}
double thickness_of(const Geometry& shape) { return std::visit(ThicknessOf{}, shape); }
void check_shape(const Geometry& shape) {
  std::visit(CheckShape{}, shape);
  if (!is_convex(shape)) return;
  constexpr double thinnest = 1e-7;  // of its extent
  const Bounds bounds = bounds_of(shape, {});
  const double extent = largest(bounds.high - bounds.low), thickness = thickness_of(shape);
  require(thickness >= thinnest * extent, "A shape of ", rounded(extent), " m is ", rounded(thickness),
          " m thick; it must be 1e-7 of its extent or more, ", rounded(thinnest * extent), " m.");
}
double rounding_of(const Geometry& convex) { return core_of(convex).rounding; }
Vec3 support_of_core(const Geometry& convex, Vec3 direction) { return support(core_of(convex), direction); }

}  // namespace pantin
