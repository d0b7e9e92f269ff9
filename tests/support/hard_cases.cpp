#include "support/hard_cases.hpp"

#include <array>
#include <numbers>

#include "base/functions.hpp"
#include "edit/constrain.hpp"

namespace pantin::cases {

namespace {

PointDef anchor(Vec3 at, double mass = 0.0) {
  PointDef point;
  point.at = at;
  point.mass = mass;
  return point;
}

Quat about_z(double angle) { return {functions::cos(0.5 * angle), 0, 0, functions::sin(0.5 * angle)}; }

/// Corners 0 to 3 against the clock, from (-1/2, -1/2).
BodyId add_square(World& world, Vec3 at, double turn) {
  BodyDef def;
  def.points = {anchor(vec(-0.5, -0.5, 0)), anchor(vec(0.5, -0.5, 0)), anchor(vec(0.5, 0.5, 0)),
                anchor(vec(-0.5, 0.5, 0))};
  def.at = at;
  def.orientation = about_z(turn);
  def.mass = 1.0;
  def.inertia = diagonal(vec(1.01, 1.01, 2.0) / 12.0);
  return add_body(world, def);
}

BodyDef tangled(Random& random, double mass, double length) {
  BodyDef def;
  const int kind = static_cast<int>(random.bits() % 3);
  const double own = kind == 0 ? 0.0 : mass, across = own * length * length / 12.0;
  def.points = {anchor(vec(-0.5 * length, 0, 0), 0.5 * (mass - own)),
                anchor(vec(0.5 * length, 0, 0), 0.5 * (mass - own))};
  def.mass = own;
  if (kind == 1) def.points.push_back(anchor(vec(0, between(random, 0, length), between(random, -length, length))));
  if (kind > 0) def.inertia = diagonal(vec(kind == 2 ? 0.0 : across * between(random, 0.1, 1.2), across, across));
  return def;
}

Quat any_orientation(Random& random) {
  const Vec3 u = vector_within(random, 1.0);
  return normalised({between(random, -1, 1), u[0], u[1], u[2]});
}

}  // namespace

double of_any_size(Random& random, double decades) { return functions::pow(10, between(random, -decades, decades)); }

Vec3 vector_within(Random& random, double size) {
  const double x = between(random, -size, size), y = between(random, -size, size);
  return vec(x, y, between(random, -size, size));
}

Squares add_squares(World& world, int side, double turn) {
  world.settings.gravity = zero3();
  const double pitch = functions::cos(turn) + functions::sin(turn);
  Squares squares;
  for (int j = 0; j < side; j++)
    for (int i = 0; i < side; i++)
      squares.bodies.push_back(add_square(world, vec(i * pitch, j * pitch, 0), (i + j) % 2 == 0 ? turn : -turn));
  const auto join = [&](int k, std::size_t corner, int m, std::size_t other) {
    add_hinge(world, std::array{point_of(world, squares.bodies[static_cast<std::size_t>(k)], corner),
                                point_of(world, squares.bodies[static_cast<std::size_t>(m)], other)});
  };
  for (int j = 0; j < side; j++)
    for (int i = 0; i < side; i++) {
      const bool even = (i + j) % 2 == 0;
      const int k = j * side + i;
      if (i + 1 < side) even ? join(k, 1, k + 1, 0) : join(k, 2, k + 1, 3);
      if (j + 1 < side) even ? join(k, 2, k + side, 1) : join(k, 3, k + side, 0);
    }
  const PointId fixed = point_of(world, squares.bodies.front(), 0);
  add_nail(world, fixed);
  squares.corner = point_of(world, squares.bodies.back(), 2);
  squares.away = direction(position(world, squares.corner) - position(world, fixed));
  return squares;
}

PointId add_cantilever(World& world, int links) {
  const std::array<Vec3, 3> positions = {zero3(), vec(0, 0.05, 0), vec(0, 0, 0.05)};
  BodyId last;
  for (int i = 0; i < links; i++) {
    BodyDef def;
    for (Vec3 position : positions) def.points.push_back(anchor(vec(-0.5, 0, 0) + position));
    for (Vec3 position : positions) def.points.push_back(anchor(vec(0.5, 0, 0) + position));
    def.at = vec(i + 0.5, 0, 0);
    def.mass = 1.0;
    def.inertia = rod_inertia(1.0, 1.0);
    const BodyId body = add_body(world, def);
    for (std::size_t k = 0; k < 3; k++) {
      const PointId head = point_of(world, body, k);
      if (i == 0)
        add_nail(world, head);
      else
        add_hinge(world, std::array{point_of(world, last, k + 3), head});
    }
    last = body;
  }
  return point_of(world, last, 3);
}

Hub add_hub(World& world, int spokes) {
  BodyDef def;
  def.points.push_back(anchor(zero3()));
  const auto outward = [&](int i) {
    const double angle = 2.0 * std::numbers::pi * i / spokes;
    return vec(functions::cos(angle), functions::sin(angle), 0);
  };
  for (int i = 0; i < spokes; i++) def.points.push_back(anchor(outward(i)));
  def.mass = 10.0;
  def.inertia = diagonal(vec(2.5, 2.5, 5.0));
  Hub hub;
  hub.disc = add_body(world, def);
  add_nail(world, point_of(world, hub.disc, 0));
  for (int i = 0; i < spokes; i++) {
    BodyDef spoke;
    spoke.at = outward(i) * 1.5;
    spoke.orientation = about_z(2.0 * std::numbers::pi * i / spokes);
    hub.spokes.push_back(add_rod_body(world, 1.0, 1.0, spoke));
    add_hinge(world, std::array{point_of(world, hub.disc, static_cast<std::size_t>(i) + 1),
                                point_of(world, hub.spokes.back(), 0)});
  }
  return hub;
}

Chain add_mixed_chain(World& world, int links, Random& random, double decades) {
  Chain chain;
  for (int i = 0; i < links; i++) {
    BodyDef link;
    link.at = vec(i + 0.5, 0, 0);
    const BodyId body = add_rod_body(world, of_any_size(random, decades), 1.0, link);
    chain.bodies.push_back(body);
    chain.heads.push_back(point_of(world, body, 0));
    if (i > 0) chain.hinges.push_back(add_hinge(world, std::array{chain.tails.back(), chain.heads.back()}));
    chain.tails.push_back(point_of(world, body, 1));
  }
  chain.pin = add_nail(world, chain.heads.front());
  return chain;
}

Tangle add_tangle(World& world, Random& random, int bodies, double decades, int loops) {
  Tangle tangle;
  const auto any = [&] { return tangle.points[random.bits() % tangle.points.size()]; };
  for (int i = 0; i < bodies; i++) {
    const double mass = of_any_size(random, decades), length = between(random, 0.3, 2.0);
    BodyDef def = tangled(random, mass, length);
    def.orientation = any_orientation(random);
    const PointId at = i > 0 ? any() : PointId{};
    def.at = (at ? position(world, at) : zero3()) + rotate(def.orientation, vec(0.5 * length, 0, 0));
    const BodyId body = add_body(world, def);
    const PointId head = point_of(world, body, 0);
    if (at)
      tangle.hinges.push_back(add_hinge(world, std::array{at, head}));
    else if (random.bits() % 2)
      add_nail(world, head);
    tangle.bodies.push_back(body);
    for (const PointId point : world.bodies[body].points) tangle.points.push_back(point);
  }
  for (int i = 0; i < loops; i++) {
    const PointId a = any(), b = any();
    const BodyId body = world.points[a].body;
    if (body != world.points[b].body && norm(position(world, a) - position(world, b)) > 0.1) add_rod(world, a, b);
  }
  return tangle;
}

}  // namespace pantin::cases
