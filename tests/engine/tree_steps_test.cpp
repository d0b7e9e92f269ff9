// Steps of trees: order, error, and what is between.
#include "trees/tree_steps.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace pantin;

namespace {

const Vec3 g = vec(0, -9.81, 0);

/// Unit rods in a row, each turned against the last so that they leave every plane.
struct Crooked {
  Tree tree;
  TreeWorkspace workspace;
  TreeCourse course;

  explicit Crooked(std::int32_t links) {
    std::vector<TreeNode> nodes;
    std::vector<TreeHinge> hinges;
    for (std::int32_t i = 0; i < links; i++) {
      nodes.push_back({1.0, vec(0.02, 0.08, 0.09), 1.0 / vec(0.02, 0.08, 0.09), 0.5});
      nodes.back().inverse_inertia[3] = 0.0;
      hinges.push_back({i, i - 1, vec(-0.5, 0, 0), i > 0 ? vec(0.5, 0.1, 0) : zero3()});
    }
    tree = make_tree(nodes, hinges);
    make_room(tree, workspace);
    course.end.resize(tree.batches.size());
    for (Rotation4& t : course.end) t = {{lanes(1.0), lanes(0.0), lanes(0.0), lanes(0.0)}, zero3x4()};
    for (std::int32_t i = 0; i < links; i++) {
      const std::uint32_t k = tree.slots[static_cast<std::size_t>(i)];
      Rotation4& t = course.end[k / batch_size];
      const double c = std::cos(0.2 * i), s = std::sin(0.2 * i);
      t.q.w[k % batch_size] = c;
      t.q.y[k % batch_size] = s;
    }
    TreeCost cost;
    begin_course(tree, workspace, course, g, cost);
  }

  TreeCost move(double time, const StepControl& control) {
    TreeCost cost;
    REQUIRE(advance(tree, workspace, course, time, g, control, cost));
    return cost;
  }
  TreeState now() const {
    TreeState state;
    read_present(course, state);
    return state;
  }
};

double difference(const TreeState& a, const TreeState& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) {
    const Quatx4 &p = a[i].q, &q = b[i].q;
    const Lanes turn =
        (p.w - q.w) * (p.w - q.w) + (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z);
    most = std::max(most, std::sqrt(largest_lane(turn)));
  }
  return most;
}

TreeState after(double time, const StepControl& control) {
  Crooked c(5);
  c.move(time, control);
  return c.now();
}

TreeState by_steps(double time, int steps) {
  Crooked c(5);
  const double h = time / steps;
  for (int i = 0; i < steps; i++) {
    c.course.next = h;
    c.course.fresh = true;  // no step goes past what was asked
    c.move(h, {1e3, h, h});
  }
  return c.now();
}

}  // namespace

TEST_CASE("tree_steps: steps are of order 8") {
  const TreeState exact = after(0.5, {1e-13, 1e-5, 1.0});
  const double coarse = difference(by_steps(0.5, 8), exact), fine = difference(by_steps(0.5, 16), exact);
  CAPTURE(coarse, fine);
  CHECK(coarse <= 1e-6);
  CHECK(std::log2(coarse / fine) >= 7.5);
  CHECK(std::log2(coarse / fine) <= 10.0);
}

TEST_CASE("tree_steps: what is between the ends of steps is of order 7 or more") {
  const TreeState exact = after(0.19, {1e-13, 1e-5, 1.0});
  const auto wrong = [&](double h) {
    Crooked c(5);
    c.course.next = h;
    c.course.fresh = false;
    c.move(0.19, {1e3, h, h});
    CHECK(c.course.ahead > 0.0);
    return difference(c.now(), exact);
  };
  const double coarse = wrong(0.04), fine = wrong(0.02);
  CAPTURE(coarse, fine);
  CHECK(coarse <= 1e-7);
  CHECK(std::log2(coarse / fine) >= 6.5);
}

TEST_CASE("tree_steps: the error is as asked, whenever somebody asks where all is") {
  const TreeState exact = after(1.0, {1e-12, 1e-5, 1.0});
  for (const double wanted : {1e-3, 1e-6, 1e-9}) {
    CAPTURE(wanted);
    Crooked rarely(5), often(5);
    const StepControl control{wanted, 1e-5, 1.0};
    std::uint32_t few = 0, many = 0;
    for (int i = 0; i < 10; i++) few += rarely.move(0.1, control).evaluations;
    for (int i = 0; i < 1000; i++) many += often.move(0.001, control).evaluations;
    CHECK(difference(rarely.now(), exact) <= 10.0 * wanted);
    CHECK(difference(often.now(), exact) <= 10.0 * wanted);
    CHECK(many <= 1.4 * few);
  }
}

TEST_CASE("tree_steps: a step that may not be shorter is taken and told") {
  Crooked c(5);
  const TreeCost cost = c.move(0.5, {1e-9, 0.05, 1.0});
  CHECK(cost.missed > 1e-9);
  CHECK(cost.missed < 1.0);
}

TEST_CASE("tree_steps: what is not a number is not taken for one") {
  Crooked c(5);
  c.course.end[0].w.x[0] = std::nan("");
  TreeCost cost;
  begin_course(c.tree, c.workspace, c.course, g, cost);
  CHECK_FALSE(advance(c.tree, c.workspace, c.course, 0.1, g, {1e-6, 1e-3, 1.0}, cost));
}
