#include <utility>

#include "model/model.hpp"

namespace pantin {
namespace {

constexpr double round_off = 4e-16;  // of a matrix scaled to 1
constexpr int sweeps = 8;            // Jacobi's method converges quadratically; 5 are enough for 3 x 3

/// Turns columns i and j so that the matrix has no element (i, j).
void annihilate(Mat3& a, Mat3& axes, int i, int j) {
  const double off = a[j][i];
  if (std::fabs(off) <= round_off) return;  // axes of equal moments do not turn for it
  const double theta = (a[j][j] - a[i][i]) / (2.0 * off);
  const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
  Mat3 turn = identity33();
  turn[i][i] = turn[j][j] = c;
  turn[j][i] = s;
  turn[i][j] = -s;
  a = transpose(turn) * a * turn;
  a[i][j] = a[j][i] = 0.0;
  axes = axes * turn;
}

}  // namespace

Principal principal_axes(const Mat3& symmetric, const Mat3& near) {
  double scale = 0.0;
  for (int i = 0; i < 3; i++) scale = std::fmax(scale, largest(symmetric[i]));
  if (!(scale > 0.0)) return {zero3(), near};
  // Starting in the old frame leaves the axes of equal moments where they were.
  const Mat3 scaled = symmetric * (1.0 / scale);
  Mat3 a = transpose(near) * ((scaled + transpose(scaled)) * 0.5) * near;
  Mat3 turn = identity33();
  for (int sweep = 0; sweep < sweeps; sweep++) {
    annihilate(a, turn, 0, 1);
    annihilate(a, turn, 0, 2);
    annihilate(a, turn, 1, 2);
  }
  Mat3 axes = near * turn;
  double moments[3] = {a[0][0], a[1][1], a[2][2]};
  const auto order = [&](int i, int j) {
    if (moments[i] <= moments[j] + round_off) return;
    std::swap(moments[i], moments[j]);
    std::swap(axes[i], axes[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  int weakest = 0;
  double fit[3];
  for (int i = 0; i < 3; i++) {
    axes[i] = direction(axes[i]);
    fit[i] = dot(axes[i], near[i]);
    if (fit[i] < 0.0) axes[i] = -axes[i];
    if (std::fabs(fit[i]) < std::fabs(fit[weakest])) weakest = i;
  }
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0.0) axes[weakest] = -axes[weakest];
  return {vec(moments[0], moments[1], moments[2]) * scale, axes};
}

}  // namespace pantin
