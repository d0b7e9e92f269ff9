#pragma once
// Where the ends of constraints are now.
#include <cmath>
#include <string_view>

#include "base/functions.hpp"
#include "model/model.hpp"

namespace pantin {

inline Vec3 direction_of(const Model& model, BodyId body, Vec3 axis) {
  return body ? rotate(orientation(model, body), axis) : axis;
}
inline double angle_between(Vec3 u, Vec3 v) { return functions::atan2(norm(cross(u, v)), dot(u, v)); }

/// From the position that a constraint names to its point [m].
inline Vec3 from_position(const Model& model, const Constraint& c) { return position(model, c.a) - c.position.now; }

inline double end_distance(const Model& model, const Constraint& c) {
  return norm(position(model, c.a) - (c.b ? position(model, c.b) : c.position.now));
}
/// Rate of that [m/s].
double end_distance_rate(const Model& model, const Constraint& c);

/// How far a body is turned about an axis against another, or the world [rad], nearest to what was counted last: it may have
/// turned while nothing counted. `turn`: the orientation that counts as 0; `axis_b`: in the frame of body_b.
double present_angle(const Model& model, BodyId body_a, BodyId body_b, const Quat& turn, Vec3 axis_b, double last);
/// Counts the angle of a constraint on one anew where it is another by now.
void count_anew(const Model& model, Constraint& c);
inline Vec3 relative_spin(const Model& model, const Constraint& c) {
  const Vec3 of_a = angular_velocity(model.motion_of(c.body_a));
  return c.body_b ? of_a - angular_velocity(model.motion_of(c.body_b)) : of_a;
}

/// Rotation vector, world axes, from where an orient or weld wants its body to where it is [rad].
Vec3 present_turn(const Model& model, const Constraint& constraint);
/// The lesser of the mean radii of gyration of a body and of another, or null [m]: turns an angle into a distance.
double lever(const Model& model, BodyId a, BodyId b);
inline double lever(const Model& model, const Constraint& c) { return lever(model, c.body_a, c.body_b); }

/// Throws Error, which begins with the kind's name, unless its second end is another particle than the first, not of one body
/// with it, or a finite position; `hint` ends what is said of one particle.
void require_two_ends(const Model& model, const Constraint& constraint, std::string_view hint = "");

/// Notes what is far: `value` is `excess` beyond what it is to be, and grows by `rate`; `size` says what is far.
void start_number(Constraint& c, double excess, double rate, double allowed);
/// The same of a point that is `away` [m] from where it is to be, at a velocity of `rate` [m/s].
void start_point(const Model& model, Constraint& c, Vec3 away, Vec3 rate, double tolerance);

}  // namespace pantin
