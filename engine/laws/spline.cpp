#include "laws/spline.hpp"

#include <cmath>

#include "base/check.hpp"

namespace pantin {

namespace {

// Second derivatives at the points, 0 at both ends: a tridiagonal system.
std::vector<double> second_derivatives(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  std::vector<double> m(n, 0.0), upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; i++) {
    const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
    const double pivot = 2.0 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    m[i] = (6.0 * ((y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before) - before * m[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) m[i] -= upper[i] * m[i + 1];
  return m;
}

}  // namespace

Spline::Spline(std::span<const double> x, std::span<const double> y) : x_(x.begin(), x.end()) {
  require(x.size() == y.size() && x.size() >= 2,
          "table: it needs at least two points, each with a position and a value; got ", x.size(), " and ", y.size());
  for (std::size_t i = 0; i < x.size(); i++) {
    require(std::isfinite(x[i]) && std::isfinite(y[i]), "table: point ", i + 1, " is (", x[i], ", ", y[i],
            "): not finite");
    require(i == 0 || x[i] > x[i - 1], "table: its positions must rise; point ", i + 1, " is at ", x[i], " after ",
            x[i - 1]);
  }
  const auto m = second_derivatives(x, y);
  for (std::size_t i = 0; i + 1 < x.size(); i++) {
    const double h = x[i + 1] - x[i];
    pieces_.push_back(
        {y[i], (y[i + 1] - y[i]) / h - h * (2.0 * m[i] + m[i + 1]) / 6.0, m[i] / 2.0, (m[i + 1] - m[i]) / (6.0 * h)});
  }
  find_bins();
  integrate();
}

void Spline::find_bins() {
  const std::size_t bins = 2 * pieces_.size();
  bins_per_x_ = static_cast<double>(bins) / (x_.back() - x_.front());
  std::size_t piece = 0;
  for (std::size_t bin = 0; bin < bins; bin++) {
    const double start = x_.front() + (static_cast<double>(bin) - 1e-9) / bins_per_x_;
    while (piece + 1 < pieces_.size() && x_[piece + 1] <= start) piece++;
    start_.push_back(static_cast<std::uint32_t>(piece));
  }
}

namespace {

double integral_of(const std::array<double, 4>& piece, double s) {
  return s * (piece[0] + s * (piece[1] / 2.0 + s * (piece[2] / 3.0 + s * (piece[3] / 4.0))));
}

}  // namespace

// After the last point comes one piece more, the straight line.
void Spline::integrate() {
  const double h = x_.back() - x_[x_.size() - 2];
  const auto& [value, slope, half, sixth] = pieces_.back();
  pieces_.push_back({value + h * (slope + h * (half + h * sixth)), slope + h * (2.0 * half + h * (3.0 * sixth)), 0, 0});
  integral_.assign(pieces_.size(), 0.0);
  for (std::size_t i = pieces_.size() - 1; i-- > 0;) {
    integral_[i] = integral_[i + 1] - integral_of(pieces_[i], x_[i + 1] - x_[i]);
  }
}

std::size_t Spline::piece_of(double x) const {
  if (!(x > x_.front())) return 0;
  if (x >= x_.back()) return pieces_.size() - 1;
  const auto bin = static_cast<std::size_t>((x - x_.front()) * bins_per_x_);
  std::size_t piece = start_[bin < start_.size() ? bin : start_.size() - 1];
  while (x_[piece + 1] <= x) piece++;
  return piece;
}

double Spline::evaluate(double x, int order) const {
  const std::size_t i = piece_of(x);
  auto piece = pieces_[i];
  if (x < x_.front()) piece[2] = piece[3] = 0.0;
  const auto& [value, slope, half, sixth] = piece;
  const double s = x - x_[i];
  switch (order) {
    case -1: return integral_[i] + integral_of(piece, s);
    case 0: return value + s * (slope + s * (half + s * sixth));
    case 1: return slope + s * (2.0 * half + s * (3.0 * sixth));
    case 2: return 2.0 * half + s * (6.0 * sixth);
    default: return 6.0 * sixth;
  }
}

}  // namespace pantin
