// Particles that become a body, and a body that becomes particles.
#include "world/assemble.hpp"
#include "world/parts.hpp"

namespace pantin {

using namespace editing;

namespace {

std::vector<PointId> particles_to_freeze(const World& world, GroupId group) {
  require(world.groups.alive(group), "freeze: ", world.groups.story(group));
  std::vector<PointId> points;
  for (const AnyId& member : world.groups[group].members) {
    if (const auto* particle = std::get_if<ParticleId>(&member); particle && world.particles.alive(*particle))
      for (PointId p : world.particles[awake(world, *particle)].points) points.push_back(p);
    if (const auto* point = std::get_if<PointId>(&member); point && world.points.alive(*point))
      points.push_back(*point);
    if (const auto* body = std::get_if<BodyId>(&member))
      require(!world.bodies.alive(*body), "freeze: ", describe(world, *body), " is in ", describe(world, group),
              "; freeze takes particles, merge takes bodies");
  }
  for (PointId p : points) require(!world.points[p].body, "freeze: ", describe(world, p), " belongs to a body already");
  std::sort(points.begin(), points.end(),
            [&](PointId a, PointId b) { return world.points[a].serial < world.points[b].serial; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  require(!points.empty(), "freeze: there are no particles in ", describe(world, group));
  return points;
}

/// A mass at a place relative to the common centre.
struct Fragment {
  PointId point;  ///< null: the own mass
  double mass;
  Vec3 arm;
};

std::vector<Fragment> fragments_of(const World& world, BodyId id) {
  const Body& body = world.bodies[id];
  const Motion& m = world.motion_of(id);
  std::vector<Fragment> list;
  for (PointId p : body.points)
    if (world.points[p].mass > 0.0) list.push_back({p, world.points[p].mass, rotate(m.q, arm(world, p))});
  if (body.own_mass > 0.0)
    list.push_back({{}, body.own_mass, rotate(orientation(world, id), body.own_place - body.centre)});
  return list;
}

/// The spin with which fragments carry an angular momentum [kg m²/s] about their centre.
Vec3 spin_of(const World& world, BodyId body, const std::vector<Fragment>& fragments, Vec3 angular) {
  constexpr double least_moment = 1e-6;  // relative: below it a spin would be absurd
  Mat3 inertia = zero33();
  for (const Fragment& f : fragments) {
    const Vec3 arm = world.plane.along(f.arm);
    inertia += (identity33() * norm2(arm) - outer(arm, arm)) * f.mass;
  }
  const Principal own = principal_axes(inertia, identity33());
  Vec3 spin = zero3(), left = angular;
  for (int i = 0; i < 3; i++) {
    if (!(own.moments[i] > least_moment * own.moments[2])) continue;
    const double along = dot(own.axes[i], angular);
    spin += own.axes[i] * (along / own.moments[i]);
    left -= own.axes[i] * along;
  }
  require(norm(left) <= 1e-9 * norm(angular), "shatter: ", describe(world, body), " spins, and ", fragments.size(),
          fragments.size() == 1 ? " particle" : " particles", " in these places cannot carry its angular momentum");
  return spin;
}

/// Frees a point with a velocity, [m/s].
void set_free(World& world, PointId id, Vec3 at, Vec3 velocity) {
  Point& point = world.points[id];
  point.body = {};
  point.place = zero3();
  point.articulate = -1;
  point.name.clear();
  world.motion_of(id) = {at, velocity};
  touch(world, id);
}

PointId own_mass_point(World& world, BodyId body) {
  Point row;
  row.mass = world.bodies[body].own_mass;
  row.radius = 0.05;
  row.color =
      world.bodies[body].points.empty() ? ParticleDef::usual_color : world.points[world.bodies[body].points[0]].color;
  return make_point(world, std::move(row));
}

}  // namespace

BodyId freeze(World& world, GroupId group, std::string name) {
  require_unlocked(world, "freeze");
  const std::vector<PointId> points = particles_to_freeze(world, group);
  acted(world);
  disturb_forces(world);
  const Totals kept = totals_of(world, {}, points);
  double before = 0.0;
  for (PointId p : points) {
    before += energy_of(world, p);
    touch(world, p);
    disturb(world, p);
  }
  part_ties_within(world, points, text(culprit(world), ", freezing it"));
  for (PointId p : points) {
    world.points[p].place = world.motion_of(p).x - kept.centre;
    world.points[p].articulate = -1;
  }
  const BodyId body = make_body(world, std::move(name), kept.centre, Quat{}, points);
  weigh_again(world, body);
  set_momenta(world, body, kept.p, kept.angular);
  for (PointId p : points) {
    world.motion_of(body).force += world.points[p].force;
    world.motion_of(body).torque += world.plane.about(cross(position(world, p) - kept.centre, world.points[p].force));
    world.points[p].force = zero3();
  }
  touch(world, body);
  post(world, energy_of(world, body) - before, Source::merge);
  return body;
}

std::vector<ParticleId> shatter(World& world, BodyId body) {
  require_unlocked(world, "shatter");
  require(world.bodies.alive(body), "shatter: ", world.bodies.story(body));
  std::vector<Fragment> fragments = fragments_of(world, body);
  const Motion old = world.motion_of(body);
  const Vec3 spin = spin_of(world, body, fragments, rotate(old.q, old.angular));
  const std::string who = text(culprit(world), ", shattering it");

  acted(world);
  disturb_forces(world);
  touch(world, body);
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
    set_free(world, f.point, old.x + f.arm, old.p / old.mass + cross(spin, f.arm));
    particles.push_back(world.points[f.point].own);
    after += energy_of(world, f.point);
  }
  world.bodies[body].points.clear();
  erase_body(world, body, who);
  post(world, after - before);
  return particles;
}

}  // namespace pantin
