#include <algorithm>

#include "articulates/solve/state.hpp"
#include "edit/assemble.hpp"
#include "edit/parts.hpp"
#include "model/weigh.hpp"

namespace pantin {

using namespace internal;

namespace {

/// How the frame of one body lies in that of another.
struct Frame {
  Quat turn;
  Vec3 shift;
  Vec3 place(Vec3 v) const { return shift + rotate(turn, v); }
};

Mat3 about_other_position(const OwnMass& own, Vec3 position) {
  const Vec3 r = own.position - position;
  return own.inertia + (identity33() * norm2(r) - outer(r, r)) * own.mass;
}

OwnMass together(const OwnMass& a, const OwnMass& b) {
  OwnMass both;
  both.mass = a.mass + b.mass;
  both.position = both.mass > 0.0 ? a.position + (b.position - a.position) * (b.mass / both.mass) : a.position;
  both.inertia = about_other_position(a, both.position) + about_other_position(b, both.position);
  return both;
}

/// The values of a coupling that b has a part in are a's.
void hand_over(std::vector<CoupledValue>& coupled, BodyId a, BodyId b, const Frame& frame) {
  for (CoupledValue& v : coupled) {
    if (v.body_a == b) {
      v.body_a = a;
      v.axis_a = rotate(frame.turn, v.axis_a);
      v.turn = normalised(v.turn * conjugate(frame.turn));
    }
    if (v.body_b == b) {
      v.body_b = a;
      v.axis_b = rotate(frame.turn, v.axis_b);
      v.position = frame.place(v.position);
      v.turn = normalised(frame.turn * v.turn);
    }
  }
}

/// Whether two bodies that become one turn against each other in it.
bool turns_between(const Constraint& c, BodyId a, BodyId b) {
  const auto is = [&](BodyId first, BodyId second) {
    return (first == a && second == b) || (first == b && second == a);
  };
  return is(c.body_a, c.body_b) || std::any_of(c.coupled().begin(), c.coupled().end(),
                                               [&](const CoupledValue& v) { return is(v.body_a, v.body_b); });
}

/// Rotations that are tied to b are tied to a from now on, as they are now.
void hand_over(World& world, ConstraintId id, BodyId a, BodyId b, const Frame& frame) {
  Constraint& c = world.constraints[id];
  if (c.is<CouplingData>()) hand_over(c.as<CouplingData>().values, a, b, frame);
  if (c.body_a == b) {
    c.body_a = a;
    c.axis_a = rotate(frame.turn, c.axis_a);
    if (c.is<WeldData>()) c.as<WeldData>().arm_a = frame.place(c.as<WeldData>().arm_a);
    c.turn.now = normalised(c.turn.now * conjugate(frame.turn));
    c.turn.previous = normalised(c.turn.previous * conjugate(frame.turn));
    if (const auto wanted = c.turn.of_time) c.turn.of_time = TurnedAttitude{wanted, frame.turn};
  } else if (c.body_b == b) {
    c.body_b = a;
    c.axis_b = rotate(frame.turn, c.axis_b);
    if (c.is<WeldData>()) c.as<WeldData>().arm_b = frame.place(c.as<WeldData>().arm_b);
    c.turn.now = normalised(frame.turn * c.turn.now);
    c.turn.previous = normalised(frame.turn * c.turn.previous);
  }
  std::erase(world.bodies[b].constraints, id);
  std::vector<ConstraintId>& list = world.bodies[a].constraints;
  if (std::find(list.begin(), list.end(), id) == list.end()) list.push_back(id);
  mark_edited(world, c);
}

/// Axes that hinges of both bodies gave to b but not to a are a's now; b is to leave these hinges.
void take_axes(World& world, BodyId a, BodyId b, const Frame& frame) {
  const std::vector<ConstraintId> constraints = world.bodies[b].constraints;
  for (ConstraintId id : constraints) {
    const Constraint& c = world.constraints[id];
    if (!c.ring()) continue;
    const auto& axes = world.particles[c.ring()].axes;
    const bool of_both = std::any_of(axes.begin(), axes.end(), [&](ConstraintId other) {
      const Constraint& o = world.constraints[other];
      return o.as<AxisData>().given == c.as<AxisData>().given && (o.body_a == a || o.body_b == a);
    });
    if (!of_both) hand_over(world, id, a, b, frame);
  }
}

/// Whether a point of one of two bodies that become one counts along an axis of the other.
bool moves_between(const World& world, const Constraint& c, BodyId a, BodyId b) {
  const auto is = [&](BodyId body) { return body && (body == a || body == b); };
  return std::any_of(c.coupled().begin(), c.coupled().end(), [&](const CoupledValue& v) {
    return v.point_a && is(v.body_b) && is(world.points[v.point_a].body);
  });
}

void merge_rotations(World& world, BodyId a, BodyId b, const Frame& frame) {
  for (BodyId body : {a, b}) {
    const std::vector<ConstraintId> constraints = world.bodies[body].constraints;
    for (ConstraintId id : constraints) {
      const Constraint& c = world.constraints[id];
      if (turns_between(c, a, b) || moves_between(world, c, a, b))
        remove(world, id);
      else if (body == b)
        hand_over(world, id, a, b, frame);
    }
  }
}

void take_points(World& world, BodyId a, BodyId b, const Frame& frame) {
  std::vector<PointId>& points = world.bodies[a].points;
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(points.begin(), points.end(), [&](PointId p) { return world.points[p].name == name; });
  };
  for (PointId id : world.bodies[b].points) {
    Point& point = world.points[id];
    point.position = frame.place(point.position);
    point.body = a;
    if (is_taken(point.name)) point.name.clear();
    points.push_back(id);
  }
  world.bodies[b].points.clear();
}

void take_shapes(World& world, BodyId a, BodyId b, const Frame& frame) {
  for (const ShapeId id : world.bodies[b].shapes) {
    Shape& shape = world.shapes[id];
    shape.at = frame.place(shape.at);
    shape.orientation = normalised(frame.turn * shape.orientation);
    shape.material.surface_velocity = rotate(frame.turn, shape.material.surface_velocity);
    shape.body = a;
    world.bodies[a].shapes.push_back(id);
  }
  world.bodies[b].shapes.clear();
}

/// Pushes of this step go on.
void take_pushes(World& world, BodyId a, const Motion& old_a, const Motion& old_b) {
  Motion& m = world.motion_of(a);
  m.force = old_a.force + old_b.force;
  const Vec3 moved = cross(old_a.x - m.x, old_a.force) + cross(old_b.x - m.x, old_b.force);
  m.torque = old_a.torque + old_b.torque + world.plane.about(moved);
}

}  // namespace

void merge(World& world, BodyId a, BodyId b) {
  require_unlocked(world, "merge");
  for (BodyId id : {a, b}) require(world.bodies.alive(id), "merge: ", world.bodies.story(id));
  require(a != b, "merge: both are ", describe(world, a), "; it needs two bodies");
  acted(world);
  disturb_sites(world);
  const Quat to_a = conjugate(orientation(world, a));
  const Frame frame{normalised(to_a * orientation(world, b)), rotate(to_a, origin(world, b) - origin(world, a))};
  const double before = energy_of(world, a) + energy_of(world, b);
  const BodyId both[] = {a, b};
  const Totals kept = totals_of(world, both, {});
  const Motion old_a = world.motion_of(a), old_b = world.motion_of(b);
  const std::string who = text(culprit(world), ", merging it into ", describe(world, a));

  for (BodyId id : both) {
    mark_edited(world, id);
    disturb(world, id);
  }
  std::vector<PointId> points = world.bodies[a].points;
  points.insert(points.end(), world.bodies[b].points.begin(), world.bodies[b].points.end());
  take_axes(world, a, b, frame);
  part_ties_within(world, points, who);
  merge_rotations(world, a, b, frame);
  take_points(world, a, b, frame);
  take_shapes(world, a, b, frame);
  OwnMass own_b = own_mass_of(world.bodies[b]);
  const Mat3 R = matrix(frame.turn);
  own_b.position = frame.place(own_b.position);
  own_b.inertia = times_transposed(R * own_b.inertia, R);
  Body& body = world.bodies[a];
  const OwnMass own = together(own_mass_of(body), own_b);
  body.own_mass = own.mass;
  body.own_inertia = own.inertia;
  body.own_position = own.position;
  erase_body(world, b, who);
  update_mass(world, a);
  set_momenta(world, a, kept.p, kept.angular);
  take_pushes(world, a, old_a, old_b);
  mark_edited(world, a);
  post(world, Source::merge, energy_of(world, a) - before);
}

}  // namespace pantin
