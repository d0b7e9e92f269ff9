// The mechanisms that other engines are compared on are those of the references.
#include "peers/mechanism.hpp"

#include <catch2/catch.hpp>

#include "support/reference.hpp"

using namespace pantin;

namespace {

std::vector<peers::SolidState> at_rest(const peers::Mechanism& mechanism) {
  std::vector<peers::SolidState> state;
  for (const peers::SolidDef& solid : mechanism.solids)
    state.push_back({solid.at, solid.turn, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  return state;
}

const peers::Mechanism& named(const std::vector<peers::Mechanism>& all, const std::string& name) {
  for (const peers::Mechanism& m : all)
    if (m.name == name) return m;
  throw std::runtime_error("there is no " + name);
}

}  // namespace

TEST_CASE("mechanisms: all joints meet at the start") {
  for (const peers::Mechanism& mechanism : peers::mechanisms()) {
    CAPTURE(mechanism.name);
    CHECK(peers::largest_separation(mechanism, at_rest(mechanism)) <= 1e-13);
    CHECK(peers::kinetic_energy(mechanism, at_rest(mechanism)) == 0.0);
  }
}

TEST_CASE("mechanisms: start where the references do, with their energy") {
  const std::vector<peers::Mechanism> all = peers::mechanisms();
  const auto check = [&](const std::string& name, const reference::PlaneChain& plane) {
    CAPTURE(name);
    const peers::Mechanism& mechanism = named(all, name);
    const Eigen::Vector2d position = reference::centre(plane, plane.start, mechanism.measured);
    const Eigen::Vector3d& at = mechanism.solids[static_cast<std::size_t>(mechanism.measured)].at;
    CHECK((at - Eigen::Vector3d(position.x(), position.y(), 0)).norm() <= 1e-13);
    CHECK(peers::potential_energy(mechanism, at_rest(mechanism)) ==
          Approx(reference::energy(plane, plane.start)).epsilon(1e-13).margin(1e-10));
  };
  check("chain(10)", reference::plane_chain(10));
  check("heavy(10) 1:1000", reference::heavy_plane_chain(10, 1e3));
  check("ring(24)", reference::plane_ring(24));
}

TEST_CASE("mechanisms: separations and kinetic energies are those of the poses") {
  const std::vector<peers::Mechanism> all = peers::mechanisms();
  const peers::Mechanism& chain = named(all, "chain(10)");
  std::vector<peers::SolidState> state = at_rest(chain);
  state[4].position.y() += 0.3;
  CHECK(peers::largest_separation(chain, state) == Approx(0.3));
  state[4].velocity = {0, 2, 0};
  state[4].spin = {0, 0, 3};
  CHECK(peers::kinetic_energy(chain, state) == Approx(0.5 * 4 + 0.5 * 1.01 / 12 * 9));
}
