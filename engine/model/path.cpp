#include "model/path.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace pantin {

namespace {

constexpr double cosine_of_sharp = 0.99939;  // of two degrees

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
  for (double corner = 0.0; corner < pieces() && !smooth_; corner++)
    if (may_turn_at(corner) &&
        dot(direction(piece_from(corner - 1.0).b), direction(piece_from(corner).b)) < cosine_of_sharp)
      sharp_.push_back(corner);
}

const Path::Piece& Path::piece_from(double first) const {
  return pieces_[static_cast<std::size_t>(closed_ ? first - pieces() * std::floor(first / pieces()) : first)];
}

const Path::Piece& Path::piece(double u, double& t, PathRun run) const {
  const double count = pieces();
  if (u >= run.to || u < run.from) {
    const double first = u >= run.to ? run.to - 1.0 : run.from;
    t = u - first;
    return piece_from(first);
  }
  if (closed_) u -= count * std::floor(u / count);
  const double index = u > 0.0 ? std::min(std::floor(u), count - 1.0) : 0.0;
  t = u > index ? std::min(u - index, 1.0) : 0.0;
  return pieces_[static_cast<std::size_t>(index)];
}

PathRun Path::run_of(double u) const {
  if (sharp_.empty()) return {};
  const double count = pieces(), whole = closed_ ? count * std::floor(u / count) : 0.0;
  const auto next = std::upper_bound(sharp_.begin(), sharp_.end(), u - whole);
  const double first = closed_ ? sharp_.front() + count : infinity, last = closed_ ? sharp_.back() - count : -infinity;
  return {whole + (next == sharp_.begin() ? last : next[-1]), whole + (next == sharp_.end() ? first : *next)};
}

PathRun Path::run(double u, Vec3 velocity) const {
  const double corner = std::round(u);
  if (std::fabs(u - corner) > at_corner || !may_turn_at(corner)) return run_of(u);
  const PathRun before = run_of(corner - 0.5), after = run_of(corner + 0.5);
  const bool ahead =
      std::fabs(dot(velocity, tangent(corner, after))) >= std::fabs(dot(velocity, tangent(corner, before)));
  return ahead ? after : before;
}

Vec3 Path::position(double u, PathRun run) const {
  double t = 0.0;
  const Piece& p = piece(u, t, run);
  return p.a + (p.b + (p.c + p.d * t) * t) * t;
}

Vec3 Path::tangent(double u, PathRun run) const {
  double t = 0.0;
  const Piece& p = piece(u, t, run);
  const Vec3 ahead = direction(p.b + (2.0 * p.c + 3.0 * p.d * t) * t);
  const double corner = std::round(u);
  const bool within = corner > run.from && corner < run.to && may_turn_at(corner);
  if (smooth_ || std::fabs(u - corner) > at_corner || !within) return ahead;
  return direction(direction(piece(corner - 0.5, t).b) + direction(piece(corner + 0.5, t).b), ahead);
}

bool Path::is_straight(double u, double v, PathRun run) const {
  double t = 0.0;
  return !smooth_ && &piece(u, t, run) == &piece(v, t, run);
}

double Path::step_towards(Vec3 to, double u, PathRun run) const {
  double t = 0.0;
  const Piece& p = piece(u, t, run);
  const Vec3 position = p.a + (p.b + (p.c + p.d * t) * t) * t, slope = p.b + (2.0 * p.c + 3.0 * p.d * t) * t;
  const Vec3 bend = 2.0 * p.c + 6.0 * p.d * t, off = to - position;
  const double first = dot(off, slope), second = norm2(slope) - dot(off, bend);
  return first / std::max(0.3 * norm2(slope), second);
}

double Path::nearest(Vec3 to, double u, PathRun run) const {
  const double count = pieces();
  const double least = closed_ || std::isfinite(run.from) ? -infinity : 0.0,
               most = closed_ || std::isfinite(run.to) ? infinity : count;
  constexpr int most_steps = 50;
  double last = infinity, before = infinity;
  for (int left = most_steps - 1; left >= 0; left--) {
    const double change = std::min(std::max(-0.5, step_towards(to, u, run)), 0.5);
    double next = std::min(std::max(least, u + change), most);
    // A step over the end of a piece stops there first: the next piece has its own slope.
    const double edge = change > 0.0 ? std::floor(u) + 1.0 : std::ceil(u) - 1.0;
    const bool within = edge > run.from && edge < run.to;
    const bool stops = within && ((change > 0.0 && next > edge) || (change < 0.0 && next < edge));
    if (stops) next = edge;
    const double moved = std::fabs(next - u);
    // At a corner whose two pieces both lead to it the steps go to and fro: what is left of them is known.
    if (next == before && moved > 1e-12 * count) return left % 2 == 0 ? next : u;
    before = u;
    u = next;
    if (!stops && (moved < 1e-15 * count || (moved >= last && moved < 1e-12 * count))) break;
    last = moved;
  }
  return u;
}

double Path::nearest(Vec3 to) const {
  constexpr double samples = 8.0;  // of a piece
  double best = 0.0, least = infinity;
  const auto try_at = [&](double u) {
    const double distance = norm2(position(u) - to);
    if (distance >= least) return;
    least = distance;
    best = u;
  };
  for (double first = 0.0; first < pieces(); first++) {
    if (!smooth_) {
      const Piece& p = piece_from(first);
      try_at(first + std::min(std::max(0.0, dot(to - p.a, p.b) / norm2(p.b)), 1.0));
      continue;
    }
    for (double i = 0.0; i < samples; i++) {
      const double u = first + i / samples, here = norm2(position(u) - to);
      if (here > norm2(position(u - 1.0 / samples) - to) || here > norm2(position(u + 1.0 / samples) - to)) continue;
      try_at(nearest(to, u));
    }
  }
  return best;
}

}  // namespace pantin
