#include <algorithm>

#include "constraints/kind.hpp"
#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "laws/curve.hpp"

namespace pantin {

using namespace internal;

namespace {

struct Member {
  PointId point;
  std::size_t given;  // which of the call's points brought it
};

/// The given points and all that already share their hinges.
std::vector<Member> members_of(const World& world, std::span<const PointId> points) {
  require(points.size() >= 2, "hinge: needs two points or more, got ", points.size());
  for (std::size_t i = 0; i < points.size(); i++) {
    require(world.points.alive(points[i]), "hinge: point ", i + 1, ": ", world.points.story(points[i]));
    const auto same = std::find(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), points[i]);
    require(*same != points[i] || same == points.begin() + static_cast<std::ptrdiff_t>(i), "hinge: points ",
            same - points.begin() + 1, " and ", i + 1, " are the same point");
  }
  std::vector<Member> members;
  std::vector<ParticleId> rings;
  for (std::size_t i = 0; i < points.size(); i++) {
    const ParticleId ring = world.points[points[i]].particle;
    if (std::find(rings.begin(), rings.end(), ring) != rings.end()) continue;
    rings.push_back(ring);
    for (PointId p : world.particles[ring].points) members.push_back({p, i});
  }
  require(rings.size() > 1, "hinge: these points are joined already, in ", describe(world, rings[0]));
  return members;
}

void require_different_bodies(const World& world, const std::vector<Member>& members) {
  std::vector<std::pair<BodyId, std::size_t>> bodies;
  for (const Member& m : members)
    if (const BodyId body = world.points[m.point].body) bodies.push_back({body, m.given});
  std::sort(bodies.begin(), bodies.end());
  const auto twice =
      std::adjacent_find(bodies.begin(), bodies.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == bodies.end()) return;
  throw Error(text("hinge: points ", twice->second + 1, " and ", (twice + 1)->second + 1, " both belong to ",
                   describe(world, twice->first), "; a hinge joins different bodies"));
}

/// Those that a call names: the points' own, and for a free particle all that share its position already.
std::vector<BodyId> named_bodies(const World& world, std::span<const PointId> points) {
  std::vector<BodyId> bodies;
  for (PointId point : points) {
    const Point& row = world.points[point];
    for (PointId member : row.body ? std::vector{point} : world.particles[row.particle].points)
      if (const BodyId body = world.points[member].body)
        if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) bodies.push_back(body);
  }
  return bodies;
}

void require_one_holder(const World& world, const std::vector<Member>& members) {
  ConstraintId held;
  std::vector<PointId> all;
  for (const Member& m : members) all.push_back(m.point);
  std::sort(all.begin(), all.end());
  for (const Member& m : members)
    for (ConstraintId id : world.points[m.point].constraints) {
      const Constraint& c = world.constraints[id];
      if (rule_of(c).parts_points)
        require(!c.b || !std::binary_search(all.begin(), all.end(), c.a == m.point ? c.b : c.a),
                "hinge: ", describe(world, id), " keeps two of these points apart; remove it first");
      else if (pins(c)) {
        require(!held, "hinge: the points are held twice, by ", held ? describe(world, held) : "", " and by ",
                describe(world, id), "; remove one of them first");
        held = id;
      }
    }
}

/// Shared data: those given, else the first point's.
Particle shared_data(const World& world, PointId first, const HingeDef& def) {
  const Point& point = world.points[first];
  const Particle& last = world.particles[point.particle];
  Particle ring;
  ring.born = world.time;
  ring.color = def.color ? *def.color : last.color.value_or(point.color);
  ring.radius = def.radius ? *def.radius : last.radius.value_or(point.radius);
  ring.family = def.family ? def.family : last.family;
  ring.values = ring.family == last.family ? last.values : attribute_values("hinge", world.families[ring.family], {});
  ring.look = last.look;
  ring.curves = ring.family == last.family ? last.curves : world.families[ring.family].curves;
  if (def.color) ring.curves = without(ring.curves, "color");
  if (def.radius) ring.curves = without(ring.curves, "radius");
  if (ring.family) require_solid_radius("hinge", world.families[ring.family], *ring.radius, ring.curves.get());
  ring.collide = def.collide;
  ring.name = def.name;
  return ring;
}

/// A hinge that it takes the place of hands on what was not given anew; the first that has it.
void keep_of_old(const Particle& old, Particle& ring) {
  if (!old.is_hinge()) return;
  if (ring.name.empty()) ring.name = old.name;
  if (!ring.breaks_at.possible()) ring.breaks_at = old.breaks_at;
}

/// The largest coordinate of a point [m].
double farthest_coordinate(const World& world) {
  double most = 0.0;
  for (const PointId point : world.points.ids()) most = std::fmax(most, largest(position(world, point)));
  return most;
}

}  // namespace

void internal::require_together(const World& world, std::span<const PointId> points) {
  const Vec3 first = position(world, points[0]);
  const double size = size_of(world, points[0]);
  for (std::size_t i = 1; i < points.size(); i++) {
    const double gap = norm(position(world, points[i]) - first);
    if (gap == 0.0) continue;
    const double of_bodies = std::fmax(size, size_of(world, points[i]));
    const bool are_bodies = of_bodies > 0.0;
    const double allowed = world.settings.tolerance * (are_bodies ? of_bodies : farthest_coordinate(world));
    require(gap <= allowed, "hinge: points 1 and ", i + 1, " are ", gap, " m apart, and at most ", allowed,
            " m (scene.tolerance times ", are_bodies ? "the size of their bodies" : "the largest coordinate of a point",
            ") is allowed; move them together first");
  }
}

ParticleId add_hinge(World& world, std::span<const PointId> points, const HingeDef& def) {
  require_unlocked(world, "hinge");
  require_positive_or_infinite("hinge", "lifetime", def.lifetime, "s");
  if (def.radius) require_not_negative("hinge", "radius", *def.radius, "m");
  const std::vector<Member> members = members_of(world, points);
  require_different_bodies(world, members);
  require_together(world, points);
  require_one_holder(world, members);
  const std::vector<BodyId> bodies = named_bodies(world, points);
  if (def.axis) require_axis(world, bodies, *def.axis);

  Particle ring = shared_data(world, points[0], def);
  disturb_sites(world);
  for (const Member& m : members) {
    ring.points.push_back(m.point);
    keep_of_old(world.particles[world.points[m.point].particle], ring);
  }
  ring.serial = world.next_serial++;
  const ParticleId hinge = world.particles.add(std::move(ring));
  if (std::isfinite(def.lifetime)) set_lifetime(world, hinge, def.lifetime);
  for (const Member& m : members) {
    const ParticleId old = world.points[m.point].particle;
    if (!world.particles[old].is_hinge()) continue;
    take_over_axes(world, old, hinge);
    end_ring(world, old, text("joining into ", describe(world, hinge)));
    notice(world, Notice::Kind::removed, old, world.particles.story(old));
  }
  for (const Member& m : members) {
    Point& point = world.points[m.point];
    point.particle = hinge;
    point.row_force = zero3();
    world.particles[point.own].asleep_in = hinge;
  }
  mark_edited(world, hinge);
  if (def.axis) add_axes(world, hinge, bodies, *def.axis);
  return hinge;
}

}  // namespace pantin
