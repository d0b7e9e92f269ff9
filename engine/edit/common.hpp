#pragma once
// What every edit shares: the energy it makes, and how things join and leave rings.
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "constraints/kind.hpp"
#include "edit/edit.hpp"
#include "forces/disturb.hpp"
#include "model/weigh.hpp"
#include "world/checks.hpp"
#include "world/in_plane.hpp"
#include "world/record.hpp"

namespace pantin::internal {

/// Kinetic and potential energy of one thing, [J].
double energy_of(const World& world, BodyId body);
double energy_of(const World& world, PointId free_point);
/// Of a free point, or of the body that the point belongs to.
double energy_round(const World& world, PointId point);

/// Values of a family's attributes: those given, else the family's. Throws Error for a name that it does not have.
std::vector<double> attribute_values(std::string_view call, const Family& family, std::span<const AttributeDef> given);

/// The curves of a new particle: its family's, less what is given as a value, with its own. Throws Error for a name that
/// neither a particle nor its family has.
std::shared_ptr<const Curves> curves_of(std::string_view call, const Family& family,
                                        const std::shared_ptr<const Curves>& own, bool radius_given, bool color_given,
                                        std::span<const AttributeDef> given);

/// Throws Error where what is solid would have no radius [m], or one that follows its age.
void require_solid_radius(std::string_view call, const Family& family, double radius, const Curves* curves);

/// A constraint starts anew, see constraints/kind.hpp.
inline void start_constraint(const World& world, Constraint& constraint) {
  pantin::start_constraint(world, constraint, world.settings.tolerance);
}
void require_point(const World& world, std::string_view call, PointId point);
/// A body that has an orientation.
void require_turning(const World& world, std::string_view call, BodyId body);
/// A direction of the world in a body's frame; null: in the world's.
Vec3 in_frame(const World& world, BodyId body, Vec3 v);
/// Throws Error where a constraint cannot be what it was given; brings that into form. `same`: what it is to replace.
void check_constraint(const World& world, Constraint& constraint, ConstraintId same = {});
/// Puts a constraint into the world as it is. Throws Error where it does not fit into the world's plane.
ConstraintId insert_constraint(World& world, Constraint constraint);
/// Takes a constraint out of the rows of what it ties, and of the world.
void take_out_constraint(World& world, ConstraintId constraint, Obituary obituary);
/// Empties the hand that grabs by this constraint, which goes: told as "drop", with the point. False where none does.
bool let_go(World& world, ConstraintId constraint);
/// Ends a connection that bore no more than `force` [N]; told as "broke". May be called inside a step.
void break_connection(World& world, ConnectionId connection, double force);

/// Throws Error where a shape is none: of no size, not finite, of a material that is none; or cannot be a body's.
void check_shape(const std::string& who, const ShapeDef& def, bool of_body);
/// A convex shape filled evenly.
struct Filled {
  Geometry geometry;
  Vec3 at;           ///< [m] in a body's frame
  Quat orientation;  ///< its axes to that
  double density;    ///< [kg/m³]
};
/// Mass, centre and inertia about it of one or more.
OwnMass mass_of(std::span<const Filled> shapes);
/// By how much a mass that is given makes shapes denser than theirs.
double filling(const BodyDef& def);
void require_friction(const std::string& who, double friction);
void require_restitution(const std::string& who, double restitution);
/// What a body of these shapes has beside its points, with the mass and inertia given or else theirs.
OwnMass own_mass_of(const BodyDef& def);
void erase_shape(World& world, ShapeId id, const std::string& who);
/// Shapes of a body that goes.
void erase_shapes(World& world, BodyId body, const std::string& who);

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
Vec3 present(World& world, const std::function<Vec3(double)>& position);

/// A constraint of one of these kinds, awake; throws Error where it is another.
Constraint& of_kinds(World& world, ConstraintId id, std::initializer_list<ConstraintKind> kinds, const char* call);

}  // namespace pantin::internal
