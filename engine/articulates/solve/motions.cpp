#include "articulates/solve/motions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pantin {

std::pmr::memory_resource& kept_memory() {
  static std::pmr::synchronized_pool_resource pool;
  return pool;
}

double product(const Motions& a, const Motions& b) {
  Lanes all = lanes(0.0);
  for (std::size_t i = 0; i < a.size(); i++) all += dot(a[i].v, b[i].p) + dot(a[i].w, b[i].L);
  return sum(all);
}

double size_of(const Motions& m) { return std::sqrt(std::max(0.0, product(m, m))); }

void add(Motions& to, const Motions& more, double times) {
  for (std::size_t i = 0; i < to.size(); i++) {
    to[i].v += more[i].v * times;
    to[i].w += more[i].w * times;
    to[i].p += more[i].p * times;
    to[i].L += more[i].L * times;
  }
}

void push(BatchMotion& to, std::size_t lane, Vec3 impulse, Vec3 angular) {
  set_lane(to.p, lane, lane_of(to.p, lane) + impulse);
  set_lane(to.L, lane, lane_of(to.L, lane) + angular);
}

/// Leaves what is new in a direction; its size.
double MotionSpace::orthogonalise(Motions& direction) const {
  for (int again = 0; again < 2; again++)
    for (const Motions& q : directions) add(direction, q, -product(q, direction));
  return size_of(direction);
}

double MotionSpace::add_direction(Motions direction, double size_of_all,
                                  const std::function<Motions(const Motions&)>& allowed) {
  constexpr double negligible = 1e-7, small = 1e-3, least_kept = 0.5;
  const double found = orthogonalise(direction);
  if (!(found > negligible * size_of_all)) return 0.0;
  double size = found;
  if (found < small * size_of_all) {
    direction = allowed(direction);
    size = orthogonalise(direction);
    if (!(size > least_kept * found)) return 0.0;
  }
  Motions unit(direction.size());
  add(unit, direction, 1.0 / size);
  directions.push_back(std::move(unit));
  return size;
}

void MotionSpace::add_forces(const std::vector<Motions>& forces) {
  const auto n = static_cast<Eigen::Index>(directions.size());
  galerkin.conservativeResize(n, n);
  for (Eigen::Index i = 0; i < n; i++) {
    const auto k = static_cast<std::size_t>(i);
    galerkin(i, n - 1) = product(directions[k], forces.back());
    galerkin(n - 1, i) = product(directions.back(), forces[k]);
  }
}

namespace {

/// Whether all eigenvalues of a symmetric matrix are positive: whether Cholesky's method has all its pivots.
bool is_positive(Eigen::MatrixXd m) {
  for (Eigen::Index k = 0; k < m.rows(); k++) {
    if (!(m(k, k) > 0.0)) return false;
    for (Eigen::Index i = k + 1; i < m.rows(); i++)
      for (Eigen::Index j = k + 1; j <= i; j++) m(i, j) -= m(i, k) * m(j, k) / m(k, k);
  }
  return true;
}

}  // namespace

double MotionSpace::fastest_decay() const {
  constexpr int halvings = 50;
  const Eigen::MatrixXd working = -0.5 * (galerkin + galerkin.transpose());
  double high = 0.0;
  for (const double x : working.reshaped()) high += std::fabs(x);
  double low = -high;
  for (int k = 0; k < halvings; k++) {
    const double middle = 0.5 * (low + high);
    const bool above = is_positive(middle * Eigen::MatrixXd::Identity(working.rows(), working.cols()) - working);
    (above ? high : low) = middle;
  }
  return high;
}

}  // namespace pantin
