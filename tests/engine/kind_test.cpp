// Most kinds of constraints in one machine, thrown about.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/random.hpp"
#include "choreography/hands.hpp"
#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "model/path.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

Passage through(PointId point) { return {point, zero3()}; }
Passage place(Vec3 at) { return {{}, at}; }

PointId loose(World& world, Vec3 at, double mass) {
  ParticleDef def;
  def.at = at;
  def.mass = mass;
  return cases::point_of(world, add_particle(world, def));
}

/// A chain whose links alternate in mass by `ratio`, tied by every kind of constraint. Returns the end to pull at.
PointId add_everything(World& world, double ratio) {
  const auto rod = [&](double x, double mass) {
    BodyDef def;
    def.at = vec(x + 0.5, 0, 0);
    return cases::add_rod_body(world, mass, 1.0, def);
  };
  std::vector<BodyId> links;
  for (int i = 0; i < 5; i++) links.push_back(rod(i, i % 2 ? ratio : 1.0));
  const auto head = [&](int i) { return world.bodies[links[static_cast<std::size_t>(i)]].points[0]; };
  const auto tail = [&](int i) { return world.bodies[links[static_cast<std::size_t>(i)]].points[1]; };
  add_nail(world, head(0));
  HingeDef axis;
  axis.axis = vec(0, 0, 1);
  const PointId first[] = {tail(0), head(1)}, second[] = {tail(1), head(2)}, last[] = {tail(3), head(4)};
  add_hinge(world, first, axis);
  add_hinge(world, second);
  add_weld(world, links[2], links[3]);
  add_hinge(world, last);
  MotorDef motor;
  motor.axis = vec(0, 1, 0);
  motor.speed = 3.0;
  motor.max_torque = 5.0;
  add_motor(world, links[2], links[1], motor);
  add_limit(world, links[4], links[3], vec(0, 0, 1), {-1.0, 1.0, 0.1});
  add_align(world, links[1], {}, {vec(0, 0, 1), vec(0, 0, 1), {}, 0.1});
  const PointId slider = loose(world, vec(2, 1, 0), 0.01 * ratio), stone = loose(world, vec(3, 2, 0), 1.0);
  const auto rail = std::make_shared<const Path>(
      std::vector<Vec3>{vec(0, 1, 0), vec(1, 1.2, 0), vec(2, 1, 0), vec(4, 1, 1)}, true, false);
  add_on_path(world, slider, rail);
  add_rod(world, slider, stone);
  StringDef string;
  string.length = 4.0;
  add_string(world, {through(stone), through(slider), place(vec(2, 3, 0)), through(tail(4))}, string);
  cases::add_on_plane(world, stone);
  return tail(4);
}

}  // namespace

TEST_CASE("a machine of many kinds of constraints holds while a hand throws it about, at any step and mass") {
  for (double ratio : {1.0, 1e3})
    for (double step_length : {1.0 / 60, 1.0 / 240}) {
      World world;
      world.settings.step = step_length;
      const PointId end = add_everything(world, ratio);
      Vec3 at = position(world, end), way = zero3();
      Random random{7, 0};
      const std::int32_t hand = add_hand(world, [&](double) { return at; });
      grab(world, hand, end);
      for (int i = 0; i < 300; i++) {
        if (i % 20 == 0)
          for (int k = 0; k < 3; k++) way[k] = 4.0 * (random.uniform() - 0.5);
        at = at + (way - at * 0.2) * (10.0 * step_length);
        step(world);
        INFO(ratio << " " << step_length << " step " << i << ": " << world.failure);
        REQUIRE(world.failure.empty());
      }
      INFO(ratio << " " << 1 / step_length << " safe " << world.stats.fallback_steps << " halved "
                 << world.stats.halved_steps << " gap " << world.error.constraint << " worst "
                 << world.worst.constraint);
      if (world.stats.fallback_steps == 0) CHECK(world.worst.constraint < 1e-8);
      CHECK(std::isfinite(world.error.constraint));
    }
}
