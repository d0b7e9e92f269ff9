// Momentum, angular momentum, mass and centre through edits of bodies far from the origin, of sizes over four decades and
// masses over twelve.
#include <catch2/catch.hpp>

#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"
#include "support/balance.hpp"

using namespace pantin;

namespace {

struct Wild {
  World world;
  BodyMaker make;
  Vec3 middle = zero3();
  double size = 1.0;

  explicit Wild(std::uint64_t seed) {
    world.settings.gravity = zero3();
    make.random.seed = seed;
    middle = make.place(1.0) * power(0, 6);
    size = power(-2, 2);
  }
  double power(double low, double high) { return std::pow(10.0, make.number(low, high)); }
  Vec3 place() { return middle + make.place(size); }

  BodyDef body_def(std::size_t points) {
    BodyDef def;
    for (std::size_t i = 0; i < points; i++) {
      PointDef p;
      p.at = make.place(size);
      p.mass = power(-6, 6);
      def.points.push_back(p);
    }
    def.at = place();
    def.orientation = make.turn();
    def.velocity = make.place(power(-2, 2));
    def.spin = make.place(power(-2, 1));
    return def;
  }
  BodyId body(std::size_t points = 4) { return add_body(world, body_def(points)); }
  /// On one line, which may be along nothing in particular.
  BodyId line(std::size_t points) {
    BodyDef def = body_def(points);
    const Vec3 along = direction(make.place(1.0));
    for (PointDef& p : def.points) p.at = along * make.number(-size, size);
    return add_body(world, def);
  }
  ParticleId particle(Vec3 at) {
    ParticleDef def;
    def.at = at;
    def.velocity = make.place(power(-2, 2));
    def.mass = power(-6, 6);
    return add_particle(world, def);
  }
  std::vector<PointId> some_points(BodyId body) {
    const std::vector<PointId>& all = world.bodies[body].points;
    const auto count = 1 + static_cast<std::ptrdiff_t>(make.random.uniform() * static_cast<double>(all.size() - 1));
    return {all.begin(), all.begin() + count};
  }
};

constexpr std::uint64_t cases = 200;

}  // namespace

TEST_CASE("any two bodies merge without a change of their balances") {
  for (std::uint64_t i = 0; i < cases; i++) {
    Wild w(i);
    const BodyId a = i % 4 == 3 ? w.line(3) : w.body(), b = i % 3 == 2 ? w.line(2) : w.body(1 + i % 5);
    expect_kept(w.world, [&] { merge(w.world, a, b); });
  }
}

TEST_CASE("any body splits without a change of its balances, one of two points too") {
  int done = 0;
  for (std::uint64_t i = 0; i < cases; i++) {
    Wild w(1000 + i);
    const BodyId body = i % 3 == 0 ? w.line(2 + i % 4) : w.body(2 + i % 6);
    const std::vector<PointId> some = w.some_points(body);
    try {
      expect_kept(w.world, [&] { split(w.world, body, some); });
      done++;
    } catch (const Error&) {  // an inertia that was lifted carries what its points cannot
      CHECK(lift(w.world, body) > 0.0);
    }
  }
  CHECK(done > static_cast<int>(cases) * 8 / 10);
}

TEST_CASE("particles and bodies freeze without a change of their balances") {
  for (std::uint64_t i = 0; i < cases; i++) {
    Wild w(2000 + i);
    const GroupId group = add_group(w.world, "");
    const Vec3 along = direction(w.make.place(1.0));
    for (std::uint64_t k = 0; k < 1 + i % 7; k++)
      add_to_group(w.world, group,
                   w.particle(i % 3 == 0 ? w.middle + along * w.make.number(-w.size, w.size) : w.place()));
    for (std::uint64_t k = 0; k < i % 4; k++) add_to_group(w.world, group, w.body());
    expect_kept(w.world, [&] { freeze(w.world, group); });
    CHECK(w.world.bodies.size() == 1);
  }
}

TEST_CASE("any body shatters without a change of its balances") {
  int done = 0;
  for (std::uint64_t i = 0; i < cases; i++) {
    Wild w(3000 + i);
    const BodyId body = i % 3 == 0 ? w.line(2 + i % 4) : w.body(2 + i % 6);
    try {
      expect_kept(w.world, [&] { shatter(w.world, body); });
      done++;
    } catch (const Error&) { CHECK(w.world.bodies.alive(body)); }  // one mass is nearly all, and spins
  }
  CHECK(done > static_cast<int>(cases) / 2);
}

TEST_CASE("two bodies of any masses are welded without a change of their balances, and the weld keeps them") {
  for (std::uint64_t i = 0; i < cases; i++) {
    Wild w(4000 + i);
    w.middle = w.make.place(w.size) * w.power(0, 4);
    const auto body = [&] {
      BodyDef def = w.body_def(4);
      const double mass = w.power(-6, 6);
      for (PointDef& p : def.points) p.mass = mass * w.make.number(0.1, 1.0);
      return add_body(w.world, def);
    };
    const BodyId a = body(), b = body();
    const Balance before = balance_of(w.world);
    const BalanceScale scale = scale_of(w.world);
    expect_kept(w.world, [&] { add_weld(w.world, a, b); });
    for (int k = 0; k < 3; k++) step(w.world);
    const Balance after = balance_of(w.world);
    const double turning = std::fmax(scale.angular, scale_of(w.world).angular);
    CHECK(norm(after.momentum - before.momentum) <= 1e-13 * scale.momentum);
    CHECK(norm(after.angular - before.angular) <= 1e-13 * turning);
  }
}

TEST_CASE("any hinge is cut without a change of the balances") {
  for (std::uint64_t i = 0; i < cases; i++) {
    Wild w(5000 + i);
    std::vector<PointId> ring;
    for (std::uint64_t k = 0; k < 2 + i % 4; k++) {
      const BodyId body = w.body();
      ring.push_back(w.world.bodies[body].points[0]);
      set_position(w.world, body, w.world.motion_of(body).x + w.middle - position(w.world, ring.back()));
    }
    w.world.settings.tolerance = 1e-3;
    const ParticleId hinge = add_hinge(w.world, ring);
    const BodyId body = w.world.points[ring[0]].body;
    expect_kept(w.world, [&] { i % 2 ? cut(w.world, hinge) : cut(w.world, hinge, body); });
  }
}
