// What touches falls asleep together, and wakes together.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "base/parallel.hpp"
#include "choreography/hands.hpp"
#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "forces/sleep.hpp"
#include "laws/library.hpp"
#include "measure/ledger_closure.hpp"
#include "measure/measure.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

ShapeDef solid(Geometry geometry, double friction = 0.5) {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.material.friction = friction;
  return def;
}

const BoxShape unit_box = {vec(0.5, 0.5, 0.5)};

ShapeId level_ground(World& world, double friction = 0.5) {
  ShapeDef def = solid(HalfSpaceShape{}, friction);
  const double up = -M_PI / 4;
  def.orientation = Quat{std::cos(up), std::sin(up), 0, 0};
  return add_shape(world, def);
}

BodyId put(World& world, const ShapeDef& def, Vec3 at, double mass = 1.0) {
  BodyDef body;
  body.shapes = {def};
  body.at = at;
  body.mass = mass;
  return add_body(world, body);
}

std::vector<BodyId> pile_up(World& world, int count, Vec3 at = zero3(), double friction = 0.5) {
  std::vector<BodyId> boxes;
  for (int i = 0; i < count; i++) boxes.push_back(put(world, solid(unit_box, friction), at + vec(0, 0.5 + i, 0)));
  return boxes;
}

bool sleeps(const World& world, BodyId body) { return world.contacts.bodies[body.slot - 1].rest.asleep; }

/// Until all that there is sleeps, or for so long [s].
void step_to_sleep(World& world, double most = 5.0) {
  const double end = world.time + most;
  do step(world);
  while (!all_asleep(world) && world.time < end);
  CAPTURE(sleepers(world), world.contacts.list.size(), world.time);
  REQUIRE(world.failure == "");
  REQUIRE(all_asleep(world));
}

/// A tower of three that sleeps, and another.
struct TwoTowers {
  World world;
  ShapeId ground = level_ground(world);
  std::vector<BodyId> tower = pile_up(world, 3), other = pile_up(world, 3, vec(10, 0, 0));
  TwoTowers() { step_to_sleep(world); }
};

/// `rows`: boxes of a stack; below 0: rows of a pyramid.
void check_sleep_of_pile(double hz, int rows) {
  CAPTURE(hz, rows);
  World world;
  world.settings.step = 1.0 / hz;
  level_ground(world);
  std::vector<BodyId> boxes;
  std::vector<Vec3> at;
  for (int row = 0; row < std::abs(rows); row++)
    for (int i = 0; i < (rows < 0 ? -rows - row : 1); i++) {
      at.push_back(vec(rows < 0 ? i + 0.5 * row : 0.0, 0.5 + row, 0));
      boxes.push_back(put(world, solid(unit_box), at.back()));
    }
  keep_ledger(world);
  step_to_sleep(world, 2.0);
  CHECK(sleepers(world) == boxes.size());
  CHECK(energy(world).kinetic == 0.0);
  const double line = world.ledger.given[static_cast<std::size_t>(Source::sleep)];
  CHECK(line <= 0.0);
  CHECK(line >= -1e-12);
  const Energy then = energy(world);
  std::vector<Vec3> where;
  for (const BodyId box : boxes) where.push_back(world.motion_of(box).x);
  const std::uint64_t iterations = world.stats.contact_iterations;
  const double depth = world.error.penetration;
  advance(world, world.time + 1.0);
  CHECK(world.stats.contact_iterations == iterations);
  CHECK(world.error.penetration == depth);
  CHECK(energy(world).potential == then.potential);
  CHECK(world.contacts.list.empty());
  CHECK(closure(world) <= 1e-10);
  CHECK(world.error.energy <= 1e-4);
  for (std::size_t i = 0; i < boxes.size(); i++) {
    CHECK(norm(world.motion_of(boxes[i]).x - where[i]) == 0.0);
    CHECK(norm(where[i] - at[i]) < 1e-4);
  }
}

}  // namespace

TEST_CASE("Sleep in touch: stacks and a pyramid fall asleep within 2 s where they stand, and the ledger closes") {
  check_sleep_of_pile(GENERATE(60.0, 240.0), GENERATE(1, 2, 10, -8));
}

TEST_CASE("Sleep in touch: high stacks and a large pyramid fall asleep within 2 s, and the ledger closes", "[slow]") {
  check_sleep_of_pile(GENERATE(60.0, 240.0), GENERATE(30, -20));
}

TEST_CASE("Sleep in touch: what was asleep goes on as what was not") {
  constexpr double rough =
      3.0;  // where boxes slide, rigid bodies leave open which of several contacts carries how much
  World world, watched;
  std::vector<BodyId> tower;
  for (World* w : {&world, &watched}) {
    level_ground(*w, rough);
    tower = pile_up(*w, 3, zero3(), rough);
  }
  while (world.time < 3.4) {  // what was not asleep moves by 1e-10
    if (world.steps == 3 * 240) {
      CHECK(all_asleep(world));
      for (World* w : {&world, &watched}) {
        BodyDef ball;
        ball.shapes = {solid(BallShape{0.5})};
        ball.mass = 1.0;
        ball.at = vec(-1.5, 2.45, 0);
        ball.velocity = vec(5, 0, 0);
        add_body(*w, ball);
      }
    }
    step(world);
    wake_all(watched);
    step(watched);
  }
  CHECK(norm(world.motion_of(tower[2]).p) > 0.1);
  for (const BodyId box : tower) {
    CHECK(norm(world.motion_of(box).x - watched.motion_of(box).x) < 1e-8);
    CHECK(norm(world.motion_of(box).p - watched.motion_of(box).p) < 1e-8);
  }
}

TEST_CASE("Sleep in touch: a tower of thirty wakes in the step in which a ball hits it") {
  World world;
  level_ground(world);
  const std::vector<BodyId> tower = pile_up(world, 30);
  step_to_sleep(world);
  BodyDef def;
  def.shapes = {solid(BallShape{0.5})};
  def.mass = 2.0;
  def.at = vec(-6, 15.5, 0);
  def.velocity = vec(20, 0, 0);
  const BodyId ball = add_body(world, def);
  step(world);
  CHECK(sleeps(world, tower[15]));
  while (world.motion_of(ball).p[0] > 39.9) {
    step(world);
    REQUIRE(world.time < 10.0);
  }
  for (const BodyId box : tower) CHECK(!sleeps(world, box));
  const Motion& m = world.motion_of(ball);
  double p = m.p[0];
  for (const BodyId box : tower) p += world.motion_of(box).p[0];
  CHECK(std::fabs(p - 40.0) < 2.0);  // the ground has hardly had a part in it
  CHECK(world.motion_of(tower[15]).p[0] > 1.0);
}

TEST_CASE("Sleep in touch: edits and forces wake all of an island, and no other") {
  const auto wakes = [](const std::function<void(TwoTowers&)>& act) {
    TwoTowers scene;
    act(scene);
    step(scene.world);
    for (const BodyId box : scene.tower)
      if (scene.world.bodies.alive(box)) CHECK(!sleeps(scene.world, box));
    for (const BodyId box : scene.other) CHECK(sleeps(scene.world, box));
    step_to_sleep(scene.world, 10.0);
  };
  wakes([](TwoTowers& s) { push(s.world, s.tower[2], vec(1, 0, 0)); });
  wakes([](TwoTowers& s) { twist(s.world, s.tower[1], vec(0, 1, 0)); });
  wakes([](TwoTowers& s) { kick(s.world, s.tower[0], vec(1, 0, 0)); });
  wakes([](TwoTowers& s) { set_velocity(s.world, s.tower[2], vec(0, 1, 0)); });
  wakes([](TwoTowers& s) { set_position(s.world, s.tower[2], vec(0, 3, 0)); });
  wakes([](TwoTowers& s) { set_own_mass(s.world, s.tower[1], 2.0); });
  wakes([](TwoTowers& s) { set_friction(s.world, s.world.bodies[s.tower[1]].shapes[0], 0.1); });
  wakes([](TwoTowers& s) { remove(s.world, s.tower[0]); });
  wakes([](TwoTowers& s) { put(s.world, solid(unit_box), vec(0.2, 3.501, 0)); });
  wakes([](TwoTowers& s) { add_shape(s.world, s.tower[0], solid(BallShape{0.1})); });
}

TEST_CASE("Sleep in touch: what loses its support falls, and what stands still wakes all when it changes") {
  TwoTowers removed;
  remove(removed.world, removed.tower[0]);
  advance(removed.world, removed.world.time + 2.0);
  CHECK(std::fabs(removed.world.motion_of(removed.tower[2]).x[1] - 1.5) < 1e-3);

  TwoTowers without_ground;
  remove(without_ground.world, without_ground.ground);
  const double from = without_ground.world.time;
  advance(without_ground.world, from + 1.0);
  CHECK(std::fabs(without_ground.world.motion_of(without_ground.other[0]).x[1] - (0.5 - 0.5 * 9.81)) < 0.1);

  TwoTowers tilted;
  set_gravity(tilted.world, vec(9.81, -1, 0));
  step(tilted.world);
  CHECK(sleepers(tilted.world) == 0);
  CHECK(energy(tilted.world).kinetic > 0.0);
}

TEST_CASE("Sleep in touch: an island that parted sleeps in two") {
  World world;
  level_ground(world);
  const std::vector<BodyId> boxes = pile_up(world, 2);
  step_to_sleep(world);
  kick(world, boxes[1], vec(8, 0, 0));
  step_to_sleep(world, 10.0);
  REQUIRE(norm(world.motion_of(boxes[0]).x - world.motion_of(boxes[1]).x) > 1.2);
  push(world, boxes[1], vec(1, 0, 0));
  step(world);
  CHECK(!sleeps(world, boxes[1]));
  CHECK(sleeps(world, boxes[0]));
}

TEST_CASE("Sleep in touch: a chain that lies sleeps with the box on it, and a hand wakes both") {
  World world;
  level_ground(world);
  BodyDef link;
  link.shapes = {solid(BoxShape{vec(0.5, 0.1, 0.1)})};
  link.mass = 1.0;
  link.points.resize(2);
  link.points[0].at = vec(-0.5, 0, 0);
  link.points[1].at = vec(0.5, 0, 0);
  std::vector<BodyId> links;
  for (int i = 0; i < 3; i++) {
    link.at = vec(i, 0.1, 0);
    links.push_back(add_body(world, link));
  }
  for (std::size_t i = 0; i + 1 < 3; i++)
    add_hinge(world,
              std::vector<PointId>{cases::point_of(world, links[i], 1), cases::point_of(world, links[i + 1], 0)});
  const BodyId box = put(world, solid(BoxShape{vec(0.2, 0.2, 0.2)}), vec(1, 0.4, 0));
  step_to_sleep(world, 15.0);
  CHECK(sleepers(world) == 2);
  const std::int32_t hand = add_hand(world, [](double) { return vec(0, 3, 0); });
  step(world);
  CHECK(sleepers(world) == 2);
  grab(world, hand, cases::point_of(world, links[0], 0));
  step(world);
  CHECK(sleepers(world) == 0);
  CHECK(!sleeps(world, box));
}

TEST_CASE("Sleep in touch: a box that stands on its edge does not sleep through its fall") {
  const double angle = GENERATE(1e-5, 1e-7, 1e-9);
  World world;
  level_ground(world);
  const BodyId box = put(world, solid(unit_box), vec(0, std::sqrt(0.5), 0));
  const double half = M_PI / 8 + 0.5 * angle;
  set_orientation(world, box, {std::cos(half), 0, 0, std::sin(half)});
  step_to_sleep(world, 20.0);
  CHECK(std::fabs(world.motion_of(box).x[1] - 0.5) < 1e-4);
}

TEST_CASE("Sleep in touch: a box on a slope sleeps just below the angle of friction, and slides just above it") {
  const double hz = GENERATE(60.0, 240.0);
  const double ratio = GENERATE(0.999, 1.001, 1.01);
  CAPTURE(hz, ratio);
  World world;
  world.settings.step = 1.0 / hz;
  const double angle = std::atan(0.5 * ratio);
  level_ground(world);
  world.settings.gravity = vec(9.81 * std::sin(angle), -9.81 * std::cos(angle), 0);
  const BodyId box = put(world, solid(unit_box), vec(0, 0.5, 0));
  advance(world, 3.0);
  CHECK(sleeps(world, box) == (ratio < 1.0));
  const double a = ratio < 1.0 ? 0.0 : 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
  CHECK(std::fabs(world.motion_of(box).p[0] - 3.0 * a) < 1e-3 * 3.0 * a + 1e-9);
}

TEST_CASE("Sleep in touch: a box that leans by a millionth of its size falls when it would have fallen") {
  const double hz = GENERATE(60.0, 240.0);
  World world;
  world.settings.step = 1.0 / hz;
  level_ground(world);
  const BodyId box = put(world, solid(unit_box), vec(0, std::sqrt(0.5), 0));
  const double half = 0.5 * (M_PI / 4 + 1e-6);
  set_orientation(world, box, Quat{std::cos(half), 0, 0, std::sin(half)});
  // I = m (1/6 + 1/2), so the lean is 1e-6 cosh(t / 0.31 s): 0.5 after 4.2 s
  while (world.motion_of(box).x[1] > 0.65 && world.time < 10.0) {
    step(world);
    REQUIRE(!sleeps(world, box));
  }
  CHECK(std::fabs(world.time - 4.2) < 0.5);
}

TEST_CASE(
    "Sleep in touch: a ball that rolls slowly sleeps on level ground, and the ledger tells; not on a slope of a "
    "thousandth") {
  World world;
  level_ground(world);
  BodyDef def;
  def.shapes = {solid(BallShape{0.1})};
  def.mass = 1.0;
  def.at = vec(0, 0.1, 0);
  def.velocity = vec(0.02, 0, 0);  // 0.03 of what a fall through its gyration radius gives
  keep_ledger(world);
  const BodyId ball = add_body(world, def);
  step_to_sleep(world, 3.0);
  const double line = world.ledger.given[static_cast<std::size_t>(Source::sleep)];
  CHECK(line < 0.0);
  CHECK(line >= -0.5 * 0.02 * 0.02);
  CHECK(closure(world) <= 1e-12);
  world.settings.gravity = vec(0.01, -9.81, 0);  // a slope of a thousandth
  wake(world, ball);
  for (int i = 0; i < 480; i++) {
    step(world);
    REQUIRE(!sleeps(world, ball));
  }
  CHECK(std::fabs(world.motion_of(ball).p[0] - 5.0 / 7.0 * 0.01 * 2.0) < 1e-4);
}

TEST_CASE("Sleep in touch: a spring that changes wakes what it pulls") {
  World world;
  level_ground(world);
  BodyDef def;
  def.shapes = {solid(unit_box)};
  def.mass = 1.0;
  def.at = vec(0, 0.5, 0);
  def.points.resize(1);
  def.points[0].at = vec(0, 0.5, 0);
  const BodyId box = add_body(world, def);
  const BodyId upper = put(world, solid(unit_box), vec(0, 1.5, 0));
  LawArguments arguments;
  arguments.numbers = {{"stiffness", 1.0}, {"length", 1.0}};
  ConnectionDef spring;
  spring.ends = {{world.points[cases::point_of(world, box, 0)].own, zero3()}, {{}, vec(2, 1, 0)}};
  spring.solve = Solve::explicitly;
  const ConnectionId id =
      add_connection(world, std::make_shared<const Law>(make_library_law("spring", arguments).front()), spring);
  step_to_sleep(world);
  CHECK(sleepers(world) == 2);
  const auto& names = world.connections[id].law->parameters;
  for (std::size_t i = 0; i < names.size(); i++)
    if (names[i].name == "stiffness") set_parameter(world, id, i, 1.1);
  step(world);
  CHECK(!sleeps(world, box));
  CHECK(!sleeps(world, upper));
}

TEST_CASE("Sleep in touch: nothing parts by falling asleep, and what touches is still told") {
  TwoTowers scene;
  const std::size_t touching = scene.world.contacts.resting.size();
  CHECK(touching >= 24);
  World world;
  world.contacts.watched = true;
  level_ground(world);
  pile_up(world, 2);
  ShapeDef zone = solid(BoxShape{vec(3, 3, 3)});
  zone.sensor = true;
  add_shape(world, zone);
  std::size_t parted = 0, touched = 0;
  while (world.time < 4.0) {
    step(world);
    for (const Notice& n : world.notices) {
      parted += n.kind == Notice::Kind::parted;
      touched += n.kind == Notice::Kind::touched;
    }
    world.notices.clear();
  }
  CHECK(all_asleep(world));
  CHECK(parted == 0);
  CHECK(touched == 4);  // each other, the ground, and the sensor twice
}

TEST_CASE("Sleep in touch: the same bits by any number of threads, and from a snapshot") {
  std::uint64_t hashes[2];
  for (int threads = 1; threads <= 2; threads++) {
    World world;
    world.workers = std::make_unique<Workers>(threads);
    level_ground(world);
    for (int i = 0; i < 12; i++) {
      pile_up(world, 4, vec(3 * i, 0, 0));
      put(world, solid(BallShape{0.3}), vec(3 * i + 1.2, 0.5 + 1.5 * i, 0.1 * i));
    }
    advance(world, 2.0);
    CHECK(sleepers(world) > 0);
    CHECK(sleepers(world) < 60);
    const Snapshot snapshot = take_snapshot(world);
    kick(world, world.bodies.ids()[3], vec(3, 0, 0.5));
    advance(world, 3.0);
    hashes[threads - 1] = state_hash(world);
    restore(world, snapshot);
    kick(world, world.bodies.ids()[3], vec(3, 0, 0.5));
    advance(world, 3.0);
    CHECK(state_hash(world) == hashes[threads - 1]);
  }
  CHECK(hashes[0] == hashes[1]);
}
