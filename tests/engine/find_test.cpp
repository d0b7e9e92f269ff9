// What passes over seams: flush boxes, triangles of one plane; and what rolls. All as on a half space.
#include <catch2/catch.hpp>
#include <cmath>

#include "edit/edit.hpp"
#include "shapes/mesh.hpp"
#include "step/step.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;

namespace passing {

namespace {

constexpr double g = 9.81;

ShapeDef shape(Geometry geometry, double friction = 0.5) {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.material.friction = friction;
  return def;
}

Quat about(Vec3 axis, double angle) {
  const Vec3 u = axis * std::sin(angle / 2);
  return {std::cos(angle / 2), u[0], u[1], u[2]};
}

void add_floor(World& world, double friction = 0.5) {
  ShapeDef def = shape(HalfSpaceShape{}, friction);
  def.orientation = about(vec(1, 0, 0), -M_PI / 2);
  add_shape(world, def);
}

/// Boxes of 1 m with tops at height 0, as far as x = last.
void add_tiles(World& world, int last, double friction = 0.5) {
  for (int i = -3; i < last; i++) {
    ShapeDef def = shape(BoxShape{vec(0.5, 0.5, 5)}, friction);
    def.at = vec(i + 0.5, -0.5, 0);
    add_shape(world, def);
  }
}

/// A flat grid of 0.5 m about the origin.
constexpr std::uint32_t cells = 240;

void add_flat_mesh(World& world) {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t j = 0; j <= 8; j++)
    for (std::uint32_t i = 0; i <= cells; i++) vertices.push_back(vec(0.5 * i - 0.25 * cells, 0, 0.5 * j - 2.0));
  for (std::uint32_t j = 0; j < 8; j++)
    for (std::uint32_t i = 0; i < cells; i++) {
      const std::uint32_t a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      faces.push_back({a, c, d});
      faces.push_back({a, d, b});
    }
  add_shape(world, shape(make_mesh(vertices, faces)));
}

void add_flat_heights(World& world) {
  add_shape(world, shape(make_height_field(cells + 1, 9, 0.5, std::vector<double>((cells + 1) * 9, 0.0))));
}

enum class Ground { half_space, tiles, mesh, heights };

void add_ground(World& world, Ground ground) {
  switch (ground) {
    case Ground::half_space: return add_floor(world);
    case Ground::tiles: return add_tiles(world, 60);
    case Ground::mesh: return add_flat_mesh(world);
    case Ground::heights: return add_flat_heights(world);
  }
}

BodyId add(World& world, const ShapeDef& def, Vec3 at, Vec3 velocity, Quat orientation = {1, 0, 0, 0},
           Vec3 spin = zero3()) {
  BodyDef body;
  body.shapes = {def};
  body.at = at;
  body.velocity = velocity;
  body.spin = spin;
  body.orientation = orientation;
  return add_body(world, body);
}

const BoxShape block = {vec(0.2, 0.1, 0.15)};

/// The farthest that a body gets from a height within a time [m].
double strays(World& world, BodyId body, double height, double time) {
  double most = 0.0;
  for (const double end = world.time + time; world.time < end;) {
    step(world);
    most = std::fmax(most, std::fabs(world.motion_of(body).x[1] - height));
  }
  return most;
}

/// [m]
double deepest(const World& world) {
  double depth = 0.0;
  for (const Contact& c : world.contacts.list) depth = std::fmax(depth, -c.gap);
  return depth;
}

}  // namespace

TEST_CASE("A box slides v²/2µg over the seams of flush boxes, of a mesh and of heights") {
  const auto ground = GENERATE(Ground::tiles, Ground::mesh, Ground::heights);
  const double speed = GENERATE(1.0, 3.0, 10.0), hz = GENERATE(60.0, 240.0), turn = GENERATE(0.0, 0.3);
  CAPTURE(static_cast<int>(ground), speed, hz, turn);
  World world;
  world.settings.step = 1.0 / hz;
  add_ground(world, ground);
  const BodyId box = add(world, shape(block), vec(-0.4, 0.1, 0.13), vec(speed, 0, 0), about(vec(0, 1, 0), turn));
  CHECK(strays(world, box, 0.1, speed / (0.5 * g) + 0.3) < 1e-6);
  const Vec3 x = world.motion_of(box).x;
  CHECK(std::fabs(x[0] + 0.4 - speed * speed / g) < (turn == 0.0 ? 1e-4 : 1e-3));
  CHECK(std::fabs(x[2] - 0.13) < 1e-3);
  CHECK(world.stats.unsolved_islands == 0);
}

TEST_CASE("A box that turns as it slides does so on tiles as on a half space") {
  const double hz = GENERATE(60.0, 240.0);
  CAPTURE(hz);
  const auto slide = [&](Ground ground) {
    World world;
    world.settings.step = 1.0 / hz;
    add_ground(world, ground);
    const BodyId box = add(world, shape(block), vec(-0.4, 0.1, 0.13), vec(3, 0, 0), {1, 0, 0, 0}, vec(0, 4, 0));
    CHECK(strays(world, box, 0.1, 1.5) < 1e-6);
    return world.motion_of(box).x;
  };
  const Vec3 expected = slide(Ground::half_space);
  // How four points or eight share the load is not for the laws of motion to say, and friction turns the box by it.
  CHECK(norm(slide(Ground::mesh) - expected) < 5e-3);
  CHECK(norm(slide(Ground::tiles) - expected) < 2e-2);
}

TEST_CASE("What is round rolls on at its speed and height over any flat ground") {
  const auto ground = GENERATE(Ground::half_space, Ground::mesh, Ground::heights, Ground::tiles);
  const double speed = GENERATE(3.0, 10.0), hz = GENERATE(60.0, 240.0);
  const Geometry round = GENERATE(Geometry(BallShape{0.1}), Geometry(CapsuleShape{0.1, 0.15}),
                                  Geometry(CylinderShape{0.1, 0.2}), Geometry(CylinderShape{0.1, 0.02}));
  CAPTURE(static_cast<int>(ground), speed, hz, round.index());
  World world;
  world.settings.step = 1.0 / hz;
  add_ground(world, ground);
  const BodyId body =
      add(world, shape(round), vec(-0.4, 0.1, 0.13), vec(speed, 0, 0), {1, 0, 0, 0}, vec(0, 0, -10 * speed));
  const double strayed = strays(world, body, 0.1, 5.0);
  const Motion& m = world.motion_of(body);
  const double slip = norm(m.p / m.mass - vec(speed, 0, 0)), aside = std::fabs(m.x[2] - 0.13);
  const bool one_point = std::holds_alternative<BallShape>(round), seams = ground == Ground::tiles;
  CHECK(strayed < (seams       ? 2e-6
                   : one_point ? 1e-8
                               : 1e-7));  // what rests overlaps by 1e-8 of its size, at a seam by more
  CHECK(slip < (one_point && !seams ? 1e-9 : 1e-6));
  CHECK(aside < (one_point ? 1e-9 : 2e-6));
}

TEST_CASE("A box that lands while it moves goes on over seams as on a half space") {
  const double hz = GENERATE(60.0, 240.0), start = GENERATE(-1.0, -0.93, -0.87, -0.8, -0.71);
  CAPTURE(hz, start);
  const auto land = [&](Ground ground) {
    World world;
    world.settings.step = 1.0 / hz;
    add_ground(world, ground);
    const BodyId box = add(world, shape(block), vec(start, 0.4, 0.13), vec(3, 0, 0));
    for (int i = 0; i < 1.5 * hz; i++) step(world);
    return world.motion_of(box).x;
  };
  CHECK(norm(land(Ground::tiles) - land(Ground::half_space)) < 1e-6);
}

TEST_CASE("A ball slides down a wall of flush boxes that it is pressed against") {
  const double hz = GENERATE(60.0, 240.0);
  World world;
  world.settings.step = 1.0 / hz;
  world.settings.gravity = vec(-5, -g, 0);
  for (int i = 0; i < 30; i++) {
    ShapeDef def = shape(BoxShape{vec(0.5, 0.5, 0.5)}, 0.0);
    def.at = vec(-0.5, -1.0 * i, 0);
    add_shape(world, def);
  }
  const BodyId ball = add(world, shape(BallShape{0.1}, 0.0), vec(0.1, 0, 0), zero3());
  for (int i = 0; i < 2 * hz; i++) step(world);
  const Vec3 x = world.motion_of(ball).x;
  CHECK(std::fabs(x[0] - 0.1) < 1e-6);
  CHECK(std::fabs(x[1] + 0.5 * g * world.time * world.time) < 1e-6);
}

TEST_CASE("A step up stops a box that slides against it, and is not passed through") {
  const double hz = GENERATE(60.0, 240.0), speed = GENERATE(1.0, 3.0, 10.0);
  CAPTURE(hz, speed);
  World world;
  world.settings.step = 1.0 / hz;
  add_tiles(world, 1, 0.0);
  ShapeDef higher = shape(BoxShape{vec(0.5, 0.5, 5)}, 0.0);
  higher.at = vec(1.5, -0.49, 0);  // by 5 % of the box's height
  add_shape(world, higher);
  const BodyId box = add(world, shape(block, 0.0), vec(-0.4, 0.1, 0), vec(speed, 0, 0));
  double most = 0.0;
  for (int i = 0; i < 1.4 / speed * hz; i++) {
    step(world);
    most = std::fmax(most, deepest(world));
  }
  CHECK(most < 1e-3);
  CHECK(world.motion_of(box).p[0] / world.motion_of(box).mass < 0.5 * speed);  // it tips over the edge
}

TEST_CASE("A box that flies at a side of another, aslant from above, meets it and does not sink in") {
  const double hz = GENERATE(60.0, 240.0), drop = GENERATE(0.2, 0.5, 1.0, 2.0);
  CAPTURE(hz, drop);
  World world;
  world.settings.step = 1.0 / hz;
  world.settings.gravity = zero3();
  add_shape(world, shape(BoxShape{vec(0.5, 0.5, 0.5)}, 0.0));
  add(world, shape(block, 0.0), vec(-3, 0.6 + 2.2 * drop, 0), vec(20, -20 * drop, 0));
  double most = 0.0;
  for (int i = 0; i < hz; i++) {
    step(world);
    most = std::fmax(most, deepest(world));
  }
  CHECK(most < 5e-3);
}

TEST_CASE("Nothing passes a wall of thin flush boxes, however fast, from any side, at seams or between") {
  Random random{.seed = 31};
  const Geometry bullet = GENERATE(Geometry(BallShape{0.005}), Geometry(BoxShape{vec(0.005, 0.005, 0.005)}),
                                   Geometry(CapsuleShape{0.005, 0.005}), Geometry(CylinderShape{0.005, 0.005}));
  for (int trial = 0; trial < 60; trial++) {
    World world;
    world.settings.step = 1.0 / (trial % 2 == 0 ? 60.0 : 240.0);
    world.settings.gravity = zero3();
    for (int i = -2; i < 2; i++)
      for (int j = -2; j < 2; j++) {
        ShapeDef tile = shape(BoxShape{vec(0.005, 15, 15)}, 0.0);
        tile.at = vec(0.005, 30 * (i + 0.5), 30 * (j + 0.5));
        add_shape(world, tile);
      }
    const bool at_seam = trial % 3 == 0;
    const double up = random.uniform() - 0.5, aside = random.uniform() - 0.5;
    const double from_below = 1.6 * (random.uniform() - 0.5), from_beside = 1.6 * (random.uniform() - 0.5);
    const double speed = std::pow(10.0, 1.0 + 2.0 * random.uniform());
    const Quat turn = quaternion(brute::random_turn(random));
    const Vec3 way = vec(1.0, from_below, from_beside);
    const BodyId body = add(world, shape(bullet, 0.0), vec(0, at_seam ? 0.0 : up, aside) - way * 0.9,
                            direction(way) * speed, trial % 4 == 0 ? Quat{1, 0, 0, 0} : turn);
    CAPTURE(bullet.index(), trial, speed);
    for (const double end = 1.5 / speed + 3 * world.settings.step; world.time < end;) step(world);
    CHECK(world.motion_of(body).x[0] < 0.0);
  }
}

}  // namespace passing
