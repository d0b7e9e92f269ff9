#include "support/reference.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace pantin::reference {

namespace {

using Rate = std::function<State(const State&)>;

/// Gragg's modified midpoint rule with `n` sub-steps, n even: its error is a series in (h/n)².
State midpoint(const Rate& rate, const State& y, double h, int n) {
  const double k = h / n;
  State before = y, now = y + k * rate(y);
  for (int i = 1; i < n; i++) {
    State next = before + 2.0 * k * rate(now);
    before = now;
    now = next;
  }
  return 0.5 * (before + now + k * rate(now));
}

/// One piece: midpoint rules with 2, 4 … 16 sub-steps, extrapolated to none in h².
State extrapolated(const Rate& rate, const State& y, double h) {
  constexpr int rows = 8;
  std::vector<State> last, row;
  for (int i = 0; i < rows; i++) {
    row.assign(1, midpoint(rate, y, h, 2 * (i + 1)));
    for (int j = 1; j <= i; j++) {
      const std::size_t before = static_cast<std::size_t>(j - 1);
      const double ratio = static_cast<double>(i + 1) / (i - j + 1);
      row.push_back(row[before] + (row[before] - last[before]) / (ratio * ratio - 1.0));
    }
    last = row;
  }
  return row.back();
}

/// Mass behind each link, [kg].
std::vector<double> mass_behind(const PlaneChain& chain) {
  std::vector<double> behind(chain.links.size(), 0.0);
  for (std::size_t i = chain.links.size() - 1; i > 0; i--) behind[i - 1] = behind[i] + chain.links[i].mass;
  return behind;
}

}  // namespace

State integrate(const Rate& rate, State y, double time, int pieces) {
  for (int i = 0; i < pieces; i++) y = extrapolated(rate, y, time / pieces);
  return y;
}

PlaneChain plane_chain(int links) {
  PlaneChain chain;
  chain.links.resize(static_cast<std::size_t>(links));
  chain.start = State::Zero(2 * links);
  return chain;
}

PlaneChain heavy_plane_chain(int links, double ratio) {
  PlaneChain chain = plane_chain(links);
  const double radius = 0.5;
  chain.links.push_back({radius, radius, ratio, 0.4 * ratio * radius * radius});
  chain.start = State::Zero(2 * (links + 1));
  return chain;
}

PlaneChain plane_ring(int links) {
  PlaneChain chain = plane_chain(links);
  for (int i = 0; i < links; i++) chain.start(i) = std::numbers::pi * (1.0 + (2.0 * i + 1.0) / links);
  chain.closed = true;
  return chain;
}

// With e_j = (cos θ_j, sin θ_j), the centre of link i is at Σ_{j<i} L_j e_j + c_i e_i. Lagrange's equations:
// Σ_k w_jk (cos(θ_j − θ_k) θ_k'' + sin(θ_j − θ_k) θ_k'²) + I_j θ_j'' = −g s_j cos θ_j,
// s_j = m_j c_j + L_j M_j, w_jk = L_j s_k for j < k, w_jj = m_j c_j² + L_j² M_j, M_j the mass behind link j.
// Closed: forces J'μ on the angles keep Σ L_j e_j, so that J θ'' = Σ L_j θ_j'² e_j.
State rate(const PlaneChain& chain, const State& y) {
  const Eigen::Index n = y.size() / 2;
  const std::vector<double> behind = mass_behind(chain);
  Eigen::MatrixXd inertia(n, n);
  State push = State::Zero(n);
  for (Eigen::Index k = 0; k < n; k++) {
    const Link& link = chain.links[static_cast<std::size_t>(k)];
    const double m = behind[static_cast<std::size_t>(k)], s = link.mass * link.centre + link.length * m;
    inertia(k, k) = link.inertia + link.mass * link.centre * link.centre + link.length * link.length * m;
    push(k) -= chain.gravity * s * std::cos(y(k));
    for (Eigen::Index j = 0; j < k; j++) {
      const double w = chain.links[static_cast<std::size_t>(j)].length * s;
      const double sine = w * std::sin(y(j) - y(k));
      inertia(j, k) = inertia(k, j) = w * std::cos(y(j) - y(k));
      push(j) -= sine * y(n + k) * y(n + k);
      push(k) += sine * y(n + j) * y(n + j);
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(inertia);
  State bend = factor.solve(push);
  if (chain.closed) {
    Eigen::MatrixXd across(n, 2);
    Eigen::Vector2d inward = Eigen::Vector2d::Zero();
    for (Eigen::Index j = 0; j < n; j++) {
      const Eigen::Vector2d along =
          chain.links[static_cast<std::size_t>(j)].length * Eigen::Vector2d(std::cos(y(j)), std::sin(y(j)));
      across.row(j) << -along.y(), along.x();
      inward += y(n + j) * y(n + j) * along;
    }
    const Eigen::MatrixXd yielding = factor.solve(across);
    const Eigen::Matrix2d give = across.transpose() * yielding;
    bend += yielding * give.inverse() * (inward - across.transpose() * bend);
  }
  State dy(2 * n);
  dy << y.tail(n), bend;
  return dy;
}

State advance(const PlaneChain& chain, double time, int pieces) {
  return integrate([&](const State& y) { return rate(chain, y); }, chain.start, time, pieces);
}

Eigen::Vector2d centre(const PlaneChain& chain, const State& y, int link) {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  for (int j = 0; j <= link; j++) {
    const Link& l = chain.links[static_cast<std::size_t>(j)];
    position += (j < link ? l.length : l.centre) * Eigen::Vector2d(std::cos(y(j)), std::sin(y(j)));
  }
  return position;
}

double energy(const PlaneChain& chain, const State& y) {
  const Eigen::Index n = y.size() / 2;
  Eigen::Vector2d head = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < n; i++) {
    const Link& l = chain.links[static_cast<std::size_t>(i)];
    const Eigen::Vector2d along(std::cos(y(i)), std::sin(y(i))), across(-along.y(), along.x());
    const Eigen::Vector2d v = velocity + l.centre * y(n + i) * across;
    sum += 0.5 * l.mass * v.squaredNorm() + 0.5 * l.inertia * y(n + i) * y(n + i);
    sum += l.mass * chain.gravity * (head + l.centre * along).y();
    head += l.length * along;
    velocity += l.length * y(n + i) * across;
  }
  return sum;
}

// With d = a − b: 2 a'' + b'' cos d + b'² sin d + 2 g sin a = 0, b'' + a'' cos d − a'² sin d + g sin b = 0.
State double_pendulum(double time, int pieces) {
  const auto rate = [](const State& y) {
    const double g = 9.81, s = std::sin(y(0) - y(1)), c = std::cos(y(0) - y(1)), aa = y(2) * y(2), bb = y(3) * y(3);
    const double a = (-2 * g * std::sin(y(0)) - bb * s - aa * s * c + c * g * std::sin(y(1))) / (2 - c * c);
    State dy(4);
    dy << y(2), y(3), a, aa * s - a * c - g * std::sin(y(1));
    return dy;
  };
  State start(4);
  start << std::numbers::pi / 2, std::numbers::pi / 2, 0, 0;
  return integrate(rate, start, time, pieces);
}

// Euler 1765: I ω' = I ω × ω.
Eigen::Vector3d top(double time, int pieces) {
  const auto rate = [](const State& w) {
    State dw(3);
    dw << (2.0 - 3.0) / 1.0 * w(1) * w(2), (3.0 - 1.0) / 2.0 * w(2) * w(0), (1.0 - 2.0) / 3.0 * w(0) * w(1);
    return dw;
  };
  State start(3);
  start << 0.01, 1, 0.01;
  return integrate(rate, start, time, pieces);
}

// Euler 1765: I ω' = I ω × ω + R' τ, with q' = q (0, ω)/2.
State free_body(Eigen::Vector3d moments, Eigen::Vector3d spin, Eigen::Vector3d torque, double time, int pieces) {
  const auto rate = [&](const State& y) {
    const Eigen::Quaterniond q(y(0), y(1), y(2), y(3));
    const Eigen::Vector3d w = y.tail(3), L = moments.cwiseProduct(w);
    const Eigen::Quaterniond turning = q * Eigen::Quaterniond(0, w.x() / 2, w.y() / 2, w.z() / 2);
    State dy(7);
    dy << turning.w(), turning.vec(), (L.cross(w) + q.inverse() * torque).cwiseQuotient(moments);
    return dy;
  };
  State start(7);
  start << 1, 0, 0, 0, spin;
  return integrate(rate, start, time, pieces);
}

}  // namespace pantin::reference
