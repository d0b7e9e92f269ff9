#pragma once
// Making, joining, cutting, changing and removing things, between two steps. Every function checks its input and throws
// Error, leaving the world as it was. Changes of energy are added to World::work.
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace pantin {

struct ParticleDef {
  Vec3 at = zero3();        ///< [m]
  Vec3 velocity = zero3();  ///< [m/s]
  double mass = 1.0;        ///< [kg] > 0
  double radius = 0.05;     ///< [m] >= 0
  Color color = {0.35f, 0.62f, 0.85f, 1.0f};
  double lifetime = std::numeric_limits<double>::infinity();  ///< [s] > 0
  std::string name;
};

struct PointDef {
  Vec3 at = zero3();    ///< [m] in the body's frame
  double mass = 0.0;    ///< [kg] >= 0; 0: an anchor
  double radius = 0.0;  ///< [m] >= 0; 0: the window chooses
  std::optional<Color> color;
  std::string name;
};

struct BodyDef {
  std::vector<PointDef> points;
  Vec3 at = zero3();        ///< [m] place of the frame's origin
  Quat orientation;         ///< frame to world; normalised when made
  Vec3 velocity = zero3();  ///< [m/s] of the centre of mass
  Vec3 spin = zero3();      ///< [rad/s] world axes
  double mass = 0.0;        ///< [kg] beside the points', at the frame's origin; >= 0
  Mat3 inertia = zero33();  ///< [kg m²] beside the points', about the frame's origin; symmetric, positive semidefinite
  Color color = {0.93f, 0.55f, 0.27f, 1.0f};
  std::string name;
};

struct HingeDef {
  std::optional<Color> color;
  std::optional<double> radius;                               ///< [m]
  double lifetime = std::numeric_limits<double>::infinity();  ///< [s] > 0
  std::string name;
};

struct FollowDef {
  Vec3 at = zero3();                   ///< [m] a place, unless `target` or `hand` is given
  std::function<Vec3(double)> target;  ///< place at time t [s]
  std::int32_t hand = -1;
  double max_force = std::numeric_limits<double>::infinity();  ///< [N] > 0
  double time_constant = 0.05;                                 ///< [s] > 0
};

ParticleId add_particle(World& world, const ParticleDef& def);
BodyId add_body(World& world, const BodyDef& def);
/// Joins points of different bodies (or free points) into one ring. Points may be in hinges already: the rings unite.
ParticleId add_hinge(World& world, std::span<const PointId> points, const HingeDef& def = {});
/// Keeps a point at `at` [m], or where it is. One far from `at` is drawn there with `time_constant` [s].
ConstraintId add_nail(World& world, PointId point, std::optional<Vec3> at = {}, double time_constant = 0.1);
ConstraintId add_follow(World& world, PointId point, const FollowDef& def);
/// Keeps two points, or a point and a place [m], at a distance [m], or at their present one.
ConstraintId add_rod(World& world, PointId a, PointId b, std::optional<double> length = {});
ConstraintId add_rod(World& world, PointId a, Vec3 place, std::optional<double> length = {});
GroupId add_group(World& world, std::string name);
void add_to_group(World& world, GroupId group, AnyId thing);
void remove_from_group(World& world, GroupId group, AnyId thing);

/// Frees all members of a hinge, or those of one body; cut points get copies of the shared data.
void cut(World& world, ParticleId hinge);
void cut(World& world, ParticleId hinge, BodyId body);

/// A body goes with its points; a particle of a body's point cannot be removed (Error names remove_point).
void remove(World& world, BodyId body);
void remove(World& world, ParticleId particle);
void remove(World& world, PointId point);
void remove(World& world, ConstraintId constraint);
void remove(World& world, GroupId group);  ///< the set, not its members
void remove(World& world, const AnyId& thing);

PointId add_point(World& world, BodyId body, const PointDef& def);
void remove_point(World& world, PointId point);

// State. Positions [m], velocities [m/s], spins [rad/s] world axes, masses [kg], inertia [kg m²].
void set_position(World& world, PointId free_point, Vec3 at);
void set_velocity(World& world, PointId free_point, Vec3 velocity);
void set_mass(World& world, PointId point, double mass);
void set_position(World& world, BodyId body, Vec3 centre);
void set_origin(World& world, BodyId body, Vec3 origin);
/// Turns about the centre of mass; the spin in world axes stays.
void set_orientation(World& world, BodyId body, Quat orientation);
void set_velocity(World& world, BodyId body, Vec3 velocity);
void set_spin(World& world, BodyId body, Vec3 spin);
void set_lifetime(World& world, ParticleId particle, double lifetime);  ///< [s] from its making; > 0
void set_own_mass(World& world, BodyId body, double mass);
void set_own_inertia(World& world, BodyId body, const Mat3& inertia);

// Acts. A push or twist lasts for the coming step; a kick is an impulse now. `at` [m] in the world, default the centre.
void push(World& world, BodyId body, Vec3 force, std::optional<Vec3> at = {});    ///< [N]
void kick(World& world, BodyId body, Vec3 impulse, std::optional<Vec3> at = {});  ///< [N s]
void twist(World& world, BodyId body, Vec3 torque);                               ///< [N m]
void push(World& world, PointId point, Vec3 force);                               ///< [N]
void kick(World& world, PointId point, Vec3 impulse);                             ///< [N s]

void set_enabled(World& world, ConstraintId constraint, bool enabled);
void set_length(World& world, ConstraintId rod, double length);  ///< [m]; it is drawn in within some 0.1 s
void set_target(World& world, ConstraintId follow, std::function<Vec3(double)> target);
void set_place(World& world, ConstraintId constraint, Vec3 place);    ///< [m] nail's, follow's target, rod's world end
void set_max_force(World& world, ConstraintId follow, double force);  ///< [N]

/// Changes gravity [m/s²] from now on; the energy that things gain by it is work from outside.
void set_gravity(World& world, Vec3 gravity);
/// Changes the length of a step [s], from the step that is about to be done.
void set_step(World& world, double step);

}  // namespace pantin
