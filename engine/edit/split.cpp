#include <algorithm>
#include <unordered_set>

#include "articulates/solve/state.hpp"
#include "edit/assemble.hpp"
#include "edit/parts.hpp"
#include "model/weigh.hpp"

namespace pantin {

using namespace internal;

namespace {

std::vector<MassPoint> masses_of(const World& world, const std::vector<PointId>& points) {
  std::vector<MassPoint> masses;
  for (PointId p : points) masses.push_back({world.points[p].position, world.points[p].mass});
  return masses;
}

/// The points that stay; throws Error where the call makes no sense.
std::vector<PointId> rest_of(const World& world, BodyId body, std::span<const PointId> points) {
  require(!points.empty(), "split: no points were given, so there is nothing to split off");
  const std::string who = describe(world, body);
  std::unordered_set<PointId> taken;
  for (std::size_t i = 0; i < points.size(); i++) {
    require(world.points.alive(points[i]), "split: point ", i + 1, ": ", world.points.story(points[i]));
    require(world.points[points[i]].body == body, "split: ", describe(world, points[i]), " is not of ", who);
    require(taken.insert(points[i]).second, "split: ", describe(world, points[i]), " is given twice");
  }
  std::vector<PointId> rest;
  for (PointId p : world.bodies[body].points)
    if (!taken.contains(p)) rest.push_back(p);
  require(!rest.empty(), "split: these are all points of ", who, "; it must keep one");
  return rest;
}

/// Axes of hinges go with the points that the hinges hold.
void take_axes(World& world, BodyId body, BodyId fresh) {
  for (PointId p : world.bodies[fresh].points)
    for (ConstraintId id : world.particles[world.points[p].particle].axes) {
      Constraint& c = world.constraints[id];
      BodyId& end = c.body_a == body ? c.body_a : c.body_b;
      if (end != body) continue;
      end = fresh;
      std::erase(world.bodies[body].constraints, id);
      world.bodies[fresh].constraints.push_back(id);
    }
}

/// What cannot turn any more has no rotation to tie.
void drop_turns(World& world, BodyId body) {
  if (world.motion_of(body).freedom != Freedom::point) return;
  drop_rotations(world, body);
}

/// A part of a moving body on its own.
Motion part_of(const Weighed& w, const World& world, BodyId body, Vec3 spin) {
  const Motion& old = world.motion_of(body);
  const Quat frame = orientation(world, body);
  Motion m;
  m.mass = w.mass;
  m.inertia = w.moments;
  m.freedom = w.freedom;
  m.q = world.plane.about(normalised(frame * w.axes));
  m.x = origin(world, body) + rotate(frame, w.centre);
  m.p = (old.p / old.mass + cross(spin, m.x - old.x)) * m.mass;
  m.angular = m.inertia * turning_part(m, spin);
  return m;
}

/// What the two parts of a body miss of its angular momentum, because an inertia is lifted, goes into their spins, and
/// what these cannot take into their motion about each other. `arm` [m] is how far they are from the frame's origin.
void keep_momenta(const Plane& plane, const Motion& whole, const std::string& who, double arm, Motion& a, Motion& b) {
  a.p = whole.p - b.p;
  Vec3 missing = rotate(whole.q, whole.angular);
  double least = 1e-13 * norm(missing);
  for (Motion* m : {&a, &b}) {
    missing -= plane.about(cross(m->x - whole.x, m->p)) + rotate(m->q, m->angular);
    least += (1e-13 * norm(m->x - whole.x) + round_off * (norm(m->x) + arm)) * norm(m->p);
  }
  for (Motion* m : {&a, &b}) {
    const Vec3 part = turning_part(*m, missing);
    m->angular += part;
    missing -= rotate(m->q, part);
  }
  const Vec3 d = plane.along(a.x - b.x);
  if (norm2(d) > 0.0) {
    const Vec3 impulse = cross(missing, d) / norm2(d);
    a.p += impulse;
    b.p -= impulse;
    missing -= cross(d, impulse);
  }
  require(norm(missing) <= least, "split: ", who, " spins about the line through its two parts, and these, of which ",
          "neither can turn about it, cannot carry its angular momentum");
}

}  // namespace

BodyId split(World& world, BodyId body, std::span<const PointId> points, std::string name) {
  require_unlocked(world, "split");
  require(world.bodies.alive(body), "split: ", world.bodies.story(body));
  const std::vector<PointId> off(points.begin(), points.end()), rest = rest_of(world, body, points);
  const Body& row = world.bodies[body];
  const Vec3 normal = normal_in(world, orientation(world, body));
  const Weighed left = weigh("split: what is left of it", masses_of(world, rest),
                             {row.own_mass, row.own_inertia, row.own_position}, row.axes, normal);
  const Weighed gone = weigh("split: what is split off", masses_of(world, off), {}, row.axes, normal);
  const Vec3 spin = angular_velocity(world.motion_of(body));
  Motion first = part_of(left, world, body, spin), second = part_of(gone, world, body, spin);
  keep_momenta(world.plane, world.motion_of(body), describe(world, body),
               std::fmax(norm(left.centre), norm(gone.centre)), first, second);

  acted(world);
  disturb_sites(world);
  touch(world, body);
  disturb(world, body);
  const double before = energy_of(world, body);
  world.bodies[body].points = rest;
  const BodyId fresh = make_body(world, std::move(name), origin(world, body), orientation(world, body), off);
  take_axes(world, body, fresh);
  for (const auto& [id, part] : {std::pair{body, first}, std::pair{fresh, second}}) {
    update_mass(world, id);
    drop_turns(world, id);
    set_momenta(world, id, part.p, rotate(part.q, part.angular));
  }
  touch(world, fresh);
  post(world, Source::edit, energy_of(world, body) + energy_of(world, fresh) - before);
  return fresh;
}

}  // namespace pantin
