#pragma once
// Where two shapes touch, or soon may: up to six points with a normal and gaps: four, one where edges meet, the inner ball.
#include <array>
#include <optional>

#include "shapes/distance.hpp"
#include "shapes/shape.hpp"

namespace pantin {

struct ManifoldPoint {
  Vec3 on_a;         ///< [m] world, on the surface of a; that of b is on_a - gap normal
  Vec3 normal;       ///< from b to a, of unit length
  double gap;        ///< [m] below 0: overlap
  std::uint32_t id;  ///< of the features that meet: the same in the next step where the same features do
};

/// Of a point of the ball about the origin of a that is within it: that does not turn away.
inline constexpr std::uint32_t inner_ball_id = 0x7fffffffu;

/// Where a motion within the step takes a to b, as if b did not move, and which part of the step that takes.
struct PoseAhead {
  Pose pose;
  double part;
};

struct Manifold {
  std::uint32_t count = 0;
  std::array<ManifoldPoint, 6> points;
  std::optional<PoseAhead> meeting;  ///< for whose points these are
};

/// What is to be foreseen of a pair.
struct Ahead {
  Ahead(double gaps, double turn = 0.0, bool blows = false) : margin(gaps), turn_way(turn), strikes(blows) {}
  double margin;    ///< [m] gaps up to this are told
  double turn_way;  ///< [m] by which turns within the step may close one gap more than another
  bool strikes;     ///< the two rebound, or nothing held either in the last drift: where they meet is found exactly
};

/// How a moves against b within the step if nothing stops it.
struct Travel {
  Vec3 displacement = zero3();  ///< [m] of its origin
  Vec3 turn = zero3();          ///< [rad] about its origin, world axes
};

/// Takes the points of two shapes, most important first where there are more than are kept, with the number of a triangle.
struct ManifoldSink {
  virtual void take(const Manifold& manifold, std::uint32_t part) = 0;
  /// Asked where there are points: none of two that hold each other already, and of those, too.
  virtual Travel motion() const { return {}; }
  virtual Travel motion_even_if_held() const { return motion(); }
  /// Told where triangles have points of what is behind their front by more than half of what goes back through it, or was a
  /// step before.
  virtual void tell_behind() {}

 protected:
  ~ManifoldSink() = default;
};
/// A ball within a convex shape, about as large as there can be; in its axes, [m].
struct InnerBall {
  Vec3 centre = zero3();
  double radius = 0.0;
};
InnerBall inner_ball(const Geometry& convex);
/// Tells the points. a is convex; b may be any shape: of meshes and height fields there may be
/// more than one manifold. Of convex shapes that a would meet within the step, those of where they meet; none where it
/// would pass over b, though one of its sides is ahead.
void find_manifolds(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, Ahead ahead,
                    SeparationCache& cache, ManifoldSink& sink);

}  // namespace pantin
