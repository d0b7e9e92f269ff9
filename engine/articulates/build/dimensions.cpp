#include <algorithm>
#include <cmath>

#include "articulates/build/build.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/state.hpp"
#include "constraints/kind.hpp"
#include "constraints/stiff.hpp"

namespace pantin {

namespace {

/// Calls visit(node, arm) for both ends of all rows; the arm of an angular row is infinite about all axes.
template <class Visit>
void each_end(Articulate& a, Visit visit) {
  const Vec3 all = vec(infinity, infinity, infinity);
  for (const Row& row : a.rows) {
    visit(a.nodes[static_cast<std::size_t>(row.a)], row.lever > 0.0 ? all : row.la);
    if (row.b >= 0) visit(a.nodes[static_cast<std::size_t>(row.b)], row.lever > 0.0 ? all : row.lb);
  }
}

/// Clears `felt_axes` about the axis of symmetry that all arms lie on.
void find_free_axes(Articulate& a) {
  for (Node& n : a.nodes) n.felt_axes = zero3();
  each_end(a, [](Node& n, Vec3 arm) {
    const Vec3 l = vec(std::fabs(arm[0]), std::fabs(arm[1]), std::fabs(arm[2]));
    const double least = 1e-9 * n.reach;
    for (int axis = 0; axis < 3; axis++)
      if (std::fmax(l[(axis + 1) % 3], l[(axis + 2) % 3]) > least) n.felt_axes[axis] = 1.0;
  });
  for (Node& n : a.nodes) {
    if (!n.turns) n.felt_axes = zero3();
    for (int axis = 0; axis < 3 && n.turns; axis++) {
      const double x = n.inertia[(axis + 1) % 3], y = n.inertia[(axis + 2) % 3];
      if (std::fabs(x - y) > 1e-9 * std::fmax(x, y)) n.felt_axes[axis] = 1.0;
    }
  }
}

/// Whether the rows make no loop; the world counts as one node, and an angular row beside one between points makes none.
bool is_loop_free(const Articulate& a) {
  if (!a.couplings.empty()) return false;
  const bool anchored = std::any_of(a.rows.begin(), a.rows.end(), [](const Row& row) { return row.b < 0; });
  const auto angular_rows_count =
      std::count_if(a.rows.begin(), a.rows.end(), [](const Row& r) { return r.lever > 0.0; });
  const std::size_t edges = a.nodes.size() - (anchored ? 0 : 1);
  if (angular_rows_count == 0) return a.rows.size() == edges;
  std::vector<std::pair<std::int32_t, std::int32_t>> points, turns;
  for (const Row& row : a.rows) (row.lever > 0.0 ? turns : points).push_back(std::minmax(row.a, row.b));
  std::sort(turns.begin(), turns.end());
  if (std::adjacent_find(turns.begin(), turns.end()) != turns.end()) return false;
  std::sort(points.begin(), points.end());
  const auto alone = std::count_if(turns.begin(), turns.end(), [&](const auto& pair) {
    return !std::binary_search(points.begin(), points.end(), pair);
  });
  return points.size() + static_cast<std::size_t>(alone) == edges;
}

/// Radius of gyration; 0 of what does not turn.
double gyration(const Node& n) { return n.turns ? std::sqrt(largest(n.inertia) * n.inverse_mass) : 0.0; }

std::vector<double> lengths_of(const Articulate& a, const Model& model) {
  constexpr double round_off = 1e-9;  // of a body's size: a point that is meant to be its centre
  std::vector<double> lengths;
  lengths.reserve(2 * a.rows.size());
  for (const Row& row : a.rows) {
    if (row.condition >= 0 && !pulls_by_law(row)) {
      const Constraint& c = model.constraints[condition(a, row).constraint];
      if (const double size = size_of(c); size > 0.0) lengths.push_back(size);
    }
    if (pulls_by_law(row)) lengths.push_back(condition(a, row).stiff->first_length());
    if (row.lever > 0.0) {
      lengths.push_back(row.lever);
      continue;
    }
    const auto add_arm = [&](std::int32_t node, Vec3 arm) {
      const double size = gyration(a.nodes[static_cast<std::size_t>(node)]);
      if (norm(arm) > round_off * size) lengths.push_back(norm(arm));
    };
    add_arm(row.a, row.la);
    if (row.b >= 0) add_arm(row.b, row.lb);
  }
  return lengths;
}

/// Of what turns about its centre alone: the largest radius of gyration; 0 where nothing turns.
double largest_gyration(const Articulate& a) {
  double size = 0.0;
  for (const Node& n : a.nodes) size = std::max(size, gyration(n));
  return size;
}

/// The median arm.
double median_length(const Articulate& a, const Model& model) {
  std::vector<double> lengths = lengths_of(a, model);
  if (lengths.empty()) return largest_gyration(a);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

void find_reaches(Articulate& a) {
  for (Node& node : a.nodes) node.reach = 0.1 * a.length;
  for (const Row& row : a.rows) {
    double& ra = a.nodes[static_cast<std::size_t>(row.a)].reach;
    ra = std::max(ra, row.lever > 0.0 ? row.lever : norm(row.la));
    if (row.b < 0) continue;
    double& rb = a.nodes[static_cast<std::size_t>(row.b)].reach;
    rb = std::max(rb, row.lever > 0.0 ? row.lever : norm(row.lb));
  }
}

}  // namespace

void find_dimensions(Articulate& a, const Model& model) {
  for (const Row& row : a.rows) {
    a.all_rigid = a.all_rigid && is_rigid(row);
    a.angular = a.angular || row.lever > 0.0;
    a.soft_constraint = a.soft_constraint || (is_soft(row) && !pulls_by_law(row));
    if (pulls_by_law(row)) a.nonconservative = a.nonconservative || condition(a, row).stiff->is_nonconservative();
  }
  const auto draws = [](const Row& row) { return row.rule->at_distance; };
  a.attracts = std::any_of(a.rows.begin(), a.rows.end(), draws) && is_free(a);
  a.forbids_nothing = std::all_of(a.rows.begin(), a.rows.end(), is_soft);
  a.length = median_length(a, model);
  if (a.length == 0.0) a.length_of_motion = 0.0;
  for (const Node& node : a.nodes) a.total_mass += node.mass;
  find_reaches(a);
  find_free_axes(a);
  a.loop_free = is_loop_free(a);
  if (a.loop_free) a.least_epsilon = a.most_epsilon = 1e-16;
  a.epsilon = std::min(a.epsilon, a.most_epsilon);
}

namespace {

constexpr double steps_of_motion = 256.0;

void set_length_of_motion(Articulate& a, double length) {
  a.length_of_motion = length;
  a.length = length > 0.0 ? length : 1.0;
  find_reaches(a);
}

}  // namespace

void find_length_of_motion(Articulate& a, const Model& model, Vec3 gravity, double step) {
  constexpr double round_off = 1e-6;
  double length = std::max((1.0 - 1.0 / steps_of_motion) * *a.length_of_motion, norm(gravity) * step * step);
  for (Node n : a.nodes) {
    load(n, model, gravity);
    length = std::max({length, round_off * norm(n.x0), steps_of_motion * step * norm(n.p0) * n.inverse_mass});
  }
  set_length_of_motion(a, length);
}

void grow_length_of_motion(Articulate& a, double step) {
  double length = *a.length_of_motion;
  for (const Node& n : a.nodes) length = std::max(length, step * norm(n.p0) * n.inverse_mass);
  if (length > *a.length_of_motion) set_length_of_motion(a, length);
}

}  // namespace pantin
