#pragma once
// What edits are to keep, and random bodies to try them on.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/random.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"

namespace pantin {

struct Balance {
  double mass;
  Vec3 centre, momentum, angular;
};

inline Balance balance_of(const World& world) {
  const Things all = everything(world);
  Balance b{mass(world, all), zero3(), momentum(world, all), angular_momentum(world, all)};
  for (BodyId id : all.bodies) b.centre += world.motion_of(id).x * world.motion_of(id).mass;
  for (PointId id : all.free_points) b.centre += world.motion_of(id).x * world.points[id].mass;
  b.centre = b.centre / b.mass;
  return b;
}

/// Sums of magnitudes, which what is kept is relative to.
struct BalanceScale {
  double momentum = 0.0, angular = 0.0, length = 0.0;
};

inline BalanceScale scale_of(const World& world) {
  BalanceScale s;
  const Things all = everything(world);
  for (BodyId id : all.bodies) {
    const Motion& m = world.motion_of(id);
    s.momentum += norm(m.p);
    s.angular += norm(m.x) * norm(m.p) + norm(m.angular);
    s.length = std::fmax(s.length, norm(m.x));
  }
  for (PointId id : all.free_points) {
    const FreeMotion& m = world.motion_of(id);
    s.momentum += norm(m.v) * world.points[id].mass;
    s.angular += norm(m.x) * norm(m.v) * world.points[id].mass;
    s.length = std::fmax(s.length, norm(m.x));
  }
  return s;
}

/// Mass, centre, momentum and angular momentum are kept to 1e-13.
template <class Edit>
void expect_balances_kept(World& world, Edit edit) {
  const Balance before = balance_of(world);
  const BalanceScale scale = scale_of(world);
  edit();
  const Balance after = balance_of(world);
  CHECK(std::fabs(after.mass - before.mass) <= 1e-13 * before.mass);
  CHECK(norm(after.centre - before.centre) <= 1e-13 * scale.length);
  CHECK(norm(after.momentum - before.momentum) <= 1e-13 * scale.momentum);
  CHECK(norm(after.angular - before.angular) <= 1e-13 * scale.angular);
}

/// The same where no laws act, and the work is what the energy changed by.
template <class Edit>
void expect_kept(World& world, Edit edit) {
  const double joules = energy(world).total(), work = world.work;
  expect_balances_kept(world, edit);
  CHECK(std::fabs(world.work - work - (energy(world).total() - joules)) <= 1e-12 * (1.0 + std::fabs(joules)));
}

struct BodyMaker {
  Random random{7, 0};
  double number(double low, double high) { return low + (high - low) * random.uniform(); }
  Vec3 place(double size) {
    const double x = number(-size, size), y = number(-size, size), z = number(-size, size);
    return vec(x, y, z);
  }
  Quat turn() {
    const Vec3 v = place(1.0);
    return normalised({number(0.1, 1), v[0], v[1], v[2]});
  }
  BodyDef body(std::size_t points = 4) {
    BodyDef def;
    for (std::size_t i = 0; i < points; i++) {
      PointDef p;
      p.at = place(1.0);
      p.mass = number(0.1, 2.0);
      def.points.push_back(p);
    }
    def.at = place(3.0);
    def.orientation = turn();
    def.velocity = place(2.0);
    def.spin = place(3.0);
    return def;
  }
};

}  // namespace pantin
