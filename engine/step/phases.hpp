#pragma once
// The phases of a step, in their order: free functions over the world, each timed under its own name.
#include "world/world.hpp"

namespace pantin::phases {

/// Moves hands to the end of the coming step, and carries out the input's commands.
void begin_step(World& world);
/// Choreography: what is due up to the end of the coming step.
void fire_events(World& world);
/// "step" callbacks, and the notices of the last step; then the targets of follows at the end of the coming step.
void run_behaviours(World& world);
/// Ends of lifetimes up to the end of the coming step: hinges are cut, others removed. Then what emitters make.
void age_particles(World& world);
/// Only what an edit made dirty.
void find_articulates(World& world);
/// After an edit: laws act on what there now is, with the forces of the present state.
void refresh_forces(World& world);
/// Half a step of forces: on free particles gravity and pushes, on all that laws act on theirs.
void half_kick(World& world);
/// Of shapes that touch: impulses with which the drift brings none into another.
void place_contacts(World& world);
/// Moves free particles and bodies on their own, and articulates by Newton's iteration or by their trees; with thermostats in
/// two halves, which these kick between. Where nothing acts in between, also takes out of an articulate's velocities what
/// its constraints forbid.
void drift(World& world);
/// Which shapes touch after the drift; what overlaps is displaced a little.
void find_contacts(World& world);
/// Neighbours, only when something has moved too far.
void find_pairs(World& world);
/// Forces of the laws at the positions after the drift.
void apply_forces(World& world);
/// The same as `half_kick` at the end of a step.
void half_kick_to_end(World& world);
/// Takes out of the velocities what the constraints forbid.
void project_velocities(World& world);
/// Impulses of the whole step: friction, restitution, rest.
void meet_contacts(World& world);
/// Ends connections that were pulled harder or further than they bear, and constraints and hinges that bore too much; joins that
/// met become hinges.
void break_connections(World& world);
/// Time, pushes' end, errors, probes, and the check that all is finite.
void end_step(World& world);

}  // namespace pantin::phases
