#include "peers/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pantin::peers {

namespace {

const Eigen::Vector3d head(-0.5, 0, 0), tail(0.5, 0, 0);

/// Unit rods along x from the origin, the first nailed there.
Mechanism chain(int links) {
  Mechanism made;
  made.name = "chain(" + std::to_string(links) + ")";
  for (int i = 0; i < links; i++) {
    SolidDef rod;
    rod.at = {i + 0.5, 0, 0};
    made.solids.push_back(rod);
    made.joints.push_back({i - 1, i, i > 0 ? tail : Eigen::Vector3d(0, 0, 0), head, false});
  }
  made.measured = links - 1;
  return made;
}

/// The same with a solid sphere of radius 0.5 m jointed at its surface.
Mechanism heavy(int links, double ratio, double compare_at) {
  Mechanism made = chain(links);
  made.name = "heavy(" + std::to_string(links) + ") 1:" + std::to_string(std::lround(ratio));
  SolidDef sphere;
  sphere.mass = ratio;
  sphere.moments.setConstant(0.4 * ratio * 0.25);
  sphere.at = {links + 0.5, 0, 0};
  made.solids.push_back(sphere);
  made.joints.push_back({links - 1, links, tail, head, false});
  made.measured = links;
  made.compare_at = compare_at;
  return made;
}

/// A closed regular polygon of unit rods, nailed at its top; rods follow each other from there.
Mechanism ring(int links) {
  const double pi = std::numbers::pi;
  Mechanism made;
  made.name = "ring(" + std::to_string(links) + ")";
  Eigen::Vector3d corner(0, 0, 0);
  for (int i = 0; i < links; i++) {
    SolidDef rod;
    const double angle = pi + 2 * pi * (i + 0.5) / links;
    rod.turn = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
    rod.at = corner + 0.5 * along;
    corner += along;
    made.solids.push_back(rod);
    made.joints.push_back({i - 1, i, i > 0 ? tail : Eigen::Vector3d(0, 0, 0), head, false});
  }
  made.joints.push_back({links - 1, 0, tail, head, true});
  made.measured = links / 2 - 1;
  return made;
}

}  // namespace

std::vector<Mechanism> mechanisms() {
  return {chain(10), chain(100), heavy(10, 1e3, 1.0), heavy(19, 5e4, 2.0), ring(24)};
}

double kinetic_energy(const Mechanism& mechanism, const std::vector<SolidState>& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); i++) {
    const SolidDef& solid = mechanism.solids[i];
    const Eigen::Vector3d spin = state[i].turn.conjugate() * state[i].spin;
    sum += 0.5 * solid.mass * state[i].velocity.squaredNorm() + 0.5 * spin.dot(solid.moments.cwiseProduct(spin));
  }
  return sum;
}

double potential_energy(const Mechanism& mechanism, const std::vector<SolidState>& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); i++) sum += mechanism.solids[i].mass * gravity * state[i].position.y();
  return sum;
}

double largest_separation(const Mechanism& mechanism, const std::vector<SolidState>& state) {
  const auto end = [&](int solid, const Eigen::Vector3d& at) -> Eigen::Vector3d {
    if (solid < 0) return at;
    const SolidState& s = state[static_cast<std::size_t>(solid)];
    return s.position + s.turn * at;
  };
  double largest = 0.0;
  for (const BallJoint& joint : mechanism.joints)
    largest = std::max(largest, (end(joint.a, joint.at_a) - end(joint.b, joint.at_b)).norm());
  return largest;
}

}  // namespace pantin::peers
