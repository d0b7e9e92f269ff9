#include <catch2/catch.hpp>

#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "laws/library.hpp"
#include "measure/freedoms.hpp"
#include "model/path.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;
using namespace pantin::cases;

namespace {

long freedoms(const World& world) { return count_freedoms(world, everything(world)).count; }

std::shared_ptr<const Law> thermostat(double temperature, double rate) {
  LawArguments arguments;
  arguments.numbers = {{"temperature", temperature}, {"rate", rate}};
  return std::make_shared<const Law>(make_library_law("thermostat", arguments).front());
}

/// Two masses on a line body of 1 m.
BodyId dumbbell(World& world, Vec3 at) {
  BodyDef def;
  def.at = at;
  for (double x : {-0.5, 0.5}) {
    PointDef p;
    p.at = vec(x, 0, 0);
    p.mass = 1.0;
    def.points.push_back(p);
  }
  return add_body(world, def);
}

double mean_temperature(World& world, double until) {
  double sum = 0.0;
  int count = 0;
  while (world.time < until) {
    step(world);
    if (world.time < 0.1 * until) continue;
    sum += temperature(world, everything(world));
    count++;
  }
  return sum / count;
}

}  // namespace

TEST_CASE("degrees of freedom are those of the things, less what ties them, less their common motion") {
  World world;
  add_particle(world, {});
  CHECK(freedoms(world) == 0);
  ParticleDef def;
  def.at = vec(1, 0, 0);
  const PointId far = point_of(world, add_particle(world, def));
  CHECK(freedoms(world) == 3);
  const BodyId a = dumbbell(world, vec(0, 5, 0)), b = dumbbell(world, vec(1, 5, 0));
  CHECK(freedoms(world) == 3 + 10);
  const PointId points[] = {point_of(world, a, 1), point_of(world, b, 0)};
  const ParticleId hinge = add_hinge(world, points);
  CHECK(freedoms(world) == 10);
  const ConstraintId rod = add_rod(world, far, point_of(world, a, 0));
  CHECK(freedoms(world) == 9);
  set_enabled(world, rod, false);
  CHECK(freedoms(world) == 10);
  cut(world, hinge);
  add_nail(world, far);  // nothing moves together any more: 6 + 5 + 5, less 3
  CHECK(freedoms(world) == 13);
  BodyDef at_nine;
  at_nine.at = vec(9, 0, 0);
  const BodyId c = add_rod_body(world, 1.0, 1.0, at_nine), d = add_rod_body(world, 1.0, 1.0);
  CHECK(freedoms(world) == 25);
  add_weld(world, c, d);
  CHECK(freedoms(world) == 19);
}

TEST_CASE("hinged and rigid bodies in a heat bath come to its temperature") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 0.01;
  for (int i = 0; i < 40; i++) {  // a pair of dumbbells on a hinge: seven freedoms of twelve
    const BodyId a = dumbbell(world, vec(0, 0, 3.0 * i)), b = dumbbell(world, vec(1, 0, 3.0 * i));
    const PointId points[] = {point_of(world, a, 1), point_of(world, b, 0)};
    add_hinge(world, points);
  }
  CHECK(freedoms(world) == 40 * 7 - 3);
  add_field(world, thermostat(0.5, 2.0), {});
  CHECK(mean_temperature(world, 40.0) == Approx(0.5).epsilon(0.03));
}

TEST_CASE("temperature: rk4 refuses a thermostat, which would heat too little in it") {
  World world;
  add_particle(world, {});
  add_field(world, thermostat(0.5, 2.0), {});
  CHECK_THROWS_WITH(set_integrator(world, Integrator::rk4),
                    Catch::Contains("where noise has no meaning: there is thermostat"));
}

TEST_CASE("a nailed chain in a heat bath comes to its temperature, and its links share it") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 0.01;
  const Chain chain = [&] {
    Chain c;
    PointId last;
    for (int i = 0; i < 30; i++) {
      const BodyId link = dumbbell(world, vec(i, 0, 0));
      c.bodies.push_back(link);
      const PointId head = point_of(world, link, 0);
      if (last) {
        const PointId points[] = {last, head};
        add_hinge(world, points);
      } else {
        add_nail(world, head);
      }
      last = point_of(world, link, 1);
    }
    return c;
  }();
  CHECK(freedoms(world) == 60);
  add_field(world, thermostat(0.5, 2.0), {});
  CHECK(mean_temperature(world, 100.0) == Approx(0.5).epsilon(0.04));
}

TEST_CASE("what slides along a plane or a path together is not hot, and what moves on it apart is") {
  World world;
  world.settings.gravity = zero3();
  const auto add = [&](Vec3 at, Vec3 velocity) {
    ParticleDef def;
    def.at = at;
    def.velocity = velocity;
    return point_of(world, add_particle(world, def));
  };
  std::vector<PointId> points;
  for (int i = 0; i < 5; i++) points.push_back(add(vec(i, 0, i * i), vec(3, 0, -4)));
  for (PointId p : points) cases::add_on_plane(world, p);
  CHECK(freedoms(world) == 5 * 2 - 2);
  CHECK(temperature(world, everything(world)) == Approx(0.0).margin(1e-12));
  set_velocity(world, points[0], vec(3, 0, -3));
  // One of five equal masses moves at 1 m/s relative to the others: 1/2 m v² (1 - 1/5) J on eight freedoms.
  CHECK(temperature(world, everything(world)) == Approx(2.0 * 0.5 * 0.8 / 8.0));
  for (PointId p : points) remove(world, p);
  points.clear();
  for (int i = 0; i < 3; i++) points.push_back(add(vec(i, 0, 0), vec(2, 0, 0)));
  const auto line = std::make_shared<const Path>(std::vector<Vec3>{vec(-9, 0, 0), vec(9, 0, 0)}, false, false);
  for (PointId p : points) add_on_path(world, p, line);
  CHECK(freedoms(world) == 3 - 1);
  CHECK(temperature(world, everything(world)) == Approx(0.0).margin(1e-12));
  add_nail(world, add(vec(0, 5, 0), zero3()));
  CHECK(freedoms(world) == 3);
}
