#include "shapes/polish.hpp"

#include <array>

namespace pantin {

namespace {

/// Adds the second derivative of a cylinder's reach along n; `axis` and n in axes of the pair.
void add_bend(const Core& core, Vec3 axis, Vec3 n, Mat3& bend) {
  if (core.kind != Core::Kind::cylinder) return;
  const Vec3 across = cross(axis, n);
  const double square = norm2(across);
  if (square > 1e-24) bend += outer(across, across) * (core.half[0] / (square * std::sqrt(square)));
}

/// At most three directions of edges, or rather of all differences of corners, of one core's corners in a simplex.
struct Edges {
  std::array<Vec3, 4> along;
  std::size_t count = 0;

  void add(Vec3 u) {
    if (count < along.size() && norm2(u) > 0.0) along[count++] = u / norm(u);
  }
};

Edges edges_of(const Core& core, Vec3 axis, const Simplex& simplex, Vec3 Difference::*side) {
  Edges edges;
  if (core.kind == Core::Kind::cylinder)
    edges.add(axis);
  else
    for (int i = 1; i < simplex.count; i++)
      edges.add(simplex.corner[static_cast<std::size_t>(i)].*side - simplex.corner[0].*side);
  return edges;
}

class Polish {
 public:
  Polish(const CorePair& pair, Vec3 normal) : pair_(pair), start_(normal) { offer(normal); }
  const Widest& widest() const { return widest_; }

  void offer(Vec3 n) { widest_.offer(n, dot(n, pair_.lowest(n).w)); }
  void offer_both(Vec3 n) {
    const double near = dot(n, start_);
    if (std::fabs(near) > 0.9) offer(near < 0.0 ? -n : n);
  }
  void offer_across(Vec3 u, Vec3 v) {
    const Vec3 n = cross(u, v);
    const double square = norm2(n);
    if (square > 1e-20) offer_both(n / std::sqrt(square));
  }
  /// Newton's method on the great circle square to u.
  void climb_circle(Vec3 u) {
    Vec3 n = direction(start_ - u * dot(u, start_), zero3());
    if (same(n, zero3())) return;
    for (int i = 0; i < 8; i++) {
      const Vec3 t = cross(u, n), w = pair_.lowest(n).w;
      const double slope = dot(t, w), bend = dot(t, bend_at(n) * t) + dot(n, w);
      if (!(std::fabs(bend) > 0.0) || !move(n, t * (slope / bend))) break;
    }
    offer(direction(n - u * dot(u, n)));
  }
  /// Newton's method on the sphere.
  void climb_sphere() {
    Vec3 n = start_;
    for (int i = 0; i < 8; i++) {
      const Vec3 e = direction(cross(n, std::fabs(n[0]) < 0.6 ? vec(1, 0, 0) : vec(0, 1, 0))), f = cross(n, e);
      const Vec3 w = pair_.lowest(n).w;
      const Mat3 bend = bend_at(n);
      const double along = dot(n, w), ee = dot(e, bend * e) + along, ff = dot(f, bend * f) + along,
                   ef = dot(e, bend * f);
      const double determinant = ee * ff - ef * ef, on_e = dot(e, w), on_f = dot(f, w);
      if (!(std::fabs(determinant) > 0.0)) break;
      if (!move(n, e * ((on_e * ff - on_f * ef) / determinant) + f * ((on_f * ee - on_e * ef) / determinant))) break;
    }
    offer(n);
  }

 private:
  Mat3 bend_at(Vec3 n) const {
    Mat3 bend = zero33();
    add_bend(pair_.a, vec(0, 0, 1), n, bend);
    add_bend(pair_.b, pair_.R[2], n, bend);
    return bend;
  }
  /// False where it has come to rest.
  static bool move(Vec3& n, Vec3 step) {
    const double length = norm(step);
    if (!(length > 1e-17) || !std::isfinite(length)) return false;
    n = direction(n + (length > 0.2 ? step * (0.2 / length) : step));
    return length > 1e-15;
  }

  const CorePair& pair_;
  Vec3 start_;
  Widest widest_;
};

/// The flat faces of a core that look nearly along n.
void offer_faces(Polish& polish, const Core& core, const Mat3& R, Vec3 n) {
  if (core.kind == Core::Kind::cylinder) polish.offer_both(R[2]);
  if (core.kind == Core::Kind::box)
    for (int i = 0; i < 3; i++) polish.offer_both(R[i]);
  if (core.kind != Core::Kind::hull) return;
  const Vec3 own = transposed_times(R, n);
  Vec3 best = zero3();
  for (const Hull::Face& face : core.hull->faces)
    if (dot(face.normal, own) > dot(best, own)) best = face.normal;
  polish.offer_both(R * best);
}

}  // namespace

Widest polished(const CorePair& pair, Vec3 normal, const Simplex& simplex) {
  Polish polish(pair, normal);
  const Edges a = edges_of(pair.a, vec(0, 0, 1), simplex, &Difference::a);
  const Edges b = edges_of(pair.b, pair.R[2], simplex, &Difference::b);
  polish.climb_sphere();
  for (const Edges* edges : {&a, &b})
    for (std::size_t i = 0; i < edges->count; i++) {
      polish.climb_circle(edges->along[i]);
      for (std::size_t j = 0; j < i; j++) polish.offer_across(edges->along[i], edges->along[j]);
    }
  for (std::size_t i = 0; i < a.count; i++)
    for (std::size_t j = 0; j < b.count; j++) polish.offer_across(a.along[i], b.along[j]);
  offer_faces(polish, pair.a, identity33(), -normal);
  offer_faces(polish, pair.b, pair.R, normal);
  return polish.widest();
}

}  // namespace pantin
