// Rates of trees against one sparse system of all their hinges.
#include "trees/tree.hpp"

#include <catch2/catch.hpp>

#include "support/random_tree.hpp"

using namespace pantin;

namespace {

/// A tree in the axes of its parts.
struct Made {
  Tree tree;
  TreeState state;
};

Vec3 vector_of(const Eigen::Vector3d& v) { return vec(v.x(), v.y(), v.z()); }

Made make(const cases::RandomTree& random) {
  std::vector<TreeNode> nodes;
  std::vector<TreeHinge> hinges;
  for (const cases::TreePart& part : random.parts) {
    TreeNode node{part.mass, vector_of(part.moments), zero3(), 0.5};
    for (int k = 0; k < 3; k++)
      if (node.inertia[k] > 0.0) node.inverse_inertia[k] = 1.0 / node.inertia[k];
    nodes.push_back(node);
  }
  const auto arm = [&](int part, int point) {
    return vector_of(random.parts[static_cast<std::size_t>(part)].points[static_cast<std::size_t>(point)]);
  };
  for (const cases::TreeTie& tie : random.ties)
    hinges.push_back({tie.a, tie.b, arm(tie.a, tie.point_a), tie.b >= 0 ? arm(tie.b, tie.point_b) : zero3()});
  Made made{make_tree(nodes, hinges), {}};
  made.state.resize(made.tree.batches.size());
  for (Rotation4& t : made.state) t = {{lanes(1.0), lanes(0.0), lanes(0.0), lanes(0.0)}, zero3x4()};
  const reference::Hinged all = cases::hinged(random);
  for (std::size_t i = 0; i < nodes.size(); i++) {
    const auto& q = random.parts[i].turn;
    Rotation4& t = made.state[made.tree.slots[i] / batch_size];
    const std::size_t lane = made.tree.slots[i] % batch_size;
    t.q.w[lane] = 3.0 * q.w();  // of any length
    t.q.x[lane] = 3.0 * q.x();
    t.q.y[lane] = 3.0 * q.y();
    t.q.z[lane] = 3.0 * q.z();
    set_lane(t.w, lane, vector_of(all.bodies[i].spin));
  }
  return made;
}

/// Largest difference of spins' rates from the reference's, relative to the largest of those.
double wrong(const cases::RandomTree& random) {
  const Made made = make(random);
  TreeWorkspace workspace;
  make_room(made.tree, workspace);
  TreeState rates;
  rates.resize(made.state.size());
  find_rates(made.tree, workspace, vec(0, -9.81, 0), made.state.data(), rates.data());
  const reference::Hinged all = cases::hinged(random);
  const reference::State exact = reference::rate(all, reference::start(all));
  double most = 0.0, size = 0.0;
  for (std::size_t i = 0; i < random.parts.size(); i++) {
    const Vec3 bend = vector_of(exact.segment<3>(13 * static_cast<Eigen::Index>(i) + 10));
    const std::uint32_t slot = made.tree.slots[i];
    most = std::max(most, norm(lane_of(rates[slot / batch_size].w, slot % batch_size) - bend));
    size = std::max(size, norm(bend));
  }
  return most / size;
}

}  // namespace

TEST_CASE("tree: rates are those that one system of all hinges gives") {
  Random random;
  for (int run = 0; run < 60; run++) {
    const int parts = run < 30 ? 1 + run : 2 + static_cast<int>(random.bits() % 199);
    const bool nailed = run % 2 == 0 || parts == 1;
    CAPTURE(run, parts, nailed);
    CHECK(wrong(cases::make_random_tree(random, {parts, nailed, 0})) <= 1e-10);
  }
}

TEST_CASE("tree: a hub of many hinges is one branch, with an arm for each") {
  Random random;
  const cases::RandomTree hub = cases::make_random_tree(random, {300, true, 250});
  CHECK(wrong(hub) <= 1e-10);
  const Made made = make(hub);
  std::size_t most = 0;
  for (const Tree::Branch& b : made.tree.branches) most = std::max<std::size_t>(most, b.last - b.first);
  CHECK(most >= 250);
  CHECK(made.tree.arms.size() <= 300);
}

TEST_CASE("tree: a chain is eliminated from both ends, and what all nodes do twice as fast is four times the rate") {
  std::vector<TreeNode> nodes(9, {1.0, vec(0.1, 0.1, 0.1), vec(10, 10, 10), 0.5});
  std::vector<TreeHinge> hinges;
  for (std::int32_t i = 0; i < 9; i++) hinges.push_back({i, i - 1, vec(-0.5, 0, 0), i > 0 ? vec(0.5, 0, 0) : zero3()});
  const Tree tree = make_tree(nodes, hinges);
  CHECK(tree.pairs.size() == 5);  // the last node, and four pairs of both sides
  for (std::size_t p = 2; p < tree.pairs.size(); p++) CHECK(tree.pairs[p].outer_is_pair);
  TreeWorkspace workspace;
  make_room(tree, workspace);
  TreeState state, rates;
  state.resize(tree.batches.size());
  rates.resize(tree.batches.size());
  for (Rotation4& t : state)
    t = {{lanes(1.0), lanes(0.0), lanes(0.0), lanes(0.0)}, {lanes(0.0), lanes(0.0), lanes(1.0)}};
  find_rates(tree, workspace, zero3(), state.data(), rates.data());
  const double once = largest_own_rate2(tree, workspace);
  for (Rotation4& t : state) t.w.z = lanes(2.0);
  find_rates(tree, workspace, zero3(), state.data(), rates.data());
  CHECK(largest_own_rate2(tree, workspace) == Approx(4.0 * once));
  CHECK(once >= 9 * 8 / 2);  // that the outer nodes pull at the nail with, by what a rod of these swings with
}
