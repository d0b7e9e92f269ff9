#include <catch2/catch.hpp>

#include "edit/assemble.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;
using namespace pantin::cases;
using Catch::Contains;

namespace {

struct TwoTips {
  World world;
  BodyId a, b;
  PointId tip_a, tip_b;
  TwoTips() {
    BodyDef def;
    def.at = vec(-1.5, 0, 0);
    def.velocity = vec(0, 0.3, 0.1);
    a = add_rod_body(world, 1.0, 1.0, def);
    def = {};
    def.at = vec(1.5, 0.5, 0);
    def.spin = vec(0, 0, 1);
    b = add_rod_body(world, 2.0, 1.0, def);
    tip_a = point_of(world, a, 1);
    tip_b = point_of(world, b, 0);
    world.settings.gravity = zero3();
  }
};

}  // namespace

TEST_CASE("two points are drawn together critically damped, and become a hinge") {
  TwoTips s;
  const Vec3 d0 = position(s.world, s.tip_a) - position(s.world, s.tip_b);
  const Vec3 v0 = velocity(s.world, s.tip_a) - velocity(s.world, s.tip_b);
  ParticleId met;
  JoinDef def;
  def.time_constant = 0.1;
  def.on_met = [&](ParticleId hinge) { met = hinge; };
  const ConstraintId join = add_join(s.world, s.tip_a, s.tip_b, def);
  const Vec3 momentum_before = momentum(s.world, everything(s.world));
  double worst = 0.0;
  while (s.world.time < 1.0) {
    step(s.world);
    const double t = s.world.time;
    const Vec3 wanted = (d0 + (v0 + d0 / 0.1) * t) * std::exp(-t / 0.1);  // Barzel and Barr 1988
    worst = std::fmax(worst, norm(position(s.world, s.tip_a) - position(s.world, s.tip_b) - wanted));
  }
  CHECK(worst < 1e-9);
  CHECK_FALSE(met);
  advance(s.world, 4.0);
  CHECK(s.world.failure.empty());
  REQUIRE(s.world.particles.alive(met));
  CHECK(s.world.particles[met].points == std::vector<PointId>{s.tip_a, s.tip_b});
  CHECK_FALSE(s.world.constraints.alive(join));
  CHECK(s.world.error.hinge_gap < 1e-8);
  CHECK(norm(momentum(s.world, everything(s.world)) - momentum_before) < 1e-12);
}

TEST_CASE("bodies are joined at a position, and let go of it when they have met") {
  TwoTips s;
  const Vec3 P = vec(0.2, 1.0, 0.3);
  JoinDef def;
  def.at = P;
  def.name = "knee";
  add_join(s.world, s.tip_a, s.tip_b, def);
  while (hinges(s.world).empty() && s.world.time < 5.0) step(s.world);
  REQUIRE(hinges(s.world).size() == 1);
  CHECK(norm(position(s.world, s.tip_a) - P) < 1e-7);
  CHECK(s.world.constraints.empty());
  CHECK(s.world.particles[hinges(s.world)[0]].name == "knee");
  bool told = false;
  for (const Notice& n : s.world.notices) told = told || n.kind == Notice::Kind::joined;
  CHECK(told);
}

TEST_CASE("what draws points together is counted from its first step on") {
  for (bool at_place : {false, true}) {
    TwoTips s;
    JoinDef def;
    def.time_constant = 0.1;
    if (at_place) def.at = vec(0.2, 1.0, 0.3);
    add_join(s.world, s.tip_a, s.tip_b, def);
    const double before = energy(s.world).total();
    step(s.world);
    const double given = energy(s.world).total() - before;
    CHECK(given > 0.1);
    CHECK(s.world.work == Approx(given).epsilon(1e-5));
    advance(s.world, 3.0);
    CHECK(hinges(s.world).size() == 1);
    CHECK(s.world.worst.energy < 1e-4);
  }
}

TEST_CASE("a join with a greatest force never pulls harder on the way") {
  TwoTips s;
  JoinDef def;
  def.max_force = 3.0;
  const ConstraintId join = add_join(s.world, s.tip_a, s.tip_b, def);
  double most = 0.0;
  while (hinges(s.world).empty() && s.world.time < 30.0) {
    const double apart = norm(position(s.world, s.tip_a) - position(s.world, s.tip_b));
    step(s.world);
    if (apart > 0.02 && s.world.constraints.alive(join)) most = std::fmax(most, norm(s.world.constraints[join].force));
  }
  CHECK(hinges(s.world).size() == 1);
  CHECK(most <= 3.0 * (1.0 + 1e-9));
  CHECK(most > 2.9);
}

TEST_CASE("what cannot be joined is told, and a join that is taken back leaves nothing") {
  TwoTips s;
  CHECK_THROWS_WITH(add_join(s.world, s.tip_a, point_of(s.world, s.a, 0)),
                    Contains("join: both points belong to body"));
  CHECK_THROWS_WITH(add_join(s.world, s.tip_a, s.tip_a), Contains("join: both are"));
  JoinDef bad;
  bad.at = vec(0, std::nan(""), 0);
  CHECK_THROWS_WITH(add_join(s.world, s.tip_a, s.tip_b, bad), Contains("join: at must be finite"));
  bad = {};
  bad.max_force = 0.0;
  CHECK_THROWS_WITH(add_join(s.world, s.tip_a, s.tip_b, bad), Contains("max_force must be > 0"));
  CHECK(s.world.constraints.empty());
  JoinDef def;
  def.at = zero3();
  const ConstraintId join = add_join(s.world, s.tip_a, s.tip_b, def);
  CHECK(s.world.constraints.size() == 2);
  remove(s.world, join);
  CHECK(s.world.constraints.empty());
  add_join(s.world, s.tip_a, s.tip_b, def);
  step(s.world);
  remove(s.world, s.a);
  CHECK(s.world.constraints.empty());
  step(s.world);
  CHECK(s.world.failure.empty());
}

TEST_CASE("a join that is too weak for what holds its points apart is told, once") {
  TwoTips s;
  add_nail(s.world, s.tip_b);
  s.world.settings.gravity = vec(0, -9.81, 0);
  set_position(s.world, s.b, vec(1.5, 5, 0));
  JoinDef def;
  def.max_force = 3.0;
  def.time_constant = 0.01;
  def.name = "crane";
  const ConstraintId join = add_join(s.world, s.tip_a, s.tip_b, def);
  add_nail(s.world, point_of(s.world, s.a, 0));
  advance(s.world, 5.0);
  CHECK(s.world.constraints.alive(join));
  REQUIRE(s.world.log.size() == 1);
  CHECK(s.world.log[0].kind == "warning");
  CHECK_THAT(s.world.log[0].text, Contains("its points have come no nearer than") && Contains("max_force of 3 N"));
}
