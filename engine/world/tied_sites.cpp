#include "world/tied_sites.hpp"

#include <Eigen/LU>

#include "articulates/articulate.hpp"
#include "articulates/project.hpp"
#include "world/forces.hpp"
#include "world/mover_momenta.hpp"

namespace pantin {

namespace {

const Attached& attached(const Forces& f, std::uint32_t site) { return f.attached[f.attached_of[site]]; }

Vec3 velocity_at(const Node& n, Vec3 r) { return n.p0 * n.inverse_mass + (n.turns ? cross(n.R0 * n.O0, r) : zero3()); }

void strike(const World& world, Node& n, Vec3 r, Vec3 impulse) {
  n.p0 = impulse;
  if (!n.turns) return;
  n.P0 = transposed_times(n.R0, world.plane.about(cross(r, impulse)));
  n.O0 = n.inverse_inertia * n.P0;
}

void stop(Articulate& a) {
  for (Node& n : a.nodes) n.p0 = n.P0 = n.O0 = zero3();
}

}  // namespace

TiedSites::TiedSites(World& world, const Forces& f, std::vector<std::uint32_t> list) : sites(std::move(list)) {
  const Mover& first = f.movers[attached(f, sites[0]).mover];
  Articulate copy = *world.articulates[static_cast<std::size_t>(first.articulate)];
  const auto node = [&](std::uint32_t site) -> Node& { return copy.nodes[f.movers[attached(f, site).mover].node]; };
  begin_answers(copy);
  for (std::uint32_t site : sites) velocity.push_back(velocity_at(node(site), attached(f, site).r));
  stop(copy);
  for (Node& n : copy.nodes) n.p0 = world.plane.along(world.settings.gravity) * n.mass;
  answer(copy);
  for (std::uint32_t site : sites) falling.push_back(velocity_at(node(site), attached(f, site).r));
  response.resize(sites.size() * sites.size());
  for (std::size_t j = 0; j < sites.size(); j++)
    for (int axis = 0; axis < 3; axis++) {
      Vec3 impulse = zero3();
      impulse[axis] = 1.0;
      stop(copy);
      strike(world, node(sites[j]), attached(f, sites[j]).r, world.plane.along(impulse));
      answer(copy);
      for (std::size_t i = 0; i < sites.size(); i++)
        response[i * sites.size() + j][axis] = velocity_at(node(sites[i]), attached(f, sites[i]).r);
    }
}

void TiedSites::read_velocities(World& world, const Forces& f, bool drifted) {
  for (std::size_t i = 0; i < sites.size(); i++) {
    const Attached& a = attached(f, sites[i]);
    const MoverMomenta m = momenta_of(world, f.movers[a.mover], drifted);
    velocity[i] = m.velocity() + cross(m.spin(), a.r);
  }
}

void TiedSites::solve(const std::vector<Vec3>& asked, const std::vector<Mat3>& slope, const std::vector<Vec3>& at,
                      const std::vector<Vec3>& others, double dt, double fall) {
  const std::size_t n = sites.size();
  const auto row = [](std::size_t i, int c) { return static_cast<Eigen::Index>(3 * i) + c; };
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(row(n, 0), row(n, 0));
  Eigen::VectorXd b(row(n, 0));
  for (std::size_t i = 0; i < n; i++) {
    Vec3 u = velocity[i] + falling[i] * fall - at[i];
    for (std::size_t j = 0; j < n; j++) {
      u += response[i * n + j] * others[j] * dt;
      const Mat3 felt = slope[i] * response[i * n + j] * dt;
      for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) A(row(i, k), row(j, c)) -= felt[c][k];
    }
    const Vec3 known = asked[i] + slope[i] * u;
    for (int k = 0; k < 3; k++) b(row(i, k)) = known[k];
  }
  const Eigen::VectorXd x = A.partialPivLu().solve(b);
  force.assign(n, zero3());
  moved = velocity;
  for (std::size_t i = 0; i < n; i++) moved[i] += falling[i] * fall;
  for (std::size_t j = 0; j < n; j++) force[j] = vec(x(row(j, 0)), x(row(j, 1)), x(row(j, 2)));
  for (std::size_t i = 0; i < n; i++)
    for (std::size_t j = 0; j < n; j++) moved[i] += response[i * n + j] * (others[j] + force[j]) * dt;
}

}  // namespace pantin
