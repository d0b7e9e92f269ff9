// What other engines are compared on where things touch starts as it says, and is measured as it says.
#include "peers/piles.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "peers/pile_trial.hpp"
#include "shapes/mass.hpp"

using namespace pantin;
using Eigen::Vector3d;

namespace {

std::vector<peers::SolidState> at_start(const peers::Mechanism& pile) {
  std::vector<peers::SolidState> state;
  for (const peers::SolidDef& solid : pile.solids) state.push_back({solid.at, solid.turn, {0, 0, 0}, {0, 0, 0}});
  return state;
}

peers::SolidDef solid(peers::Form form, const Vector3d& size, const Vector3d& at) {
  peers::SolidDef def;
  def.form = form;
  def.size = size;
  def.at = at;
  return def;
}

/// A ball of 2 kg that moves as a function of time says.
class Told final : public peers::Rig {
 public:
  explicit Told(std::function<peers::SolidState(double)> motion) : motion_(std::move(motion)) {}
  void step() override { steps_++; }
  void read(std::vector<peers::SolidState>& state) override {
    state = {motion_(static_cast<double>(steps_) / peers::pile_rate)};
  }
  std::size_t contacts() const override { return 3; }
  std::size_t unsolved() const override { return 7; }

 private:
  std::function<peers::SolidState(double)> motion_;
  long steps_ = 0;
};

peers::PileTrial trial_of(const std::function<peers::SolidState(double)>& motion, double most = 1e9) {
  peers::Mechanism pile;
  pile.solids = {solid(peers::Form::ball, {0.5, 0, 0}, {0, 0.5, 0})};
  pile.solids[0].mass = 2.0;
  pile.walls = {{Vector3d::UnitY(), 0.0}};
  peers::Setting setting;
  setting.make = [&](const peers::Mechanism&, double) { return std::make_unique<Told>(motion); };
  return peers::run_pile(setting, pile, peers::pile_end, most);
}

peers::SolidState ball(const Vector3d& at, const Vector3d& velocity) {
  return {at, Eigen::Quaterniond::Identity(), velocity, {0, 0, 0}};
}

}  // namespace

TEST_CASE("piles: nothing overlaps at the start, joints meet, and a name always gives the same") {
  std::vector<std::string> names = peers::usual_piles();
  for (const char* other : {"boxes(1)", "boxes(10)", "boxes(1000)", "balls(3000)", "heavy(100)", "mixed(200)"})
    names.push_back(other);
  for (const std::string& name : names)
    for (const bool in_plane : {false, true}) {
      CAPTURE(name, in_plane);
      const peers::Mechanism pile = peers::pile(name, in_plane), again = peers::pile(name, in_plane);
      CHECK(peers::deepest_overlap(pile, at_start(pile)) <= 1e-12);
      CHECK(peers::largest_separation(pile, at_start(pile)) <= 1e-12);
      REQUIRE(pile.solids.size() == again.solids.size());
      bool same = true, flat = true;
      for (std::size_t i = 0; i < pile.solids.size(); i++) {
        const peers::SolidDef &a = pile.solids[i], &b = again.solids[i];
        same = same && a.at == b.at && a.turn.coeffs() == b.turn.coeffs() && a.size == b.size && a.mass == b.mass;
        flat = flat && a.at.z() == 0.0;
      }
      CHECK(same);
      CHECK(flat == in_plane);
    }
}

TEST_CASE("piles: have as many bodies as their name says") {
  CHECK(peers::pile("pyramid(20)").solids.size() == 210);
  CHECK(peers::pile("ragdolls(8)").solids.size() == 80);
  CHECK(peers::pile("ragdolls(8)").joints.size() == 72);
  CHECK(peers::pile("heavy(80)").solids[15].mass == 1000.0);
}

TEST_CASE("piles: a wrong name is refused, with what there is") {
  for (const char* name :
       {"", "boxes", "boxes()", "boxes(0)", "boxes(-3)", "boxes(1e3)", "boxes(99999999)", "cubes(3)"})
    CHECK_THROWS_WITH(peers::pile(name), Catch::Contains("is no case") && Catch::Contains("ragdolls(n)"));
}

TEST_CASE("piles: moments of inertia are those of solids") {
  for (const peers::SolidDef& def :
       {solid(peers::Form::ball, {0.3, 0, 0}, {}), solid(peers::Form::box, {0.1, 0.2, 0.5}, {}),
        solid(peers::Form::capsule, {0.2, 0, 0.4}, {}), solid(peers::Form::capsule, {0.5, 0, 0.01}, {})}) {
    const SolidMass mass = solid_mass(peers::geometry_of(def));
    const Vector3d moments = peers::moments_of(def.form, def.size, mass.volume);
    for (int i = 0; i < 3; i++) CHECK(moments[i] == Approx(mass.second[i][i]).epsilon(1e-12));
  }
}

TEST_CASE("piles: the deepest overlap is that of shapes with each other and with walls") {
  peers::Mechanism pile;
  pile.solids = {solid(peers::Form::ball, {0.5, 0, 0}, {0, 0.5, 0}),
                 solid(peers::Form::ball, {0.2, 0, 0}, {0, 1.17, 0}),
                 solid(peers::Form::box, {0.1, 0.2, 0.3}, {3, 0.2, 0})};
  CHECK(peers::deepest_overlap(pile, at_start(pile)) == Approx(0.03));
  pile.joints = {{0, 1, {0, 0.5, 0}, {0, -0.17, 0}, false}};
  CHECK(peers::deepest_overlap(pile, at_start(pile)) == 0.0);
  pile.walls = {{Vector3d::UnitY(), 0.0}, {-Vector3d::UnitX(), -3.06}};
  CHECK(peers::deepest_overlap(pile, at_start(pile)) == Approx(0.04));
  pile.solids[2].turn = Eigen::AngleAxisd(M_PI / 4, Vector3d::UnitZ());  // its corner is 0.3 / sqrt(2) off
  CHECK(peers::deepest_overlap(pile, at_start(pile)) == Approx(0.3 / std::sqrt(2.0) - 0.06));
}

TEST_CASE("piles: what is measured of a motion") {
  // It slides at 0.1 m/s until 5 s and at 0.01 m/s after, sinks by 1 cm at 1 s and rises again at 2 s.
  const peers::PileTrial trial = trial_of([](double t) {
    const double x = t < 5 ? 0.1 * t : 0.5 + 0.01 * (t - 5), speed = t < 5 ? 0.1 : 0.01;
    return ball({x, t >= 1 && t < 2 ? 0.49 : 0.5, 0}, {speed, 0, 0});
  });
  REQUIRE(trial.trouble.empty());
  CHECK(trial.simulated == peers::pile_end);
  CHECK(trial.creep == Approx(0.02));
  CHECK(trial.settled == Approx(5.0 - 1 / peers::pile_rate));
  CHECK(trial.rise == Approx(2.0 * 9.81 * 0.01));
  CHECK(trial.moving.overlap == Approx(0.01));
  CHECK(trial.rest.overlap <= 1e-15);
  CHECK(trial.moving.contacts == 3.0);
  CHECK(trial.unsolved == 7.0);
  CHECK(trial.gap == 0.0);
}

TEST_CASE("piles: what does not settle, fails or takes too long is told") {
  CHECK(std::isinf(trial_of([](double t) { return ball({t, 0.5, 0}, {1, 0, 0}); }).settled));
  CHECK(trial_of([](double t) { return ball({t, 0.5, 0}, {0.5 / (0.5 - t), 0, 0}); }).trouble == "not finite");
  CHECK(trial_of([](double t) {
          return ball({t + 1, 0.5, 0}, {0, 0, 0});
        }).trouble == "does not start where it should");
  const peers::PileTrial stopped = trial_of([](double) { return ball({0, 0.5, 0}, {0, 0, 0}); }, 1e-12);
  CHECK(stopped.simulated == Approx(1 / peers::pile_rate));
  CHECK(std::isnan(stopped.rest.step));
  CHECK(std::isnan(stopped.creep));
}

TEST_CASE("piles: of several falls times are means, and what is worst is told") {
  peers::PileTrial first, second;
  first.moving = {100.0, 10.0, 0.1};
  second.moving = {300.0, 20.0, 0.05};
  first.creep = 1e-3;
  first.settled = 2.0;
  second.settled = 4.0;
  first.unsolved = second.unsolved = 5.0;
  first.simulated = second.simulated = 8.0;
  peers::PileTrial both = peers::together({first, second});
  CHECK(both.moving.step == 200.0);
  CHECK(both.moving.contacts == 15.0);
  CHECK(both.moving.overlap == 0.1);
  CHECK(both.creep == 1e-3);
  CHECK(both.settled == 3.0);
  CHECK(both.unsolved == 10.0);
  second.simulated = 5.0;
  second.creep = std::nan("");
  both = peers::together({first, second});
  CHECK(both.simulated == 5.0);
  CHECK(std::isnan(both.creep));
}
