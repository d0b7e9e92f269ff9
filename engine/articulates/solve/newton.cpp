// Newton's iteration on rotations and row forces together, with line backtracking, on a factor that is
// kept while it serves, with a compliance that adapts. Sizes of residuals are lengths in metres.
#include "articulates/solve/newton.hpp"
#include "articulates/fetch.hpp"
#include "articulates/solve/prediction.hpp"

#include <algorithm>
#include <limits>

#include "articulates/solve/angular_rows.hpp"
#include "articulates/solve/couplings.hpp"
#include "articulates/solve/matrix.hpp"
#include "articulates/solve/midpoint.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/state.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/stiff.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t most_iterations = 40, most_line_halvings = 6;

const Node& first(const Articulate& a, const Row& row) { return a.nodes[static_cast<std::size_t>(row.a)]; }
const Node& second(const Articulate& a, const Row& row) { return a.nodes[static_cast<std::size_t>(row.b)]; }

/// Where the rows' ends are, at the end of the step.
void place_row_at_end(Articulate& a, std::size_t k) {
  Row& row = a.rows[k];
  if (row.lever > 0.0) return place_angular_row_at_end(a, row);
  row.d1 = a.at_ends[2 * k] - (row.b >= 0 ? a.at_ends[2 * k + 1] : condition(a, row).position1);
}

Vec3x4 mean_arm(const RowEnds& end) { return (end.r0 + end.r1) * 0.5; }

/// What the unknowns, once set, make of a batch; hands the rows its positions. Returns the squares of the residuals [m²].
Lanes place_batch(Articulate& a, std::size_t b, double h) {
  NodeBatch& n = a.batches[b];
  const auto ends = ends_of(a, n);
  turn_arms(n, ends);
  RowLoad load{zero3x4(), zero3x4()};
  for (const RowEnds& end : ends)
    add_load(load, end, fetch(end, [&](std::uint32_t k) { return a.rows[k].f; }), mean_arm(end));
  const Lanes size2 = evaluate(n, load, h);
  for (const RowEnds& end : ends) scatter_to_rows(a, end, n.x1 + end.r1);
  if (a.angular) tell_positions(a, b);  // angular rows are placed from the nodes, not from what ends hand over
  return size2;
}

/// Places batches and rows, and finds the largest residual.
class Evaluation {
 public:
  Evaluation(Articulate& a, double h) : a_(a), h_(h) {}

  /// Once its unknowns and the forces of its rows are set.
  void batch(std::size_t b) {
    const Lanes size2 = place_batch(a_, b, h_);
    largest2_ = larger(size2, largest2_);
    not_finite_ += size2 * 0.0;
  }
  /// Once its batches are placed.
  void row(std::size_t k) {
    Row& row = a_.rows[k];
    place_row_at_end(a_, k);
    if (!is_rigid(row)) return raise(worst_, residual(a_, row, h_));
    row.residual = a_.has_offsets ? row.d1 - row.offset : row.d1;
    raise(worst2_, norm2(row.residual));
  }
  /// Once all are; returns the largest residual [m].
  double end() {
    if (!a_.couplings.empty()) raise(worst_, evaluate_couplings(a_, h_));
    a_.residual = std::sqrt(worst2_);
    if (!(largest_lane(not_finite_) == 0.0)) return infinity;
    return std::max(worst_, std::sqrt(std::max(worst2_, largest_lane(largest2_))));
  }

 private:
  static void raise(double& worst, double r) { worst = r <= worst ? worst : std::isfinite(r) ? r : infinity; }

  Articulate& a_;
  double h_;
  Lanes largest2_ = lanes(0.0),
        not_finite_ = lanes(0.0);  // of the latter 0, or not a number where a rotation is not finite
  double worst2_ = 0.0, worst_ = 0.0;
};

/// Finds states and residuals of unknowns that set_row(k) and set_batch(b) set; returns the largest residual [m].
template <class SetRow, class SetBatch>
double evaluate(Articulate& a, double h, SetRow set_row, SetBatch set_batch) {
  Evaluation evaluation(a, h);
  Tile done;
  for (const Tile& tile : a.tiles) {
    for (; done.forces < tile.forces; done.forces++) set_row(done.forces);
    for (; done.batches < tile.batches; done.batches++) {
      Fetch::some();
      set_batch(done.batches);
      evaluation.batch(done.batches);
    }
    for (; done.rows < tile.rows; done.rows++) evaluation.row(done.rows);
  }
  return evaluation.end();
}

/// Moves the unknowns from their saved values by a fraction of the direction: forces in `right_side`, rotations in
/// `d_cayley`. Returns the largest residual there [m].
double evaluate_along(Articulate& a, double h, double fraction) {
  return evaluate(
      a, h, [&](std::size_t k) { a.rows[k].f = a.f_saved[k] + a.right_side[k] * fraction; },
      [&](std::size_t b) {
        NodeBatch& n = a.batches[b];
        n.cayley = n.cayley_saved + n.d_cayley * fraction;
      });
}

/// The residual that counts as solved, and the size of its round-off, [m].
struct Goal {
  double tolerance, round_off;

  /// Whether what is left is kept where nothing gains any more.
  bool accepts(double e) const { return e <= 100.0 * tolerance; }
};

/// Where the iteration begins: predicted unknowns. Returns their largest residual [m].
double start_iteration(Articulate& a, double h, Vec3 gravity, Goal& goal) {
  Prediction prediction(a, h);
  Largest of_nodes;
  const double e = evaluate(
      a, h, [&](std::size_t k) { prediction.row(k); },
      [&](std::size_t b) {
        begin(a, b, h, of_nodes);
        prediction.batch(b);
      });
  prediction.end();
  const double speed2 = std::max(norm(gravity) * a.length, largest_lane(of_nodes.speed2));
  double largest = std::max(a.length, largest_lane(of_nodes.position));
  for (const Condition& c : a.conditions) largest = std::fmax(largest, c.extent);
  goal.round_off = 8e-16 * largest;
  const double wanted = std::min(3e-11 * std::fabs(h) * std::sqrt(speed2), 5e-11 * a.length);
  goal.tolerance = std::max(wanted, goal.round_off);
  return e;
}

/// The change of the rotations that goes with that of the rows' forces, and which they start from; returns its square.
Lanes find_change(Articulate& a, NodeBatch& n, double h) {
  RowLoad load{zero3x4(), zero3x4()};
  for (const RowEnds& end : ends_of(a, n))
    add_load(load, end, fetch(end, [&](std::uint32_t k) { return a.right_side[k]; }), mean_arm(end));
  const Vec3x4& tau = load.torque;
  n.cayley_saved = n.cayley;
  n.d_cayley = n.own_d_cayley + n.J_inverse * (tau - cross(n.cayley, tau) * 0.5) * h;
  return norm2(n.d_cayley);
}

/// Whether all nodes of a row are in batch b or later ones, through which a sweep against the order has been.
bool is_swept(const Row& row, std::size_t b) {
  const std::int32_t earlier = row.b < 0 ? row.a : std::min(row.a, row.b);
  return static_cast<std::size_t>(earlier) >= b * batch_size;
}

/// Of a direction, and the residual [m] after all of it.
struct FullNewtonStep {
  double largest_turn, residual;
};

/// Finishes the direction from the half solved right side, forces in `right_side` and rotations in `d_cayley`, and moves the
/// unknowns along it, from values that it saves: all in one sweep against the order of elimination.
FullNewtonStep take_direction(Articulate& a, double h) {
  Lanes largest_turn = lanes(0.0);
  Evaluation evaluation(a, h);
  std::size_t b = a.batches.size(), placed = a.rows.size();
  solve_hubs(a);
  for (std::size_t k = a.rows.size(); k-- > 0;) {
    a.factor.substitute_back(static_cast<std::uint32_t>(k), a.right_side.data());
    Vec3& f = a.rows[k].f;
    a.f_saved[k] = f;
    f += a.right_side[k];
    for (; b > 0 && a.batches[b - 1].first_row == k; b--) {
      NodeBatch& n = a.batches[b - 1];
      largest_turn = larger(find_change(a, n, h), largest_turn);
      n.cayley += n.d_cayley;
      evaluation.batch(b - 1);
    }
    for (; placed > 0 && is_swept(a.rows[placed - 1], b); placed--) evaluation.row(placed - 1);
  }
  return {std::sqrt(largest_lane(largest_turn)), evaluation.end()};
}

void lower_epsilon(Articulate& a, bool at_once) {
  a.epsilon = at_once ? a.least_epsilon : std::max(a.least_epsilon, 0.1 * a.epsilon);
  a.good_steps = 0;
  if (!a.lowered) a.wait = std::min(2 * a.wait, 2000u);
  a.lowered = true;
}

/// What a search along a line left [m], and whether it found what it looked for.
struct Search {
  double residual;
  bool found;
};

/// One damped Newton step along the direction in the nodes and rows.
Search search_line(Articulate& a, double h, double e, double tolerance, bool new_factor, std::uint32_t most_cost,
                   DriftReport& report) {
  const FullNewtonStep full = take_direction(a, h);
  double fraction = std::min(1.0, 1.0 / full.largest_turn);
  for (std::uint32_t halvings = 0;; halvings++) {
    const double e1 = fraction == 1.0 ? full.residual : evaluate_along(a, h, fraction);
    report.iterations++;
    const bool accepted = e1 < e * (1.0 - 0.1 * fraction) || e1 <= tolerance;
    if (accepted || halvings >= most_line_halvings || cost(report) > most_cost || (!new_factor && halvings == 0))
      return {e1, accepted};
    fraction *= 0.5;
  }
}

/// The factor at hand.
struct FactorUse {
  int uses = 0;            // since it was made
  double reduction = 1.0;  // e1/e of the last one; 1 where it serves no more

  bool is_new() const { return uses == 1; }
  /// Whether it is to be used again, at a residual e [m].
  bool serves(double e, double tolerance) const {
    constexpr double kept = 0.1, kept_at_first = 0.5;
    return reduction <= kept || (reduction <= kept_at_first && uses <= 2) ||
           (reduction < 1.0 && e * reduction <= tolerance);
  }
  /// Near the end an old factor often gains nothing at first, and much the next time: whether that is to be seen, once its
  /// first use as an old one was from e [m]. It serves then.
  bool try_again(double e, double length) {
    constexpr double most_lost = 4.0, near_end = 1e-6, serves_again = 0.5;
    if (uses != 2 || !(reduction < most_lost) || !(e < near_end * length)) return false;
    reduction = std::min(reduction, serves_again);
    return true;
  }
};

/// Searches in a row along directions of new factors: that accepted nothing, and that gained less than a tenth.
struct Setbacks {
  int vain = 0, slow = 0;

  void count(const FactorUse& factor, bool found) {
    const int more = factor.is_new() ? 1 : 0;
    vain = found ? 0 : vain + more;
    slow = factor.reduction > 0.9 ? slow + more : 0;
  }
  /// Once more would not help.
  bool end(bool lowered) const {
    constexpr int most = 2;
    return vain == most || (lowered && slow == most);
  }
};

/// Takes the right side through the forward substitution of the factor at hand, or of a new one where that does not serve.
void start_direction(Articulate& a, double h, double e, double tolerance, FactorUse& factor, DriftReport& report) {
  const System system{
      .right = Arms::mean, .epsilon = a.epsilon, .times_C = 2.0 / (h * h), .times_residual = -2.0 / (h * h), .h = h};
  if (factor.serves(e, tolerance)) {
    factor.uses++;
    return reuse_factor(a, system);
  }
  factor.uses = 1;
  a.weak = factorise(a, system) && !a.loop_free;
  a.factor_of = FactorOf::newton;
  report.factorisations++;
}

/// From predicted unknowns; false where it does not converge, or costs more than may be spent.
bool iterate(Articulate& a, double h, Vec3 gravity, DriftReport& report) {
  constexpr double rough = 0.03, near = 1e-4;  // of the length: a bad prediction; so near that ε may be to blame
  constexpr double poor = 0.2;                 // e1/e of a new factor with too large an ε
  constexpr double of_round_off = 10.0;
  a.lowered = false;
  const std::uint32_t most_cost = cost(report) + a.effort.spare;  // above it, it gives up
  Goal goal{};
  double e = start_iteration(a, h, gravity, goal);
  a.predictor.rough = e > rough * a.length;
  // A prediction must be better than what an iteration leaves: what rests is to stay at rest.
  double enough = std::max(0.01 * goal.tolerance, goal.round_off);
  FactorUse factor;
  Setbacks setbacks;
  for (std::uint32_t i = 0; e > enough && i < most_iterations && cost(report) <= most_cost; i++) {
    enough = goal.tolerance;
    start_direction(a, h, e, goal.tolerance, factor, report);
    const auto [e1, found] = search_line(a, h, e, goal.tolerance, factor.is_new(), most_cost, report);
    factor.reduction = e1 / e;
    setbacks.count(factor, found);
    if (setbacks.end(a.lowered) && !goal.accepts(e1)) return false;
    if (factor.try_again(e, a.length)) {
      e = e1;
      continue;
    }
    const bool gained = e1 < e;
    const double start = gained ? e : evaluate_along(a, h, 0.0);  // this with J as it is now
    e = gained ? e1 : start;
    if (!gained) factor.reduction = 1.0;
    if (!factor.is_new() || factor.reduction <= poor) continue;
    if (gained ? e < of_round_off * goal.round_off : goal.accepts(e)) break;
    if (start < near * a.length && a.epsilon > a.least_epsilon) {
      lower_epsilon(a, !found);
      factor.reduction = 1.0;
      setbacks.vain = 0;
    } else if (!gained) {
      break;
    }
  }
  return goal.accepts(e);
}

/// Whether the position of its condition, which may move, says where its first point is to be.
bool keeps_to_position(const Row& row) { return row.b < 0 || row.rule->keeps_separation; }

/// Velocity of a point at the start, [m/s].
Vec3 start_velocity(const Node& n, Vec3 l) {
  return n.p0 * n.inverse_mass + (n.turns ? n.R0 * cross(n.spin0, l) : zero3());
}

}  // namespace

void find_solved_gaps(Articulate& a) {
  if (!a.all_rigid || a.angular || a.has_offsets) return measure_gaps(a);
  a.gaps = {a.residual, 0.0, a.residual};
}

void place_rows_at_start(Articulate& a) {
  for (std::size_t b = 0; b < a.batches.size(); b++) place_at_start(a, b);
  if (a.all_rigid && !a.angular) return;
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    Row& row = a.rows[k];
    if (row.lever > 0.0) {
      place_angular_row_at_start(a, row);
      continue;
    }
    row.d0 = a.at_ends[2 * k] - (row.b >= 0 ? a.at_ends[2 * k + 1] : condition(a, row).position0);
    if (!pulls_by_law(row)) continue;
    Vec3 v = start_velocity(first(a, row), row.la);
    if (row.b >= 0) v -= start_velocity(second(a, row), row.lb);
    start_stiff(*condition(a, row).stiff, row, dot(row.d0, v));
  }
}

void place_rows_at_end(Articulate& a) {
  for (std::size_t b = 0; b < a.batches.size(); b++) place_at_end(a, b);
  for (std::size_t k = 0; k < a.rows.size(); k++) { place_row_at_end(a, k); }
}

void add_unsolved_work(const Articulate& a, double h, DriftReport& report) {
  const auto turn_of = [&](std::size_t k) { return lane_of(a.batches[k / batch_size].cayley, k % batch_size); };
  // Not as a difference of positions, which has no digits of what rests.
  const auto moved = [&](std::int32_t node, Vec3 l) {
    const auto k = static_cast<std::size_t>(node);
    const Node &n = a.nodes[k], &start = a.saved[k];
    const Vec3 by = (start.p0 + n.p0) * (0.5 * h * n.inverse_mass);
    return n.turns ? by + cross(turn_of(k), (start.R0 * l + n.R0 * l) * 0.5) : by;
  };
  for (const Row& r : a.rows) {
    const double size = std::max(largest(first(a, r).x0), norm(r.d1));
    report.round_off += std::numeric_limits<double>::epsilon() * norm(r.f) * size;
    const bool does_work = r.condition >= 0 && condition(a, r).works_along_d;
    if (pulls_by_law(r) || (does_work && r.lever > 0.0)) continue;
    if (r.lever > 0.0) {
      report.unsolved += work_of_angular_row(a, r);
      continue;
    }
    const Vec3 position = keeps_to_position(r) ? condition(a, r).position1 - condition(a, r).position0 : zero3();
    const Vec3 by = moved(r.a, r.la) - (r.b >= 0 ? moved(r.b, r.lb) : zero3()) - position;
    report.unsolved += dot(r.f, does_work ? by - (r.d1 - r.d0) : by);
  }
  for (std::size_t i = 0; i < a.nodes.size(); i++) {
    const Node &n = a.nodes[i], &start_of = a.saved[i];
    if (!n.turns) continue;
    const Vec3 spin = (start_of.spin0 + n.spin0) * 0.5;
    report.unsolved += dot(spin - transposed_times(start_of.R0, turn_of(i)) / h, n.P0 - start_of.P0);
  }
}

void add_work_of_rows(Articulate& a, DriftReport& report) {
  for (Condition& c : a.conditions) {
    const Row& r = row(a, c);
    if (c.stiff) {
      const double done = c.stiff->take_work(r, c.energy_given);
      (c.stiff->is_damped() ? report.damped : report.nonconservative_work) += done;
      c.settling = c.stiff->settling;
      c.mean_rate = c.stiff->mean_rate;
      continue;
    }
    if (keeps_to_position(r) && r.lever == 0.0) report.hand += dot(r.f, c.position1 - c.position0);
    if (!c.works_along_d) continue;
    const bool still = c.whole_value0 == c.whole_value1;
    double& line = c.ranged && still ? report.limit : r.lever > 0.0 ? report.motor : report.hand;
    line += r.lever > 0.0 ? work_of_angular_row(a, r) : dot(r.f, r.d1 - r.d0);
  }
}

namespace {

/// Whether an end of a string that holds went past its anchor: its direction leaps there, and what is solved between two
/// directions is no motion.
bool passes_anchor(const Articulate& a) {
  return std::any_of(a.couplings.begin(), a.couplings.end(), [&](const Coupling& coupling) {
    return std::any_of(coupling.rows.begin(), coupling.rows.end(), [&](std::uint32_t k) {
      const Row& row = a.rows[k];
      return leads_to_anchor(a, row) && condition(a, row).held && dot(row.d0, row.d1) < 0.0;
    });
  });
}

}  // namespace

bool solve_step(Articulate& a, double h, Vec3 gravity, DriftReport& report) {
  if (!a.all_rigid || a.angular) place_rows_at_start(a);
  if (!iterate(a, h, gravity, report) || passes_anchor(a)) return false;
  Lanes pushed = lanes(0.0);
  for (std::size_t b = 0; b < a.batches.size(); b++) pushed += commit(a, b, h, gravity);
  report.hand += sum(pushed);
  add_work_of_rows(a, report);
  return true;
}

}  // namespace pantin
