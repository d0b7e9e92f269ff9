#include "constraints/violation.hpp"

#include <algorithm>

#include "base/functions.hpp"
#include "model/model.hpp"
#include "model/path.hpp"

namespace pantin {

namespace {

Vec3 second_end(const Model& model, const Constraint& c) { return c.b ? position(model, c.b) : c.position; }

Vec3 direction_of(const Model& model, BodyId body, Vec3 axis) {
  return body ? rotate(orientation(model, body), axis) : axis;
}

double gyration(const Model& model, BodyId body) {
  const Motion& m = model.motion_of(body);
  return std::sqrt((m.inertia[0] + m.inertia[1] + m.inertia[2]) / (2.0 * m.mass));
}

/// Where body_b, or the world, wants body_a's frame.
Quat wanted_orientation(const Model& model, const Constraint& c) {
  return c.body_b ? orientation(model, c.body_b) * c.turn : c.turn;
}

Vec3 place_of(const Model& model, const Passage& p) { return p.point ? position(model, p.point) : p.position; }

double angle_between(Vec3 u, Vec3 v) { return functions::atan2(norm(cross(u, v)), dot(u, v)); }

Vec3 point_gap(const Model& model, const Constraint& c) { return position(model, c.a) - c.position; }

/// How far a value is outside the range of a limit.
double outside(const Constraint& limit, double value) {
  return std::fmax(0.0, value - limit.high) + std::fmin(0.0, value - limit.low);
}

}  // namespace

double present_length(const Model& model, const Constraint& c) {
  if (c.kind == ConstraintKind::string) {
    double sum = 0.0;
    for (std::size_t i = 1; i < c.passages.size(); i++)
      sum += norm(place_of(model, c.passages[i]) - place_of(model, c.passages[i - 1]));
    return sum;
  }
  if (c.a) return norm(position(model, c.a) - second_end(model, c));
  const Vec3 axis = direction_of(model, c.body_a, c.axis_a);
  if (c.kind == ConstraintKind::align) return angle_between(axis, direction_of(model, c.body_b, c.axis_b));
  return c.angle;
}

Vec3 present_turn(const Model& model, const Constraint& c) {
  const Quat q = orientation(model, c.body_a) * conjugate(wanted_orientation(model, c));
  const double sign = q.w < 0.0 ? -1.0 : 1.0, s = norm(vec(q.x, q.y, q.z));
  return direction(vec(q.x, q.y, q.z)) * (2.0 * sign * functions::atan2(s, std::fabs(q.w)));
}

double lever(const Model& model, const Constraint& c) {
  const double a = gyration(model, c.body_a);
  return c.body_b ? std::fmin(a, gyration(model, c.body_b)) : a;
}

double present_gap(const Model& model, const Constraint& c) {
  switch (c.kind) {
    case ConstraintKind::nail:
    case ConstraintKind::follow: return c.pins() ? norm(point_gap(model, c) - c.away) : 0.0;
    case ConstraintKind::join:
      return std::isfinite(c.max_force) ? 0.0 : norm(position(model, c.a) - position(model, c.b) - c.away);
    case ConstraintKind::rod: return std::fabs(present_length(model, c) - c.length - c.excess);
    case ConstraintKind::string: return std::fmax(0.0, present_length(model, c) - c.length - c.excess);
    case ConstraintKind::on_path: {
      const Vec3 at = position(model, c.a) - c.away;
      return norm(at - c.path->position(c.path->nearest(at, c.along)));
    }
    case ConstraintKind::on_plane: return std::fabs(dot(c.axis_a, point_gap(model, c) - c.away));
    case ConstraintKind::axis:
      return lever(model, c) *
             norm(cross(direction_of(model, c.body_a, c.axis_a), direction_of(model, c.body_b, c.axis_b)));
    case ConstraintKind::align:
      if (c.length == 0.0 && norm2(c.away) > 0.0) return 0.0;
      return lever(model, c) * std::fabs(present_length(model, c) - c.length - c.excess);
    case ConstraintKind::orient: return lever(model, c) * norm(present_turn(model, c) - c.away);
    case ConstraintKind::weld: {
      const auto at = [&](BodyId body, Vec3 arm) { return origin(model, body) + direction_of(model, body, arm); };
      return std::fmax(norm(at(c.body_a, c.arm_a) - at(c.body_b, c.arm_b)),
                       lever(model, c) * norm(present_turn(model, c)));
    }
    case ConstraintKind::motor: break;
    case ConstraintKind::limit: {
      const double past = std::fabs(outside(c, present_length(model, c))) - std::fabs(c.excess);
      return std::fmax(0.0, c.a ? past : past * lever(model, c));
    }
  }
  return 0.0;
}

namespace {

void start_vector(const Model& model, Constraint& c, double tolerance) {
  Vec3 away = point_gap(model, c), rate = velocity(model, c.a);
  if (c.kind == ConstraintKind::on_plane) {
    away = c.axis_a * dot(c.axis_a, away);
    rate = c.axis_a * dot(c.axis_a, rate);
  }
  const double size = size_of(model, c.a);
  if (norm(away) <= tolerance * (size > 0.0 || c.pins() ? size : largest(c.position))) return;
  c.away = away;
  c.away_rate = rate;
}

Vec3 relative_spin(const Model& model, const Constraint& c) {
  const Vec3 of_a = angular_velocity(model.motion_of(c.body_a));
  return c.body_b ? of_a - angular_velocity(model.motion_of(c.body_b)) : of_a;
}

/// An align to 0 turns its second axis, so that the two are one at once; this is in body_b's frame.
void start_align(const Model& model, Constraint& c, double tolerance) {
  const Quat frame = c.body_b ? orientation(model, c.body_b) : Quat{};
  const Vec3 axis = rotate(conjugate(frame), direction_of(model, c.body_a, c.axis_a));
  const double angle = angle_between(c.axis_b, axis);
  if (angle <= tolerance) return;
  const Vec3 across = cross(c.axis_b, axis);
  const Vec3 any = cross(c.axis_b, std::fabs(c.axis_b[0]) < 0.7 ? vec(1, 0, 0) : vec(0, 1, 0));
  c.away = direction(norm(across) > 1e-9 ? across : any) * angle;
  c.away_rate = direction(c.away) * dot(direction(c.away), rotate(conjugate(frame), relative_spin(model, c)));
}

double present_rate(const Model& model, const Constraint& c) {
  if (c.kind == ConstraintKind::string) {
    double rate = 0.0;
    const auto velocity_of = [&](const Passage& p) { return p.point ? velocity(model, p.point) : zero3(); };
    for (std::size_t i = 1; i < c.passages.size(); i++) {
      const Passage &from = c.passages[i - 1], &to = c.passages[i];
      const Vec3 along = direction(place_of(model, to) - place_of(model, from));
      rate += dot(along, velocity_of(to) - velocity_of(from));
    }
    return rate;
  }
  if (c.a) {
    const Vec3 d = position(model, c.a) - second_end(model, c);
    const Vec3 v = velocity(model, c.a) - (c.b ? velocity(model, c.b) : zero3());
    return dot(direction(d), v);
  }
  const Vec3 axis = direction_of(model, c.body_a, c.axis_a);
  const Vec3 about =
      c.kind == ConstraintKind::align ? direction(cross(direction_of(model, c.body_b, c.axis_b), axis)) : axis;
  return dot(about, relative_spin(model, c));
}

void start_scalar(const Model& model, Constraint& c, double tolerance) {
  const double value = present_length(model, c);
  const double excess = c.kind == ConstraintKind::limit    ? outside(c, value)
                        : c.kind == ConstraintKind::string ? std::fmax(0.0, value - c.length)
                                                           : value - c.length;
  const double size = c.a ? (c.kind == ConstraintKind::limit ? value : c.length) : 1.0;
  if (std::fabs(excess) <= tolerance * size) return;
  c.excess = excess;
  c.excess_rate = present_rate(model, c);
}

}  // namespace

void start_constraint(const Model& model, Constraint& c, double tolerance) {
  c.previous = c.before = c.position;
  c.previous_length = c.before_length = c.length;
  c.previous_turn = c.turn;
  c.velocity = c.away = c.away_rate = c.previous_away = c.spin = c.previous_spin = zero3();
  c.excess = c.excess_rate = c.previous_excess = 0.0;
  if (!c.by_speed) c.length_rate = 0.0;
  c.moves = 0;
  switch (c.kind) {
    case ConstraintKind::follow:
      if (c.pins()) start_vector(model, c, tolerance);
      return;
    case ConstraintKind::nail:
    case ConstraintKind::on_plane: return start_vector(model, c, tolerance);
    case ConstraintKind::join:
      if (std::isfinite(c.max_force)) return;
      c.away = position(model, c.a) - position(model, c.b);
      c.away_rate = velocity(model, c.a) - velocity(model, c.b);
      return;
    case ConstraintKind::align:
      if (c.length == 0.0) return start_align(model, c, tolerance);
      return start_scalar(model, c, tolerance);
    case ConstraintKind::orient:
      c.away = present_turn(model, c);
      if (norm(c.away) <= tolerance)
        c.away = zero3();
      else
        c.away_rate = angular_velocity(model.motion_of(c.body_a));
      return;
    case ConstraintKind::motor:
      if (!c.by_speed) start_scalar(model, c, tolerance);
      return;
    case ConstraintKind::rod:
    case ConstraintKind::string:
    case ConstraintKind::limit: return start_scalar(model, c, tolerance);
    case ConstraintKind::on_path: {
      const Vec3 at = position(model, c.a);
      c.along = c.path->nearest(at);
      const Vec3 T = c.path->tangent(c.along), off = at - c.path->position(c.along), v = velocity(model, c.a);
      if (norm(off) <= tolerance * std::fmax(size_of(model, c.a), largest(at))) return;
      c.away = off;
      c.away_rate = v - T * dot(T, v);
      return;
    }
    case ConstraintKind::axis:
    case ConstraintKind::weld: return;
  }
}

}  // namespace pantin
