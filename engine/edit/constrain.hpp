#pragma once
// Constraints beyond nails, follows and rods: made and changed between two steps. Every function checks its input and
// throws Error, leaving the world as it was. Axes without a word of a frame are in world axes, as things are now.
#include <functional>
#include <limits>
#include <optional>

#include "edit/edit.hpp"

namespace pantin {

/// Makes a constraint of any kind: of what it ties, what it keeps and its time constant, as its file in `constraints` says.
ConstraintId add_constraint(World& world, Constraint constraint);
/// Changes what it was given but for what it ties, by `change`; `call` begins messages. It has the same rows as before.
void change_constraint(World& world, ConstraintId id, std::string_view call,
                       const std::function<void(Constraint&)>& change);

/// Keeps two bodies in their present relative position and orientation; it tells its load, and may break.
ConstraintId add_weld(World& world, BodyId a, BodyId b);

struct OrientDef {
  std::optional<Quat> to;                      ///< orientation of the body's frame; not given: its present one
  std::function<Quat(double)> target;          ///< the same at time t [s]
  double time_constant = usual_time_constant;  ///< [s] > 0
};
/// Keeps the orientation of a body.
ConstraintId add_orient(World& world, BodyId body, const OrientDef& def = {});

struct AlignDef {
  Vec3 axis_a = zero3();                       ///< in the frame of a; of any length but 0
  Vec3 axis_b = zero3();                       ///< in the frame of b, or the world's
  std::optional<double> angle;                 ///< [rad] 0 to π; not given: the present one
  double time_constant = usual_time_constant;  ///< [s] > 0
};
/// Keeps the angle between an axis of a and one of b; null b: of the world.
ConstraintId add_align(World& world, BodyId a, BodyId b, const AlignDef& def);

struct MotorDef {
  Vec3 axis = zero3();                   ///< of any length but 0; stays fixed in a
  std::optional<double> speed;           ///< [rad/s] of a against b, right-handed about the axis
  std::optional<double> angle;           ///< [rad] of a against b, 0 where it is now; one of speed and angle is given
  std::function<double(double)> number;  ///< that one at time t [s], whose present value is given as well
  double max_torque = std::numeric_limits<double>::infinity();  ///< [N m] > 0
  double time_constant = usual_time_constant;                   ///< [s] > 0
};
/// Turns a against b about an axis; null b: against the world. It leaves all other motion free.
ConstraintId add_motor(World& world, BodyId a, BodyId b, const MotorDef& def);

struct LimitDef {
  double min = -std::numeric_limits<double>::infinity();  ///< [rad] or [m]
  double max = std::numeric_limits<double>::infinity();   ///< [rad] or [m] > min; one of them is finite
  double time_constant = usual_time_constant;             ///< [s] > 0
};
/// Keeps the angle of a against b about an axis, 0 where it is now, in a range; null b: against the world.
ConstraintId add_limit(World& world, BodyId a, BodyId b, Vec3 axis, const LimitDef& def);
/// Keeps the distance of two points, or of a point and a position [m], in a range.
ConstraintId add_limit(World& world, PointId a, PointId b, const LimitDef& def);
ConstraintId add_limit(World& world, PointId a, Vec3 position, const LimitDef& def);

struct StringDef {
  std::optional<double> length;                ///< [m] > 0; not given: the present one
  double time_constant = usual_time_constant;  ///< [s] > 0
};
/// At most `length` along its points and positions, two or more, through whose inner ones it slides; it may go slack.
ConstraintId add_string(World& world, std::vector<Passage> passages, const StringDef& def = {});
/// Keeps a point on a path; at the end of an open one it stops.
ConstraintId add_on_path(World& world, PointId point, std::shared_ptr<const Path> path,
                         double time_constant = usual_time_constant);

/// What a constraint keeps as a number: length of a rod or string [m], angle of a motor or align [rad], speed of a
/// motor [rad/s]. Given as a function it is that at time t [s].
void set_length(World& world, ConstraintId constraint, double value, std::function<double(double)> function = {});
void set_attitude(World& world, ConstraintId orient, const Quat& to, std::function<Quat(double)> target = {});
void set_range(World& world, ConstraintId limit, double min, double max);  ///< [rad] or [m]
void set_max_torque(World& world, ConstraintId motor, double torque);      ///< [N m] > 0
void set_breaks_at(World& world, ConstraintId constraint, const Breaking& breaks_at);
void set_breaks_at(World& world, ParticleId hinge, const Breaking& breaks_at);
/// Whether the points of a hinge stay together. They must be together when they are to stay so again.
void set_enabled(World& world, ParticleId hinge, bool enabled);

/// What bore too much.
template <class Id>
struct Overload {
  Id id;
  double load;        ///< [N] or [N m]
  double part;        ///< of what it can bear
  std::string story;  ///< what broke it
  double since;       ///< [s] when it broke, before the end of the step
  bool at_once;       ///< the load leapt there
  friend bool operator==(const Overload& o, Id other) { return o.id == other; }
};
struct Overloads {
  std::vector<Overload<ConstraintId>> constraints;
  std::vector<Overload<ParticleId>> hinges;
  bool empty() const { return constraints.empty() && hinges.empty(); }
};

/// Of those whose load leapt beyond what they bear in the step just done, those that bore most of that.
Overloads overloads_at_once(const World& world);
/// Ends them; told as "broke".
void break_overloaded(World& world, const Overloads& overloads);

/// What broke, with the serials that tell what was made first.
using BrokenThings = std::vector<std::pair<AnyId, std::uint64_t>>;
/// Ends constraints and hinges that bore more in the step just done than they can; told as "broke".
BrokenThings break_constraints(World& world);
/// What broke is told in the order of making: of the notices from `first` on, those of what is in the list.
void tell_in_order(World& world, std::size_t first, const BrokenThings& broken);

}  // namespace pantin
