#include "laws/library.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "support/library_laws.hpp"

using namespace pantin;
using namespace pantin::testing;
using Catch::Contains;

TEST_CASE("library laws have names, units and sources") {
  std::set<std::string> names;
  for (const LibraryLaw& law : library()) {
    CAPTURE(law.name);
    CHECK(names.insert(law.name).second);
    CHECK(std::string(law.doc).size() > 10);
    CHECK(std::string(law.source).size() > 5);
    for (const LibraryParameter& parameter : law.parameters) {
      CHECK(std::string(parameter.unit) != "");
      CHECK(std::string(parameter.doc) != "");
    }
    CHECK(find_library_law(law.name) == &law);
  }
  for (const char* name : {"spring",     "damper", "gravitation", "coulomb", "lennard_jones", "wca",  "morse",
                           "buckingham", "yukawa", "hydrophobic", "repel",   "drag",          "wind", "vortex",
                           "buoyancy",   "angle",  "torsion",     "table",   "thermostat",    "wall", "flock"}) {
    CHECK(names.contains(name));
  }
  CHECK(names.size() == 21);
}

namespace {

void check_program(const Law& law, Uniform uniform) {
  std::vector<Expr> outputs = law.force;
  for (Expr e : {law.energy, law.stiffness}) {
    if (e != no_expression) outputs.push_back(e);
  }
  const Program program = lower(law.graph, outputs, uniform);
  std::vector<LawState> states;
  for (std::uint64_t seed = 1; seed <= 40; seed++) {
    states.push_back(some_particles(static_cast<std::size_t>(law.count), 1.0, seed));
    states.back().parameters = {{"boltzmann", 0.01}, {"step", 0.005}};
  }
  Machine machine(program);
  for (const Input& input : program.inputs) {
    const int i = machine.input(input);
    machine.fill(i, value_of(law, states[0], input));
    for (std::size_t k = 0; k < states.size(); k++) machine.column(i)[k] = value_of(law, states[k], input);
  }
  machine.run_uniform();
  machine.run(static_cast<int>(states.size()));
  for (std::size_t o = 0; o < outputs.size(); o++) {
    for (std::size_t k = 0; k < states.size(); k++) {
      const double expected = value_of(law, states[k], outputs[o]);
      CAPTURE(law.name, o, k);
      CHECK(machine.output(static_cast<int>(o))[k] == Approx(expected).epsilon(1e-10).margin(1e-10));
    }
  }
}

}  // namespace

TEST_CASE("programs of library laws give what their expressions give") {
  const auto laws = one_of_each();
  CHECK(laws.size() == library().size());
  for (const auto& parts : laws) {
    for (const Law& law : parts) {
      check_program(law, {.parameters = true});
      check_program(law, {.parameters = false});
    }
  }
}

TEST_CASE("parameters of library laws that are missing, unknown or out of range are refused") {
  CHECK_THROWS_WITH(make("sprung"), Contains("there is no law \"sprung\""));
  CHECK_THROWS_WITH(make("spring"), Contains("spring: stiffness [N/m] is missing"));
  CHECK_THROWS_WITH(make("spring", {{"stiffness", -1.0}}), Contains("spring: stiffness must be >= 0 N/m, got -1"));
  CHECK_THROWS_WITH(make("spring", {{"stiffness", std::nan("")}}), Contains("got NaN"));
  CHECK_THROWS_WITH(make("spring", {{"stifness", 1.0}}),
                    Contains("no parameter \"stifness\"; it has stiffness [N/m], length [m], damping [N s/m]"));
  CHECK_THROWS_WITH(make("lennard_jones", {{"epsilon", 1.0}, {"sigma", 0.0}}), Contains("sigma must be > 0 m, got 0"));
  CHECK_THROWS_WITH(make("torsion", {{"stiffness", 1.0}, {"fold", 1.5}}),
                    Contains("fold must be a whole number >= 1, got"));
  CHECK_THROWS_WITH(make("hydrophobic", {{"strength", 1.0}, {"size", 1.0}, {"attraction", 2.0}}),
                    Contains("from -1 to 1"));
  CHECK_THROWS_WITH(make("wall", {{"stiffness", 1.0}}), Contains("wall: normal, a vec, is missing"));
  CHECK_THROWS_WITH(make("wall", {{"stiffness", 1.0}}, {{"normal", zero3()}}),
                    Contains("normal must be a finite vec, not 0"));
  CHECK_THROWS_WITH(make("wind", {{"velocity", 1.0}}), Contains("velocity [m/s] must be a vec"));
  LawArguments cut;
  cut.numbers = {{"linear", 1.0}};
  cut.cutoff = 1.0;
  CHECK_THROWS_WITH(make_library_law("drag", cut), Contains("only laws of pairs have a cutoff"));
}
