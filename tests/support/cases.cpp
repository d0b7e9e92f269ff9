#include "support/cases.hpp"

#include <array>
#include <memory>
#include <numbers>
#include <utility>

#include "base/functions.hpp"
#include "edit/constrain.hpp"
#include "laws/library.hpp"

namespace pantin::cases {

namespace {

void join(World& world, Chain& chain, PointId tail, PointId head) {
  chain.hinges.push_back(add_hinge(world, std::array{tail, head}));
}

void append_rod(World& world, Chain& chain, double mass, double length, BodyDef def) {
  const BodyId body = add_rod_body(world, mass, length, std::move(def));
  chain.bodies.push_back(body);
  chain.heads.push_back(point_of(world, body, 0));
  chain.tails.push_back(point_of(world, body, 1));
}

}  // namespace

Mat3 rod_inertia(double mass, double length) {
  const double thickness = 0.1 * length;
  const double along = mass / 12.0 * (2.0 * thickness * thickness);
  const double across = mass / 12.0 * (length * length + thickness * thickness);
  return diagonal(vec(along, across, across));
}

BodyId add_rod_body(World& world, double mass, double length, BodyDef def) {
  PointDef head, tail;
  head.at = vec(-0.5 * length, 0, 0);
  head.name = "head";
  tail.at = vec(0.5 * length, 0, 0);
  tail.name = "tail";
  def.points = {head, tail};
  def.mass = mass;
  def.inertia = rod_inertia(mass, length);
  return add_body(world, def);
}

Chain add_chain(World& world, const ChainDef& def) {
  Chain chain;
  for (int i = 0; i < def.links; i++) {
    BodyDef link;
    link.at = def.start + vec((i + 0.5) * def.length, 0, 0);
    link.name = text("link ", i + 1);
    append_rod(world, chain, def.mass, def.length, link);
    if (i > 0) join(world, chain, chain.tails[chain.tails.size() - 2], chain.heads.back());
  }
  if (def.pinned) chain.pin = add_nail(world, chain.heads.front());
  return chain;
}

Chain add_heavy_chain(World& world, int links, double ratio) {
  const double radius = 0.5;
  Chain chain = add_chain(world, {.links = links});
  BodyDef sphere;
  sphere.at = vec(links + radius, 0, 0);
  sphere.mass = ratio;
  sphere.inertia = identity33() * (0.4 * ratio * radius * radius);
  sphere.name = "sphere";
  PointDef surface;
  surface.at = vec(-radius, 0, 0);
  sphere.points = {surface};
  const BodyId body = add_body(world, sphere);
  chain.bodies.push_back(body);
  chain.heads.push_back(point_of(world, body, 0));
  join(world, chain, chain.tails.back(), chain.heads.back());
  return chain;
}

Chain add_ring(World& world, int links) {
  const double pi = std::numbers::pi, inner = 0.5 / functions::tan(pi / links);
  Chain ring;
  for (int i = 0; i < links; i++) {
    const double angle = 2.0 * pi * (i + 0.5) / links, turn = 0.5 * (angle + 0.5 * pi);
    BodyDef side;
    side.at = vec(inner * functions::cos(angle), inner * functions::sin(angle), 0);
    side.orientation = {functions::cos(turn), 0, 0, functions::sin(turn)};
    side.name = text("side ", i + 1);
    append_rod(world, ring, 1.0, 1.0, side);
  }
  const std::size_t n = ring.bodies.size();
  for (std::size_t i = 0; i < n; i++) join(world, ring, ring.tails[i], ring.heads[(i + 1) % n]);
  ring.pin = add_nail(world, ring.heads[n / 4]);
  return ring;
}

Wheel add_wheel(World& world, const WheelDef& def) {
  BodyDef disc;
  disc.mass = def.mass;
  disc.inertia = diagonal(vec(0.25, 0.5, 0.25) * def.mass);
  disc.points.resize(1);
  const auto angle = [&](int i) { return 2.0 * std::numbers::pi * i / def.spokes; };
  const auto outwards = [&](int i) { return vec(functions::cos(angle(i)), 0, -functions::sin(angle(i))); };
  const int to = def.to < 0 ? def.spokes : def.to;
  for (int i = def.from; i < to; i++) {
    PointDef point;
    point.at = outwards(i);
    disc.points.push_back(point);
  }
  Wheel wheel;
  wheel.hub = add_body(world, disc);
  wheel.centre = point_of(world, wheel.hub, 0);
  for (int i = def.from; i < to; i++) {
    PointId end = point_of(world, wheel.hub, static_cast<std::size_t>(1 + i - def.from));
    wheel.edge.push_back(end);
    for (int k = 0; k < def.links; k++) {
      BodyDef link;
      link.at = outwards(i) * (1.5 + k);
      link.orientation = {functions::cos(0.5 * angle(i)), 0, functions::sin(0.5 * angle(i)), 0};
      const BodyId body = add_rod_body(world, 1, 1, link);
      add_hinge(world, std::array{end, point_of(world, body, 0)});
      end = point_of(world, body, 1);
    }
    wheel.ends.push_back(end);
  }
  return wheel;
}

DoublePendulum add_double_pendulum(World& world) {
  ParticleDef inner, outer;
  inner.at = vec(1, 0, 0);
  outer.at = vec(2, 0, 0);
  DoublePendulum pendulum;
  pendulum.inner = point_of(world, add_particle(world, inner));
  pendulum.outer = point_of(world, add_particle(world, outer));
  pendulum.upper = add_rod(world, pendulum.inner, zero3());
  pendulum.lower = add_rod(world, pendulum.inner, pendulum.outer);
  return pendulum;
}

std::vector<ParticleId> add_cube(World& world, const CubeDef& def) {
  constexpr double farthest = 1.8;  // of the distance along an edge: the diagonal through space is 1.73
  std::vector<ParticleId> cube;
  const int count = def.edge * def.edge * def.edge;
  const auto at = [&](int i) {
    return def.start + vec(i / (def.edge * def.edge), i / def.edge % def.edge, i % def.edge) * def.apart;
  };
  for (int i = 0; i < count; i++) {
    ParticleDef particle;
    particle.at = at(i);
    particle.mass = def.mass;
    particle.family = def.family;
    cube.push_back(add_particle(world, particle));
  }
  for (int i = 0; i < count; i++)
    for (int j = 0; j < i; j++) {
      const double length = norm(at(i) - at(j));
      if (length > farthest * def.apart) continue;
      LawArguments arguments;
      arguments.numbers = {{"stiffness", def.stiffness}, {"length", length}};
      ConnectionDef tie;
      tie.ends = {{cube[static_cast<std::size_t>(i)], zero3()}, {cube[static_cast<std::size_t>(j)], zero3()}};
      tie.solve = def.solve;
      add_connection(world, std::make_shared<const Law>(make_library_law("spring", arguments).front()), tie);
    }
  return cube;
}

BodyId add_top(World& world) {
  world.settings.gravity = zero3();
  BodyDef top;
  top.mass = 1.0;
  top.inertia = diagonal(vec(1, 2, 3));
  top.spin = vec(0.01, 1, 0.01);
  top.name = "top";
  return add_body(world, top);
}

ConstraintId add_on_plane(World& world, PointId point, Vec3 normal, std::optional<Vec3> through, double time_constant) {
  Constraint c;
  c.kind = ConstraintKind::on_plane;
  c.a = point;
  c.position.now = through.value_or(position(world, point));
  c.axis_a = normal;
  c.time_constant = time_constant;
  return add_constraint(world, std::move(c));
}

PointId point_of(const World& world, ParticleId particle) { return world.particles[particle].points.front(); }

PointId point_of(const World& world, BodyId body, std::size_t index) { return world.bodies[body].points[index]; }

}  // namespace pantin::cases
