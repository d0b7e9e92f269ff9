#pragma once
// A row of an articulate's equations: a force of three components between two nodes, or between one and the world. Letters
// as in articulates/articulate.hpp.
//
// An angular row ties rotations: lever f is a torque on its first node [N m], d is lever times a small rotation of the
// first node against the second [m], l and r are axes (unit vectors). Its torque does the work lever f·(a_a - a_b) exactly,
// with the nodes' Cayley vectors: a rigid one does none, since equal relative rotations at both ends have equal ones.
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/lanes.hpp"
#include "model/bend.hpp"
#include "model/constraint.hpp"

namespace pantin {

struct RowRule;
struct StiffBond;
extern const RowRule rigid_row;

/// Ties a point of node a to a point of node b, or to a position of the world (b = -1), by one force.
struct alignas(64) Row {
  std::int32_t a = 0, b = -1;
  std::int32_t condition = -1;  // of a row that a constraint made; a hinge has none
  const RowRule* rule = &rigid_row;
  double lever = 0.0;  // [m] of an angular row; 0: ties points
  Vec3 f = zero3();
  // [m] ρ in Newton's iteration, of soft constraints [N]; [m] the gap in a fallback step; [m/s] the forbidden velocity in a
  // projection
  Vec3 residual = zero3();
  Vec3 d1 = zero3();                // [m] first point less second
  Vec3 offset = zero3();            // [m] gap that cannot be closed
  Vec3 la = zero3(), lb = zero3();  // arms of the two points
  // of rows that are not rigid:
  Vec3 d0 = zero3();
  Vec3 ra0 = zero3(), rb0 = zero3(), ra1 = zero3(), rb1 = zero3();  // axes of an angular row
  PointId member;                                                   // of a hinge: the point that f pulls
  PointId star_point;                                               // of a hinge: that of its star, which -f pulls
};

/// What of a condition leaves the straight line between the ends of a step.
enum class Bent : std::uint8_t { nothing, position, value, turn };

/// What the row of a constraint has beyond a hinge's: an anchor, a matrix of its own, limits.
struct Condition {
  // [m] anchor, [rad] rotation of a turn prescribed, at the start and end of the step being solved; or a separation
  Vec3 position0 = zero3(), position1 = zero3();
  Vec3 whole0 = zero3(), whole1 = zero3();  // the same at the start and end of the scene's step
  Vec3 velocity = zero3();                  // [m/s] of the anchor at the end of the step
  Mat3 kept = zero33();                     // projects on the directions in which velocities are forbidden,
  Vec3 wanted = zero3();                    // [m/s] but for this one of d1
  Vec3 worked_at = zero3();  // [m/s] at which impulses do work: of what is driven the mean of before and after
  bool driven = false;       // what is prescribed moves, in this step or the last one
  // the row of Newton's matrix: M (change of d1) + C df = -residual; rigid: M = 1, C = 0
  Mat3 M = zero33(), C = zero33();
  // [m] what the value of a row of one dimension is kept at, at the end of the step being solved; of a range, by how much it
  // is still beyond that (`low_end`, `high_end`). `whole_…` and `value_rate` are of the same.
  double kept_value = 0.0;
  double whole_value0 = 0.0, whole_value1 = 0.0;  // [m] at the start and end of the whole step
  double value_rate = 0.0;                        // [m/s]
  Bend bend;  // [m] of what is prescribed, [rad] of a turn; of a length, or [m/s] of a speed, the first component
  // [m] what a value is beyond what it is kept at since no motion can close it; of rows without `offsets_gap`
  double accepted = 0.0;
  double stiffness = 0.0, damping = 0.0;  // [N/m], [N s/m] of a soft row
  double max_force = 0.0;                 // [N]
  // Of angular rows: principal axes of the second node, or the world, turned by `turn` are those of the first; `axis` is b's,
  // at the ends of a step while it is drawn in. Of a coupled row between points `axis` is what its distance counts along, in the
  // same frame; 0: it is a length.
  Quat turn0, turn1, whole_turn0, whole_turn1;
  Vec3 axis = zero3(), axis0 = zero3(), axis1 = zero3();
  // [rad] of a turn at the start and end, turns counted; of a point on a path, its parameter there.
  double angle0 = 0.0, angle1 = 0.0;
  Vec3 normal = zero3();        // of a plane
  const Path* path = nullptr;   // of a point on one, and
  PathRun run;                  // of it, between two sharp corners, and
  double turned_at = infinity;  // the one that it went round last in this drift,
  bool returned = false;        // whether it came back there, and
  Vec3 turning = zero3();       // the tangent on the way round one; 0: that of the path
  std::uint32_t index = 0;      // which row of its constraint it is
  std::uint32_t sum = 0;        // of a coupled row: which of the sums of its constraint it adds to
  // Of rows of one dimension: the range that its value is kept in, [m], and the range of its force, [N].
  double low = 0.0, high = 0.0;
  double lower = -infinity, upper = infinity;
  double stall_force = infinity;  // [N] of a motor that stalls: what it exerts if nothing moves, and
  double yields_by = 0.0;         // [m/N] how far it yields per force
  // [N] bound of a motor without `max_torque` while its articulate touches something: of its torque over its lever
  double bound_in_touch = infinity;
  // [N] what such a motor gives at its bound while contacts stop it; it gives nothing in the drift then
  double jam_force = 0.0;
  bool ranged = false;  // low < high
  Bent bent = Bent::nothing;
  bool by_speed = false;    // of a motor: its turn in a part is what a body of its speed turns by then
  double start_rate = 0.0;  // [m/s] of such a motor: `value_rate` at the start of the step
  // Of a coupled row: by how much its value counts in metres of its own [1], in the step and at its ends; and in matrices,
  // by d1 in the equation of the head, and by the head's force in its own.
  double weight = 1.0, weight0 = 1.0, weight1 = 1.0;
  bool turns_axis = false;  // an angular one that turns the axis along which another's distance counts
  Mat3 into_head = zero33(), from_head = zero33();
  double extent = 0.0;         // [m] of the largest number that its gap is found from, whose round-off it has
  bool held = true;            // the range, or the limit of the force, lets it act as a constraint
  bool held_before = true;     // before the part of a step that is being solved: what began to hold in it is struck
  bool works_along_d = false;  // its force may do work f·Δd: it stops, pulls, or keeps what is prescribed
  bool gives_way = false;      // while impulses are found in which it has no part, since its force has an end
  std::uint32_t row = 0;
  ConstraintId constraint;  // null of a stiff row
  // of a stiff row; copies of an articulate share it, so it keeps nothing between steps
  std::shared_ptr<StiffBond> stiff;
  // (its curves) [J] what their energies gave to the motion in this stage of the step
  std::vector<double> energy_given;
  double settling = 0.0, mean_rate = 0.0;  // [kg], [m/s] those of `stiff`, in the last stage of the step
  bool settles = false;                    // while `settle_velocities` solves
};

/// Whether its force has an end either way, as that of a motor with a largest torque.
inline bool is_limited(const Condition& c) { return std::isfinite(c.lower) && std::isfinite(c.upper); }

/// Mean of the axes of an angular row over its nodes and the step, of unit length.
inline Vec3 mean_axis(const Row& row) { return direction(row.ra0 + row.rb0 + row.ra1 + row.rb1); }

/// Of the angle of an angular row about its axis, by the small rotation.
inline Vec3 angle_gradient(const Row& row) {
  return (row.ra1 + row.rb1) / std::fmax(1.0 + dot(row.ra1, row.rb1), 1e-9);
}

}  // namespace pantin
