#include "contacts/take_back.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

BodyId add_box(World& world, Vec3 half, double mass, Vec3 at, Vec3 velocity) {
  ShapeDef shape;
  shape.geometry = BoxShape{half};
  BodyDef def;
  def.shapes = {shape};
  def.mass = mass;
  def.at = at;
  def.velocity = velocity;
  return add_body(world, def);
}

double less_push_out(const World& world) {
  const Energy e = energy(world);
  return e.kinetic + e.potential - world.ledger.given[static_cast<std::size_t>(Source::push_out)];
}

}  // namespace

TEST_CASE("Light boxes that slide on each other under a heavy one that lands gain nothing when placing is taken back") {
  World world;
  world.settings.step = 1.0 / GENERATE(60.0, 240.0);
  ShapeDef floor;
  floor.geometry = HalfSpaceShape{};
  floor.orientation = {std::cos(M_PI / 4), -std::sin(M_PI / 4), 0, 0};
  add_shape(world, floor);
  add_box(world, vec(0.2, 0.1, 0.2), 1.0, vec(0, 0.1, 0), vec(1, 0, 0.5));
  add_box(world, vec(0.2, 0.1, 0.2), 1.0, vec(0.05, 0.3, 0.02), vec(-1, 0, 1));
  add_box(world, vec(0.5, 0.5, 0.5), 1000.0, vec(0.1, 1.0, 0), vec(0.3, -5, 0));
  keep_ledger(world);
  const double start = less_push_out(world);
  for (double last = start; world.time < 1.0;) {
    step(world);
    CHECK(less_push_out(world) - last < 1e-5 * start);
    last = less_push_out(world);
  }
}

TEST_CASE(
    "Boxes of any mass that meet in the air keep their momenta, though each gets back what placing gave it alone") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 1.0 / GENERATE(60.0, 240.0);
  add_box(world, vec(0.3, 0.3, 0.3), 1000.0, vec(-0.8, 0.1, 0), vec(3, 0, 0.2));
  add_box(world, vec(0.2, 0.1, 0.2), 1.0, vec(0, 0.05, 0.1), vec(0, 1, 0));
  add_box(world, vec(0.3, 0.3, 0.3), 500.0, vec(0.8, -0.1, 0.05), vec(-4, 0.5, 0));
  const Vec3 p = momentum(world, everything(world)), l = angular_momentum(world, everything(world));
  bool met = false;
  while (world.time < 0.5) {
    step(world);
    met = met || !world.contacts.list.empty();
  }
  CHECK(met);
  CHECK(norm(momentum(world, everything(world)) - p) < 1e-11 * 3000.0);
  CHECK(norm(angular_momentum(world, everything(world)) - l) < 1e-11 * 3000.0);
}
