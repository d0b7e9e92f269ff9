#pragma once
#include <vector>

#include "constraints/row_rule.hpp"
#include "laws/pair_curve.hpp"
#include "model/model.hpp"

namespace pantin {

/// What the row of a connection has that is solved with its articulate.
struct StiffBond {
  ConnectionId connection;
  ParticleId a, b;  // b null: a position of the world
  Solve solve = Solve::at_middle;
  std::vector<PairCurve> curves;  // of the law, and of the laws that act with it
  std::vector<double> energy0;    // (curves) [J] at the start of the step being solved
  double least2 = 0.0;            // [m²] below it distances count as equal to its root: of the first length 1e-12
  double rate0 = 0.0;             // [m/s] of the distance at the start
  std::vector<double> pulls;      // (curves) [N/m] f = -Σ pull e
  bool damping_known = false;     // of the step being solved, as are:
  double damping = 0.0;           // [N s/m] beyond that of its curves
  double settling = 0.0;          // [kg] m_s, and what it draws to:
  double mean_rate = 0.0;         // [m/s] of the distance over the step

  /// [m] Between its ends when it was made; 1 where they were at one position.
  double first_length() const;
  /// Whether it takes energy or gives it.
  bool is_nonconservative() const;
  /// Whether it takes energy by its nature: it depends on velocities, or swallows at the end of the step.
  bool is_damped() const;
  /// Once a step is solved: adds what the curves' energies gave to the motion to `energy_given` (curves) [J], bounds `settling`
  /// by what dampers took, and returns the work of laws without energy and of `damping`, [J].
  double take_work(const Row& row, std::vector<double>& energy_given);
};

/// Makes the bond of a connection, with the force that it had; `row` and `condition` are its.
void make_stiff(const Model& model, ConnectionId id, Row& row, Condition& condition);
/// Reads the start of a step of h [s] from d0; `approach` is d0 · the velocity of d0 [m²/s].
void start_stiff(StiffBond& bond, const Row& row, double approach);

/// Energy of its laws, with its ends d [m] apart, [J]; adds `times` that of each curve to `list` (curves).
double add_energies(StiffBond& bond, Vec3 d, double times, std::vector<double>& list);

/// Its row keeps the length of the start of the step instead, and with it the energy of the bond.
void hold_length(Row& row, Condition& condition);
void pull_again(Row& row);

/// What a bond pulls its first point with at d [m], at rest [N], and how d [N/m] and its rate [N s/m] change that, where it
/// draws back.
struct StiffPull {
  Vec3 f = zero3();
  Mat3 by_position = zero33(), by_rate = zero33();
};
StiffPull pull_at(StiffBond& bond, Vec3 d);
/// [kg] What half of the impulse of a step changes by with the mean velocity of one end against the other in it.
struct DrawnInStep {
  double along = 0.0, across = 0.0;  ///< its length; across where it is taut
};
/// From rest at d [m].
DrawnInStep drawn_in_step(StiffBond& bond, Vec3 d, const RowContext& context);

}  // namespace pantin
