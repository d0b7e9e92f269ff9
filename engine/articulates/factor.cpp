#include "articulates/factor.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace pantin {

namespace {

/// 1/pivot with its sign; 0 where the pivot vanishes.
double inverse_pivot(double pivot, double whole, double redundant, bool& weak) {
  const double size = std::fabs(pivot);
  weak = weak || size < Factor::weak * whole;
  return size > redundant * whole ? 1.0 / pivot : 0.0;
}

/// Inverse by LDU without interchanges.
[[gnu::always_inline]] inline Mat3 inverse_ldu(const Mat3& a, Vec3 whole, double redundant, bool& weak) {
  const double i0 = inverse_pivot(a[0][0], whole[0], redundant, weak);
  const double l10 = a[0][1] * i0, l20 = a[0][2] * i0, u01 = a[1][0] * i0, u02 = a[2][0] * i0;
  const double i1 = inverse_pivot(a[1][1] - l10 * a[1][0], whole[1], redundant, weak);
  const double l21 = (a[1][2] - l20 * a[1][0]) * i1, u12 = (a[2][1] - l10 * a[2][0]) * i1;
  const double c12 = a[2][1] - l10 * a[2][0];
  const double i2 = inverse_pivot(a[2][2] - l20 * a[2][0] - l21 * c12, whole[2], redundant, weak);
  const double m20 = l21 * l10 - l20, n02 = u01 * u12 - u02;
  const double t0 = n02 * i2, t1 = -u12 * i2;
  return {{vec(i0 + u01 * i1 * l10 + t0 * m20, -i1 * l10 + t1 * m20, m20 * i2),
           vec(-u01 * i1 - t0 * l21, i1 - t1 * l21, -l21 * i2), vec(t0, t1, i2)}};
}

/// The LDL' of a symmetric block, its pivots inverted. Blocks go through its triangles one after the other: where pivots differ by
/// much, products with the inverse would lose what is small (of stiff ties: what their bodies weigh).
struct Triangles {
  double l10, l20, l21;
  Vec3 inverse;

  explicit Triangles(const Mat3& a) {
    const auto inverted = [](double pivot) { return pivot != 0.0 ? 1.0 / pivot : 0.0; };
    const double i0 = inverted(a[0][0]);
    l10 = a[0][1] * i0;
    l20 = a[0][2] * i0;
    const double i1 = inverted(a[1][1] - l10 * a[0][1]), c21 = a[1][2] - l20 * a[0][1];
    l21 = c21 * i1;
    inverse = vec(i0, i1, inverted(a[2][2] - l20 * a[0][2] - l21 * c21));
  }
  /// b L'⁻¹
  Mat3 behind(const Mat3& b) const {
    const Vec3 y1 = b[1] - b[0] * l10;
    return {{b[0], y1, b[2] - b[0] * l20 - y1 * l21}};
  }
  /// y D⁻¹
  Mat3 scaled(const Mat3& y) const { return {{y[0] * inverse[0], y[1] * inverse[1], y[2] * inverse[2]}}; }
  /// z L⁻¹
  Mat3 before(const Mat3& z) const {
    const Vec3 x1 = z[1] - z[2] * l21;
    return {{z[0] - x1 * l10 - z[2] * l20, x1, z[2]}};
  }
};

}  // namespace

std::uint32_t Factor::block(std::uint32_t row, std::uint32_t column) const {
  const auto begin = below.begin() + first[column], end = below.begin() + first[column + 1];
  const auto found = std::lower_bound(begin, end, row);
  assume(found != end && *found == row);
  return static_cast<std::uint32_t>(found - below.begin());
}

template <bool symmetric>
void Factor::subtract_products(std::uint32_t k, const std::uint32_t*& to) {
  const std::uint32_t begin = first[k], count = first[k + 1] - begin;
  for (std::uint32_t i = 0; i < count; i++)
    for (std::uint32_t j = 0; j <= i; j++) {
      const std::uint32_t t = *to++, block = t & ~(on_diagonal | is_fill_in);
      if (t & on_diagonal) {
        diagonal[block] -= scratch[i] * upper[begin + j];
        continue;
      }
      if (t & is_fill_in) lower[block] = upper[block] = zero33();
      lower[block] -= scratch[i] * upper[begin + j];
      if (!symmetric) upper[block] -= scratch[j] * upper[begin + i];
    }
}

bool Factor::eliminate(std::uint32_t k, const std::uint32_t*& to, double redundant) {
  bool weak_pivot = false;
  const Mat3 pivot = diagonal[k] = inverse_ldu(diagonal[k], whole[k], redundant, weak_pivot);
  const std::uint32_t begin = first[k], count = first[k + 1] - begin;
  if (count == 1) {  // chains and trees
    const Mat3 l = lower[begin] * pivot;
    diagonal[*to++ & ~on_diagonal] -= l * upper[begin];
    lower[begin] = l;
    upper[begin] = pivot * upper[begin];
    return weak_pivot;
  }
  for (std::uint32_t i = 0; i < count; i++) scratch[i] = lower[begin + i] * pivot;
  subtract_products<false>(k, to);
  for (std::uint32_t i = 0; i < count; i++) {
    lower[begin + i] = scratch[i];
    upper[begin + i] = pivot * upper[begin + i];
  }
  return weak_pivot;
}

void Factor::eliminate_symmetric(std::uint32_t k, const std::uint32_t*& to) {
  bool weak_pivot = false;
  const Triangles triangles(diagonal[k]);
  diagonal[k] = inverse_ldu(diagonal[k], whole[k], 0.0, weak_pivot);
  const std::uint32_t begin = first[k], count = first[k + 1] - begin;
  for (std::uint32_t i = 0; i < count; i++) {
    const Mat3 y = triangles.behind(lower[begin + i]);
    upper[begin + i] = transpose(y);
    scratch[i] = triangles.scaled(y);
  }
  subtract_products<true>(k, to);
  for (std::uint32_t i = 0; i < count; i++) {
    lower[begin + i] = triangles.before(scratch[i]);
    upper[begin + i] = transpose(lower[begin + i]);
  }
}

void Factor::substitute_forward(std::uint32_t k, Vec3* y) const {
  const Vec3 v = y[k];
  for (std::uint32_t i = first[k]; i < first[k + 1]; i++) y[below[i]] -= lower[i] * v;
}

void Factor::substitute_back(std::uint32_t k, Vec3* y) const {
  Vec3 v = diagonal[k] * y[k];
  for (std::uint32_t i = first[k]; i < first[k + 1]; i++) v -= upper[i] * y[below[i]];
  y[k] = v;
}

}  // namespace pantin
