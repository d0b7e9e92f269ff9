// Edits of bodies that have shapes.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "contacts/find.hpp"
#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "shapes/distance.hpp"
#include "shapes/hull.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/balance.hpp"
#include "support/thrown.hpp"

using namespace pantin;
using Catch::Contains;

TEST_CASE("A body of two boxes splits by its points: each box goes with the point in it, and weighs what it did") {
  Weightless world;
  BodyDef def = thrown({thrown_shape(box(1, 1, 1)), thrown_shape(box(1, 2, 3), vec(3, 0, 0), 500)});
  def.points = {point(zero3()), point(vec(3, 0, 0))};
  const BodyId body = add_body(world, def);
  const ShapeId first = world.bodies[body].shapes[0], second = world.bodies[body].shapes[1];
  const PointId off[] = {world.bodies[body].points[1]};
  const Vec3 at = pose_of(world, world.shapes[second]).x;
  const double joules = kinetic(world);
  BodyId part;
  expect_kept(world, [&] { part = split(world, body, off); });
  CHECK(kinetic(world) == Approx(joules).epsilon(1e-13));
  CHECK(world.bodies[body].shapes == std::vector{first});
  CHECK(world.bodies[part].shapes == std::vector{second});
  CHECK(world.shapes[second].body == part);
  CHECK(norm(pose_of(world, world.shapes[second]).x - at) < 1e-14);
  CHECK(world.motion_of(body).mass == Approx(1000));
  CHECK(world.motion_of(part).mass == Approx(3000));
  CHECK(norm(world.bodies[part].moments - sorted(box_moments(3000, 1, 2, 3))) < 1e-9);
}

TEST_CASE("A shape with points of both parts in it, or without mass for a part, is told and nothing is changed") {
  Weightless world;
  BodyDef def = thrown({thrown_shape(box(4, 1, 1))});
  def.points = {point(zero3()), point(vec(1, 0, 0))};
  def.name = "plank";
  const BodyId body = add_body(world, def);
  const PointId off[] = {world.bodies[body].points[1]};
  const std::uint64_t before = state_hash(world);
  CHECK_THROWS_WITH(split(world, body, off), Contains("shape 1 of body 'plank' has points of both parts in it"));
  def.points[1].at = vec(9, 0, 0);
  const BodyId other = add_body(world, def);
  const PointId far[] = {world.bodies[other].points[1]};
  CHECK_THROWS_WITH(split(world, other, far), Contains("split: what is split off: mass must be > 0 kg"));
  remove(world, other);
  CHECK(state_hash(world) == before);
  CHECK(world.bodies[body].shapes.size() == 1);
}

TEST_CASE("A plane cuts a box in halves of half its mass, whose moments are those of boxes") {
  Weightless world;
  BodyDef def = thrown({thrown_shape(box(2, 1, 1))});
  def.mass = 6;
  const BodyId body = add_body(world, def);
  const Vec3 normal = rotate(def.orientation, vec(1, 0, 0));
  const double joules = kinetic(world);
  BodyId front;
  expect_kept(world, [&] { front = split(world, body, def.at, normal * 7.0); });
  CHECK(kinetic(world) == Approx(joules).epsilon(1e-13));
  for (BodyId half : {body, front}) {
    CHECK(world.motion_of(half).mass == Approx(3).epsilon(1e-13));
    CHECK(norm(world.bodies[half].moments - box_moments(3, 1, 1, 1)) < 1e-13);
    CHECK(world.bodies[half].shapes.size() == 1);
  }
  CHECK(norm(world.motion_of(front).x - def.at - normal * 0.5) < 1e-13);
  CHECK(overlap_of(world) < 1e-14);
}

TEST_CASE("A plane leaves round shapes whole where they are on one side") {
  Weightless world;
  const BodyId body =
      add_body(world, thrown({thrown_shape(BallShape{0.5}), thrown_shape(BallShape{0.5}, vec(2, 0, 0))}));
  const Vec3 x = rotate(orientation(world, body), vec(1, 0, 0)), at = origin(world, body);
  CHECK_THROWS_WITH(split(world, body, at + x * 9.0, x), Contains("leaves all of body") && Contains("on one side"));
  CHECK_THROWS_WITH(split(world, body, at, zero3()), Contains("normal must have a length > 0"));
  CHECK_THROWS_WITH(split(world, body, vec(std::nan(""), 0, 0), x), Contains("split: through must be"));
  const BodyId front = split(world, body, at + x, x);
  CHECK(world.bodies[front].shapes.size() == 1);
  CHECK(world.motion_of(front).mass == Approx(world.motion_of(body).mass).epsilon(1e-13));
}

TEST_CASE("Merging and splitting again gives what there was, with given masses, too") {
  Weightless world;
  BodyDef def = thrown({thrown_shape(box(1, 2, 1))});
  def.mass = 3;
  def.points = {point(zero3())};
  const BodyId a = add_body(world, def);
  def.at = vec(4, 4, 4);
  def.mass = 50;
  def.velocity = vec(1, 1, 1);
  const BodyId b = add_body(world, def);
  const Vec3 moments_a = world.bodies[a].moments, moments_b = world.bodies[b].moments;
  merge(world, a, b);
  REQUIRE(world.bodies[a].shapes.size() == 2);
  const PointId off[] = {world.bodies[a].points[1]};
  BodyId again;
  expect_kept(world, [&] { again = split(world, a, off); });
  CHECK(world.motion_of(a).mass == Approx(3).epsilon(1e-12));
  CHECK(world.motion_of(again).mass == Approx(50).epsilon(1e-12));
  CHECK(norm(world.bodies[a].moments - moments_a) < 1e-11);
  CHECK(norm(world.bodies[again].moments - moments_b) < 1e-11);
}

TEST_CASE("Two cubes that freeze side by side are a box of both") {
  Weightless world;
  const GroupId group = add_group(world, "both");
  for (double x : {-0.5, 0.5}) {
    BodyDef def;
    def.shapes = {thrown_shape(box(1, 1, 1))};
    def.at = vec(x, 0, 0);
    add_to_group(world, group, add_body(world, def));
  }
  const BodyId body = freeze(world, group);
  CHECK(world.bodies.size() == 1);
  CHECK(world.bodies[body].shapes.size() == 2);
  CHECK(world.motion_of(body).mass == Approx(2000));
  CHECK(norm(world.bodies[body].moments - sorted(box_moments(2000, 2, 1, 1))) < 1e-9);
}

TEST_CASE("What shatters keeps mass, centre, momenta and kinetic energy; its pieces are flush and fly apart") {
  BodyMaker make;
  std::vector<Vec3> corners;
  for (int i = 0; i < 30; i++) corners.push_back(make.place(1.0));
  const auto hull = make_hull(corners);
  for (const std::vector<ShapeDef>& shapes :
       {std::vector{thrown_shape(box(2, 0.1, 2))}, std::vector{thrown_shape(hull)},
        std::vector{thrown_shape(box(1, 1, 1)), thrown_shape(box(0.5, 2, 0.5), vec(0, 1.5, 0), 7000)}})
    for (std::size_t pieces : {2u, 5u, 40u})
      for (const bool near : {false, true}) {
        Weightless world;
        const BodyId body = add_body(world, thrown(shapes));
        ShatterDef def{pieces, 3 + pieces, {}};
        if (near) def.at = vec(1, 2, 3);
        const double joules = kinetic(world);
        std::vector<BodyId> made;
        expect_kept(world, [&] { made = shatter(world, body, def); });
        CHECK(made.size() == pieces);
        CHECK(!world.bodies.alive(body));
        CHECK(world.shapes.size() == pieces);
        CHECK(kinetic(world) == Approx(joules).epsilon(1e-12));
        CHECK(overlap_of(world) < 1e-13);
        for (int i = 0; i < 60; i++) step(world);
        REQUIRE(world.failure.empty());
        CHECK(kinetic(world) <= joules * (1.0 + 1e-9));
        CHECK(kinetic(world) >= 0.999 * joules);
      }
}

TEST_CASE("Points, and hinges that hold them, go with the piece that they are in") {
  Weightless world;
  BodyDef def;
  def.shapes = {thrown_shape(box(2, 0.2, 2))};
  def.mass = 100;
  for (double x : {-1.0, 1.0}) def.points.push_back(point(vec(x, 0.1, 1), 0.5));
  const BodyId plate = add_body(world, def);
  BodyDef arm;
  arm.points = {point(zero3(), 1.0), point(vec(0, 1, 0), 1.0)};
  arm.at = vec(1, 0.1, 1);
  const BodyId hanging = add_body(world, arm);
  const PointId right = world.bodies[plate].points[1], held[] = {right, world.bodies[hanging].points[0]};
  const ParticleId hinge = add_hinge(world, held);
  const Vec3 at = position(world, right);
  expect_kept(world, [&] { shatter(world, plate, ShatterDef{12, 1, {}}); });
  CHECK(world.particles.alive(hinge));
  CHECK(norm(position(world, right) - at) < 1e-14);
  const Shape& piece = world.shapes[world.bodies[world.points[right].body].shapes[0]];
  CHECK(separation(piece.geometry, pose_of(world, piece), BallShape{1e-9}, {at}).distance < 1e-9);
  for (int i = 0; i < 60; i++) step(world);
  CHECK(world.failure.empty());
  CHECK(accuracy(world).hinge_gap < 1e-11);
}

TEST_CASE("In a plane pieces are prisms, and their moments add up") {
  Weightless world;
  set_plane(world, Plane{2});
  BodyDef def;
  def.shapes = {thrown_shape(box(2, 1, 1))};
  def.at = vec(3, 1, 0);
  def.spin = vec(0, 0, 2);
  def.velocity = vec(1, 0, 0);
  const BodyId body = add_body(world, def);
  const double joules = kinetic(world);
  CHECK(joules == Approx(0.5 * 2000 * 1 + 0.5 * 2000 * 5.0 / 12.0 * 4));
  expect_kept(world, [&] { shatter(world, body, ShatterDef{20, 5, {}}); });
  CHECK(kinetic(world) == Approx(joules).epsilon(1e-12));
  for (BodyId id : world.bodies.ids()) {
    CHECK(std::fabs(world.motion_of(id).x[2]) < 1e-14);
    const auto& hull = *std::get<std::shared_ptr<const Hull>>(world.shapes[world.bodies[id].shapes[0]].geometry);
    for (const Vec3 v : hull.vertices) CHECK(std::fabs(std::fabs(v[2]) - 0.5) < 1e-14);
  }
  for (int i = 0; i < 30; i++) step(world);
  CHECK(world.failure.empty());
  CHECK_THROWS_WITH(split(world, world.bodies.ids()[0], zero3(), vec(0, 0, 1)), Contains("normal must have no z"));
}

TEST_CASE("What cannot shatter into pieces is told, and the scene is as it was") {
  Weightless world;
  BodyDef def = thrown({thrown_shape(box(1, 1, 1))});
  const BodyId cube = add_body(world, def);
  def.points = {point(zero3(), 1.0), point(vec(0.1, 0, 0), 1.0)};
  const BodyId weighed = add_body(world, def);
  def.points.clear();
  def.inertia = diagonal(vec(300, 300, 300));
  const BodyId odd = add_body(world, def);
  const BodyId two = add_body(world, thrown({thrown_shape(box(1, 1, 1)), thrown_shape(box(1, 1, 1), vec(1, 0, 0)),
                                             thrown_shape(box(1, 1, 1), vec(2, 0, 0))}));
  BodyDef sensing = thrown({thrown_shape(box(1, 1, 1))});
  sensing.shapes[0].sensor = true;
  const BodyId sensor = add_body(world, sensing);
  const std::uint64_t before = state_hash(world);
  const auto message = [&](BodyId body, ShatterDef how) {
    try {
      shatter(world, body, how);
    } catch (const Error& error) { return std::string(error.what()); }
    return std::string("none");
  };
  CHECK_THAT(message(cube, {1, 1, {}}), Contains("pieces must be from 2 to 1000, got 1"));
  CHECK_THAT(message(cube, {1001, 1, {}}), Contains("pieces must be from 2 to 1000, got 1001"));
  CHECK_THAT(message(cube, {5, 1, vec(0, infinity, 0)}), Contains("shatter: at must be"));
  CHECK_THAT(message(weighed, {5, 1, {}}), Contains("is that of its points alone"));
  CHECK_THAT(message(odd, {5, 1, {}}), Contains("was set to something else than its shapes have"));
  CHECK_THAT(message(two, {2, 1, {}}), Contains("has 3 shapes, so there must be as many pieces, got 2"));
  CHECK_THAT(message(sensor, {5, 1, {}}), Contains("has no shape that could break into pieces"));
  CHECK(state_hash(world) == before);
}

namespace {

void add_ground(World& world) {
  ShapeDef floor = thrown_shape(HalfSpaceShape{});
  const double up = -M_PI / 4;
  floor.orientation = {std::cos(up), std::sin(up), 0, 0};
  add_shape(world, floor);
}

/// A heap of boxes that fall on a floor.
struct Heap : World {
  Heap() {
    add_ground(*this);
    for (int i = 0; i < 12; i++) {
      BodyDef def;
      def.shapes = {thrown_shape(box(1, 0.5, 0.7))};
      def.at = vec(0.3 * (i % 3), 0.4 + 0.6 * i, 0.2 * (i % 2));
      def.spin = vec(0.1 * i, 1, 0);
      add_body(*this, def);
    }
  }
};

/// One of each edit of bodies that touch.
void edit_all(World& world) {
  const std::vector<BodyId> ids = world.bodies.ids();
  merge(world, ids[0], ids[1]);
  shatter(world, ids[2], ShatterDef{6, 4, {}});
  split(world, ids[3], world.motion_of(ids[3]).x, vec(0, 1, 0.3));
  remove(world, ids[4]);
  remove(world, world.bodies[ids[5]].shapes[0]);
}

}  // namespace

TEST_CASE("In a heap bodies merge, shatter, split and go at once, and snapshots go on from there with the same bits") {
  Heap world;
  for (int i = 0; i < 200; i++) step(world);
  REQUIRE(world.contacts.list.size() > 20);
  const Snapshot before = take_snapshot(world);
  const auto end_of_run = [&] {
    for (int i = 0; i < 60; i++) step(world);
    return state_hash(world);
  };
  edit_all(world);
  const Snapshot edited = take_snapshot(world);
  const std::uint64_t end = end_of_run();
  CHECK(world.failure.empty());
  CHECK(accuracy(world).penetration < 1e-2);
  restore(world, edited);
  CHECK(end_of_run() == end);
  restore(world, before);
  edit_all(world);
  CHECK(end_of_run() == end);
}

TEST_CASE("A cube at rest that shatters where it stands gains no energy, and nothing goes through the floor") {
  World world;
  add_ground(world);
  BodyDef def;
  def.shapes = {thrown_shape(box(1, 1, 1))};
  def.at = vec(0, 0.5, 0);
  const BodyId cube = add_body(world, def);
  for (int i = 0; i < 30; i++) step(world);
  const double start = energy(world).total();
  for (BodyId piece : shatter(world, cube, ShatterDef{20, 2, {}})) world.bodies[piece].name = "piece";
  for (int i = 0; i < 240; i++) {
    step(world);
    CHECK(energy(world).total() <= start + 1e-3 * std::fabs(start));
  }
  for (BodyId id : world.bodies.ids()) CHECK(world.motion_of(id).x[1] > 0.0);
  CHECK(accuracy(world).penetration < 1e-3);
}
