#include "articulates/solve/tree_drift.hpp"

#include <algorithm>

#include "articulates/solve/drift.hpp"
#include "articulates/solve/energy_return.hpp"
#include "articulates/solve/state.hpp"
#include "articulates/solve/sub_steps.hpp"
#include "constraints/row_rule.hpp"
#include "trees/tree_steps.hpp"

namespace pantin {

namespace {

// Steps that stability may ask for in a stage, for each sub-step that the implicit step takes there: these cost more.
constexpr double most_per_stage = 2.0;
constexpr std::uint16_t stages_until_tree = 16;

/// Whether its rows are those of a tree: hinges and nails.
bool is_tree_of_hinges(const Articulate& a) {
  return a.loop_free && a.all_rigid && !a.plane.flat() && !a.rows.empty() &&
         std::all_of(a.rows.begin(), a.rows.end(), [](const Row& row) { return row.lever == 0.0; });
}

std::shared_ptr<const Tree> tree_of(const Articulate& a) {
  if (!is_tree_of_hinges(a)) return nullptr;
  std::vector<TreeNode> nodes;
  nodes.reserve(a.nodes.size());
  for (const Node& n : a.nodes) nodes.push_back({n.mass, n.inertia, n.turns ? n.inverse_inertia : zero3(), extent(n)});
  std::vector<TreeHinge> hinges;
  hinges.reserve(a.rows.size());
  for (const Row& row : a.rows) hinges.push_back({row.a, row.b, row.la, row.lb});
  return std::make_shared<const Tree>(make_tree(nodes, hinges));
}

/// Whether nothing that it is nailed to moves, and only gravity acts on its nodes.
bool only_gravity_acts(const Articulate& a, Vec3 gravity) {
  const auto stays = [](const Condition& c) {
    return same(c.whole0, c.whole1) && c.bent == Bent::nothing && norm2(c.velocity) == 0.0;
  };
  const auto falls = [&](const Node& n) { return same(n.force, gravity * n.mass) && norm2(n.torque) == 0.0; };
  return !is_open(a) && !a.torn && !a.has_offsets && !a.fell_back &&
         std::all_of(a.conditions.begin(), a.conditions.end(), stays) &&
         std::all_of(a.nodes.begin(), a.nodes.end(), falls);
}

/// Sums over the nodes.
struct TreeSums {
  double kinetic = 0.0;                              // [J]
  Vec3 momentum = zero3(), mass_position = zero3();  // [kg m/s], [kg m]
};
TreeSums sums_of(const Articulate& a) {
  TreeSums sums;
  for (const Node& n : a.nodes) {
    sums.kinetic += kinetic_energy(n);
    sums.momentum += n.p0;
    sums.mass_position += n.x0 * n.mass;
  }
  return sums;
}

const Node& node(const Articulate& a, std::int32_t i) { return a.nodes[static_cast<std::size_t>(i)]; }
Node& node(Articulate& a, std::int32_t i) { return a.nodes[static_cast<std::size_t>(i)]; }
Vec3 spin(const Node& n) { return n.R0 * n.spin0; }
Vec3 velocity(const Node& n) { return n.p0 * n.inverse_mass; }

/// Largest difference of velocities that a hinge forbids [m/s], and the largest speed.
struct Forbidden {
  double velocity = 0.0, fastest = 0.0;
};
Forbidden forbidden_of(const Articulate& a) {
  Forbidden f;
  for (const Tree::Placement& p : a.as_tree->placements) {
    const Node& child = node(a, p.child);
    Vec3 rate = velocity(child) + cross(spin(child), child.R0 * p.child_arm);
    if (p.parent >= 0) {
      const Node& parent = node(a, p.parent);
      rate -= velocity(parent) + cross(spin(parent), parent.R0 * p.parent_arm);
    }
    f.velocity = std::max(f.velocity, norm2(rate));
    f.fastest = std::max(f.fastest, norm2(velocity(child)));
  }
  return {std::sqrt(f.velocity), std::sqrt(f.fastest)};
}

/// The tree's velocities are those that no hinge forbids: what the implicit step left of others is taken out. The energy of
/// that goes to where the rest of the projection does.
void project_onto_tree(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  const Forbidden f = forbidden_of(a);
  if (f.velocity <= 1e-13 * f.fastest) return;
  const double before = kinetic_energy(a);
  make_start_consistent(a, settings.step, settings.from);
  report.energy_projected += kinetic_energy(a) - before;
  if (settings.energy_return) report.returned += return_energy(a, before, settings.gravity);
}

void read_nodes(Articulate& a) {
  TreeState& state = a.course.end;
  state.resize(a.as_tree->batches.size());
  for (Rotation4& t : state) t = {{lanes(1.0), lanes(0.0), lanes(0.0), lanes(0.0)}, zero3x4()};
  for (std::size_t i = 0; i < a.nodes.size(); i++) {
    const Node& n = a.nodes[i];
    if (!n.turns) continue;
    const std::uint32_t slot = a.as_tree->slots[i];
    Rotation4& t = state[slot / batch_size];
    const std::size_t lane = slot % batch_size;
    t.q.w[lane] = n.q0.w;
    t.q.x[lane] = n.q0.x;
    t.q.y[lane] = n.q0.y;
    t.q.z[lane] = n.q0.z;
    set_lane(t.w, lane, spin(n));
  }
  a.course.fresh = true;
}

void turn_nodes(Articulate& a, const TreeState& state) {
  for (std::size_t i = 0; i < a.nodes.size(); i++) {
    Node& n = a.nodes[i];
    if (!n.turns) continue;
    const std::uint32_t slot = a.as_tree->slots[i];
    const Rotation4& t = state[slot / batch_size];
    const std::size_t lane = slot % batch_size;
    n.q0 = {t.q.w[lane], t.q.x[lane], t.q.y[lane], t.q.z[lane]};
    n.R0 = matrix(n.q0);
    n.spin0 = transposed_times(n.R0, lane_of(t.w, lane));
    n.P0 = n.inertia * n.spin0;
  }
}

/// Puts the nodes where the hinges want them, and gives them the velocities that these leave.
void place_nodes(Articulate& a) {
  a.gaps = {};
  if (!a.as_tree->anchored) {
    a.nodes[0].x0 = zero3();
    a.nodes[0].p0 = zero3();
  }
  for (const Tree::Placement& p : a.as_tree->placements) {
    Row& row = a.rows[p.hinge];
    Node& child = node(a, p.child);
    Vec3 x, v = zero3();
    if (p.parent < 0) {
      x = condition(a, row).whole1;
    } else {
      const Node& parent = node(a, p.parent);
      const Vec3 r = parent.R0 * p.parent_arm;
      x = parent.x0 + r;
      v = velocity(parent) + cross(spin(parent), r);
    }
    const Vec3 r = child.R0 * p.child_arm;
    child.x0 = x - r;
    child.p0 = (v - cross(spin(child), r)) * child.mass;
    row.d1 = row.a == p.child ? child.x0 + r - x : x - (child.x0 + r);
    a.gaps.unaccepted = std::max(a.gaps.unaccepted, norm(row.d1));
  }
  a.gaps.points = a.residual = a.gaps.unaccepted;
}

/// Where nothing holds it, its centre falls.
void fall(Articulate& a, const TreeSums& before, Vec3 gravity, double h) {
  const TreeSums now = sums_of(a);
  const Vec3 v = (before.momentum - now.momentum) / a.total_mass + gravity * h;
  const Vec3 x =
      (before.mass_position - now.mass_position + before.momentum * h) / a.total_mass + gravity * (0.5 * h * h);
  for (Node& n : a.nodes) {
    n.x0 += x;
    n.p0 += v * n.mass;
  }
}

/// Mean forces of the hinges over h [s], by what momentum is beyond them. `before`: (nodes) [kg m/s].
void tell_forces(Articulate& a, std::vector<Vec3>& before, double h) {
  for (std::size_t i = 0; i < a.nodes.size(); i++) before[i] = (a.nodes[i].p0 - before[i]) / h - a.nodes[i].force;
  const std::vector<Tree::Placement>& placements = a.as_tree->placements;
  for (std::size_t k = placements.size(); k-- > 0;) {
    const Vec3 f = before[static_cast<std::size_t>(placements[k].child)];
    Row& row = a.rows[placements[k].hinge];
    row.f = row.a == placements[k].child ? f : -f;
    if (placements[k].parent >= 0) before[static_cast<std::size_t>(placements[k].parent)] += f;
  }
}

/// Whether stability asks for more steps than the error does, and than an implicit step is worth.
bool is_too_stiff(const Articulate& a, double own_rate2, double h, double most) {
  const double stable = stable_length(own_rate2);
  const double per_stage = h / stable;
  if (per_stage > sub_step_limit) return true;  // more than it may take
  if (per_stage <= most * a.sub_steps.count) return false;
  return !(a.course.next > 0.0) || a.course.next > 1.5 * stable;
}

/// Square of the rate that the rows' forces give the nodes.
double own_rate2_of_rows(const Articulate& a) {
  std::vector<double> sum(a.nodes.size(), 0.0);
  for (const Row& row : a.rows) {
    const auto add = [&](std::int32_t i, Vec3 l) {
      const Node& n = node(a, i);
      sum[static_cast<std::size_t>(i)] +=
          norm(row.f) * turn_per_force({n.mass, n.inertia, n.turns ? n.inverse_inertia : zero3(), 0.0}, l);
    };
    add(row.a, row.la);
    if (row.b >= 0) add(row.b, row.lb);
  }
  return *std::max_element(sum.begin(), sum.end());
}

/// Whether an articulate that the implicit step has moved is to go on by its tree.
bool may_enter(Articulate& a, double h) {
  if (a.stages_not_stiff == 0) return true;  // it never was too stiff
  a.stages_not_stiff = is_too_stiff(a, own_rate2_of_rows(a), h, 0.7 * most_per_stage)
                           ? std::uint16_t{1}
                           : static_cast<std::uint16_t>(a.stages_not_stiff + 1);
  return a.stages_not_stiff > stages_until_tree;
}

/// The implicit step has no history of what comes now.
void forget_implicit_step(Articulate& a) {
  a.factor_of = FactorOf::none;
  a.weak = a.sums_impulses = a.lowered = false;
  a.smooth = true;
  a.last_h = a.symmetric_h = a.exerted_time = a.moved_to = 0.0;
  a.by_tree = true;
  a.stages_not_stiff = 0;
}

}  // namespace

void find_tree(Articulate& a) {
  a.as_tree = tree_of(a);
  a.tree_sought = true;
}

bool drift_as_tree(Articulate& a, const DriftSettings& settings, double accuracy, TreeWorkspace& workspace,
                   DriftReport& report) {
  const bool goes_on = std::exchange(a.by_tree, false) && !a.edited;
  if (!a.tree_sought) find_tree(a);
  if (!a.as_tree || !only_gravity_acts(a, settings.gravity)) return false;
  const Tree& tree = *a.as_tree;
  const double h = settings.step * (settings.to - settings.from);
  TreeCost cost;
  if (!goes_on) {
    if (!may_enter(a, h)) return false;
    if (a.edited) {
      const EnergyOfConsistency gave = make_start_consistent(a, settings.step, settings.from);
      report.after_edit += gave.tied;
      report.limit += gave.stopped;
    }
    project_onto_tree(a, settings, report);
    read_nodes(a);
    begin_course(tree, workspace, a.course, settings.gravity, cost);
  }
  const StepControl control{accuracy * a.length, h / sub_step_limit, 32.0 * settings.step};
  if (is_too_stiff(a, a.course.own_rate2, h, most_per_stage) ||
      !advance(tree, workspace, a.course, h, settings.gravity, control, cost)) {
    a.stages_not_stiff = 1;
    report.evaluations += cost.evaluations;
    return false;
  }
  report.evaluations += cost.evaluations;
  if (cost.missed > 0.0) report.unreached = cost.missed / a.length;
  const bool summed = settings.ledger || !tree.anchored;
  const TreeSums before = summed ? sums_of(a) : TreeSums{};
  workspace.momenta.resize(a.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); i++) workspace.momenta[i] = a.nodes[i].p0;
  read_present(a.course, workspace.present);
  turn_nodes(a, workspace.present);
  place_nodes(a);
  if (!tree.anchored) fall(a, before, settings.gravity, h);
  tell_forces(a, workspace.momenta, h);
  if (settings.ledger) {
    const TreeSums now = sums_of(a);
    report.inexact += now.kinetic - before.kinetic - dot(settings.gravity, now.mass_position - before.mass_position);
  }
  forget_implicit_step(a);
  return true;
}

}  // namespace pantin
