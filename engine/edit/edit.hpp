#pragma once
// Making, joining, cutting, changing and removing things, between two steps. Every function checks its input and throws
// Error, leaving the world as it was. Changes of energy are added to World::work.
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "laws/law.hpp"
#include "world/world.hpp"

namespace pantin {

struct Curve;

/// A named value of a family's attribute.
struct AttributeDef {
  std::string name;
  double value = 0.0;
};

struct FamilyDef {
  std::vector<AttributeDef> attributes;  ///< with the value of a particle that gives none
  std::optional<Color> color;
  std::optional<double> radius;  ///< [m] >= 0
  std::optional<double> mass;    ///< [kg] > 0
  std::optional<Look> look;
  std::shared_ptr<const Cover> sprite;
  std::shared_ptr<const Curves> curves;  ///< of "color", "radius" and its attributes; null: none
  std::optional<Solid> solid;            ///< its particles touch; their radius > 0, and follows no age
  std::string layer;                     ///< of what is solid; empty: of none
  std::string name;                      ///< not empty, and of no other family
};

struct ParticleDef {
  static constexpr Color usual_color = {0.35f, 0.62f, 0.85f, 1.0f};

  Vec3 at = zero3();                                          ///< [m]
  Vec3 velocity = zero3();                                    ///< [m/s]
  std::optional<double> mass;                                 ///< [kg] > 0; not given: its family's, else 1
  std::optional<double> radius;                               ///< [m] >= 0; not given: its family's, else 0.05
  std::optional<Color> color;                                 ///< not given: its family's, else blue
  double lifetime = std::numeric_limits<double>::infinity();  ///< [s] > 0
  FamilyId family;                                            ///< null: of none
  std::vector<AttributeDef> attributes;                       ///< of its family's
  std::optional<Look> look;                                   ///< not given: its family's, else a ball
  std::shared_ptr<const Curves> curves;                       ///< besides its family's; null: none
  std::string name;
};

struct PointDef {
  FamilyId family;                       ///< of its particle; null: of none
  std::vector<AttributeDef> attributes;  ///< of its family's
  Vec3 at = zero3();                     ///< [m] in the body's frame
  double mass = 0.0;                     ///< [kg] >= 0; 0: an anchor
  double radius = 0.0;                   ///< [m] >= 0; 0: the window chooses
  std::optional<Color> color;
  std::string name;
};

/// A shape of a body, in its frame, or of the world.
struct ShapeDef {
  Geometry geometry = BallShape{0.5};
  Vec3 at = zero3();  ///< [m]
  Quat orientation;   ///< normalised when made
  Material material;
  std::string layer;                          ///< empty: of none
  bool sensor = false;                        ///< tells what it touches, and pushes nothing
  Color color = {0.62f, 0.64f, 0.66f, 1.0f};  ///< of one of the world's
  std::optional<double> extent;               ///< [m] > 0: across which a half space is drawn, about its origin
  std::shared_ptr<const Cover> cover;
  std::string name;
};

struct BodyDef {
  std::vector<PointDef> points;
  std::vector<ShapeDef> shapes;  ///< convex ones; where no mass is given, they are filled with their density
  Vec3 at = zero3();             ///< [m] position of the frame's origin
  Quat orientation;              ///< frame to world; normalised when made
  Vec3 velocity = zero3();       ///< [m/s] of the centre of mass
  Vec3 spin = zero3();           ///< [rad/s] world axes
  double mass = 0.0;             ///< [kg] beside the points', at the frame's origin, or spread over the shapes; >= 0
  Mat3 inertia =
      zero33();  ///< [kg m²] beside the points', about the frame's origin, or about the centre of the shapes; symmetric, positive semidefinite
  Color color = {0.93f, 0.55f, 0.27f, 1.0f};
  std::shared_ptr<const Cover> sprite;
  std::string name;
};

struct HingeDef {
  FamilyId family;  ///< null: the first point's
  std::optional<Color> color;
  std::optional<double> radius;                               ///< [m]
  double lifetime = std::numeric_limits<double>::infinity();  ///< [s] > 0
  std::optional<Vec3> axis;                                   ///< turns about it only; world axes, of any length but 0
  bool collide = false;                                       ///< its bodies touch each other, too
  std::string name;
};

struct FollowDef {
  Vec3 at = zero3();                   ///< [m] a position, unless `target` or `hand` is given
  std::function<Vec3(double)> target;  ///< position at time t [s]
  std::int32_t hand = -1;
  double max_force = std::numeric_limits<double>::infinity();  ///< [N] > 0
  double time_constant = 0.05;                                 ///< [s] > 0
};

/// One end of a connection: a particle, or a position of the world [m] where that is null.
struct End {
  ParticleId particle;
  Vec3 position = zero3();
};

struct ConnectionDef {
  std::vector<End> ends;           ///< as many as the law acts on; at least one a particle, all different
  std::vector<double> parameters;  ///< (parameters of the law); empty: the law's
  double max_force = std::numeric_limits<double>::infinity();   ///< [N] > 0, tension at which it breaks
  double max_length = std::numeric_limits<double>::infinity();  ///< [m] > 0 at which it breaks
  Solve solve = Solve::explicitly;  ///< other: in open space, and by a traced law of distance
  std::string name;
};

FamilyId add_family(World& world, const FamilyDef& def);
/// What a law's parameter that is `present` measures of ends now (laws/library.hpp), each at its image that is nearest to
/// the one before.
double present_value(const World& world, std::span<const End> ends);
/// Ties particles by a law. It goes when one of them goes.
ConnectionId add_connection(World& world, std::shared_ptr<const Law> law, const ConnectionDef& def);
/// A law between all pairs of two families, or of one with itself. `parameters` as of a connection.
InteractionId add_interaction(World& world, std::shared_ptr<const Law> law, FamilyId a, FamilyId b,
                              std::vector<double> parameters = {});
/// A law on each particle of a family; of a group, those of its bodies too; or of the whole scene (monostate).
FieldId add_field(World& world, std::shared_ptr<const Law> law, const AnyId& target,
                  std::vector<double> parameters = {});

ParticleId add_particle(World& world, const ParticleDef& def);
BodyId add_body(World& world, const BodyDef& def);
/// A shape that stands in the world.
ShapeId add_shape(World& world, const ShapeDef& def);
/// Several, or none where one of them cannot be.
std::vector<ShapeId> add_shapes(World& world, std::span<const ShapeDef> defs);
/// One more shape of a body, whose mass stays as it is.
ShapeId add_shape(World& world, BodyId body, const ShapeDef& def);
/// The layer of this name; it exists from now on. 0 for the empty one: none.
std::uint32_t layer_of(World& world, std::string_view name);
void set_extent(World& world, ShapeId half_space, std::optional<double> extent);  ///< [m] > 0
void set_layer(World& world, ShapeId shape, std::string_view layer);
void set_sensor(World& world, ShapeId shape, bool sensor);
void set_friction(World& world, ShapeId shape, double friction);        ///< >= 0
void set_restitution(World& world, ShapeId shape, double restitution);  ///< 0 … 1
void set_rolling(World& world, ShapeId shape, double rolling);          ///< [m] >= 0
void set_spinning(World& world, ShapeId shape, double spinning);        ///< [m] >= 0
void set_surface_velocity(World& world, ShapeId shape, Vec3 velocity);  ///< [m/s]
/// The same of a solid family.
void set_layer(World& world, FamilyId family, std::string_view layer);
void set_friction(World& world, FamilyId family, double friction);        ///< >= 0
void set_restitution(World& world, FamilyId family, double restitution);  ///< 0 … 1
/// How shapes of two layers, or two of one, touch from now on: `rule.a` and `rule.b` are set by this.
void set_rule(World& world, std::string_view a, std::string_view b, LayerRule rule);
/// Whether the bodies of a hinge touch each other.
void set_collide(World& world, ParticleId hinge, bool collide);

/// Joins points of different bodies (or free points) into one ring. Points may be in hinges already: the rings unite.
ParticleId add_hinge(World& world, std::span<const PointId> points, const HingeDef& def = {});
/// Keeps a point at `at` [m], or where it is. One far from `at` is drawn there with `time_constant` [s].
ConstraintId add_nail(World& world, PointId point, std::optional<Vec3> at = {}, double time_constant = 0.1);
ConstraintId add_follow(World& world, PointId point, const FollowDef& def);
/// Keeps two points, or a point and a position [m], at a distance [m], or at their present one.
ConstraintId add_rod(World& world, PointId a, PointId b, std::optional<double> length = {});
ConstraintId add_rod(World& world, PointId a, Vec3 position, std::optional<double> length = {});
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
void remove(World& world, ConnectionId connection);
void remove(World& world, InteractionId interaction);
void remove(World& world, FieldId field);
void remove(World& world, GroupId group);      ///< the set, not its members
void remove(World& world, FamilyId family);    ///< only one without particles and laws
void remove(World& world, ShapeId shape);      ///< the body's mass stays as it is
void remove(World& world, EmitterId emitter);  ///< its particles live on
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
/// A particle's own: of a hinge the ring's, not its members'. Attributes that both families have are kept.
void set_family(World& world, ParticleId particle, FamilyId family);
void set_radius(World& world, ParticleId particle, double radius);  ///< [m] >= 0, of what is solid > 0
void set_color(World& world, ParticleId particle, const Color& color);
void set_look(World& world, ParticleId particle, Look look);
void set_attribute(World& world, ParticleId particle, std::string_view name, double value);
/// Makes "color", "radius" or an attribute follow the particle's age, until it is written as a value again.
void set_curve(World& world, ParticleId particle, std::shared_ptr<const Curve> curve);
void set_own_mass(World& world, BodyId body, double mass);
void set_own_inertia(World& world, BodyId body, const Mat3& inertia);

// Acts. A push or twist lasts for the coming step; a kick is an impulse now. `at` [m] in the world, default the centre.
void push(World& world, BodyId body, Vec3 force, std::optional<Vec3> at = {});    ///< [N]
void kick(World& world, BodyId body, Vec3 impulse, std::optional<Vec3> at = {});  ///< [N s]
void twist(World& world, BodyId body, Vec3 torque);                               ///< [N m]
void push(World& world, PointId point, Vec3 force);                               ///< [N]
void kick(World& world, PointId point, Vec3 impulse);                             ///< [N s]

void set_enabled(World& world, ConstraintId constraint, bool enabled);
void set_enabled(World& world, const ForceElementId& element, bool enabled);
/// Writes a parameter of a law in use, by its index; the energy that this makes is work from outside. A cutoff of an
/// interaction that comes of parameters follows them.
void set_parameter(World& world, const ForceElementId& element, std::size_t index, double value);
/// Puts another law with the same parameters in the place of one, wherever that acts.
void replace_law(World& world, const std::shared_ptr<const Law>& law, const std::shared_ptr<const Law>& by);
void set_breaks_at(World& world, ConnectionId connection, double max_force, double max_length);  ///< [N], [m] > 0
void set_target(World& world, ConstraintId follow, std::function<Vec3(double)> target);
void set_position(World& world, ConstraintId constraint,
                  Vec3 position);                                     ///< [m] nail's, follow's target, rod's world end
void set_max_force(World& world, ConstraintId follow, double force);  ///< [N]

/// Changes gravity [m/s²] from now on; the energy that things gain by it is work from outside. In a plane, what it has
/// across that does nothing and is left out.
void set_gravity(World& world, Vec3 gravity);
/// Keeps everything in a plane: things stay at the height that they are at, and forces across it do nothing. Once, and
/// Error where things there are do not fit: what moves out of it, ties between different heights, other axes.
void set_plane(World& world, Plane plane);
/// Edges of the periodic box in which laws see the nearest image of a particle [m], or open space.
void set_box(World& world, std::optional<Vec3> box);
/// Error where it cannot move what there is.
void set_integrator(World& world, Integrator integrator);
/// Wanted error per second, relative to the sizes of things, or fixed steps; > 0. Error where the integrator has none.
void set_accuracy(World& world, std::optional<double> accuracy);
/// Whether that is wanted of each step, not of each second.
void set_accuracy_per_step(World& world, bool per_step);
/// Changes the length of a step [s], from the step that is about to be done.
void set_step(World& world, double step);

}  // namespace pantin
