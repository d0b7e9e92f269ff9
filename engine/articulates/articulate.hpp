#pragma once
// Bodies and particles tied by constraints, solved together. Nodes and rows hold working copies, laid out in the order in
// which the factor eliminates the rows; `load` and `store` move the state between them and the model.
//
// Letters follow the equations: x place [m], q orientation, R its matrix, p momentum [kg m/s], P angular momentum in
// principal axes [kg m²/s], O = I⁻¹P [rad/s], a the step's Cayley vector [rad], f the force of a row on its first point
// [N] (the second gets -f), l arms in principal axes [m], r arms in the world [m]; 0 start and 1 end of a step of h [s].
// A row of a couple ties rotations: lever f is a torque on its first node [N m], d is lever times a small rotation of the
// first node against the second [m], l and r are axes (unit vectors). Its torque does the work lever f·(ā_a - ā_b) exactly,
// ā = R0 a: a rigid couple does none, since equal relative rotations at both ends have equal ā.
#include <cstdint>
#include <memory>
#include <vector>

#include "articulates/batch.hpp"
#include "articulates/factor.hpp"
#include "articulates/forecast.hpp"
#include "articulates/rest.hpp"
#include "model/model.hpp"

namespace pantin {

/// A body or a free particle of an articulate: what it has at the start and end of a step. What is read together lies
/// together.
struct alignas(64) Node {
  Vec3 x0, p0, P0, O0;
  Quat q0;
  double mass, inverse_mass;
  std::uint32_t slot;  // where it comes from
  bool is_body;
  bool turns;  // has a rotation; a point mass has not
  Mat3 R0;
  Vec3 coupled;  // 1 or 0 per principal axis: 0 about an axis of symmetry that all arms lie on, where spin is its own
  Vec3 force, torque;  // [N], [N m] constant in the step, world axes
  Vec3 inertia, inverse_inertia;
  // seldom asked for, or only where a step is not the midpoint's
  std::uint32_t first_row;
  double reach;  // [m] turns a rotation into a displacement in the residual
  Vec3 a;        // where couples ask for it, world axes at the start; of a node without rows, principal ones
  Vec3 x1, p1, P1;
  Quat q1;
  Mat3 R1;
  Vec3 row_force, row_torque;  // sums over rows, world axes
};

/// What a row wants: rigid keeps two points together; limited draws one to a place with a force up to a limit; rod
/// keeps a distance or keeps it in a range; plane keeps a point on a plane; strand is a segment of a string; path keeps
/// a point on a path; stiff pulls by a law; drawn has two points approach each other. Of couples, rigid keeps an
/// orientation, axis keeps two axes together, align keeps the angle between them, turn drives the angle about an axis
/// or keeps it in a range.
enum class RowKind : std::uint8_t { rigid, limited, rod, plane, axis, align, turn, strand, path, stiff, drawn };

struct StiffTie;

/// Ties a point of node a to a point of node b, or to a place of the world (b = -1), by one force.
struct alignas(64) Row {
  std::int32_t a = 0, b = -1;
  std::int32_t condition = -1;  // of a row that a constraint made; a hinge has none
  RowKind kind = RowKind::rigid;
  double lever = 0.0;  // [m] of a couple; 0: ties points
  Vec3 f = zero3();
  Vec3 residual = zero3();
  Vec3 d1 = zero3();                // [m] first point less second
  Vec3 offset = zero3();            // [m] gap that cannot be closed
  Vec3 la = zero3(), lb = zero3();  // arms of the two points
  // of rows that are not rigid:
  Vec3 d0 = zero3();
  Vec3 ra0 = zero3(), rb0 = zero3(), ra1 = zero3(), rb1 = zero3();  // axes of a couple
  PointId member;                                                   // of a hinge: the point that f pulls
  PointId centre;                                                   // of a hinge: the star's point, that -f pulls
};

/// What of a condition leaves the straight way between the ends of a step.
enum class Bent : std::uint8_t { nothing, place, length, turn };

/// What the row of a constraint has beyond a hinge's: a world end, a matrix of its own, limits.
struct Condition {
  Vec3 place0 = zero3(), place1 = zero3();  // [m] world end, at the start and end of the step being solved
  Vec3 whole0 = zero3(), whole1 = zero3();  // [m] the same of the whole step, where that is halved
  Vec3 velocity = zero3();                  // [m/s] of the world end at the end of the step
  Mat3 kept = zero33();                     // projects on the directions in which velocities are forbidden,
  Vec3 wanted = zero3();                    // [m/s] but for this one of d1
  Mat3 M = zero33(),
       C = zero33();    // the row of Newton's matrix: M (change of d1) + C df = -residual; rigid: M = 1, C = 0
  double length = 0.0;  // [m] of a rod, at the end of the step being solved
  double whole_length0 = 0.0, whole_length1 = 0.0;  // [m] at the start and end of the whole step
  double length_rate = 0.0;                         // [m/s]
  Bend bend;  // [m] of what is prescribed, [rad] of a turn; of a length, or [m/s] of a speed, the first component
  double accepted = 0.0;                  // [m] what a rod is longer than that because no motion can make it shorter
  double stiffness = 0.0, damping = 0.0;  // [N/m], [N s/m] of a limited row
  double max_force = 0.0;                 // [N]
  // Of couples: principal axes of the second node, or the world, turned by `turn` are those of the first; `axis` is b's,
  // at the ends of a step while it is drawn in.
  Quat turn0, turn1, whole_turn0, whole_turn1;
  Vec3 axis = zero3(), axis0 = zero3(), axis1 = zero3();
  double angle0 = 0.0,
         angle1 = 0.0;         // [rad] of a turn at the start and end, turns counted
  Vec3 normal = zero3();       // of a plane
  const Path* path = nullptr;  // of a point on one; its parameter is `angle`
  std::uint32_t part = 0;      // which row of its constraint it is
  // Of rows of one dimension: the range that its value is kept in, [m], and the range of its force, [N].
  double low = 0.0, high = 0.0;
  double lower = -infinity, upper = infinity;
  double stalled = infinity;  // [N] of a motor that stalls: what it exerts if nothing moves, and
  double yielding = 0.0;      // [m/N] by how much it yields to that
  bool ranged = false;        // low < high
  Bent bent = Bent::nothing;
  bool by_speed = false;    // of a motor: its turn in a part is what a body of its speed turns by then
  double start_rate = 0.0;  // [m/s] of such a motor: `length_rate` at the start of the step
  // Of a segment of a string: by d1 in the equation of the head, and by the head's force in its own.
  Mat3 into_head = zero33(), from_head = zero33();
  bool held = true;         // the range, or the limit of the force, lets it act as a constraint
  bool held_before = true;  // at the end of the last part of a step
  bool works = false;       // its force may do work
  std::uint32_t row = 0;
  ConstraintId constraint;  // null of a stiff row
  std::shared_ptr<StiffTie>
      stiff;                  // of a stiff row; copies of an articulate share it, so it keeps nothing between steps
  std::vector<double> given;  // (its curves) [J] what their energies gave to the motion in this part of the step
  double settling = 0.0, mean_rate = 0.0;  // [kg], [m/s] those of `stiff`, in the last part of the step
  bool settles = false;                    // now
};

/// Two rows that meet at a node: a block of the matrix. Of a node with rows 0, 1 … rising its meetings are (0, 0), (1, 0),
/// (1, 1), (2, 0) …
struct Meeting {
  std::uint32_t block;            // of the factor; diagonal where the two are one
  bool first_lower, first_upper;  // the first to reach its block
};

/// A row that meets a segment of a string at a node: a part of the block of that row and the string's head.
struct StrandMeeting {
  std::uint32_t segment, column, node, block;
  bool upper;
};
/// The block of a segment and its string's head.
struct StrandLink {
  std::uint32_t segment, block;
};
struct Strand {
  std::uint32_t head;
  std::vector<std::uint32_t> segments;  // rows, the head among them
  std::vector<StrandMeeting> meetings;
  std::vector<StrandLink> links;
  std::vector<std::uint32_t> cleared;  // blocks that nothing else sets
};

/// How far a sweep in the order of elimination may go in each kind of work, one after the other, so that all it needs
/// is done and what it reads is still in the cache: batches whose rows are all below `forces`, rows whose batches are all
/// below `batches`, columns of the factor that reach only rows below `rows`.
struct Wave {
  std::uint32_t forces = 0, batches = 0, rows = 0, columns = 0;
};

/// Largest distances that rows should have closed, [m].
struct Gaps {
  double points = 0.0;  ///< of hinges, nails and rigid follows
  double rods = 0.0;    ///< of a rod's length
  double open = 0.0;    ///< of all, but for offsets that were accepted
  double all() const { return std::fmax(points, rods); }
};

/// Work [J] of impulses on what moves by itself: anchors and lengths, and the turns of couples.
struct ImpulseWork {
  double ends = 0.0, couples = 0.0;
  double all() const { return ends + couples; }
  void operator+=(const ImpulseWork& more) {
    ends += more.ends;
    couples += more.couples;
  }
};

/// What a drift, or a projection of velocities, did: for counting and the balance of energy.
struct DriftReport {
  std::uint32_t iterations = 0, factorisations = 0, halved = 0, safe = 0, projections = 0, offsets = 0;
  double unreached = 0.0;   // [1/s] the error where not even the most sub-steps give the wanted accuracy
  double open_work = 0.0;   // [J] of solved laws without energy that do not depend on velocities
  double damped = 0.0;      // [J] of those that do, of what settles, and of what is swallowed
  double work = 0.0;        // [J] of the world ends, changing lengths, pushes and twists
  double motor = 0.0;       // [J] of motors, and of turns and angles that follow a function of time
  double limit = 0.0;       // [J] of limits, and of all rows where one is struck
  double met = 0.0;         // [J] of making velocities consistent after an edit
  double projected = 0.0;   // [J] of the half of a projection that was carried over
  double dissipated = 0.0;  // [J] change of the energy in safe steps that nothing from outside made
  double unsolved = 0.0;    // [J] of forces on gaps that the iteration left open; only where the ledger is kept
  double round_off = 0.0;   // [J] of the work of rows; the same
  double returned = 0.0;    // [J] given back of what the projection took

  double outside() const { return work + motor; }
  void tell(const ImpulseWork& done, double sign = 1.0) {
    work += done.ends * sign;
    motor += done.couples * sign;
  }
};

/// What all attempts of a drift, and its safe steps, cost.
inline std::uint32_t cost(const DriftReport& report) { return report.iterations + report.factorisations; }

/// Sums over nodes, for the balance of energy.
struct NodeTotals {
  double kinetic = 0.0;       ///< [J]
  Vec3 mass_place = zero3();  ///< [kg m] sum of mass times place
  bool finite = true;         ///< these sums and all orientations are; then all states are
};

/// A node of so many rows that each does not meet each: they meet two variables of its own, as good as rows, by which the
/// matrix is larger: u = 2/h² times how far the rows' forces move it, w = 2/h² times how far they turn it.
struct Hub {
  std::uint32_t node, variable;       // row of u in the factor; that of w is the next
  std::vector<std::uint32_t> blocks;  // (rows on the node) those with u; with w the next of the column
  std::vector<std::uint32_t> alone;   // rows on the node that are on no node but hubs
};

inline constexpr std::uint16_t most_failed = 4;

/// What its steps cost, in iterations and factorisations, and what may still be spent on one that cannot be solved.
struct Effort {
  double usual = 4.0;        // of a step that is solved at once
  std::uint32_t spare = 0;   // left of this drift, for attempts that fail
  std::uint16_t failed = 0;  // attempts in a row that did not solve a step, at most `most_failed`,
  std::uint16_t pause = 0;   // and for how many more none is to be tried
};

/// How two points of a node moved on average over the last part of a step [m/s], and how that changed [m/s²].
struct MeanMotion {
  std::array<Vec3, 2> velocity{}, acceleration{};
};

/// What steps change beside nodes and rows; a step that is done again starts from it.
struct ArticulateState {
  std::vector<Condition> conditions;
  std::vector<Vec3> impulses;   // (rows) [N s] of the last projection of velocities
  std::vector<Vec3> exerted;    // (rows) [N s] in all, in a full sub-step that is cut into parts or strikes a row
  double exerted_time = 0.0;    // [s] for which that is the sum; 0: the rows' forces tell all
  std::vector<Vec3> expected;   // (rows) [N] in the coming step, where laws of velocity ask for it; none, or not finite
  std::vector<Vec3> reaction;   // (rows) [N] what they bore of laws of velocity in the last step; none: nothing
  std::vector<double> loads;    // (rows) [N] that they bore in the last step, where some may break; none: not known
  std::vector<Vec3> carried;    // (rows) [N s] half of them, see `take_carried_half`
  double carried_h = 0.0;       // [s] of the sub-steps after which they serve; 0: none
  double carried_energy = 0.0;  // [J] that taking them gave
  ImpulseWork carried_work;     // of them
  Vec3 turned = zero3();        // [kg m²/s] by forces over gaps, which the end of the full sub-step gives back
  Gaps gaps;                    // at the start of the next step
  double residual = 0.0;        // [m] largest of the rigid rows where the solver placed them last
  double last_h = 0.0;          // [s] of the last good step; 0: no history
  /// Relative compliance of the factor, between `least_epsilon` and `most_epsilon`: sets the speed of convergence, never
  /// the answer. Redundant loops that change shape want much, large mass ratios and long chains little. Rows without a
  /// loop are never redundant.
  double least_epsilon = 1e-10, most_epsilon = 1e-6, epsilon = most_epsilon;
  std::uint32_t good_steps = 0, wait = 20, projection_wait = 0;
  bool lowered = false;           // epsilon was lowered in this step
  bool has_factor = false;        // the factor is of a Newton matrix
  bool exact = false;             // the factor is of what the rows forbid, at the nodes' starts
  bool safe = false;              // the last step was a safe one
  bool offsets = false;           // gaps of rows were accepted
  bool edited = true;             // new: velocities are still to be made consistent
  bool torn = false;              // by an edit, and still open
  std::uint32_t open_steps = 0;   // in a row that ended with a gap beyond the tolerance
  double arrived = 0.0;           // part of the full sub-step that a safe step has already moved over
  bool smooth = true;             // no part of the full sub-step was halved or safe
  bool cut = false;               // the full sub-step has more than one part
  bool weak = false;              // the last factor had weak pivots: its multipliers are not all determined
  SubSteps sub_steps;             // in each part of a step
  std::vector<MeanMotion> means;  // (nodes) where `accuracy` asks
  double means_span = 0.0;        // [s] from part to part
  std::uint8_t means_known = 0;   // 1: velocities are known, 2: accelerations too
  Effort effort;
  DriftReport report;  // of the last phase
  NodeTotals totals;   // at the end of the last step
  Rest rest;
};

struct Articulate : ArticulateState {
  Plane plane;
  std::vector<Node> nodes;
  std::vector<Row> rows;           // in the order of elimination
  std::vector<NodeBatch> batches;  // of the nodes
  std::vector<RowEnds> ends;       // of the batches
  std::vector<Vec3>
      at_ends;  // (2 rows + 1) what nodes a and b hand to row k is in 2k and 2k + 1; the last is of no row
  std::vector<Meeting> meetings;
  std::vector<Strand> strands;
  std::vector<Hub> hubs;
  std::vector<Node> saved;                   // as they were: where a safe step goes back to, and for the ledger
  std::vector<std::uint32_t> first_meeting;  // (nodes + 1); hubs have none
  RowLists on;                               // (nodes) the rows that a node is in, rising
  std::vector<Wave> waves;                   // ends of the stretches; the last reaches all
  Factor factor;
  std::vector<Vec3> right_side;  // (rows of the factor)
  std::vector<Vec3> f_saved;     // (rows) [N] where a line search starts
  Forecast forecast;

  double length = 0.0;      // [m] median arm: every length in a criterion is a multiple of it
  double total_mass = 0.0;  // [kg]
  bool all_rigid = true;
  bool couples = false;      // has rows that tie rotations
  bool tree = false;         // its rows make no loop: all are independent
  bool limited = false;      // has limited rows
  bool breakable = false;    // has constraints that may break
  bool open = false;         // has rows that take energy or give it
  bool draws = false;        // is free, and rows draw points together over a gap
  bool yields = false;       // has no row but soft ones: its velocities are free
  bool pulled = false;       // laws act on it: its kinetic energy is no longer gravity's alone
  std::uint64_t serial = 0;  // smallest of its things
};

/// Whether a row forbids no motion, and only pulls.
inline bool is_soft(const Row& row) { return row.kind == RowKind::limited || row.kind == RowKind::stiff; }

inline Condition& condition(Articulate& a, const Row& row) {
  return a.conditions[static_cast<std::size_t>(row.condition)];
}
inline const Condition& condition(const Articulate& a, const Row& row) {
  return a.conditions[static_cast<std::size_t>(row.condition)];
}

inline const Row& row(const Articulate& a, const Condition& c) { return a.rows[c.row]; }

/// Whether a one-dimensional row began to hold in this part of the step, by an inelastic meeting.
bool struck(const Articulate& articulate);
/// What row k exerted in the last step, on average [N].
inline Vec3 exerted_force(const Articulate& a, std::size_t k) {
  const Vec3 f = a.exerted_time > 0.0 ? a.exerted[k] / a.exerted_time : a.rows[k].f;
  return a.reaction.empty() ? f : f + a.reaction[k];
}
/// Begins the sum of what the rows exert in a step that is cut into parts.
void begin_exerted(Articulate& articulate);
/// Adds what the rows exert by impulses [N s], or by their forces over h [s].
void add_impulses_exerted(Articulate& articulate);
void add_forces_exerted(Articulate& articulate, double h);

/// Copies the model's state into the nodes, with constant forces: gravity [m/s²], pushes and twists; and the world ends
/// and limits of the rows from their constraints. In a plane all is taken to height 0, so that no row sees the normal.
void load(Articulate& articulate, const Model& model, Vec3 gravity);
/// Copies the state of one thing into a node.
void load(Node& node, const Model& model, Vec3 gravity);
/// After an edit of velocities: the unknowns have no history, and the velocities are to be made consistent.
void disturb(Articulate& articulate);
/// It moves again, or is not to fall asleep before its motion was looked at anew.
inline void wake(Articulate& articulate) { articulate.rest = {}; }
/// Empties what a drift tells: `report`, and what the energies of solved laws gave.
void begin_report(Articulate& articulate);
/// Writes the nodes' starts and the rows' forces back.
void store(const Articulate& articulate, Model& model);
void store(const Node& node, Model& model);

/// Writes the tensions of solved connections.
void tell_tensions(const Articulate& articulate, Model& model);

/// Kinetic energy of the nodes' starts, [J].
double kinetic_energy(const Articulate& articulate);
inline double kinetic_energy(const Node& n) { return 0.5 * (norm2(n.p0) * n.inverse_mass + dot(n.P0, n.O0)); }
NodeTotals totals_of(const Articulate& articulate);
/// Finds `gaps` anew from the rows at the end of the step.
void measure_gaps(Articulate& articulate);

/// What a drift needs to know of the world.
struct DriftSettings {
  double h;          ///< [s] length of the step
  Vec3 gravity;      ///< [m/s²]
  double tolerance;  ///< of a gap that cannot be closed, relative to the articulate's length
  bool energy_return;
  bool ledger;                  ///< tell also what only the ledger asks for
  double from = 0.0, to = 1.0;  ///< the part of the step to move over
  double full = 0.0;       ///< [s] length of the full sub-step that the part belongs to: from projection to projection
  bool first = true;       ///< the part is the first of its full sub-step
  bool backwards = false;  ///< some parts of it go backwards in time
};

}  // namespace pantin
