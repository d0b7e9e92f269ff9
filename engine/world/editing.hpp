#pragma once
// What every edit shares: checks, the energy it makes, and how things leave their rings. Not for use outside world/.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "world/edit.hpp"

namespace pantin::editing {

/// Throws Error unless the world may be edited now; `call` begins the message.
void require_unlocked(const World& world, std::string_view call);

std::string to_text(Vec3 v);
/// "<call>: <name> must be finite, got (NaN, 0, 0) m"
void require_finite(std::string_view call, std::string_view name, Vec3 v, std::string_view unit);
void require_finite(std::string_view call, std::string_view name, double x, std::string_view unit);
void require_positive(std::string_view call, std::string_view name, double x, std::string_view unit);
/// Above zero, or infinite.
void require_positive_or_infinite(std::string_view call, std::string_view name, double x, std::string_view unit);
void require_not_negative(std::string_view call, std::string_view name, double x, std::string_view unit);
/// Finite, symmetric, positive semidefinite and of a real body: no principal moment above the sum of the others.
void require_inertia(std::string_view call, const Mat3& inertia);
/// The quaternion at unit length; throws Error where it has none.
Quat unit(std::string_view call, const Quat& q);

/// In a scene in a plane: that a vector has no part across it; that one has no part but that; that a place has the height
/// of another; that a body comes to an orientation by a turn about the normal. Throws Error where it is not so.
void require_in_plane(const World& world, std::string_view call, std::string_view name, Vec3 v, std::string_view unit);
void require_about_normal(const World& world, std::string_view call, std::string_view name, Vec3 v,
                          std::string_view unit);
void require_height(const World& world, std::string_view call, std::string_view name, Vec3 place, Vec3 of);
void require_turn(const World& world, std::string_view call, BodyId body, const Quat& orientation);
/// The same of what a constraint ties.
void require_in_plane(const World& world, const Constraint& constraint);
/// The orientation in the plane that is nearest to one.
Quat turned_in_plane(const World& world, BodyId body, const Quat& orientation);

/// Kinetic and potential energy of one thing, [J].
double energy_of(const World& world, BodyId body);
double energy_of(const World& world, PointId free_point);
/// Of a free point, or of the body that the point belongs to.
double energy_round(const World& world, PointId point);
/// Adds to World::work, [J]. The first step starts the balance anew, so building a scene is no work.
void post(World& world, double joules, Source source = Source::edit);

/// Call before an edit that changes which laws act, or on what: the energy of the laws before the edit leaves the balance,
/// and comes back with the forces of the next step. What else is called "disturb" does the same, before other edits.
void disturb_forces(World& world);
/// What bodies and points are, where they are, and what is tied: what is touched is looked at anew, all else stays as it is.
void disturb_sites(World& world);
/// What laws see of one particle.
void disturb_site(World& world, ParticleId particle);
/// Velocities.
void disturb_forces_by_motion(World& world);
/// A free particle of a family, or of none, is made, after which `note_site` is to be called.
void disturb_forces_by_birth(World& world, FamilyId family);
void note_site(World& world, ParticleId particle);
/// A particle is removed.
void disturb_forces_by_death(World& world, ParticleId particle);
/// A connection is removed.
void disturb_forces_by_break(World& world, const Connection& connection);
/// Of what edits have touched.
void note_touched_sites(World& world);
/// Values of a family's attributes: those given, else the family's. Throws Error for a name that it does not have.
std::vector<double> attribute_values(std::string_view call, const Family& family, std::span<const AttributeDef> given);

/// Whether a law's parameter of that name is the world's own: the length of its step, and k_B.
inline bool given_by_world(std::string_view name) { return name == "step" || name == "boltzmann"; }
/// Takes a constraint out of the rows of what it ties, and of the world.
void take_out_constraint(World& world, ConstraintId constraint, Obituary obituary);
/// Empties the hand that grabs by this constraint, which goes: told as "drop", with the point. False where none does.
bool let_go(World& world, ConstraintId constraint);
/// Ends a connection that bore no more than `force` [N]; told as "broke". May be called inside a step.
void break_connection(World& world, ConnectionId connection, double force);

std::string culprit(const World& world);
/// Remembers who acts, for the case that the state goes wrong.
void acted(World& world);
Obituary obituary(const World& world, std::string what);
void notice(World& world, Notice::Kind kind, const AnyId& thing, std::string story, std::int32_t hand = -1);

/// The largest arm of a point's body or distance between its points, [m]; 0 of a free point.
double size_of(const Model& model, PointId point);
/// A spin, torque or moment in world axes, in principal axes: less its part along the line of a body that cannot turn
/// about it, or but that about the normal of a plane; 0 for one that cannot turn at all.
Vec3 turning_part(const Motion& motion, Vec3 v);

/// A point with its own particle, in no body yet.
PointId make_point(World& world, Point row);
/// Ends a hinge: its points' own particles wake with copies of the shared data.
void end_ring(World& world, ParticleId hinge, std::string who);
/// Whether the points of a hinge are within the scene's tolerance; throws Error where they are not.
void require_together(const World& world, std::span<const PointId> points);
/// Makes some bodies of a hinge turn about an axis only [world axes]; `require_axis` throws Error where that cannot be.
void add_axes(World& world, ParticleId hinge, std::span<const BodyId> bodies, Vec3 axis);
/// The axes of a hinge that joins into another one stay, with the bodies that they were given to.
void take_over_axes(World& world, ParticleId from, ParticleId to);
void require_axis(const World& world, std::span<const BodyId> bodies, Vec3 axis);
/// Ends the axes of a hinge that concern a body, or all (null).
void drop_axes(World& world, ParticleId hinge, BodyId body);
/// Takes one point out of its hinge; a hinge of one point ends. `who` goes into its obituary.
void leave_ring(World& world, PointId point, const std::string& who);
/// Removes constraints of a point, takes it out of its ring, and removes it with its particle.
void erase_point(World& world, PointId point, const std::string& what);
/// The nail or rigid follow that already holds a ring in place, or null.
ConstraintId holder(const Model& model, ParticleId ring);
/// Throws Error where something other than `but` holds the point's ring in place already.
void require_free_of_holders(const World& world, std::string_view call, PointId point, ConstraintId but = {});

/// Where a target or path is now, [m]. It looks and answers: the world is locked meanwhile.
Vec3 present(World& world, const std::function<Vec3(double)>& place);

}  // namespace pantin::editing
