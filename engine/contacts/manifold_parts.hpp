#pragma once
// The families of pairs, each in a file of its own. `normal` points from b to a everywhere; gaps up to `margin` [m] are told.
#include "contacts/manifold_points.hpp"

namespace pantin {

/// Cosine above which edges that meet press as a face does.
inline constexpr double like_the_face = 0.98;

void box_on_box(const BoxShape& a, const Pose& at_a, const BoxShape& b, const Pose& at_b, Ahead ahead,
                SeparationCache& cache, Manifold& manifold);
/// b is a half space.
void convex_on_plane(const Geometry& a, const Pose& at_a, const Pose& at_b, double margin, Manifold& manifold);
/// Any two convex shapes.
void convex_on_convex(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, Ahead ahead,
                      SeparationCache& cache, Manifold& manifold);
/// b is a mesh or a height field.
void convex_on_triangles(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double margin,
                         ManifoldSink& sink);

/// The nearest points of two shapes.
ManifoldPoint nearest_point(const Separation& nearest);

}  // namespace pantin
