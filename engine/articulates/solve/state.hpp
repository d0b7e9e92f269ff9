#pragma once
// Between articulates and the model, and sums over their nodes and rows.
#include "articulates/articulate.hpp"

namespace pantin {

/// Copies the model's state into the nodes, with constant forces: gravity [m/s²], pushes and torques; and the anchors
/// and limits of the rows from their constraints. In a plane all is taken to height 0, so that no row sees the normal.
void load(Articulate& articulate, const Model& model, Vec3 gravity);
/// Anchors and limits alone.
void load_conditions(Articulate& articulate, const Model& model);
/// Copies the state of one thing into a node.
void load(Node& node, const Model& model, Vec3 gravity);
/// After an edit of velocities: the unknowns have no history, and the velocities are to be made consistent.
void disturb(Articulate& articulate);
/// Empties what a drift tells: `report`, and what the energies of solved laws gave.
void begin_report(Articulate& articulate);
/// Writes the nodes' starts and the rows' forces back.
void store(const Articulate& articulate, Model& model);
void store(const Node& node, Model& model);
/// The same before all is known to have gone well: what the model had is kept in the nodes' ends, where `take_back` finds it.
void store_early(Articulate& articulate, Model& model);
void take_back(const Articulate& articulate, Model& model);

/// Writes the tensions of solved connections.
void tell_tensions(const Articulate& articulate, Model& model);

/// Kinetic energy of the nodes' starts, [J].
double kinetic_energy(const Articulate& articulate);
/// Energy of solved laws at the nodes' starts, [J]; adds `times` that to what they gave to the motion.
double add_energies_of_solved_laws(Articulate& articulate, double times);
NodeTotals totals_of(const Articulate& articulate);
/// Finds `gaps` anew from the rows at the end of the step.
void measure_gaps(Articulate& articulate);

/// Whether a one-dimensional row began to hold in this stage of the step, by an inelastic impact.
bool struck(const Articulate& articulate);
/// Of Λ̂ in `project_symmetrically`: -1, or 1 where the articulate takes an even number of own sub-steps.
inline double symmetric_sign(const Articulate& a) { return a.sub_steps.count == 1 ? -1.0 : 1.0; }

/// Begins the sum of what the rows exert in a full sub-step, with what they did at its start.
void begin_exerted(Articulate& articulate);
/// Adds what the rows exert by impulses [N s], or by their forces over h [s].
void add_impulses_exerted(Articulate& articulate);
void add_forces_exerted(Articulate& articulate, double h);

}  // namespace pantin
