#include "model/path.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace pantin {

namespace {

/// Slopes at the positions of a cubic spline with continuous second derivative over unit pieces: natural at open ends.
/// Tridiagonal (cyclic where closed) equations m[i-1] + 4 m[i] + m[i+1] = 3 (p[i+1] - p[i-1]), by sweeps of Gauss and
/// Seidel, which gain a factor of four or more each.
std::vector<Vec3> slopes(const std::vector<Vec3>& p, bool closed) {
  const std::size_t n = p.size();
  std::vector<Vec3> m(n, zero3());
  for (int sweep = 0; sweep < 60; sweep++)
    for (std::size_t i = 0; i < n; i++) {
      const std::size_t before = i > 0 ? i - 1 : n - 1, after = i + 1 < n ? i + 1 : 0;
      if (closed || (i > 0 && i + 1 < n))
        m[i] = (3.0 * (p[after] - p[before]) - m[before] - m[after]) / 4.0;
      else if (i == 0)
        m[i] = (3.0 * (p[after] - p[i]) - m[after]) / 2.0;
      else
        m[i] = (3.0 * (p[i] - p[before]) - m[before]) / 2.0;
    }
  return m;
}

}  // namespace

Path::Path(std::vector<Vec3> positions, bool smooth, bool closed)
    : positions_(std::move(positions)), smooth_(smooth && positions_.size() > 2), closed_(closed) {
  require(positions_.size() >= 2, "on_path: a path needs two positions or more, got ", positions_.size());
  require(!closed || positions_.size() >= 3, "on_path: a closed path needs three positions or more");
  const std::size_t n = positions_.size(), count = closed ? n : n - 1;
  for (std::size_t i = 0; i < n; i++) require(finite(positions_[i]), "on_path: position ", i + 1, " is not finite");
  for (std::size_t i = 0; i < count; i++)
    require(norm(positions_[(i + 1) % n] - positions_[i]) > 0.0, "on_path: positions ", i + 1, " and ", (i + 1) % n + 1,
            " of the path are the same");
  const std::vector<Vec3> m = smooth_ ? slopes(positions_, closed) : std::vector<Vec3>(n, zero3());
  for (std::size_t i = 0; i < count; i++) {
    const Vec3 from = positions_[i], chord = positions_[(i + 1) % n] - from;
    extent_ = std::fmax(extent_, std::fmax(norm(from), norm(chord)));
    if (!smooth_) {
      pieces_.push_back({from, chord, zero3(), zero3()});
      continue;
    }
    const Vec3 s0 = m[i], s1 = m[(i + 1) % n];
    pieces_.push_back({from, s0, 3.0 * chord - 2.0 * s0 - s1, s0 + s1 - 2.0 * chord});
  }
}

const Path::Piece& Path::piece(double u, double& t) const {
  const double count = pieces();
  if (closed_) u -= count * std::floor(u / count);
  const double index = u > 0.0 ? std::min(std::floor(u), count - 1.0) : 0.0;
  t = u > index ? std::min(u - index, 1.0) : 0.0;
  return pieces_[static_cast<std::size_t>(index)];
}

Vec3 Path::position(double u) const {
  double t = 0.0;
  const Piece& p = piece(u, t);
  return p.a + (p.b + (p.c + p.d * t) * t) * t;
}

Vec3 Path::tangent(double u) const {
  double t = 0.0;
  const Piece& p = piece(u, t);
  const Vec3 ahead = direction(p.b + (2.0 * p.c + 3.0 * p.d * t) * t);
  constexpr double at_corner = 1e-9;
  const double corner = std::round(u);
  if (smooth_ || std::fabs(u - corner) > at_corner || (!closed_ && (corner <= 0.0 || corner >= pieces()))) return ahead;
  return direction(direction(piece(corner - 0.5, t).b) + direction(piece(corner + 0.5, t).b), ahead);
}

double Path::step_towards(Vec3 to, double u) const {
  double t = 0.0;
  const Piece& p = piece(u, t);
  const Vec3 position = p.a + (p.b + (p.c + p.d * t) * t) * t, slope = p.b + (2.0 * p.c + 3.0 * p.d * t) * t;
  const Vec3 bend = 2.0 * p.c + 6.0 * p.d * t, off = to - position;
  const double first = dot(off, slope), second = norm2(slope) - dot(off, bend);
  return first / std::max(0.3 * norm2(slope), second);
}

double Path::nearest(Vec3 to, double u) const {
  const double count = pieces();
  constexpr int most_steps = 50;
  double last = infinity, before = infinity;
  for (int left = most_steps - 1; left >= 0; left--) {
    const double change = std::min(std::max(-0.5, step_towards(to, u)), 0.5);
    double next = u + change;
    if (!closed_) next = std::min(std::max(0.0, next), count);
    // A step over the end of a piece stops there first: the next piece has its own slope.
    const double edge = change > 0.0 ? std::floor(u) + 1.0 : std::ceil(u) - 1.0;
    if ((change > 0.0 && next > edge) || (change < 0.0 && next < edge)) next = edge;
    const double moved = std::fabs(next - u);
    // At a corner whose two pieces both lead to it the steps go to and fro: what is left of them is known.
    if (next == before && moved > 1e-12 * count) return left % 2 == 0 ? next : u;
    before = u;
    u = next;
    if (moved == 0.0 || (moved < 1e-15 * count) || (moved >= last && moved < 1e-12 * count)) break;
    last = moved;
  }
  return u;
}

double Path::nearest(Vec3 to) const {
  double best = 0.0, least = infinity;
  const int samples = 8 * static_cast<int>(pieces_.size());
  for (int i = 0; i <= samples; i++) {
    const double u = i / 8.0, distance = norm2(position(u) - to);
    if (distance >= least) continue;
    least = distance;
    best = u;
  }
  return nearest(to, best);
}

}  // namespace pantin
