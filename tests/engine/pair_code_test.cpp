// Pairs give the same bits in one pass, as code of the processor, and by blocks.
#include "laws/run/pair_code.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "laws/run/pairs.hpp"
#include "support/library_laws.hpp"
#include "support/sites.hpp"

using namespace pantin;

namespace {

using LawPtr = std::shared_ptr<const Law>;

constexpr double cutoff = 2.0;

/// A potential of the distance, attributes of both, two parameters and time.
LawPtr random_law(Random& random, bool touching) {
  Expressions g;
  std::vector<Expr> known = {g.input({Role::distance2, 0, 0, {}}), g.input({Role::time, 0, 0, {}})};
  for (const std::uint8_t who : {std::uint8_t{0}, std::uint8_t{1}})
    for (const char* name : {"charge", "radius"}) known.push_back(g.input({Role::attribute, who, 0, name}));
  for (const char* name : {"k", "l"}) known.push_back(g.input({Role::parameter, 0, 0, name}));
  const auto any = [&] {
    return known[static_cast<std::size_t>(random.uniform() * static_cast<double>(known.size()))];
  };
  const int nodes = 3 + static_cast<int>(random.uniform() * 25.0);
  for (int i = 0; i < nodes; i++) {
    const double which = random.uniform() * 7.0;
    known.push_back(which < 1.0   ? g.add(any(), any())
                    : which < 3.0 ? g.multiply(any(), any())
                    : which < 4.0 ? g.divide(any(), any())
                    : which < 5.0 ? g.power(any(), which < 4.5 ? 0.5 : -1.5)
                    : which < 6.0 ? g.apply(Function::maximum, any(), any())
                                  : g.add(any(), g.constant(random.uniform())));
  }
  LawDef def;
  def.name = "random";
  def.cutoff = cutoff;
  def.touching = touching;
  def.parameters = {{"k", 1.3, ""}, {"l", 0.4, ""}};
  const Expr potential = g.multiply(known.back(), g.power(known[0], 0.5 * (random.uniform() < 0.5 ? -3.0 : 1.0)));
  return std::make_shared<Law>(central_potential(def, g, g.add(potential, g.scale(known[known.size() - 2], 0.1))));
}

struct Ran {
  AlignedVector<Vec3> force, nonconservative_force, with_energy;
  double energy = 0.0;
};

Ran run(const LawPtr& law, Sites sites, const Box& box, double within, bool as_code, int threads) {
  allow_machine_code(as_code);
  Workers workers(threads);
  Pairs pairs(law, sites.names, workers);
  allow_machine_code(true);
  const std::vector<std::uint32_t> zero = {0};
  pairs.neighbours.build(sites, box, zero, zero, within, within < infinity ? 0.3 : 0.0, workers);
  std::vector<double> parameters;
  for (const Parameter& p : law->parameters) parameters.push_back(p.value);
  Ran ran;
  pairs.add_forces(sites, box, {0.5, 7, 3}, parameters, workers);
  ran.force = sites.force;
  ran.nonconservative_force = sites.nonconservative_force;
  sites.clear_forces();
  ran.energy = pairs.add_forces_and_energy(sites, box, {0.5, 7, 3}, parameters, workers);
  ran.with_energy = sites.force;
  return ran;
}

/// Numbers that are none may differ in sign.
bool same_bits(const AlignedVector<Vec3>& a, const AlignedVector<Vec3>& b, std::size_t n) {
  for (std::size_t i = 0; i < n; i++)
    for (int k = 0; k < 4; k++) {
      if (std::isnan(a[i][k]) && std::isnan(b[i][k])) continue;
      if (std::bit_cast<std::uint64_t>(a[i][k]) != std::bit_cast<std::uint64_t>(b[i][k])) return false;
    }
  return true;
}

void check_same(const LawPtr& law, const Sites& sites, const Box& box, double within, int threads) {
  const Ran code = run(law, sites, box, within, true, threads), blocks = run(law, sites, box, within, false, 1);
  CHECK(same_bits(code.force, blocks.force, sites.n));
  CHECK(same_bits(code.nonconservative_force, blocks.nonconservative_force, sites.n));
  CHECK(same_bits(code.with_energy, blocks.with_energy, sites.n));
  CHECK((code.energy == blocks.energy || (std::isnan(code.energy) && std::isnan(blocks.energy))));
}

Box cube(double edge) { return {vec(edge, edge, edge)}; }

}  // namespace

TEST_CASE("pair code: random laws of distance and attributes have the bits of blocks") {
  const Sites sites = cases::random_sites({.count = 600, .edge = 8.0});
  Random random{17};
  for (int round = 0; round < 120; round++) {
    CAPTURE(round);
    const LawPtr law = random_law(random, round % 3 == 0);
    check_same(law, sites, round % 2 == 0 ? cube(8.0) : Box{}, round % 5 == 0 && round % 2 == 1 ? infinity : cutoff,
               1 + round % 2);
  }
}

TEST_CASE("pair code: laws of the library have the bits of blocks") {
  const Sites sites = cases::random_sites({.count = 2000, .edge = 12.0, .speed = 1.0});
  for (const auto& parts : testing::one_of_each())
    for (const Law& law : parts) {
      if (law.kind != LawKind::central && law.kind != LawKind::pair) continue;
      const std::vector<std::string>& has = sites.names;
      const bool can = std::all_of(law.graph.inputs().begin(), law.graph.inputs().end(), [&](const Input& input) {
        return input.role != Role::attribute || std::find(has.begin(), has.end(), input.name) != has.end();
      });
      if (!can) continue;
      CAPTURE(law.name);
      check_same(std::make_shared<Law>(law), sites, cube(12.0), cutoff, 2);
    }
}

TEST_CASE("pair code: which laws run in one pass") {
  const auto program = [](const Law& law) { return lower(law.graph, law.force); };
  const auto in_one_pass = [&](const Law& law) { return PairCode::of(law, program(law)) != nullptr; };
  const Law jones = testing::make("lennard_jones", {{"epsilon", 1.3}, {"sigma", 0.9}})[0];
  Law one_sided = jones;
  one_sided.one_sided = true;
  if (!MachineCode::of(program(jones))) return;
  CHECK(in_one_pass(jones));
  CHECK(in_one_pass(testing::make("coulomb", {{"constant", 2.0}})[0]));
  CHECK(!in_one_pass(one_sided));
  CHECK(!in_one_pass(testing::make("damper", {{"damping", 2.0}})[0]));
  CHECK(!in_one_pass(testing::make("yukawa", {{"strength", 2.0}, {"screening", 0.8}})[0]));
}
