#pragma once
// Bodies and particles tied by constraints, solved together. Nodes and rows hold working copies, laid out in the order in
// which the factor eliminates the rows; `load` and `store` move the state between them and the model.
//
// Letters follow the equations: x position [m], q orientation, R its matrix, p momentum [kg m/s], P angular momentum in
// principal axes [kg m²/s], spin I⁻¹P in the same [rad/s], cayley the step's Cayley vector in world axes [rad], f the force of a row on its first point
// [N] (the second gets -f), l arms in principal axes [m], r arms in the world [m]; 0 start and 1 end of a step of h [s].
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "articulates/factor.hpp"
#include "articulates/node_batch.hpp"
#include "articulates/predictor.hpp"
#include "articulates/rest.hpp"
#include "constraints/row.hpp"
#include "model/model.hpp"
#include "trees/tree_course.hpp"

namespace pantin {

/// A body or a free particle of an articulate: what it has at the start and end of a step. What is read together lies
/// together.
struct alignas(64) Node {
  Vec3 x0, p0, P0, spin0;
  Quat q0;
  double mass, inverse_mass;
  std::uint32_t slot;  // of the body or point in the model
  bool is_body;
  bool turns;  // has a rotation; a point mass has not
  Mat3 R0;
  Vec3 felt_axes;  // 1 for a principal axis about which rows feel the spin; 0 for one of symmetry that all arms lie on
  Vec3 force, torque;  // [N], [N m] constant in the step, world axes
  Vec3 inertia, inverse_inertia;
  // seldom asked for, or only where a step is not the midpoint's
  std::uint32_t first_row;  // the smallest that it is in
  double reach;             // [m] turns a rotation into a displacement in the residual
  Vec3 cayley;              // where angular rows ask for it, world axes; with `euler` the rotation vector
  Vec3 x1, p1, P1;
  Quat q1;
  Mat3 R1;
  Vec3 row_force, row_torque;  // sums over rows, world axes
};

/// Two rows that meet at a node: a block of the matrix. Of a node with rows 0, 1 … rising its blocks are (0, 0), (1, 0),
/// (1, 1), (2, 0) …
struct RowBlock {
  std::uint32_t block;            // of the factor; diagonal where the two are one
  bool first_lower, first_upper;  // the first to write its block: it sets, later ones add
};

/// A coupling's `row` and another, the `column`, that share a node: adds to the `block` of the column and the coupling's head.
struct CoupledBlock {
  std::uint32_t row, column, node, block;
  bool upper;
};
/// The block of a row and its coupling's head.
struct HeadBlock {
  std::uint32_t row, block;
};
/// Rows whose values add up to one number: segments of a string, turns of gears.
struct Coupling {
  std::uint32_t head;
  std::vector<std::uint32_t> rows;  // the head among them
  std::vector<CoupledBlock> blocks;
  std::vector<HeadBlock> head_blocks;  // of each of its other rows
  std::vector<std::uint32_t> cleared;  // blocks that nothing else sets
};

/// How far a sweep in the order of elimination goes in each kind of work, one after the other, before it goes on with the
/// first: so each finds done what it needs, and in the cache what it reads.
struct Tile {
  std::uint32_t forces = 0;   ///< rows below it get their force
  std::uint32_t batches = 0;  ///< batches below it are placed: all their rows are below `forces`
  std::uint32_t rows = 0;     ///< rows below it are evaluated: all their batches are below `batches`
  std::uint32_t columns = 0;  ///< columns of the factor below it are eliminated: they reach only rows below `rows`
};

/// Largest distances that rows should have closed, [m].
struct Gaps {
  double points = 0.0;      ///< of rigid rows between points
  double others = 0.0;      ///< of all other rows that forbid motion: lengths, planes, turns, couplings
  double unaccepted = 0.0;  ///< of all, less what of them was accepted
  double all() const { return std::fmax(points, others); }
};

/// Work [J] of impulses on what is prescribed: on anchors and lengths, and on the turns of angular rows.
struct ImpulseWork {
  double anchors = 0.0, angular_rows = 0.0;
  double all() const { return anchors + angular_rows; }
  void operator+=(const ImpulseWork& more) {
    anchors += more.anchors;
    angular_rows += more.angular_rows;
  }
};

/// What a drift, or a projection of velocities, did: for counting and the balance of energy.
struct DriftReport {
  std::uint32_t iterations = 0, factorisations = 0, halved = 0, fallbacks = 0, exact_projections = 0,
                offsets_accepted = 0;
  double unreached = 0.0;             // [1/s] the error where not even the most sub-steps give the wanted accuracy
  double nonconservative_work = 0.0;  // [J] of solved laws without energy that do not depend on velocities
  double damped = 0.0;                // [J] of those that do, of what settles, and of what is swallowed
  double hand = 0.0;                  // [J] of the anchors, changing lengths, pushes and torques
  double motor = 0.0;                 // [J] of motors, and of turns and angles that follow a function of time
  double limit = 0.0;                 // [J] of limits, and of all rows where one is struck
  double after_edit = 0.0;            // [J] of making velocities consistent after an edit
  double energy_projected = 0.0;      // [J] of the symmetric projection
  double dissipated = 0.0;            // [J] change of the energy in fallback steps that nothing from outside made
  double unsolved = 0.0;          // [J] of forces on gaps that the iteration left open; only where the ledger is kept
  double round_off = 0.0;         // [J] what round-off of positions makes of the work of rows; the same
  double inexact = 0.0;           // [J] change of the energy by a tree's steps that nothing from outside made; the same
  std::uint32_t evaluations = 0;  // of a tree's rates
  double returned = 0.0;          // [J] given back of what the projection took

  double outside() const { return hand + motor; }  // [J] from outside the scene: anchors, and what turns
  void tell(const ImpulseWork& done, double sign = 1.0) {
    hand += done.anchors * sign;
    motor += done.angular_rows * sign;
  }
};

/// What all attempts of a drift, and its fallback steps, cost.
inline std::uint32_t cost(const DriftReport& report) { return report.iterations + report.factorisations; }

/// Sums over nodes, for the balance of energy.
struct NodeTotals {
  double kinetic = 0.0;          ///< [J]
  Vec3 mass_position = zero3();  ///< [kg m] sum of mass times position
  bool finite = true;            ///< these sums and all orientations are; then all states are
};

/// A node of so many rows that each does not meet each: they meet variables of its own, as good as rows, by which the matrix is
/// larger: u = 2/h² times how far the rows' forces move it, and of a body w = 2/h² times how far they turn it.
struct Hub {
  std::uint32_t node, variable;             // row of u in the factor; that of w is the next
  std::vector<std::uint32_t> blocks;        // (rows on the node) those with u; with w the next of the column
  std::vector<std::uint32_t> only_on_hubs;  // rows on the node that are on no node but hubs
};

inline constexpr std::uint16_t most_failed = 4;  // drifts that are counted

/// What its steps cost, in iterations and factorisations, and what may still be spent on one that cannot be solved.
struct Effort {
  double usual = 4.0;         // of a step that is solved at once
  std::uint32_t spare = 0;    // left of this drift, for attempts that fail
  std::uint32_t corners = 0;  // of paths, round which something went in this drift
  std::uint16_t failed = 0;   // drifts in a row whose attempts did not solve all, at most `most_failed`,
  std::uint16_t pause = 0;    // and in how many more none is to be made
};

/// How two points of a node moved on average over the last stage of a step [m/s], and how that changed [m/s²].
struct MeanMotion {
  std::array<Vec3, 2> velocity{}, acceleration{};
};

/// What the factor at hand is of, where it may serve again.
enum class FactorOf : std::uint8_t {
  none,
  newton,     ///< Newton's matrix of the last attempt
  projection  ///< what the rows forbid, at the nodes' starts
};

/// What steps change beside nodes and rows; a step that is done again starts from it.
struct ArticulateState {
  std::vector<Condition> conditions;
  std::vector<Vec3> impulses;  // (rows) [N s] of the last projection of velocities
  // (rows) [N s] what they gave in the searches for contacts before and after the last drift: where the next begin. Of ties,
  // and of scalar rows at the row that they are known by; none: nothing touches.
  std::array<std::vector<Vec3>, 2> tie_impulses;
  std::array<std::vector<double>, 2> scalar_impulses;
  // (rows) [N s] in all, in a full sub-step that has parts, that something drives or in which rows may let go
  std::vector<Vec3> exerted;
  double exerted_time = 0.0;  // [s] for which that is the sum; 0: the rows' forces tell all
  // (rows) [N] forces foreseen by a kick that solves laws of velocity, where Newton begins; none, or not finite: as predicted
  std::vector<Vec3> expected;
  // (rows) [N] beyond the drift's force: what they bore in kicks by laws of velocity, at contacts and in drifts before the last
  // one in the last step
  std::vector<Vec3> reaction;
  double drift_share = 1.0;   // of the step: the last drift
  std::vector<double> loads;  // (rows) [N] that they bore in the last step, where some may break; none: not known
  // (rows) [N s] running mean of those of projections, see `project_symmetrically`
  std::vector<Vec3> symmetric_impulses;
  double symmetric_h = 0.0;       // [s] of the sub-steps after which they serve; 0: none
  double symmetric_energy = 0.0;  // [J] that taking them gave
  ImpulseWork symmetric_work;     // of them
  Vec3 angular_at_distance =
      zero3();            // [kg m²/s] by forces at a distance, which the end of the full sub-step gives back
  Gaps gaps;              // at the start of the next step
  double residual = 0.0;  // [m] largest |ρ| of rigid rows where the solver placed them last
  double last_h = 0.0;    // [s] of the last good step; 0: no history
  /// Relative compliance of the factor, between `least_epsilon` and `most_epsilon`: sets the speed of convergence, never
  /// the answer. Redundant loops that change shape want much, large mass ratios and long chains little. Rows without a
  /// loop are never redundant.
  double least_epsilon = 1e-10, most_epsilon = 1e-6, epsilon = most_epsilon;
  std::uint32_t good_steps = 0, wait = 20;  // since epsilon was lowered; after which it is raised
  std::uint32_t projection_wait = 0;        // projections until one tries the factor of Newton's matrix again
  bool lowered = false;                     // epsilon was lowered in the last attempt
  FactorOf factor_of = FactorOf::none;
  bool fell_back = false;         // the last step was a fallback step
  bool has_offsets = false;       // gaps of rows were accepted
  bool edited = true;             // new: velocities are still to be made consistent
  bool torn = false;              // by an edit, and still open
  std::uint32_t open_steps = 0;   // in a row that ended with a gap beyond the tolerance
  std::uint32_t stuck_steps = 0;  // in a row that were fallback steps though nothing was open
  double moved_to = 0.0;          // (0 … 1) of the step, up to which a fallback step has already moved
  bool smooth = true;          // no part of the full sub-step was halved, a fallback step, or round a corner of a path
  bool sums_impulses = false;  // `exerted` is summed up
  bool touches = false;        // contacts gave it impulses before the last drift
  bool weak = false;           // the last factor had weak pivots: its multipliers are not all determined
  SubSteps sub_steps;          // in each stage of a step
  float error_by_jerk = 0.0F;  // error of sub-steps by h² |jerk|, at the last trials; 0: none
  std::vector<MeanMotion> means;  // (nodes) where `accuracy` asks
  double means_span = 0.0;        // [s] from stage to stage
  std::uint8_t means_known = 0;   // 1: velocities are known, 2: accelerations too
  Effort effort;
  TreeCourse course;     // where its tree is, between the moments at which its nodes are told
  bool by_tree = false;  // it was moved by its tree last, and its velocities are as the rows want them
  // (stages) since it was too stiff for its tree, that one counted; 0: it is not, or never was
  std::uint16_t stages_not_stiff = 0;
  DriftReport report;             // of the last drift
  DriftReport projection_report;  // of the last projection, or of what settles after it
  NodeTotals totals;              // at the end of the last step
  bool stored = false;            // the model has its state before the step ends, and `totals` are known
  Rest rest;
};

struct Articulate : ArticulateState {
  Plane plane;
  std::vector<Node> nodes;
  std::vector<Row> rows;           // in the order of elimination
  std::vector<NodeBatch> batches;  // of the nodes
  std::vector<RowEnds> ends;       // of the batches
  // (2 rows + 1) what nodes a and b hand to row k is in 2k and 2k + 1; the last is of no row
  std::vector<Vec3> at_ends;
  std::vector<RowBlock> row_blocks;
  std::vector<Coupling> couplings;
  std::vector<Hub> hubs;
  std::vector<Node> saved;  // as they were: where a fallback step and a displacement go back to, and for the ledger
  std::vector<std::uint32_t> first_row_block;  // (nodes + 1); hubs have none
  RowLists rows_on;                            // (nodes) the rows that a node is in, rising
  std::vector<Tile> tiles;                     // ends of the stretches; the last reaches all
  Factor factor;
  std::vector<Vec3> right_side;  // (rows of the factor)
  std::vector<Vec3> f_saved;     // (rows) [N] where a line search starts
  Predictor predictor;
  std::shared_ptr<const Tree> as_tree;  // null where it is none, or it was not asked for
  bool tree_sought = false;

  double length = 0.0;                     // [m] median arm: every length in a criterion is a multiple of it
  std::optional<double> length_of_motion;  // [m] where nothing of it has a length: how far it went of late
  double total_mass = 0.0;                 // [kg]
  bool all_rigid = true;
  bool angular = false;          // has angular rows
  bool loop_free = false;        // its rows make no loop: all are independent
  bool soft_constraint = false;  // has a soft row of a constraint, as a follow: not of a law
  bool breakable = false;        // has constraints that may break
  bool nonconservative = false;  // has rows that take energy or give it
  bool attracts = false;         // is free, and rows draw points together over a gap
  bool forbids_nothing = false;  // has no row but soft ones, of laws too: its velocities are free
  bool pulled = false;           // explicit force elements act on it, and one in the scene by more than velocity
  std::uint64_t serial = 0;      // smallest of its things
};

inline Condition& condition(Articulate& a, const Row& row) {
  return a.conditions[static_cast<std::size_t>(row.condition)];
}
inline const Condition& condition(const Articulate& a, const Row& row) {
  return a.conditions[static_cast<std::size_t>(row.condition)];
}

inline const Row& row(const Articulate& a, const Condition& c) { return a.rows[c.row]; }

/// What row k exerted in the last drift, on average [N].
inline Vec3 force_in_drift(const Articulate& a, std::size_t k) {
  return a.exerted_time > 0.0 ? a.exerted[k] / a.exerted_time : a.rows[k].f;
}
/// What row k exerted in the last step, on average [N].
inline Vec3 exerted_force(const Articulate& a, std::size_t k) {
  const Vec3 f = force_in_drift(a, k);
  return a.reaction.empty() ? f : f * a.drift_share + a.reaction[k];
}
/// The factor at hand, where it is of that, is so no more.
inline void drop_factor(Articulate& a, FactorOf of) {
  if (a.factor_of == of) a.factor_of = FactorOf::none;
}
/// It moves again, or is not to fall asleep before its motion was looked at anew.
inline void wake(Articulate& articulate) { articulate.rest = {}; }
/// [m] The largest gap that counts as closed.
inline double largest_closed_gap(const Articulate& a) { return 1e-8 * a.length; }
/// Whether rows have gaps that are still to be closed: with these no step is tried.
inline bool is_open(const Articulate& a) { return a.gaps.unaccepted > largest_closed_gap(a); }
/// Kinetic energy of a node's start, [J].
inline double kinetic_energy(const Node& n) { return 0.5 * (norm2(n.p0) * n.inverse_mass + dot(n.P0, n.spin0)); }
/// What a drift needs to know of the world.
struct DriftSettings {
  double step;       ///< [s] length of the scene's step
  Vec3 gravity;      ///< [m/s²]
  double tolerance;  ///< of a gap that cannot be closed, relative to the articulate's length
  bool energy_return;
  bool ledger;                  ///< tell also what only the ledger asks for
  double from = 0.0, to = 1.0;  ///< the stage of the step to move over
  double full = 0.0;       ///< [s] length of the full sub-step that the stage belongs to: from projection to projection
  bool first = true;       ///< the stage is the first of its full sub-step
  bool backwards = false;  ///< some stages of it go backwards in time
};

}  // namespace pantin
