#pragma once
// Two convex shapes by the features that meet.
#include "contacts/clipping.hpp"
#include "contacts/manifold_points.hpp"

namespace pantin {

/// A core, and which feature of it is near the other.
struct FeatureSide {
  Core core;
  Pose pose;  ///< its origin from that of the pair
  Feature feature;
};

struct FeaturePair {
  FeatureSide a, b;
  Vec3 origin;              ///< [m] world
  double margin, turn_way;  ///< [m]
  double reach;             ///< [m] of the smaller shape: what tolerances are parts of
};

/// How far one shape is over the face that is the other's feature [m]; -infinity where that is no face.
double face_gap(const FeaturePair& pair, bool face_of_a);
/// A face is as good as any direction where its gap is that of the nearest points within this part of the reach.
inline constexpr double as_good_a_face = 1e-6;
/// Adds the points of the other's feature over a face, with gaps from `least` [m] to the margin.
void add_face_points(const FeaturePair& pair, bool face_of_a, double least, PointList& list);
/// Sets the points of two shapes whose nearest points are known.
void set_feature_points(const FeaturePair& pair, const Separation& nearest, Manifold& manifold);

}  // namespace pantin
