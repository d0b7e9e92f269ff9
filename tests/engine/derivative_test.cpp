#include "laws/derivative.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <vector>

using namespace pantin;

namespace {

const Input x_input{Role::parameter, 0, 0, "x"}, y_input{Role::parameter, 0, 0, "y"};

// Eighth-order central differences.
double difference(const std::function<double(double)>& f, double x) {
  const double h = 2e-3 * std::fmax(1.0, std::fabs(x));
  const double weights[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  double total = 0.0;
  for (int k = 1; k <= 4; k++) total += weights[k - 1] * (f(x + k * h) - f(x - k * h));
  return total / h;
}

// One expression of x and y for every function and shape of node.
std::vector<Expr> samples(Expressions& g, Expr x, Expr y) {
  const auto f = [&](Function function, Expr a, Expr b = no_expression) { return g.apply(function, a, b); };
  const Expr half = g.scale(x, 0.5), near = g.scale(g.subtract(x, y), 0.1);
  const double knots[] = {0.2, 0.7, 1.6, 2.4, 4.0}, values[] = {1.0, 0.2, -0.4, 0.3, 0.5};
  const Expr below = f(Function::less, x, g.constant(1.5));
  return {f(Function::exp, g.multiply(x, y)),
          f(Function::log, g.add(x, y)),
          f(Function::sin, g.multiply(x, x)),
          f(Function::cos, g.divide(x, y)),
          f(Function::tan, half),
          f(Function::asin, near),
          f(Function::acos, near),
          f(Function::atan, g.multiply(x, y)),
          f(Function::atan2, x, y),
          f(Function::atan2, near, g.scale(y, -1.0)),
          f(Function::sinh, half),
          f(Function::cosh, half),
          f(Function::tanh, g.subtract(x, y)),
          f(Function::power, x, y),
          f(Function::abs, near),
          f(Function::minimum, x, g.multiply(y, y)),
          f(Function::maximum, g.power(x, 2.0), y),
          g.select(below, g.multiply(x, y), f(Function::exp, x)),
          g.spline(std::make_shared<Spline>(knots, values), g.add(x, g.scale(y, 0.3))),
          g.power(g.add(g.power(x, 2.0), g.power(y, 2.0)), -1.5),
          g.divide(g.add(x, g.constant(3.0)), g.add(g.multiply(x, y), g.constant(1.0))),
          g.modulo(g.scale(x, 3.0), y)};
}

}  // namespace

TEST_CASE("derivatives agree with differences, forward and reverse") {
  Expressions g;
  const Expr x = g.input(x_input), y = g.input(y_input);
  const Input both[] = {x_input, y_input};
  for (Expr e : samples(g, x, y)) {
    const Expr by_x = derivative(g, e, x_input), by_y = derivative(g, e, y_input);
    const auto reverse = gradient(g, e, both);
    for (const auto& [at_x, at_y] : {std::pair{0.9, 0.77}, {1.37, 2.1}, {2.25, 0.6}}) {
      CAPTURE(e, at_x, at_y);
      const auto value = [&](Expr what, double a, double b) { return g.evaluate(what, std::vector{a, b}); };
      const double dx = difference([&, b = at_y](double a) { return value(e, a, b); }, at_x);
      const double dy = difference([&, a = at_x](double b) { return value(e, a, b); }, at_y);
      CHECK(value(by_x, at_x, at_y) == Approx(dx).epsilon(1e-8).margin(1e-8));
      CHECK(value(by_y, at_x, at_y) == Approx(dy).epsilon(1e-8).margin(1e-8));
      CHECK(value(reverse[0], at_x, at_y) == Approx(value(by_x, at_x, at_y)).epsilon(1e-13).margin(1e-13));
      CHECK(value(reverse[1], at_x, at_y) == Approx(value(by_y, at_x, at_y)).epsilon(1e-13).margin(1e-13));
    }
  }
}

TEST_CASE("second derivatives agree with differences of the first") {
  Expressions g;
  const Expr x = g.input(x_input), y = g.input(y_input);
  for (Expr e : samples(g, x, y)) {
    const Expr first = derivative(g, e, x_input), second = derivative(g, first, x_input);
    for (double at : {0.9, 2.2}) {
      CAPTURE(e, at);
      const auto value = [&](Expr what, double a) { return g.evaluate(what, std::vector{a, 0.77}); };
      const double expected = difference([&](double a) { return value(first, a); }, at);
      CHECK(value(second, at) == Approx(expected).epsilon(1e-7).margin(1e-7));
    }
  }
}

TEST_CASE("what a choice leaves out does not disturb its derivative") {
  Expressions g;
  const Expr x = g.input(x_input);
  const Expr positive = g.apply(Function::less, g.constant(0.0), x);
  const Expr e = g.scale(g.select(positive, g.square_root(x), g.scale(x, 3.0)), 2.0);
  const Expr forward = derivative(g, e, x_input);
  const auto reverse = gradient(g, e, {&x_input, 1});
  for (double at : {0.0, -1.0}) {
    CHECK(g.evaluate(forward, {&at, 1}) == 6.0);
    CHECK(g.evaluate(reverse[0], {&at, 1}) == 6.0);
  }
  const double four = 4.0;
  CHECK(g.evaluate(forward, {&four, 1}) == 0.5);
  CHECK(g.evaluate(reverse[0], {&four, 1}) == 0.5);
}
