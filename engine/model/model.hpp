#pragma once
// The rows of the world and what follows from them alone; no stepping.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/store.hpp"
#include "model/body.hpp"
#include "model/constraint.hpp"
#include "model/emitter.hpp"
#include "model/family.hpp"
#include "model/force_element.hpp"
#include "model/group.hpp"
#include "model/layers.hpp"
#include "model/particle.hpp"
#include "model/plane.hpp"
#include "model/point.hpp"
#include "model/shape.hpp"

namespace pantin {

/// A body, or a free point, that an edit concerned; it may have gone since.
struct EditedThing {
  BodyId body;
  PointId point;            ///< where body is null
  std::int32_t articulate;  ///< that it was in, or -1
};

struct Model {
  Plane plane;  ///< that everything moves in
  Store<Point> points;
  std::vector<FreeMotion> free_motion;  ///< (slots of points)
  Store<Particle> particles;
  Store<Body> bodies;
  std::vector<Motion> motion;  ///< (slots of bodies)
  Store<Constraint> constraints;
  Store<Group> groups;
  Store<Family> families;
  Store<Connection> connections;
  Store<Interaction> interactions;
  Store<Field> fields;
  Store<Emitter> emitters;
  Store<Shape> shapes;
  Layers layers;        ///< that shapes and solid families are in
  bool solids = false;  ///< a family is solid
  std::uint64_t next_serial = 1;
  bool topology_changed = true;            ///< an edit waits for `find_articulates`
  bool force_elements_changed = false;     ///< an edit concerns which laws act on what
  bool places_changed = true;              ///< an edit concerns where things are, or their shapes
  std::vector<EditedThing> edited_things;  ///< whose ties are to be looked at anew
  std::vector<BodyId> stirred;             ///< that an edit or a force concerned: what sleeps with them is to wake
  std::vector<std::int32_t> disturbed;     ///< articulates whose positions or velocities an edit changed

  FreeMotion& motion_of(PointId id) { return (void)points[id], free_motion[id.slot - 1]; }
  const FreeMotion& motion_of(PointId id) const { return (void)points[id], free_motion[id.slot - 1]; }
  Motion& motion_of(BodyId id) { return (void)bodies[id], motion[id.slot - 1]; }
  const Motion& motion_of(BodyId id) const { return (void)bodies[id], motion[id.slot - 1]; }
};

/// The row of a connection, interaction or field.
const ForceElement& force_element(const Model& m, const ForceElementId& id);
ForceElement& force_element(Model& m, const ForceElementId& id);
/// Calls use(row) for all of them, in this order.
template <class Use>
void each_force_element(const Model& m, Use use) {
  for (ConnectionId id : m.connections.ids()) use(m.connections[id]);
  for (InteractionId id : m.interactions.ids()) use(m.interactions[id]);
  for (FieldId id : m.fields.ids()) use(m.fields[id]);
}

/// Place and velocity of a point in the world, [m], [m/s].
Vec3 position(const Model& m, PointId point);
Vec3 velocity(const Model& m, PointId point);
/// Place of a point relative to its body's centre of mass in principal axes, [m].
Vec3 arm(const Model& m, PointId point);
/// How a free point touches; null where it does not.
const Solid* solid_of(const Model& m, const Point& point);
/// What it is drawn with, and touches as where it is solid, [m]; of a body's point the same.
double radius_of(const Model& m, const Point& point);
/// Mean of a ring's points (they coincide up to the gap), [m]; of a sleeping particle its hinge's.
Vec3 position(const Model& m, ParticleId particle);
Vec3 velocity(const Model& m, ParticleId particle);
/// Where a connection ends, [m]: its particle, or its position.
Vec3 end_of(const Model& m, const Connection& connection, std::size_t end);
/// Sum of the points' masses, [kg].
double mass(const Model& m, ParticleId particle);
/// The hinge a particle sleeps in, or itself.
ParticleId awake(const Model& m, ParticleId particle);
/// The point at which a ring is pulled: of its heaviest body (ties: the oldest point).
PointId star(const Model& m, ParticleId particle);

/// The body's frame: position of its origin [m], orientation (frame to world).
Vec3 origin(const Model& m, BodyId body);
Quat orientation(const Model& m, BodyId body);
/// In a plane, its normal in a frame [frame to world]; in space 0.
Vec3 normal_in(const Model& m, const Quat& frame);
/// Angular momentum about the centre of mass, world axes, [kg m²/s].
Vec3 angular_momentum(const Model& m, BodyId body);
/// Inertia about the centre of mass in the world's axes, [kg m²].
Mat3 inertia(const Model& m, BodyId body);

/// Works out mass, centre, principal axes and freedom of a body from its points and own mass, keeping its frame's position
/// and the velocity of every point. Throws Error where the body has no mass, or mass at one position only and points
/// elsewhere; the body is then as it was.
void update_mass(Model& m, BodyId body);
/// Sets the principal moments that a body moves with: its own, or where it is tied none below `least_inertia` of the
/// largest. Keeps the velocity of every point; returns the energy that this gave [J].
double settle_inertia(Model& m, BodyId body, bool tied);
/// The largest arm of a point's body, distance between its points or reach of a shape from its centre, [m]; 0 of a free
/// point.
double size_of(const Model& model, PointId point);
/// A spin, torque or moment in world axes, in principal axes: less its part along the line of a body that cannot turn
/// about it, or but that about the normal of a plane; 0 for one that cannot turn at all.
Vec3 turning_part(const Motion& motion, Vec3 v);
/// The same of one that has this orientation by now.
Vec3 turning_part(const Motion& motion, Quat q, Vec3 v);
/// By how much the smallest is larger than its own [kg m²].
double lift(const Model& m, BodyId body);

/// Has the ties of a thing looked at anew before the next step: call where an edit changes mass, positions of points in
/// their body, or what a thing is tied to.
void mark_edited(Model& m, BodyId body);
void mark_edited(Model& m, PointId point);
void mark_edited(Model& m, ParticleId particle);
/// The same, and the state of what it ties is no longer what the last step left.
void mark_edited(Model& m, const Constraint& constraint);
/// Says that an edit changed the position or velocity of a thing: velocities of its articulate are to be made consistent.
void disturb(Model& m, BodyId body);
void disturb(Model& m, PointId point);

/// "body 'arm'", "hinge 'elbow'", "particle 7" …: how messages call a thing.
std::string describe(const Model& m, PointId id);
std::vector<std::string> describe_points(const Model& m, BodyId body);  ///< all of one that is alive, in their order
std::string describe(const Model& m, ParticleId id);
std::string describe(const Model& m, BodyId id);
std::string describe(const Model& m, ConstraintId id);
std::string_view kind_name(ConstraintKind kind);  ///< as messages call it
std::string describe(const Model& m, GroupId id);
std::string describe(const Model& m, FamilyId id);
std::string describe(const Model& m, ConnectionId id);
std::string describe(const Model& m, InteractionId id);
std::string describe(const Model& m, FieldId id);
std::string describe(const Model& m, EmitterId id);
std::string describe(const Model& m, ShapeId id);
std::string describe(const Model& m, const AnyId& id);
bool alive(const Model& m, const AnyId& id);
/// Living members of a group, and those of groups among them.
std::vector<AnyId> all_members(const Model& m, GroupId group);

/// Principal moments and axes (columns) of a symmetric matrix by Jacobi's method with a fixed number of sweeps, moments
/// in rising order (up to round-off), axes right-handed with signs nearest to the columns of `near`.
struct Principal {
  Vec3 moments;
  Mat3 axes;
};
Principal principal_axes(const Mat3& symmetric, const Mat3& near);

}  // namespace pantin
