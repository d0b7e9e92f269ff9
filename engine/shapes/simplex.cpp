#include "shapes/simplex.hpp"

namespace pantin {

namespace {

/// The nearest point of some of the corners.
struct Nearest {
  std::array<std::size_t, 3> corner;
  std::array<double, 3> part;
  int count;
  Vec3 at;
  double square;
};

Nearest of_point(const Simplex& s, std::size_t i) {
  const Vec3 w = s.corner[i].w;
  return {{i, 0, 0}, {1.0, 0.0, 0.0}, 1, w, norm2(w)};
}

Nearest of_segment(const Simplex& s, std::size_t i, std::size_t j) {
  const Vec3 p = s.corner[i].w, q = s.corner[j].w, e = q - p;
  const double from_p = -dot(p, e), from_q = dot(q, e);
  if (!(from_p > 0.0)) return of_point(s, i);
  if (!(from_q > 0.0)) return of_point(s, j);
  const double t = from_p / (from_p + from_q);
  const Vec3 at = from_p < from_q ? p + e * t : q - e * (from_q / (from_p + from_q));
  return {{i, j, 0}, {1.0 - t, t, 0.0}, 2, at, norm2(at)};
}

void keep_nearer(Nearest& best, const Nearest& other) {
  if (other.square < best.square) best = other;
}

Nearest of_triangle(const Simplex& s, std::size_t i, std::size_t j, std::size_t k) {
  const Vec3 p = s.corner[i].w, e1 = s.corner[j].w - p, e2 = s.corner[k].w - p, n = cross(e1, e2);
  const double nn = norm2(n);
  const double to_j = dot(cross(e2, p), n), to_k = dot(cross(p, e1), n), to_i = nn - to_j - to_k;
  if (nn > 0.0 && to_i > 0.0 && to_j > 0.0 && to_k > 0.0) {
    const Vec3 at = n * (dot(n, p) / nn);
    return {{i, j, k}, {to_i / nn, to_j / nn, to_k / nn}, 3, at, norm2(at)};
  }
  Nearest best{};
  best.square = infinity;
  if (!(to_i > 0.0)) keep_nearer(best, of_segment(s, j, k));
  if (!(to_j > 0.0)) keep_nearer(best, of_segment(s, i, k));
  if (!(to_k > 0.0)) keep_nearer(best, of_segment(s, i, j));
  if (best.square < infinity) return best;
  keep_nearer(best, of_segment(s, i, j));
  keep_nearer(best, of_segment(s, j, k));
  keep_nearer(best, of_segment(s, i, k));
  return best;
}

/// Whether the plane of i, j, k parts the origin from the fourth corner, or is as good as the fourth's own.
bool parts(const Simplex& s, std::size_t i, std::size_t j, std::size_t k, std::size_t fourth) {
  const Vec3 p = s.corner[i].w, n = cross(s.corner[j].w - p, s.corner[k].w - p);
  const double of_fourth = dot(n, s.corner[fourth].w - p), of_origin = -dot(n, p);
  const double flat = 1e-15 * norm(n) * norm(s.corner[fourth].w - p);
  return std::fabs(of_fourth) <= flat || (of_fourth > 0.0 ? of_origin < 0.0 : of_origin > 0.0);
}

void keep(Simplex& s, const Nearest& nearest) {
  const std::array<Difference, 4> old = s.corner;
  s.count = nearest.count;
  s.nearest = nearest.at;
  for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.count); i++) {
    s.corner[i] = old[nearest.corner[i]];
    s.part[i] = nearest.part[i];
  }
}

}  // namespace

Vec3 Simplex::on_a() const {
  Vec3 sum = zero3();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); i++) sum += corner[i].a * part[i];
  return sum;
}

Vec3 Simplex::on_b() const {
  Vec3 sum = zero3();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); i++) sum += corner[i].b * part[i];
  return sum;
}

bool reduce(Simplex& s) {
  if (s.count == 1) keep(s, of_point(s, 0));
  if (s.count == 2) keep(s, of_segment(s, 0, 1));
  if (s.count == 3) keep(s, of_triangle(s, 0, 1, 2));
  if (s.count < 4) return true;
  Nearest best{};
  best.square = infinity;
  if (parts(s, 0, 1, 2, 3)) keep_nearer(best, of_triangle(s, 0, 1, 2));
  if (parts(s, 0, 1, 3, 2)) keep_nearer(best, of_triangle(s, 0, 1, 3));
  if (parts(s, 0, 2, 3, 1)) keep_nearer(best, of_triangle(s, 0, 2, 3));
  if (parts(s, 1, 2, 3, 0)) keep_nearer(best, of_triangle(s, 1, 2, 3));
  if (best.square == infinity) return false;
  keep(s, best);
  return true;
}

}  // namespace pantin
