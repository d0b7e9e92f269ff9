#include "shapes/core.hpp"

#include "base/check.hpp"

namespace pantin {

namespace {

struct MakeCore {
  Core operator()(const BallShape& ball) const { return {Core::Kind::point, zero3(), nullptr, ball.radius}; }
  Core operator()(const BoxShape& box) const { return {Core::Kind::box, box.half, nullptr, 0.0}; }
  Core operator()(const CapsuleShape& capsule) const {
    return {Core::Kind::segment, vec(0, 0, capsule.half), nullptr, capsule.radius};
  }
  Core operator()(const CylinderShape& cylinder) const {
    return {Core::Kind::cylinder, vec(cylinder.radius, cylinder.radius, cylinder.half), nullptr, 0.0};
  }
  Core operator()(const std::shared_ptr<const Hull>& hull) const {
    return {Core::Kind::hull, zero3(), hull.get(), 0.0};
  }
  Core operator()(const HalfSpaceShape&) const { return none(); }
  Core operator()(const std::shared_ptr<const TriangleMesh>&) const { return none(); }
  Core operator()(const std::shared_ptr<const HeightField>&) const { return none(); }

  static Core none() {
    assume(false);  // not convex
    return {Core::Kind::point, zero3(), nullptr, 0.0};
  }
};

}  // namespace

Core core_of(const Geometry& convex) { return std::visit(MakeCore{}, convex); }

CorePair core_pair(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b) {
  const Mat3 R{
      {transposed_times(at_a.R, at_b.R[0]), transposed_times(at_a.R, at_b.R[1]), transposed_times(at_a.R, at_b.R[2])}};
  return {core_of(a), core_of(b), R, at_a.to_local(at_b.x)};
}

}  // namespace pantin
