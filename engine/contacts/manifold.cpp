#include "contacts/manifold.hpp"

#include "contacts/manifold_parts.hpp"

namespace pantin {

void find_manifolds(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double margin,
                    SeparationCache& cache, ManifoldSink& sink) {
  Manifold manifold;
  const auto *box_a = std::get_if<BoxShape>(&a), *box_b = std::get_if<BoxShape>(&b);
  if (box_a != nullptr && box_b != nullptr)
    box_on_box(*box_a, at_a, *box_b, at_b, margin, cache, manifold);
  else if (is_convex(b))
    convex_on_convex(a, at_a, b, at_b, margin, cache, manifold);
  else if (std::holds_alternative<HalfSpaceShape>(b))
    convex_on_plane(a, at_a, at_b, margin, manifold);
  else
    return convex_on_triangles(a, at_a, b, at_b, margin, sink);
  if (manifold.count > 0) sink.take(manifold, 0);
}

}  // namespace pantin
