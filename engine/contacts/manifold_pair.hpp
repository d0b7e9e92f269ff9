#pragma once
// A pair of shapes whose points are looked for, now and where its motion takes it.
#include <span>
#include <vector>

#include "contacts/contact.hpp"
#include "contacts/manifold_parts.hpp"

namespace pantin {

/// Part of the thickness by which shapes may overlap where one passes over the other: more than is left of what was pushed out;
/// of two balls, which have no seams.
inline constexpr double passing_overlap = 5e-4, passing_overlap_of_balls = 1e-8;
/// Part of the thickness: what nears by more in the step strikes, and the blow acts where it is met: of what flew free or rebounds,
/// which else ends as fast as it is turned too far; in heaps, where many hold each other, no such blow is told from others.
inline constexpr double least_blow = 2e-4, least_blow_in_heaps = 0.02;
/// Part of the cosine up to which two normals are the same.
inline constexpr double same_normal = 1e-8;
/// [rad] past which a turn is not foreseen.
inline constexpr double most_turn = 0.5;

struct Pair {
  const Geometry& a;
  const Pose& at_a;
  const Geometry& b;
  const Pose& at_b;
  Ahead ahead;
  double thickness;  ///< [m]
  double overlap() const { return (are_balls() ? passing_overlap_of_balls : passing_overlap) * thickness; }
  bool are_balls() const { return std::holds_alternative<BallShape>(a) && std::holds_alternative<BallShape>(b); }
  double held_already() const { return ahead.strikes ? 0.0 : overlap(); }  ///< [m] what is open by less has its points
  double blow() const { return (ahead.strikes ? least_blow : least_blow_in_heaps) * thickness; }  ///< [m] in the step
};

inline std::span<const ManifoldPoint> points_of(const Manifold& manifold) {
  return std::span(manifold.points).first(manifold.count);
}

/// After so much of a motion.
Pose moved(const Pose& pose, const Travel& motion, double part);

struct PartManifold {
  Manifold manifold;
  std::uint32_t part;
};

/// Keeps what is told.
struct Collected final : ManifoldSink {
  std::vector<PartManifold> found;
  bool behind = false;
  const ManifoldSink* to = nullptr;
  void clear() {
    found.clear();
    behind = false;
  }
  void take(const Manifold& manifold, std::uint32_t part) override { found.push_back({manifold, part}); }
  Travel motion_even_if_held() const override { return to->motion_even_if_held(); }
  void tell_behind() override { behind = true; }
};

/// Tells the points of a, where it would be at a pose, on planes or triangles.
void find_on_faces(const Pair& pair, const Pose& at_a, ManifoldSink& sink);
/// The same of two convex shapes.
void set_points(const Pair& pair, const Pose& at_a, SeparationCache& cache, Manifold& manifold);
/// Points of where a was at a pose are those of where it is now.
void move_back(const Pair& pair, const Pose& pose, Manifold& manifold);

/// Adds points to which a hull rolls on within the step, and which none of its points stands for: where it is then is no blow of
/// one pose.
void add_turned(const Pair& pair, const ManifoldSink& sink, Manifold& manifold);
/// The same on planes and triangles. Whether any was added.
bool add_turned(const Pair& pair, const ManifoldSink& sink, std::vector<PartManifold>& found);

}  // namespace pantin
