#include "laws/library.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "base/random.hpp"
#include "support/law_state.hpp"

using namespace pantin;
using namespace pantin::testing;
using Catch::Contains;

namespace {

using Numbers = std::map<std::string, double>;

std::vector<Law> make(const std::string& name, Numbers numbers = {}, std::map<std::string, Vec3> vectors = {}) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  arguments.vectors = std::move(vectors);
  return make_library_law(name, arguments);
}

// Particles somewhere near each other, moving; with every attribute that a law may want.
LawState some_particles(std::size_t count, double size, std::uint64_t seed) {
  Random random{seed, 0};
  const auto vector = [&](double scale) {
    return vec(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * scale;
  };
  LawState state;
  for (std::size_t i = 0; i < count; i++) {
    state.x.push_back(vector(2.0 * size));
    state.v.push_back(vector(3.0));
    const double k = static_cast<double>(i);
    state.attributes.push_back({{"mass", 1.5 + k}, {"charge", 0.7 - 2.0 * k}, {"radius", size * (0.6 + 0.2 * k)}});
  }
  state.noise = vec(0.3, -1.1, 0.8);
  return state;
}

// Two particles at a distance of r, the second going away at 0.4 m/s and sideways.
LawState pair_at(double r) {
  LawState state = some_particles(2, 1.0, 1);
  const Vec3 along = vec(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0), across = vec(1.0, 2.0, 0.0);
  state.x[1] = state.x[0] + along * r;
  state.v[1] = state.v[0] + along * 0.4 + across;
  return state;
}

double energy_at(const Law& law, double r) { return energy_of(law, pair_at(r)); }
double tension_at(const Law& law, double r) { return tension_of(law, pair_at(r)); }

// Forces are against the slope of the energy to 1e-8 of the largest, their power is its rate.
void check_conservative(const Law& law, const LawState& state) {
  REQUIRE(law.has_energy());
  const auto forces = forces_of(law, state);
  double largest_force = 1e-3;
  for (const Vec3& f : forces) largest_force = std::fmax(largest_force, largest(f));
  double power = 0.0;
  for (std::size_t i = 0; i < state.x.size(); i++) {
    for (int k = 0; k < 3; k++) {
      const double slope = difference(
          [&](double h) {
            LawState moved = state;
            moved.x[i][k] += h;
            return energy_of(law, moved);
          },
          1e-4);
      CHECK(std::fabs(forces[i][k] + slope) <= 1e-8 * largest_force);
    }
    power += dot(forces[i], state.v[i]);
  }
  const double rate = difference(
      [&](double h) {
        LawState moved = state;
        for (std::size_t i = 0; i < state.x.size(); i++) moved.x[i] += state.v[i] * h;
        return energy_of(law, moved);
      },
      1e-4);
  CHECK(std::fabs(power + rate) <= 3e-8 * largest_force);
}

// No net force, no net torque.
void check_opposite(const std::vector<Law>& laws, const LawState& state) {
  Vec3 force = zero3(), torque = zero3();
  double largest_force = 0.0;
  const auto forces = forces_of(laws, state);
  for (std::size_t i = 0; i < forces.size(); i++) {
    force += forces[i];
    torque += cross(state.x[i], forces[i]);
    largest_force = std::fmax(largest_force, largest(forces[i]));
  }
  CHECK(largest(force) <= 1e-13 * largest_force);
  CHECK(largest(torque) <= 1e-12 * largest_force);
}

// The stiffness is the slope of the tension.
void check_stiffness(const Law& law, double r) {
  const double slope = difference([&](double h) { return tension_at(law, r + h); }, 1e-4);
  const double stiffness = value_of(law, pair_at(r), law.stiffness);
  CHECK(stiffness == Approx(slope).epsilon(1e-8).margin(1e-8));
}

void check_central(const std::vector<Law>& laws, std::initializer_list<double> distances) {
  for (double r : distances) {
    CAPTURE(laws[0].name, r);
    check_conservative(laws[0], pair_at(r));
    check_stiffness(laws[0], r);
    check_opposite(laws, pair_at(r));
  }
}

LawArguments table_arguments(std::vector<double> distances, std::vector<double> potentials,
                             std::vector<double> tensions) {
  LawArguments arguments;
  arguments.distances = std::move(distances);
  arguments.potentials = std::move(potentials);
  arguments.tensions = std::move(tensions);
  return arguments;
}

}  // namespace

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

TEST_CASE("library: spring and damper") {
  const auto spring = make("spring", {{"stiffness", 40.0}, {"length", 1.2}});
  REQUIRE(spring.size() == 1);
  CHECK(energy_at(spring[0], 1.5) == Approx(0.5 * 40.0 * 0.09));
  CHECK(tension_at(spring[0], 1.5) == Approx(12.0));
  CHECK(value_of(spring[0], pair_at(0.8), spring[0].stiffness) == Approx(40.0));
  check_central(spring, {0.4, 1.2, 3.0});

  const auto damped = make("spring", {{"stiffness", 40.0}, {"damping", 3.0}});
  REQUIRE(damped.size() == 2);
  CHECK(damped[0].parameters[1].present);
  CHECK(std::isnan(damped[0].parameters[1].value));
  CHECK(tension_at(damped[1], 1.5) == Approx(3.0 * 0.4));
  CHECK_FALSE(damped[1].has_energy());
  check_opposite({damped[1]}, pair_at(1.5));

  const auto damper = make("damper", {{"damping", 2.0}});
  CHECK(tension_at(damper[0], 0.7) == Approx(0.8));
  CHECK(damper[0].moving);
}

TEST_CASE("library: gravitation and coulomb") {
  const auto newton = make("gravitation");
  CHECK(energy_at(newton[0], 2.0) == Approx(-6.6743e-11 * 1.5 * 2.5 / 2.0));
  CHECK(tension_at(newton[0], 2.0) == Approx(6.6743e-11 * 1.5 * 2.5 / 4.0));
  const auto soft = make("gravitation", {{"constant", 2.0}, {"softening", 0.5}});
  CHECK(tension_at(soft[0], 2.0) == Approx(2.0 * 1.5 * 2.5 * 2.0 / std::pow(4.25, 1.5)));
  check_central(soft, {0.1, 1.0, 4.0});

  const auto coulomb = make("coulomb", {{"constant", 3.0}});
  CHECK(energy_at(coulomb[0], 2.0) == Approx(3.0 * 0.7 * -1.3 / 2.0));
  CHECK(tension_at(coulomb[0], 2.0) == Approx(3.0 * 0.7 * 1.3 / 4.0));
  check_central(coulomb, {0.3, 1.0, 4.0});
  CHECK(make("coulomb")[0].parameters[0].value == 8.9875517873681764e9);
}

TEST_CASE("library: lennard_jones and wca") {
  const auto lj = make("lennard_jones", {{"epsilon", 1.3}, {"sigma", 0.9}});
  const auto v = [](double r) { return 4.0 * 1.3 * (std::pow(0.9 / r, 12) - std::pow(0.9 / r, 6)); };
  CHECK(lj[0].cutoff == Approx(2.25));
  CHECK(energy_at(lj[0], 1.1) == Approx(v(1.1) - v(2.25)));
  CHECK(energy_at(lj[0], 2.25) == Approx(0.0).margin(1e-15));
  CHECK(tension_at(lj[0], 1.1) == Approx(-24.0 * 1.3 / 1.1 * (2.0 * std::pow(0.9 / 1.1, 12) - std::pow(0.9 / 1.1, 6))));
  check_central(lj, {0.8, 1.0, 2.0});
  LawArguments unshifted;
  unshifted.numbers = {{"epsilon", 1.3}, {"sigma", 0.9}};
  unshifted.shift = false;
  unshifted.cutoff = 3.0;
  const auto plain = make_library_law("lennard_jones", unshifted);
  CHECK(plain[0].cutoff == 3.0);
  CHECK(energy_at(plain[0], 1.1) == Approx(v(1.1)));

  const auto wca = make("wca", {{"epsilon", 1.3}, {"sigma", 0.9}});
  const double end = 0.9 * std::pow(2.0, 1.0 / 6.0);
  CHECK(wca[0].cutoff == Approx(end));
  CHECK(energy_at(wca[0], 0.95) == Approx(v(0.95) + 1.3));
  CHECK(energy_at(wca[0], end - 1e-9) == Approx(0.0).margin(1e-12));
  CHECK(tension_at(wca[0], end + 0.01) == 0.0);
  check_central(wca, {0.8, 0.95});
}

TEST_CASE("library: morse, buckingham and yukawa") {
  const auto morse = make("morse", {{"depth", 3.0}, {"steepness", 2.0}, {"length", 1.1}});
  CHECK(energy_at(morse[0], 1.1) == Approx(-3.0));
  const double e = std::exp(-2.0 * 0.4);
  CHECK(energy_at(morse[0], 1.5) == Approx(3.0 * (1.0 - e) * (1.0 - e) - 3.0));
  CHECK(tension_at(morse[0], 1.5) == Approx(2.0 * 3.0 * 2.0 * (1.0 - e) * e));
  check_central(morse, {0.7, 1.1, 2.0});

  const auto buckingham = make("buckingham", {{"repulsion", 50.0}, {"steepness", 3.0}, {"attraction", 2.0}});
  CHECK(energy_at(buckingham[0], 1.4) == Approx(50.0 * std::exp(-4.2) - 2.0 / std::pow(1.4, 6)));
  CHECK(tension_at(buckingham[0], 1.4) == Approx(-150.0 * std::exp(-4.2) + 12.0 / std::pow(1.4, 7)));
  check_central(buckingham, {0.9, 1.4, 3.0});

  const auto yukawa = make("yukawa", {{"strength", 2.0}, {"screening", 0.8}});
  CHECK(energy_at(yukawa[0], 1.6) == Approx(2.0 * std::exp(-2.0) / 1.6));
  CHECK(tension_at(yukawa[0], 1.6) == Approx(-2.0 * std::exp(-2.0) / 1.6 * (1.0 / 1.6 + 1.0 / 0.8)));
  check_central(yukawa, {0.3, 1.0, 3.0});
}

TEST_CASE("library: hydrophobic") {
  const auto tails = make("hydrophobic", {{"strength", 1.5}, {"size", 0.9}});
  const double end = 0.9 * std::pow(2.0, 1.0 / 6.0), range = 1.6 * 0.9;
  CHECK(tails[0].cutoff == Approx(end + range));
  CHECK(energy_at(tails[0], end) == Approx(-1.5));
  const double half = end + 0.5 * range;
  CHECK(energy_at(tails[0], half) == Approx(-1.5 * std::pow(std::cos(std::acos(-1.0) / 4.0), 2)));
  CHECK(tension_at(tails[0], half) == Approx(1.5 * 0.5 * std::acos(-1.0) / range));
  CHECK(energy_at(tails[0], end + range + 0.1) == Approx(0.0).margin(1e-15));
  CHECK(energy_at(tails[0], 0.8) == Approx(6.0 * (std::pow(0.9 / 0.8, 12) - std::pow(0.9 / 0.8, 6)) + 1.5 - 1.5));
  check_central(tails, {0.8, 0.95, 1.3, half, 2.3});

  const auto others = make("hydrophobic", {{"strength", 1.5}, {"size", 0.9}, {"range", 0.7}, {"attraction", -0.5}});
  CHECK(energy_at(others[0], end) == Approx(0.75));
  CHECK(tension_at(others[0], end + 0.3) < 0.0);
  check_central(others, {0.8, 1.3});
}

TEST_CASE("library: repel") {
  const auto repel = make("repel", {{"stiffness", 20.0}});  // radii 0.6 and 0.8 m
  CHECK(repel[0].touching);
  CHECK(tension_at(repel[0], 1.3) == Approx(-20.0 * std::pow(0.1, 1.5)));
  CHECK(energy_at(repel[0], 1.3) == Approx(0.4 * 20.0 * std::pow(0.1, 2.5)));
  CHECK(tension_at(repel[0], 1.5) == 0.0);
  CHECK(value_of(repel[0], pair_at(1.5), repel[0].stiffness) == 0.0);
  check_central(repel, {0.5, 1.3, 1.6});
}

TEST_CASE("library: table") {
  std::vector<double> r, v, t;
  for (double x = 0.5; x < 3.0; x += 0.02) {
    r.push_back(x);
    v.push_back(std::exp(-x) * std::sin(4.0 * x));
    t.push_back(x * x - 2.0);
  }
  const auto potential = make_library_law("table", table_arguments(r, v, {}));
  CHECK(potential[0].cutoff == r.back());
  CHECK(energy_at(potential[0], 1.313) - energy_at(potential[0], 1.7) ==
        Approx(std::exp(-1.313) * std::sin(4.0 * 1.313) - std::exp(-1.7) * std::sin(6.8)).epsilon(1e-5));
  check_conservative(potential[0], pair_at(1.31));  // between points: at one the third derivative jumps
  check_stiffness(potential[0], 1.31);
  check_conservative(potential[0], pair_at(0.3));

  const auto tension = make_library_law("table", table_arguments(r, {}, t));
  CHECK(tension_at(tension[0], 1.313) == Approx(1.313 * 1.313 - 2.0).epsilon(1e-6));
  CHECK(energy_at(tension[0], 2.0) - energy_at(tension[0], 1.0) == Approx(7.0 / 3.0 - 2.0).epsilon(1e-5));
  CHECK(energy_at(tension[0], r.back()) == Approx(0.0).margin(1e-15));
  check_conservative(tension[0], pair_at(1.31));

  CHECK_THROWS_WITH(make("table"), Contains("either potentials [J] or tensions [N]"));
  CHECK_THROWS_WITH(make_library_law("table", table_arguments({1.0, 2.0}, {0.0}, {})), Contains("at least two points"));
  CHECK_THROWS_WITH(make_library_law("table", table_arguments({1.0, 1.0}, {0.0, 1.0}, {})), Contains("must rise"));
}

TEST_CASE("library: drag, wind and vortex") {
  LawState state = some_particles(1, 1.0, 4);
  state.v[0] = vec(1.0, 2.0, -2.0);
  CHECK(same(forces_of(make("drag", {{"linear", 0.5}}), state)[0], vec(-0.5, -1.0, 1.0)));
  const Vec3 both = forces_of(make("drag", {{"linear", 0.5}, {"quadratic", 0.1}}), state)[0];
  CHECK(largest(both - vec(-0.8, -1.6, 1.6)) < 1e-15);
  state.v[0] = zero3();
  CHECK(same(forces_of(make("drag", {{"quadratic", 0.1}}), state)[0], zero3()));

  const auto wind = make("wind", {{"quadratic", 0.2}}, {{"velocity", vec(3.0, 0.0, 4.0)}});
  CHECK(largest(forces_of(wind, state)[0] - vec(3.0, 0.0, 4.0)) < 1e-15);
  CHECK(wind[0].moving);

  state.x[0] = vec(1.0, 7.0, 2.0);
  const auto vortex = make("vortex", {{"circulation", 5.0}, {"core", 0.5}, {"linear", 0.3}},
                           {{"axis", vec(0.0, 2.0, 0.0)}, {"centre", vec(1.0, 0.0, 1.0)}});
  const double speed = 5.0 / (2.0 * std::acos(-1.0)) * 1.0 / (0.25 + 1.0);
  CHECK(largest(forces_of(vortex, state)[0] - vec(0.3 * speed, 0.0, 0.0)) < 1e-15);
  state.x[0] = vec(1.0, 3.0, 1.0);
  CHECK(same(forces_of(vortex, state)[0], zero3()));
  CHECK_THROWS_WITH(make("drag"), Contains("linear [N s/m] or quadratic [N s²/m²]"));
}

TEST_CASE("library: buoyancy") {
  const auto law = make("buoyancy", {{"density", 1000.0}, {"surface", 2.0}});
  LawState state = some_particles(1, 1.0, 4);
  state.attributes[0]["radius"] = 0.5;
  const double pi = std::acos(-1.0), weight = 1000.0 * 9.81;
  const auto lift = [&](double y) {
    state.x[0] = vec(0.3, y, -1.0);
    const Vec3 f = forces_of(law, state)[0];
    CHECK(f[0] == 0.0);
    CHECK(f[2] == 0.0);
    return f[1];
  };
  CHECK(lift(2.0) == Approx(weight * 2.0 / 3.0 * pi * 0.125));
  CHECK(lift(1.0) == Approx(weight * 4.0 / 3.0 * pi * 0.125));
  CHECK(lift(2.3) == Approx(weight * pi * 0.04 * (1.5 - 0.2) / 3.0));
  CHECK(lift(2.6) == 0.0);
  for (double y : {2.3, 1.9, 1.2}) {
    state.x[0] = vec(0.3, y, -1.0);
    check_conservative(law[0], state);
  }
}

TEST_CASE("library: angle") {
  const auto law = make("angle", {{"stiffness", 3.0}, {"angle", 1.9}});
  LawState state = some_particles(3, 1.0, 1);
  state.x = {vec(1.0, 0.0, 0.0), zero3(), vec(0.0, 2.0, 0.0)};
  const double right = std::acos(0.0);
  CHECK(energy_of(law[0], state) == Approx(1.5 * std::pow(right - 1.9, 2)));
  CHECK(forces_of(law, state)[0][1] == Approx(-3.0 * (1.9 - right)));
  CHECK(present_value(state.x) == Approx(right));
  for (std::uint64_t seed : {2u, 3u, 4u}) {
    const auto any = some_particles(3, 1.0, seed);
    CHECK(energy_of(law[0], any) == Approx(1.5 * std::pow(present_value(any.x) - 1.9, 2)));
    check_conservative(law[0], any);
    check_opposite(law, any);
  }
  state.x = {vec(1.0, 0.0, 0.0), zero3(), vec(-2.0, 0.0, 0.0)};
  CHECK(energy_of(law[0], state) == Approx(1.5 * std::pow(2.0 * right - 1.9, 2)));
  for (const Vec3& f : forces_of(law, state)) CHECK(largest(f) < 1e-8);
}

TEST_CASE("library: torsion") {
  const auto law = make("torsion", {{"stiffness", 2.0}, {"angle", 0.4}, {"fold", 3.0}});
  LawState state = some_particles(4, 1.0, 1);
  state.x = {vec(1.0, 0.0, 0.0), zero3(), vec(0.0, 0.0, 2.0), vec(0.0, 1.5, 2.0)};
  CHECK(std::fabs(present_value(state.x)) == Approx(std::acos(0.0)));
  for (std::uint64_t seed : {2u, 3u, 4u, 5u}) {
    const auto any = some_particles(4, 1.0, seed);
    CHECK(energy_of(law[0], any) == Approx(2.0 * (1.0 - std::cos(3.0 * (present_value(any.x) - 0.4)))));
    check_conservative(law[0], any);
    check_opposite(law, any);
  }
  // Seen along the middle bond the far one is turned clockwise: the torsion is positive (IUPAC).
  state.x = {vec(0.0, 1.0, 0.0), zero3(), vec(0.0, 0.0, -1.0), vec(1.0, 1.0, -1.0)};
  CHECK(present_value(state.x) == Approx(std::acos(0.0) / 2.0));
  state.x = {vec(0.0, 0.0, 0.0), vec(1.0, 0.0, 0.0), vec(2.0, 0.0, 0.0), vec(2.0, 1.0, 0.0)};
  for (const Vec3& f : forces_of(law, state)) CHECK(same(f, zero3()));
}

TEST_CASE("library: thermostat") {
  const auto law = make("thermostat", {{"rate", 2.0}, {"temperature", 300.0}});
  LawState state = some_particles(1, 1.0, 4);
  state.parameters = {{"boltzmann", 0.01}, {"step", 0.005}};
  const Vec3 kick = state.noise * std::sqrt(2.0 * 2.0 * 1.5 * 0.01 * 300.0 / 0.005);
  CHECK(largest(forces_of(law, state)[0] - (kick - state.v[0] * 3.0)) < 1e-12);
  CHECK(law[0].timed);
  CHECK(law[0].moving);
  CHECK_THROWS_WITH(make("thermostat", {{"rate", 2.0}, {"temperature", 300.0}, {"step", 0.1}}),
                    Contains("has no parameter \"step\""));
}

TEST_CASE("library: wall") {
  const std::map<std::string, Vec3> plane = {{"through", vec(0.0, 1.0, 0.0)}, {"normal", vec(0.0, 2.0, 0.0)}};
  const auto plain = make("wall", {{"stiffness", 100.0}}, plane);
  LawState state = some_particles(1, 1.0, 4);
  state.attributes[0]["radius"] = 0.5;
  state.x[0] = vec(3.0, 1.3, -1.0);
  state.v[0] = vec(3.0, -2.0, 4.0);
  REQUIRE(plain.size() == 1);
  CHECK(largest(forces_of(plain, state)[0] - vec(0.0, 20.0, 0.0)) < 1e-12);
  CHECK(energy_of(plain[0], state) == Approx(50.0 * 0.04));
  check_conservative(plain[0], state);

  const auto rough = make("wall", {{"stiffness", 100.0}, {"damping", 4.0}, {"friction", 0.5}, {"slip", 1e-9}}, plane);
  REQUIRE(rough.size() == 2);
  CHECK_FALSE(rough[1].has_energy());
  CHECK(largest(forces_of(rough, state)[0] - vec(-14.0 * 0.6, 28.0, -14.0 * 0.8)) < 1e-12);
  state.v[0] = vec(0.0, 9.0, 0.0);  // leaves so fast that damping would pull: nothing is left of the push
  CHECK(largest(forces_of(rough, state)[0]) < 1e-12);
  state.x[0] = vec(3.0, 1.6, -1.0);
  state.v[0] = vec(3.0, -2.0, 4.0);
  CHECK(same(forces_of(rough, state)[0], zero3()));
}

TEST_CASE("library: flock") {
  const auto law = make("flock", {{"sight", 3.0}, {"separation", 0.4}, {"alignment", 0.7}, {"cohesion", 0.2}});
  const LawState state = pair_at(1.5);
  const Vec3 d = state.x[1] - state.x[0], u = state.v[1] - state.v[0];
  const Vec3 expected = (d * (0.2 - 0.4 / 2.25) + u * 0.7) * (0.75 * 0.75);
  const auto forces = forces_of(law, state);
  CHECK(largest(forces[0] - expected) < 1e-15);
  CHECK(same(forces[1], zero3()));
  CHECK(law[0].one_sided);
  CHECK(law[0].cutoff == 3.0);
  CHECK(same(forces_of(law, pair_at(3.1))[0], zero3()));
}

namespace {

std::vector<std::vector<Law>> one_of_each() {
  const Numbers drag = {{"linear", 0.3}, {"quadratic", 0.2}};
  return {make("spring", {{"stiffness", 40.0}, {"length", 1.2}, {"damping", 2.0}}),
          make("damper", {{"damping", 2.0}}),
          make("gravitation", {{"constant", 2.0}, {"softening", 0.1}}),
          make("coulomb", {{"constant", 2.0}}),
          make("lennard_jones", {{"epsilon", 1.3}, {"sigma", 0.9}}),
          make("wca", {{"epsilon", 1.3}, {"sigma", 0.9}}),
          make("morse", {{"depth", 3.0}, {"steepness", 2.0}, {"length", 1.1}}),
          make("buckingham", {{"repulsion", 50.0}, {"steepness", 3.0}, {"attraction", 2.0}}),
          make("yukawa", {{"strength", 2.0}, {"screening", 0.8}}),
          make_library_law("table", table_arguments({0.4, 0.8, 1.3, 2.0}, {3.0, 1.0, -1.0, 0.0}, {})),
          make("hydrophobic", {{"strength", 1.5}, {"size", 0.9}}),
          make("repel", {{"stiffness", 20.0}}),
          make("flock", {{"sight", 3.0}, {"separation", 0.4}, {"alignment", 0.7}, {"cohesion", 0.2}}),
          make("drag", drag),
          make("wind", drag, {{"velocity", vec(1.0, 2.0, 3.0)}}),
          make("vortex", {{"circulation", 5.0}, {"core", 0.5}, {"linear", 0.3}}, {{"axis", vec(0.0, 2.0, 1.0)}}),
          make("buoyancy", {{"density", 1000.0}}),
          make("thermostat", {{"rate", 2.0}, {"temperature", 300.0}}),
          make("wall", {{"stiffness", 100.0}, {"damping", 4.0}, {"friction", 0.5}}, {{"normal", vec(0.0, 1.0, 1.0)}}),
          make("angle", {{"stiffness", 3.0}, {"angle", 1.9}}),
          make("torsion", {{"stiffness", 2.0}, {"angle", 0.4}, {"fold", 3.0}})};
}

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
