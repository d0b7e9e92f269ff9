#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// Takes out of the momenta what the rows forbid, S1 Λ = -(G1 v1 - wanted), p += G1'Λ, once at the end of a full
/// sub-step; without it a velocity that changes its sign each step hides and grows. With `energy_return` the kinetic energy that this took is
/// given back.
void project_articulate(Articulate& articulate, const DriftSettings& settings, DriftReport& report);

/// Before a full sub-step of `full` [s]: takes out of the momenta a running mean of what projections gave, p -= G0'Λ̂ with
/// Λ̂ = ½ (Λ̂ + Λ) after each: with the projection at the end, two equal halves. A solved step turns the sign of a velocity
/// that the rows forbid, so with this it and its projection are nearly reversible together (symmetric projection: Hairer
/// 2000), and energy drifts less; where the articulate takes an even number of own sub-steps, p += G0'Λ̂. Nothing, and false,
/// where the last one was another: edited, halved, a fallback, of another length, or with multipliers that are not all
/// determined.
bool project_symmetrically(Articulate& articulate, double full, DriftReport& report);

/// Sets M and C of the rows for projections, from what velocities are forbidden: M = kept, C = 1 - M.
void set_kept_matrices(Articulate& articulate);

/// Makes momenta consistent (an inelastic impact), with the least compliance there is: anchors may be
/// near-singular or contradict each other. Rows that hold let go where they would have to do what they cannot: a stop to
/// pull, beyond what it gave if it was struck in the last `struck_for` [s], a motor to exert more than it can in `time` [s].
/// Arms at the nodes' ends; ends must equal starts. Returns the work of what is prescribed.
ImpulseWork make_consistent(Articulate& articulate, double time, double struck_for = 0.0);

/// Puts rows where nodes start, at a moment `at` (0 … 1) of the scene's step, `step` [s], and finds which velocities they forbid
/// there, if anchors move as at `wanted_at`: Condition::kept and wanted, RowEnds::r1.
void place_velocity_constraints(Articulate& articulate, double step, double at, double wanted_at);

/// Gets an articulate ready for `answer`: finds what the rows that hold forbid at the nodes' starts, Condition::wanted, and
/// their factor with a compliance `epsilon` at least, unless the articulate has one.
void begin_answers(Articulate& articulate, double epsilon);
/// Takes out of the batches' momenta what the rows forbid; Articulate::impulses are those of it. Returns the work of what
/// is prescribed.
ImpulseWork answer(Articulate& articulate);
/// Lets rows of limited force give way whose impulses of the last answer are more than it gives in h [s].
void let_answers_give_way(Articulate& articulate, double h);
/// After `begin_answers`: makes what is driven stay as fast as it is in the batches now, so that answers are to what comes alone.
/// It works at what it wanted, unless that is a jump.
void keep_driven_velocities(Articulate& articulate);

}  // namespace pantin
