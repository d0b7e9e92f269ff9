#pragma once
// The laws at work: which particles they act on, as the hot loops of laws/ read them, and the forces that come of it.
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.hpp"
#include "forces/acting_elements.hpp"
#include "forces/swing.hpp"
#include "forces/velocity_kick.hpp"
#include "laws/run/cells.hpp"
#include "laws/run/sites.hpp"
#include "laws/run/skin.hpp"
#include "world/world.hpp"

namespace pantin {

/// A body, or a free point that is tied, on which laws act through its sites.
struct Receiver {
  std::uint32_t slot = 0;  ///< of Model::bodies or points
  bool is_body = true;
  std::int32_t articulate = -1;            ///< index, or -1
  std::uint32_t node = 0;                  ///< of the articulate
  bool pulled = false;                     ///< by laws that are not solved with the articulate
  Vec3 force = zero3(), torque = zero3();  ///< [N], [N m] of laws with energy; world axes, about the centre
  Vec3 nonconservative_force = zero3(), nonconservative_torque = zero3();  ///< of those without
  Vec3 damper_force = zero3(), damper_torque = zero3();  ///< of these, of those that depend on velocities
  Vec3 solved_force = zero3(),
       solved_torque = zero3();               ///< of non-conservative ones, what is solved with the rows in a kick
  bool solved = false;                        ///< whether there is such a part: all of laws of velocity
  Vec3 start_p = zero3(), start_P = zero3();  ///< momenta at the start of the step
  Vec3 noted_torque = zero3();                ///< [N m] before the stage of the step that is being done
};

/// A site on a receiver.
struct Attached {
  std::uint32_t site = 0, receiver = 0;
  bool pulled = true;  ///< by laws that are not solved with the articulate
  Vec3 arm = zero3();  ///< [m] in principal axes
  Vec3 r = zero3();    ///< [m] the same in the world
};

/// What the local errors of kicks come of, see kick_error.hpp.
struct KickNotes {
  std::vector<Vec3> acceleration;  ///< (slots of particles) [m/s²] in the kick that began a stage of the step
  std::vector<Vec3> position;      ///< (slots of particles) [m] then
  std::vector<Vec3> within;        ///< (slots of particles) [m] at a moment within the step, another in each
  /// (slots of particles) [m/s³] in the last stages, the latest first; infinite: unknown. Now, and at the start of the step.
  std::vector<std::array<double, 3>> jerk, kept_jerk;
  /// (slots of particles) [m] errors of what was too young for a size to be relative to. Now, and at the start of the step.
  std::vector<double> untold, kept_untold;
  std::vector<Swing> swing, kept_swing;  ///< (slots of particles) now; at the start of the step where some are young
  std::vector<std::uint32_t> partner;  ///< (slots of particles) that of the nearest of those it interacts with, or none
  std::vector<Vec3> change, moved;     ///< (sites) [m/s²], [m] over the stage
  std::vector<double> turning,
      near;  ///< (sites) [m/s²] of a body's far end; [m] to the nearest thing it interacts with
  double told = 0.0, told_in_step = 0.0;  ///< [1/s] what is told where it is too much: of the last stage, of the step
  bool told_late = false;                 ///< some of that is of steps before
  double jump = 0.0;  ///< [1/s] of the jumps of forces in the last stage, the largest: what it adds from then on
  double jumps_in_step = 0.0;  ///< [1/s²] squares of these over the step
  double jumps = 0.0;          ///< [1/s²] over the time that errors are asked for: their signs are by chance
  std::size_t worst_site = 0;  ///< with the largest error in the last stage
};

struct Forces {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  Sites sites;
  std::vector<std::uint32_t> point;  ///< (sites) slot of a free point that nothing ties, or `none`
  std::vector<double> inverse_mass;  ///< (sites) [1/kg] of such a point, else 0
  std::vector<Vec3> image;           ///< (sites) [m] in a periodic box: position of the particle less that of the site
  std::vector<std::uint32_t> site_of;  ///< (slots of particles), or `none`
  std::vector<Receiver> receivers;
  std::vector<std::uint32_t> receiver_of_body, receiver_of_point;  ///< (slots), or `none`
  std::vector<Attached> attached;
  std::vector<std::uint32_t> attached_of;  ///< (sites), or `none`
  std::vector<ActingInteraction> interactions;
  std::vector<ActingField> fields;
  std::vector<ActingConnections> connections;
  Skin skin;
  bool rows = false;                   ///< some interaction keeps rows
  bool velocity_dependent = false;     ///< some law depends on velocities, beside thermostats
  bool thermal = false;                ///< there is a thermostat
  bool nonconservative = false;        ///< some law is without energy
  bool nonconservative_still = false;  ///< of these some does not depend on velocities
  bool workless = false;               ///< some law of velocity does no work by it
  bool timed = false;                  ///< some law depends on time
  bool noisy = false;                  ///< some law draws noise
  bool everybody = false;              ///< some law acts on all particles
  bool grouped = false;                ///< some field acts on a group
  std::vector<char> families;          ///< (slots of families) whether some law acts on all of it
  std::vector<char> followed;          ///< (names of attributes) whether it follows the age of some site

  std::vector<Vec3> still;  ///< (sites) [N] non-conservative forces of laws that do not depend on velocities
  /// (sites) [N] the same with what laws of velocity also give at rest, and what does no work by the velocity
  std::vector<Vec3> undamped;
  VelocityForces velocity;      ///< of laws that depend on velocities, but for thermostats
  VelocityForces thermostats;   ///< of these
  std::vector<Vec3> open_from;  ///< (slots of particles) [m] where a stage of the step begins, see work_check
  double done = 0.0;            ///< [J] work of laws without energy until then
  std::vector<Vec3>
      noise;        ///< (sites) [N] of the non-conservative forces what is noise, where `accuracy` leaves it out
  KickNotes notes;  ///< of errors, where `accuracy` asks
  AlignedVector<Vec3> kicked_from;  ///< (sites) [m/s] before the kick at the end of a stage, where the ledger is kept
  double energy = 0.0;              ///< [J] of all laws, when it was last told
  bool told = false;                ///< in the last step

  bool unsettled = false;             ///< edits have changed what the forces come of
  bool elsewhere = false;             ///< others than free particles that were born or have gone
  std::vector<ParticleId> changed;    ///< what may have another site now, or none; some may be gone
  std::vector<std::uint32_t> gone;    ///< sites of particles that have gone
  std::vector<std::uint64_t> untied;  ///< serials of connections that have gone
  std::uint64_t settled_in = 0;       ///< the last step, counted from 1, that began with such changes
};

/// Calls use(acting element) in the order in which forces are added.
template <class F, class Use>
void each_element(F& forces, Use use) {
  for (auto& a : forces.interactions) use(a);
  for (auto& a : forces.connections) use(a);
  for (auto& a : forces.fields) use(a);
}
template <class Is>
bool any_element(const Forces& forces, Is is) {
  bool any = false;
  each_element(forces, [&](const ActingElement& a) { any = any || is(a); });
  return any;
}

/// Of the non-conservative force on a site that of laws of velocity, but for those that do no work by it [N].
inline Vec3 damping_of(const Forces& f, std::size_t site) {
  return f.velocity_dependent ? f.sites.nonconservative_force[site] - f.undamped[site] : zero3();
}

/// Whether the laws at work are those of the present rows: not where an edit waits for the next step.
bool acting_now(const World& world);

/// Makes the laws act on what the model now holds, and finds the forces of the present state, where an edit has changed
/// either. Throws Error where a law reads what a particle has not. Where connections were found too stiff for explicit
/// steps, `force_elements_changed` is set again: articulates are to be found anew first.
void refresh_laws(World& world);
/// Warns of laws that do nothing to what they are to act on, once for each field and interaction: laws that go by mass, on
/// points of bodies that have none, and fields on bodies without points.
void tell_idle(World& world);
/// Reads where particles now are, and finds the pairs anew once something has moved too far.
void renew_pairs(World& world);
/// Forces of the present state, after a drift.
void find_forces_after_drift(World& world);
/// Before the kicks of a stage of the step: posts half the work of what only follows ages.
void begin_kick(World& world);
/// Changes velocities and momenta by the forces over `half` [s], those of laws of velocity as velocity_kick.hpp says. Work
/// of laws without energy goes to World::work.
void kick(World& world, double half);
/// Velocities of the sites of laws [m/s] (sites); none where the ledger is not kept.
AlignedVector<Vec3> site_velocities(World& world, bool drifted);
/// Posts for each law what it does in the drift to come beyond its kicks at both ends, since contacts changed these velocities.
void post_laws_beside_kicks(World& world, const AlignedVector<Vec3>& before);
/// Posts what laws that kick did, with the forces of now, while sites were displaced by `ways` [m] (sites): they gave that to
/// what opens overlaps.
void post_displacements(World& world, const AlignedVector<Vec3>& ways);
/// Posts what laws with an energy give in dt [s] at the present velocities.
void post_present_laws(World& world, double dt);
/// Loose things, and the model's rows of those that laws move, as they were before the step's first kick.
void put_back(World& world);
/// The forces of that state anew.
void find_forces_again(World& world);
/// The same at the end of a step.
void kick_to_end(World& world, double half);
/// After the projection: posts what that kick gave to what rows tie, at the velocities that these allow. A motion that they
/// forbid is turned by the drift, so that what a kick gives to it the next one takes back, or else the projection takes:
/// all of this is on that line.
void end_kick(World& world, double half);

/// Gives the receivers of articulates that wake in a stage of a step what its first half kick over `half` [s] and its drift
/// make of what rests in the pulls that they slept in: (articulates) whether it wakes.
void kick_from_rest(World& world, const std::vector<char>& woken, double half);

/// What laws have given to the motion since the start, by their names.
struct LawLedger {
  std::map<std::string, double> given;      ///< [J] by laws with energy: what their energy has fallen by
  std::vector<std::string> without_energy;  ///< names of laws at work that have none, sorted
  double open = 0.0;                        ///< [J] work of those that do not depend on velocities
};
LawLedger law_ledger(const World& world);

/// "lennard_jones: the force between …", of the first force that is not finite; empty where there is none.
std::string bad_force(const World& world);

/// Energy of all laws in the present state, [J].
double law_energy(const World& world);
/// What laws that read no velocities give in the present state.
struct PresentForces {
  double energy = 0.0;   ///< [J]
  std::vector<Vec3> on;  ///< (slots of particles) [N]
};
PresentForces present_forces(const World& world);
/// Of one; none where its law has no energy, or does not act.
std::optional<double> law_energy(const World& world, const ForceElementId& id);
/// Tension of a connection in the last step [N], positive where it pulls; 0 of three or four particles.
double tension(const World& world, ConnectionId id);
std::vector<double> tensions(const World& world);  ///< (slots of connections)

/// What laws read by name: mass [kg], radius [m], age [s], lifetime [s], or an attribute of its family; none where it has
/// no such attribute.
std::optional<double> attribute(const World& world, ParticleId particle, std::string_view name);

}  // namespace pantin
