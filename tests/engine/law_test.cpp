#include "laws/law.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "laws/symbol.hpp"
#include "support/law_state.hpp"

using namespace pantin;
using namespace pantin::testing;

namespace {

struct Pair : Expressions {
  Symbol r2{this, input({Role::distance2, 0, 0, {}})}, r = sqrt(r2), rate{this, rate_of_distance(*this)};
  Symbol charge{this, input({Role::attribute, 0, 0, "charge"})};
  Symbol t{this, input({Role::time, 0, 0, {}})}, noise{this, input({Role::noise, 0, 0, {}})};
  Symbol x{this, input({Role::position, 0, 0, {}})}, u{this, input({Role::velocity, 0, 0, {}})};
  Symbol k{this, input({Role::parameter, 0, 0, "k"})};
};

LawState two(double r, double closing = 0.0) {
  return {{vec(0.1, 0.2, 0.3), vec(0.1 + 0.6 * r, 0.2, 0.3 - 0.8 * r)},
          {zero3(), vec(-0.6, 0.5, 0.8) * closing},
          {{{"charge", 2.0}}, {{"charge", -3.0}}},
          {},
          0.0,
          zero3()};
}

}  // namespace

TEST_CASE("a potential of distance gives tension, stiffness and energy") {
  Pair p;
  const Law law = central_potential({.name = "quartic"}, p, (pow(p.r, 4) + 3.0 * p.r).e);
  const auto state = two(1.3);
  CHECK(tension_of(law, state) == Approx(4.0 * std::pow(1.3, 3) + 3.0));
  CHECK(value_of(law, state, law.stiffness) == Approx(12.0 * 1.3 * 1.3));
  CHECK(energy_of(law, state) == Approx(std::pow(1.3, 4) + 3.9));
  CHECK(law.has_energy());
  CHECK_FALSE(law.velocity_dependent);
  CHECK_FALSE(law.timed);
}

TEST_CASE("a cutoff shifts the energy to 0 there, if it is wanted") {
  Pair p;
  const Expr v = (p.charge / p.r).e;
  const Law shifted = central_potential({.name = "law", .cutoff = 2.5}, p, v);
  const Law plain = central_potential({.name = "law", .cutoff = 2.5, .shift = false}, p, v);
  CHECK(energy_of(shifted, two(2.5)) == Approx(0.0).margin(1e-15));
  CHECK(energy_of(shifted, two(0.5)) == Approx(4.0 - 0.8));
  CHECK(energy_of(plain, two(0.5)) == Approx(4.0));
  CHECK(tension_of(shifted, two(0.5)) == Approx(tension_of(plain, two(0.5))));
}

TEST_CASE("a tension has a stiffness at the same rate, and no energy") {
  Pair p;
  const Law law = central_tension({.name = "law"}, p, (pow(p.r, 3) + 2.0 * p.rate * p.r).e);
  const auto state = two(1.2, 0.7);
  const double rate = dot(state.x[1] - state.x[0], state.v[1]) / 1.2;
  CHECK(tension_of(law, state) == Approx(std::pow(1.2, 3) + 2.0 * rate * 1.2));
  CHECK(value_of(law, state, law.stiffness) == Approx(3.0 * 1.2 * 1.2 + 2.0 * rate));
  CHECK(law.velocity_dependent);
  CHECK_FALSE(law.has_energy());
}

TEST_CASE("what varies with time, or acts on one only, has no energy") {
  Pair p;
  const Law timed = central_potential({.name = "law"}, p, (apply(Function::sin, p.t) * p.r2).e);
  CHECK(timed.timed);
  CHECK_FALSE(timed.has_energy());
  CHECK_FALSE(central_potential({.name = "law", .one_sided = true}, p, p.r2.e).has_energy());
  CHECK(central_tension({.name = "law"}, p, (p.noise * p.r).e).timed);
  CHECK_FALSE(point_potential({.name = "law"}, p, (p.t * p.x).e).has_energy());
}

TEST_CASE("the force on a particle is against the slope of its potential") {
  Pair p;
  const Law law = point_potential({.name = "law"}, p, (p.charge * pow(p.x, 2)).e);
  const Vec3 force = forces_of(law, two(1.0))[0];
  CHECK(force[0] == Approx(-2.0 * 2.0 * 0.1));
  CHECK(force[1] == 0.0);
  CHECK(energy_of(law, two(1.0)) == Approx(2.0 * 0.01));
}

TEST_CASE("the order in which a law's operands were made does not change its bits") {
  Pair p, q;
  const Symbol swing = apply(Function::sin, p.r), root = pow(p.r2, 0.3), bend = apply(Function::exp, p.charge);
  const Symbol bend_first = apply(Function::exp, q.charge), root_first = pow(q.r2, 0.3);
  const Symbol swing_first = apply(Function::sin, q.r);
  const Law one = central_potential({.name = "one"}, p, (swing + root + bend * p.charge).e);
  const Law other = central_potential({.name = "other"}, q, (q.charge * bend_first + root_first + swing_first).e);
  REQUIRE(one.graph.size() == other.graph.size());
  CHECK(one.force == other.force);
  CHECK(one.stiffness == other.stiffness);
  for (double r : {0.3, 0.7, 1.1, 1.9, 2.3}) {
    CHECK(tension_of(one, two(r)) == tension_of(other, two(r)));
    CHECK(value_of(one, two(r), one.stiffness) == value_of(other, two(r), other.stiffness));
  }
}

TEST_CASE("a law may depend only on what its kind has") {
  using Catch::Contains;
  Pair p;
  const LawDef def{.name = "scene.lua:12", .parameters = {}};
  CHECK_THROWS_WITH(central_potential(def, p, p.rate.e),
                    Contains("scene.lua:12: a potential of a pair cannot depend on"));
  CHECK_THROWS_WITH(central_potential(def, p, p.noise.e), Contains("noise"));
  CHECK_THROWS_WITH(central_tension(def, p, p.x.e), Contains("the position of particle 1 (x)"));
  CHECK_THROWS_WITH(point_potential(def, p, p.r2.e), Contains("the distance of a pair"));
  CHECK_THROWS_WITH(point_potential(def, p, p.u.e), Contains("the velocity of particle 1"));
  CHECK_THROWS_WITH(central_potential(def, p, p.k.e), Contains("there is no parameter \"k\""));
  CHECK_THROWS_WITH(central_potential({.name = "law", .cutoff = -1.0}, p, p.r2.e), Contains("cutoff must be > 0 m"));
  const Expr of_third = p.input({Role::attribute, 2, 0, "charge"});
  CHECK_THROWS_WITH(central_potential(def, p, of_third), Contains("the charge of particle 3"));
}

TEST_CASE("law: one that is never a finite number is refused") {
  Expressions g;
  const Expr nothing = g.constant(std::nan(""));
  LawDef def;
  def.name = "scene.lua:3";
  CHECK_THROWS_WITH(central_potential(def, g, nothing), Catch::Contains("must be a finite number"));
}

TEST_CASE("law: one of expressions that are not in its graph, or of another number of them, is refused") {
  using Catch::Contains;
  Pair p;
  const LawDef def{.name = "mine", .parameters = {}};
  const std::string says = "mine: there is no expression ";
  for (const Expr none : {Expr{12345}, no_expression}) {
    CHECK_THROWS_WITH(central_potential(def, p, none), Contains(says));
    CHECK_THROWS_WITH(central_tension(def, p, none), Contains(says));
    CHECK_THROWS_WITH(point_potential(def, p, none), Contains(says));
    CHECK_THROWS_WITH(many_potential(def, 3, p, none), Contains(says));
    CHECK_THROWS_WITH(pair_force(def, p, std::vector<Expr>{p.r2.e, none, p.r2.e}), Contains(says));
    CHECK_THROWS_WITH(point_force(def, p, std::vector<Expr>{p.x.e, p.x.e, none}), Contains(says));
  }
  CHECK_THROWS_WITH(pair_force(def, p, std::vector<Expr>{p.r2.e}), "mine: a force has 3 components, got 1");
  CHECK_THROWS_WITH(point_force(def, p, {}), "mine: a force has 3 components, got 0");
  CHECK_THROWS_WITH(many_potential(def, 5, p, p.x.e), "mine: a law is of 1 to 4 particles, got 5");
  CHECK_THROWS_WITH(central_potential({.name = "mine", .exclude = 99, .parameters = {}}, p, p.r2.e),
                    Contains("exclude must be a number of connections from 0 to 8, got 99"));
}
