#include "laws/program.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/functions.hpp"
#include "base/random.hpp"
#include "laws/derivative.hpp"

using namespace pantin;

namespace {

const Input distance2{Role::distance2, 0, 0, {}};
Input parameter(std::string name) { return {Role::parameter, 0, 0, std::move(name)}; }
Input attribute(int who, std::string name) { return {Role::attribute, static_cast<std::uint8_t>(who), 0, name}; }

// Whole numbers, tiny and huge ones of all signs, what is none, and random ones.
std::vector<double> edge_values() {
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> values;
  for (double x : {0.0,     5e-324, 1e-310,   1e-300,      1e-9,  0.5,   1.0, 1.5, 2.0,  3.0,
                   3.14159, 30.0,   708.5,    709.7,       710.0, 746.0, 1e5, 1e9, 1e15, 4503599627370497.5,
                   1e17,    1e300,  infinity, std::nan("")}) {
    values.push_back(x);
    values.push_back(-x);
  }
  Random random{7, 0};
  for (int i = 0; i < 100; i++) values.push_back(random.uniform() * 2.0 - 1.0);
  for (int i = 0; i < 100; i++) values.push_back((random.uniform() - 0.5) * 100.0);
  for (int i = 0; i < 100; i++) values.push_back(std::bit_cast<double>(random.bits()));
  return values;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

// The values of an expression of a.x and a.y over columns.
std::vector<double> run(const Expressions& g, Expr e, const std::vector<double>& x, const std::vector<double>& y) {
  Machine machine(lower(g, {&e, 1}));
  machine.run_uniform();
  std::vector<double> result;
  for (std::size_t start = 0; start < x.size(); start += Machine::block) {
    const std::size_t n = std::min<std::size_t>(Machine::block, x.size() - start);
    for (const auto& [input, values] : {std::pair{attribute(0, "x"), &x}, {attribute(0, "y"), &y}}) {
      const int i = machine.input(input);
      if (i >= 0) std::copy_n(values->begin() + static_cast<std::ptrdiff_t>(start), n, machine.column(i));
    }
    machine.run(static_cast<int>(n));
    result.insert(result.end(), machine.output(0), machine.output(0) + n);
  }
  return result;
}

double value_at(const Expressions& g, Expr e, const std::function<double(const Input&)>& of) {
  std::vector<double> values;
  for (const Input& input : g.inputs()) values.push_back(of(input));
  return g.evaluate(e, values);
}

Expr lennard_jones(Expressions& g, Expr epsilon, Expr sigma) {
  const Expr s = g.divide(sigma, g.square_root(g.input(distance2)));
  return g.scale(g.multiply(epsilon, g.subtract(g.power(s, 12.0), g.power(s, 6.0))), 4.0);
}

}  // namespace

TEST_CASE("functions of a block have the bits of the scalar ones") {
  Expressions g;
  const Expr x = g.input(attribute(0, "x"));
  const std::pair<Function, double (*)(double)> all[] = {
      {Function::exp, functions::exp},   {Function::log, functions::log},   {Function::sin, functions::sin},
      {Function::cos, functions::cos},   {Function::tan, functions::tan},   {Function::asin, functions::asin},
      {Function::acos, functions::acos}, {Function::atan, functions::atan}, {Function::sinh, functions::sinh},
      {Function::cosh, functions::cosh}, {Function::tanh, functions::tanh}, {Function::floor, std::floor},
      {Function::abs, std::fabs}};
  const auto values = edge_values();
  for (const auto& [function, scalar] : all) {
    const auto result = run(g, g.apply(function, x), values, values);
    for (std::size_t i = 0; i < values.size(); i++) {
      CAPTURE(static_cast<int>(function), values[i], result[i], scalar(values[i]));
      CHECK(same_bits(result[i], scalar(values[i])));
    }
  }
  const auto roots = run(g, g.square_root(x), values, values), inverses = run(g, g.power(x, -1.0), values, values);
  for (std::size_t i = 0; i < values.size(); i++) {
    CHECK(same_bits(roots[i], std::sqrt(values[i])));
    CHECK(same_bits(inverses[i], 1.0 / values[i]));
  }
}

TEST_CASE("functions of two values have the bits of the scalar ones") {
  Expressions g;
  const Expr x = g.input(attribute(0, "x")), y = g.input(attribute(0, "y"));
  std::vector<double> xs, ys;
  for (double a : edge_values()) {
    for (double b :
         {0.0, -0.0, 0.5, 1.0, -2.0, 3.0, 7.25, -1e10, std::numeric_limits<double>::infinity(), std::nan("")}) {
      xs.push_back(a);
      ys.push_back(b);
    }
  }
  const std::pair<Function, double (*)(double, double)> all[] = {
      {Function::atan2, functions::atan2},
      {Function::power, functions::pow},
      {Function::minimum, [](double a, double b) { return b < a ? b : a; }},
      {Function::maximum, [](double a, double b) { return a < b ? b : a; }},
      {Function::less, [](double a, double b) { return a < b ? 1.0 : 0.0; }},
      {Function::less_or_equal, [](double a, double b) { return a <= b ? 1.0 : 0.0; }}};
  for (const auto& [function, scalar] : all) {
    const auto result = run(g, g.apply(function, x, y), xs, ys);
    for (std::size_t i = 0; i < xs.size(); i++) {
      CAPTURE(static_cast<int>(function), xs[i], ys[i], result[i], scalar(xs[i], ys[i]));
      CHECK(same_bits(result[i], scalar(xs[i], ys[i])));
    }
  }
}

TEST_CASE("the force of Lennard-Jones is six operations") {
  Expressions g;
  const Expr potential = lennard_jones(g, g.constant(1.0), g.constant(1.0));
  const Expr tension = g.scale(derivative(g, potential, distance2), 2.0);
  CHECK(lower(g, {&tension, 1}).operations() == 6);
}

TEST_CASE("parameters are worked with once, not for each pair") {
  Expressions g;
  const Expr potential = lennard_jones(g, g.input(parameter("epsilon")), g.input(parameter("sigma")));
  const Expr tension = g.scale(derivative(g, potential, distance2), 2.0);
  const Program program = lower(g, {&tension, 1});
  CHECK(program.operations() == 6);
  CHECK(lower(g, {&tension, 1}, {.parameters = false}).uniform.empty());

  Machine machine(program);
  machine.fill(machine.input(parameter("epsilon")), 1.3);
  machine.fill(machine.input(parameter("sigma")), 0.9);
  machine.run_uniform();
  const std::vector<double> r2(16, 1.44);
  machine.bind(machine.input(distance2), r2.data());
  machine.run(1);
  const double s6 = std::pow(0.9 / 1.2, 6);
  CHECK(machine.output(0)[0] == Approx(-24.0 * 1.3 * (2.0 * s6 * s6 - s6) / 1.44).epsilon(1e-14));
}

TEST_CASE("a program gives what its expressions give") {
  Expressions g;
  const Expr r2 = g.input(distance2), r = g.square_root(r2), x = g.input(attribute(0, "x")),
             y = g.input(attribute(1, "x")), k = g.input(parameter("k")), t = g.input({Role::time, 0, 0, {}});
  const auto f = [&](Function function, Expr a, Expr b = no_expression) { return g.apply(function, a, b); };
  const double knots[] = {0.0, 0.5, 1.0, 2.0, 9.0}, values[] = {1.0, 0.2, -0.4, 0.3, 0.5};
  const std::vector<Expr> cases = {
      r2,
      k,
      g.constant(2.5),
      g.constant(-0.0),
      g.multiply(k, t),
      g.subtract(x, y),
      g.subtract(g.constant(1.0), x),
      g.add(g.add(g.multiply(x, y), g.multiply(x, k)), g.add(g.power(x, 3.0), g.multiply(t, k))),
      g.divide(g.multiply(k, g.subtract(r, g.constant(1.0))), r),
      g.multiply(g.multiply(x, y), g.divide(f(Function::exp, g.scale(r, -1.25)), r)),
      g.power(f(Function::maximum, g.subtract(g.add(x, y), r), g.constant(0.0)), 2.5),
      g.select(f(Function::less, r, k), g.power(r, -6.0), g.power(x, 0.3)),
      g.add(f(Function::sin, g.multiply(r, t)), f(Function::cos, g.multiply(r, t))),
      g.spline(std::make_shared<Spline>(knots, values), r),
      g.square_root(g.multiply(x, y)),
      g.divide(g.power(g.add(x, y), 100.0), g.power(g.add(x, k), 7.0)),
      g.add(g.power(r, -1.0), g.add(g.power(r, 3.0), g.power(r, -1.5))),
      f(Function::power, x, y),
      g.multiply(k, g.add(g.divide(x, k), g.add(g.divide(y, g.power(k, 2.0)), g.power(k, -1.0)))),
      g.scale(g.multiply(k, g.add(g.multiply(x, t), g.constant(3.0))), -2.0),
      g.scale(g.multiply(y, g.add(x, g.constant(3.0))), -2.0),
      derivative(g, lennard_jones(g, x, y), distance2),
      gradient(g, lennard_jones(g, x, g.add(y, k)), {&distance2, 1})[0]};
  Random random{3, 0};
  const Program together = lower(g, cases);
  Machine machine(together);
  const std::size_t inputs = together.inputs.size();
  std::vector<std::vector<double>> columns(inputs, std::vector<double>(37));
  for (std::size_t i = 0; i < inputs; i++) {
    const Role role = together.inputs[i].role;
    for (double& v : columns[i]) v = role == Role::time ? 0.7 : role == Role::parameter ? 1.1 : 0.5 + random.uniform();
    std::copy(columns[i].begin(), columns[i].end(), machine.column(static_cast<int>(i)));
    if (role == Role::time || role == Role::parameter) machine.fill(static_cast<int>(i), columns[i][0]);
  }
  machine.run_uniform();
  for (int round = 0; round < 2; round++) machine.run(37);
  for (std::size_t c = 0; c < cases.size(); c++) {
    for (std::size_t k_row = 0; k_row < 37; k_row++) {
      const double expected = value_at(g, cases[c], [&](const Input& input) {
        const auto i = static_cast<std::size_t>(machine.input(input));
        return columns[i][k_row];
      });
      CAPTURE(c, k_row);
      CHECK(machine.output(static_cast<int>(c))[k_row] == Approx(expected).epsilon(1e-12).margin(1e-13));
    }
  }
}

TEST_CASE("inputs that do not matter are not asked for") {
  Expressions g;
  const Expr x = g.input(attribute(0, "x")), y = g.input(attribute(1, "x"));
  const Expr e = g.subtract(g.add(x, y), y);
  const Program program = lower(g, {&e, 1});
  CHECK(program.inputs == std::vector{attribute(0, "x")});
  CHECK(program.operations() == 0);
  CHECK(Machine(program).input(attribute(1, "x")) == -1);
}

TEST_CASE("slots are used again") {
  Expressions g;
  Expr e = g.input(attribute(0, "x"));
  for (int i = 0; i < 50; i++) e = g.apply(Function::sin, g.add(e, g.constant(1.0)));
  const Program program = lower(g, {&e, 1});
  CHECK(program.operations() == 100);
  CHECK(program.slots <= 3);
}
