#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pantin {

/// A piecewise cubic with continuous second derivatives through given points. It goes on in a straight line before the
/// first and after the last.
class Spline {
 public:
  /// Natural cubic spline (de Boor 1978, ch. IV). `x` rising, at least two points. Throws Error.
  Spline(std::span<const double> x, std::span<const double> y);

  double first() const { return x_.front(); }
  double last() const { return x_.back(); }
  /// The value (order 0), the derivative of order 1, 2 or 3, or (order -1) the integral from the last point to x.
  double evaluate(double x, int order = 0) const;

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  Spline() = default;

  std::vector<double> x_;
  std::vector<std::array<double, 4>> pieces_;  ///< value, derivative, half the second, sixth of the third at x_[i]
  std::vector<std::uint32_t> start_;           ///< a piece at or below the start of each of as many equal bins
  double bins_per_x_ = 0.0;
  std::vector<double> integral_;  ///< from the last point to x_[i]

  void find_bins();
  void integrate();
  std::size_t piece_of(double x) const;
};

}  // namespace pantin
