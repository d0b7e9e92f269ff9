// Laws as tables that LAMMPS reads.
#include "player/lammps/law_table.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "base/check.hpp"
#include "laws/library.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

player::LawOfDistance of_distance(const Law& law) {
  std::vector<double> values;
  for (const Parameter& p : law.parameters) values.push_back(p.value);
  return {law.name, law, values, [](int, const std::string&) { return 1.0; }};
}

player::LawOfDistance of_library(const std::string& name, std::map<std::string, double> numbers,
                                 std::optional<double> cutoff = {}) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  arguments.cutoff = cutoff;
  return of_distance(make_library_law(name, arguments)[0]);
}

player::TableWish of_pairs(std::vector<double> distances, double to, double error = 1e-6) {
  player::TableWish wish;
  wish.distances = std::move(distances);
  wish.to = to;
  wish.error = error;
  return wish;
}

/// The largest error of straight lines at thirds between the points.
double missed_by_lines(player::LawOfDistance& law, const player::LawTable& t) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < t.r.size(); i++)
    for (const double part : {1.0 / 3.0, 2.0 / 3.0}) {
      const auto mixed = [&](double a, double b) { return a + part * (b - a); };
      const double r = std::sqrt(mixed(t.r[i] * t.r[i], t.r[i + 1] * t.r[i + 1]));
      const player::LawOfDistance::Value v = law.at(std::span(&r, 1))[0];
      const double force = mixed(t.force[i] / t.r[i], t.force[i + 1] / t.r[i + 1]) * r;
      most = std::max(most, std::abs(mixed(t.energy[i], t.energy[i + 1]) - v.energy) /
                                std::max(std::abs(v.energy), t.usual_energy));
      most = std::max(most, std::abs(force - v.force) / std::max(std::abs(v.force), t.usual_force));
    }
  return most;
}

}  // namespace

TEST_CASE("law table: a smooth law takes splines, and a wish of half the error some points more") {
  auto law = of_library("lennard_jones", {{"epsilon", 1.0}, {"sigma", 1.0}});
  const player::LawTable rough = make_table(law, of_pairs({1.1, 1.2}, 2.5, 1e-4)),
                         fine = make_table(law, of_pairs({1.1, 1.2}, 2.5, 1e-8));
  CHECK(rough.spline);
  CHECK(rough.error <= 1e-4);
  CHECK(fine.error <= 1e-8);
  CHECK(rough.r.size() <= 1024);
  CHECK(fine.r.size() <= 16384);
  CHECK(fine.to() == 2.5);
  CHECK(fine.energy.back() == Approx(0.0).margin(1e-10));  // shifted
  const double s6 = std::pow(2.5, -6.0);
  CHECK(fine.force.back() == Approx(24.0 / 2.5 * (2.0 * s6 * s6 - s6)).epsilon(1e-9));  // not shifted
  CHECK(std::ranges::is_sorted(fine.r));
}

TEST_CASE("law table: it begins where nothing in the scene gives the energy to come") {
  auto law = of_library("lennard_jones", {{"epsilon", 1.0}, {"sigma", 1.0}});
  const player::LawTable t = make_table(law, of_pairs({1.1}, 2.5));
  CHECK(t.energy.front() > 500.0 * t.usual_energy);
  CHECK(t.from() < 0.7);
}

TEST_CASE("law table: a law that bends sharply has a point there, and straight lines follow it to the error") {
  auto law = of_library("hydrophobic", {{"strength", 1.0}, {"size", 1.0}});
  const double kink = 1.122462048309373, to = kink + 1.6;
  const player::LawTable t = make_table(law, of_pairs({0.95, 1.0, 1.2}, to));
  CHECK_FALSE(t.spline);
  const auto at = std::ranges::min_element(t.r, {}, [&](double r) { return std::abs(r - kink); });
  CHECK(*at == Approx(kink).epsilon(1e-13));
  CHECK(t.error <= 1e-6);
  CHECK(missed_by_lines(law, t) <= 1e-6);
}

TEST_CASE("law table: what ends at its cutoff with a bend is smooth up to there") {
  auto law = of_library("wca", {{"epsilon", 1.0}, {"sigma", 0.95}});
  const player::LawTable t = make_table(law, of_pairs({0.9, 1.0}, 1.122462048309373 * 0.95));
  CHECK(t.spline);
  CHECK(t.r.size() <= 1024);
}

TEST_CASE("law table: a bond reaches from far less to far more than it is long") {
  auto law = of_library("spring", {{"stiffness", 60.0}, {"length", 0.2}});
  player::TableWish wish;
  wish.over = player::TableOver::distance;
  wish.distances = {0.19, 0.2, 0.21};
  const player::LawTable t = make_table(law, wish);
  CHECK(t.spline);
  CHECK(t.r.size() == 256);
  CHECK(t.error < 1e-10);
  CHECK(t.from() < 0.1);
  CHECK(t.to() > 0.4);
  CHECK(t.stiffness == Approx(60.0));
}

TEST_CASE("law table: a jump is refused, with the law's name") {
  Expressions g;
  const Expr q = g.input({Role::distance2, 0, 0, {}});
  const Expr jump = g.select(g.apply(Function::less, q, g.constant(2.0)), g.constant(1.0), g.scale(q, 0.75));
  LawDef def;
  def.name = "scene.lua:3";
  def.cutoff = 2.0;
  auto law = of_distance(central_tension(def, g, jump));
  CHECK_THROWS_WITH(make_table(law, of_pairs({1.0, 1.5}, 2.0)),
                    Contains("scene.lua:3: no table") && Contains("1e-06") && Contains("--error"));
}

TEST_CASE("law table: a law that is no function of distance alone is refused") {
  LawArguments arguments;
  arguments.numbers = {{"damping", 1.0}};
  const Law damper = make_library_law("damper", arguments)[0];
  CHECK_THROWS_WITH(of_distance(damper), Contains("damper: it is no function of distance alone"));
}
