#include "laws/expression.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "laws/symbol.hpp"

using namespace pantin;

namespace {

const double nan_value = std::nan(""), infinite = std::numeric_limits<double>::infinity();

struct Graph : Expressions {
  Expr r2 = input({Role::distance2, 0, 0, {}});
  Expr x = input({Role::parameter, 0, 0, "x"});
  Expr y = input({Role::parameter, 0, 0, "y"});
  Expr r = square_root(r2);

  double at(Expr e, double r2_value, double x_value = 0.0, double y_value = 0.0) const {
    const double values[] = {r2_value, x_value, y_value};
    return evaluate(e, values);
  }
};

}  // namespace

TEST_CASE("equal expressions are one node") {
  Graph g;
  CHECK(g.add(g.x, g.y) == g.add(g.y, g.x));
  CHECK(g.multiply(g.x, g.y) == g.multiply(g.y, g.x));
  CHECK(g.subtract(g.add(g.x, g.y), g.x) == g.y);
  CHECK(g.subtract(g.x, g.x) == g.constant(0.0));
  CHECK(g.divide(g.multiply(g.x, g.y), g.x) == g.y);
  CHECK(g.scale(g.scale(g.x, 0.25), 4.0) == g.x);
  CHECK(g.multiply(g.scale(g.x, 2.0), g.scale(g.y, 3.0)) == g.scale(g.multiply(g.x, g.y), 6.0));
  CHECK(g.power(g.power(g.x, 2.0), 3.0) == g.power(g.x, 6.0));
  CHECK(g.multiply(g.power(g.x, 2.0), g.power(g.x, -5.0)) == g.power(g.x, -3.0));
}

TEST_CASE("even powers of the distance need no root") {
  Graph g;
  CHECK(g.multiply(g.r, g.r) == g.r2);
  CHECK(g.power(g.r, -12.0) == g.power(g.r2, -6.0));
  CHECK(g.apply(Function::log, g.r) == g.scale(g.apply(Function::log, g.r2), 0.5));
  CHECK(g.apply(Function::abs, g.r) == g.r);
}

TEST_CASE("the root of a square is the absolute value") {
  Graph g;
  const Expr root = g.square_root(g.multiply(g.x, g.x));
  CHECK(root == g.apply(Function::abs, g.x));
  CHECK(g.at(root, 1.0, -3.0) == 3.0);
  CHECK(g.at(g.power(g.power(g.x, 2.0), 1.5), 1.0, -2.0) == Approx(8.0));
  CHECK(g.at(g.square_root(g.multiply(g.power(g.x, 2.0), g.y)), 1.0, -3.0, 4.0) == 6.0);
}

TEST_CASE("what is not a number stays so") {
  Graph g;
  const Expr root = g.square_root(g.x);
  CHECK(std::isnan(g.at(g.multiply(root, root), 1.0, -4.0)));
  CHECK(g.at(g.multiply(root, root), 1.0, 4.0) == 4.0);
  CHECK(std::isnan(g.at(g.power(root, 2.0), 1.0, -4.0)));
  CHECK(std::isnan(g.at(g.power(g.power(g.x, 3.0), 0.5), 1.0, -1.0)));
  CHECK(std::isnan(g.at(g.power(g.power(g.x, 3.0), 1.0 / 3.0), 1.0, -1.0)));
  CHECK(g.at(g.square_root(g.multiply(g.x, g.y)), 1.0, -2.0, -8.0) == 4.0);
  CHECK(g.at(g.square_root(g.scale(g.x, -1.0)), 1.0, -4.0) == 2.0);
  CHECK(std::isnan(g.at(g.apply(Function::exp, g.apply(Function::log, g.x)), 1.0, -1.0)));
  CHECK(g.apply(Function::log, g.apply(Function::exp, g.x)) == g.x);
  CHECK(std::isnan(g.at(g.add(g.constant(nan_value), g.x), 1.0, 1.0)));
  CHECK(std::isnan(g.at(g.multiply(g.constant(0.0), g.constant(infinite)), 1.0)));
}

TEST_CASE("constants are worked out") {
  Graph g;
  CHECK(g.is_constant(g.power(g.constant(2.0), 10.0), 1024.0));
  CHECK(g.is_constant(g.apply(Function::atan2, g.constant(0.0), g.constant(-1.0)), std::atan2(0.0, -1.0)));
  CHECK(g.is_constant(g.modulo(g.constant(-7.5), g.constant(2.0)), 0.5));
  CHECK(g.is_constant(g.ceiling(g.constant(1.25)), 2.0));
  CHECK(g.select(g.constant(1.0), g.x, g.y) == g.x);
  CHECK(g.select(g.constant(0.0), g.x, g.y) == g.y);
  CHECK(std::signbit(g[g.constant(-0.0)].value));
}

TEST_CASE("a choice takes nothing of what it does not choose") {
  Graph g;
  const Expr positive = g.apply(Function::less, g.constant(0.0), g.x);
  const Expr e = g.select(positive, g.apply(Function::log, g.x), g.constant(-1.0));
  CHECK(g.at(e, 1.0, 0.0) == -1.0);
  CHECK(g.at(e, 1.0, -2.0) == -1.0);
  CHECK(g.at(e, 1.0, 1.0) == 0.0);
  CHECK(g.at(g.apply(Function::less_or_equal, g.x, g.y), 1.0, nan_value, 1.0) == 0.0);
  CHECK(g.at(g.apply(Function::less_or_equal, g.x, g.y), 1.0, 1.0, 1.0) == 1.0);
}

TEST_CASE("an input can be replaced by an expression") {
  Graph g;
  const Expr e = g.add(g.multiply(g.x, g.r), g.apply(Function::maximum, g.y, g.x));
  const Expr changed = g.replaced(e, {Role::parameter, 0, 0, "x"}, g.power(g.y, 2.0));
  CHECK(changed == g.add(g.multiply(g.power(g.y, 2.0), g.r), g.apply(Function::maximum, g.y, g.power(g.y, 2.0))));
  CHECK(g.inputs_of({&changed, 1}).size() == 2);
  CHECK(g.depends_on(e, Role::distance2));
  CHECK_FALSE(g.depends_on(e, Role::time));
}

TEST_CASE("a spline goes through its points and is smooth") {
  const double x[] = {0.0, 0.5, 1.25, 2.0, 3.5}, y[] = {1.0, -0.5, 2.0, 2.5, 0.0};
  const Spline spline(x, y);
  for (std::size_t i = 0; i < 5; i++) CHECK(spline.evaluate(x[i]) == Approx(y[i]).margin(1e-14));
  for (double knot : {0.5, 1.25, 2.0}) {
    for (int order = 0; order < 3; order++) {
      CHECK(spline.evaluate(knot - 1e-12, order) == Approx(spline.evaluate(knot, order)).margin(1e-9));
    }
  }
  const double h = 1e-3;
  for (double at : {-0.4, 0.3, 0.5, 1.9, 3.8}) {
    CHECK((spline.evaluate(at + h, -1) - spline.evaluate(at - h, -1)) / (2.0 * h) ==
          Approx(spline.evaluate(at)).margin(1e-5));
  }
  CHECK(spline.evaluate(3.5, -1) == 0.0);
  CHECK(spline.evaluate(-1.0) == Approx(1.0 - spline.evaluate(0.0, 1)));
  CHECK(spline.evaluate(4.5) == Approx(spline.evaluate(3.5, 1)));
  CHECK(spline.evaluate(0.0, 2) == 0.0);
  CHECK(spline.evaluate(3.5, 2) == Approx(0.0).margin(1e-12));
  CHECK_THROWS_WITH(Spline(std::vector{1.0, 1.0}, std::vector{0.0, 2.0}), Catch::Contains("must rise"));
  CHECK_THROWS_WITH(Spline(std::vector{1.0}, std::vector{0.0}), Catch::Contains("at least two points"));
}

TEST_CASE("symbols without an expression, or of two graphs, are not put together") {
  using Catch::Contains;
  Expressions one, two;
  const Symbol a{&one, one.input({Role::distance2, 0, 0, {}})}, b{&two, two.input({Role::distance2, 0, 0, {}})};
  for (const Symbol& none : {Symbol{}, Symbol{&one, no_expression}, Symbol{&one, 12345}}) {
    CHECK_THROWS_WITH(none * 2.0, Contains("a symbol has no expression"));
    CHECK_THROWS_WITH(a + none, Contains("a symbol has no expression"));
    CHECK_THROWS_WITH(1.0 - none, Contains("a symbol has no expression"));
    CHECK_THROWS_WITH(sqrt(none), Contains("a symbol has no expression"));
    CHECK_THROWS_WITH(apply(Function::exp, none), Contains("a symbol has no expression"));
  }
  CHECK_THROWS_WITH(a + b, "symbols of two graphs cannot be put together");
  CHECK_THROWS_WITH(where_less(a, a, a, b), "symbols of two graphs cannot be put together");
  CHECK_THROWS_WITH(one.add(a.e, 12345), "there is no expression 12345 in this graph");
  CHECK_THROWS_WITH(one.power(no_expression, 2.0), "there is no expression -1 in this graph");
}
