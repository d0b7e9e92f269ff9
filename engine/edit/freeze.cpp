// Particles that become a body, and a body that becomes particles.
#include <algorithm>
#include <unordered_set>

#include "articulates/solve/state.hpp"
#include "edit/assemble.hpp"
#include "edit/parts.hpp"
#include "measure/measure.hpp"

namespace pantin {

using namespace internal;

namespace {

/// Bodies and free points of a group, in the order of making.
Things things_to_freeze(const World& world, GroupId group) {
  require(world.groups.alive(group), "freeze: ", world.groups.story(group));
  std::unordered_set<BodyId> members;
  for (const AnyId& member : all_members(world, group))
    if (const auto* body = std::get_if<BodyId>(&member)) members.insert(*body);
  Things things = things_of(world, group);
  for (BodyId body : things.bodies)
    require(members.contains(body), "freeze: ", describe(world, group), " has points of ", describe(world, body),
            ", but not the body itself");
  require(!things.bodies.empty() || !things.free_points.empty(), "freeze: there is nothing in ",
          describe(world, group));
  std::sort(things.bodies.begin(), things.bodies.end(),
            [&](BodyId a, BodyId b) { return world.bodies[a].serial < world.bodies[b].serial; });
  std::sort(things.free_points.begin(), things.free_points.end(),
            [&](PointId a, PointId b) { return world.points[a].serial < world.points[b].serial; });
  return things;
}

/// A mass at a position, and with a velocity, relative to the common centre.
struct Fragment {
  PointId point;  ///< null: the own mass
  double mass;
  Vec3 arm;
  Vec3 velocity = zero3();
};

std::vector<Fragment> fragments_of(const World& world, BodyId id) {
  const Body& body = world.bodies[id];
  const Motion& m = world.motion_of(id);
  std::vector<Fragment> list;
  for (PointId p : body.points)
    if (world.points[p].mass > 0.0) list.push_back({p, world.points[p].mass, rotate(m.q, arm(world, p))});
  if (body.own_mass > 0.0)
    list.push_back({{}, body.own_mass, rotate(orientation(world, id), body.own_position - body.centre)});
  return list;
}

/// Adds a rotation, so that fragments carry an angular momentum [kg m²/s] more; returns what they cannot carry of it.
Vec3 add_rotation(const Plane& plane, std::vector<Fragment>& fragments, const Principal& own, Vec3 angular) {
  constexpr double least_moment = 1e-6;  // relative: below it a spin would be absurd
  Vec3 spin = zero3();
  for (int i = 0; i < 3; i++)
    if (own.moments[i] > least_moment * own.moments[2])
      spin += own.axes[i] * (dot(own.axes[i], angular) / own.moments[i]);
  double mass = 0.0;
  Vec3 momentum = zero3();
  for (Fragment& f : fragments) {
    f.velocity += cross(spin, f.arm);
    mass += f.mass;
    momentum += f.velocity * f.mass;
  }
  for (Fragment& f : fragments) {
    f.velocity -= momentum / mass;
    angular -= plane.about(cross(f.arm, f.velocity)) * f.mass;
  }
  return angular;
}

/// Gives fragments velocities with which they carry an angular momentum [kg m²/s] about their centre.
void set_turning(const World& world, BodyId body, std::vector<Fragment>& fragments, Vec3 angular) {
  Mat3 inertia = zero33();
  for (const Fragment& f : fragments) {
    const Vec3 arm = world.plane.along(f.arm);
    inertia += (identity33() * norm2(arm) - outer(arm, arm)) * f.mass;
  }
  const Principal own = principal_axes(inertia, identity33());
  Vec3 left = add_rotation(world.plane, fragments, own, angular);
  // What velocities are rounded to can be much of what a slender body has about its line.
  for (int again = 0; again < 2; again++) {
    std::vector<Fragment> rest = fragments;
    for (Fragment& f : rest) f.velocity = zero3();
    left = add_rotation(world.plane, rest, own, left);
    for (std::size_t i = 0; i < fragments.size(); i++) fragments[i].velocity += rest[i].velocity;
  }
  double least = 1e-13 * norm(angular);
  for (const Fragment& f : fragments)
    least += round_off * (norm(world.motion_of(body).x) + norm(f.arm)) * f.mass * norm(f.velocity);
  require(norm(left) <= least, "shatter: ", describe(world, body), " spins, and ", fragments.size(),
          fragments.size() == 1 ? " particle" : " particles", " at these positions cannot carry its angular momentum");
}

/// Frees a point with a velocity, [m/s].
void set_free(World& world, PointId id, Vec3 at, Vec3 velocity) {
  Point& point = world.points[id];
  point.body = {};
  point.position = zero3();
  point.articulate = -1;
  point.name.clear();
  world.motion_of(id) = {at, velocity};
  mark_edited(world, id);
}

PointId own_mass_point(World& world, BodyId body) {
  Point row;
  row.mass = world.bodies[body].own_mass;
  row.radius = 0.05;
  row.color =
      world.bodies[body].points.empty() ? ParticleDef::usual_color : world.points[world.bodies[body].points[0]].color;
  return make_point(world, std::move(row));
}

/// Free points become one body.
BodyId body_of_points(World& world, const std::vector<PointId>& points, std::string name) {
  acted(world);
  disturb_sites(world);
  const Totals kept = totals_of(world, {}, points);
  double before = 0.0;
  for (PointId p : points) {
    before += energy_of(world, p);
    mark_edited(world, p);
    disturb(world, p);
  }
  part_ties_within(world, points, text(culprit(world), ", freezing it"));
  for (PointId p : points) {
    world.points[p].position = world.motion_of(p).x - kept.centre;
    world.points[p].articulate = -1;
  }
  const BodyId body = make_body(world, std::move(name), kept.centre, Quat{}, points);
  update_mass(world, body);
  set_momenta(world, body, kept.p, kept.angular);
  for (PointId p : points) {
    world.motion_of(body).force += world.points[p].force;
    world.motion_of(body).torque += world.plane.about(cross(position(world, p) - kept.centre, world.points[p].force));
    world.points[p].force = zero3();
  }
  mark_edited(world, body);
  post(world, Source::merge, energy_of(world, body) - before);
  return body;
}

}  // namespace

BodyId freeze(World& world, GroupId group, std::string name) {
  require_unlocked(world, "freeze");
  const Things things = things_to_freeze(world, group);
  if (things.free_points.empty()) {
    if (!name.empty()) world.bodies[things.bodies[0]].name = std::move(name);
    for (std::size_t i = 1; i < things.bodies.size(); i++) merge(world, things.bodies[0], things.bodies[i]);
    return things.bodies[0];
  }
  const BodyId body = body_of_points(world, things.free_points, std::move(name));
  for (BodyId other : things.bodies) merge(world, body, other);
  return body;
}

std::vector<ParticleId> shatter(World& world, BodyId body) {
  require_unlocked(world, "shatter");
  require(world.bodies.alive(body), "shatter: ", world.bodies.story(body));
  std::vector<Fragment> fragments = fragments_of(world, body);
  const Motion old = world.motion_of(body);
  set_turning(world, body, fragments, rotate(old.q, old.angular));
  const std::string who = text(culprit(world), ", shattering it");

  acted(world);
  disturb_sites(world);
  mark_edited(world, body);
  disturb(world, body);
  const double before = energy_of(world, body);
  for (Fragment& f : fragments)
    if (!f.point) f.point = own_mass_point(world, body);
  const std::vector<PointId> points = world.bodies[body].points;
  for (PointId p : points)
    if (!(world.points[p].mass > 0.0)) erase_point(world, p, describe(world, p));
  std::vector<ParticleId> particles;
  double after = 0.0;
  for (const Fragment& f : fragments) {
    set_free(world, f.point, old.x + f.arm, old.p / old.mass + f.velocity);
    particles.push_back(world.points[f.point].own);
    after += energy_of(world, f.point);
  }
  world.bodies[body].points.clear();
  erase_body(world, body, who);
  post(world, Source::edit, after - before);
  return particles;
}

}  // namespace pantin
