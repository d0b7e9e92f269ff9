// What a report finds by the runs of a scene.
#include "player/study.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bindings/study_support.hpp"
#include "player/report.hpp"
#include "scene/errors.hpp"

using namespace pantin;
using namespace pantin::player;

namespace {

constexpr const char* pendulum = R"(
scene.step = 1 / 60
local bob = scene:particle { at = vec(1, 0, 0) }
scene:rod(vec(0, 0, 0), bob)
)";

}  // namespace

TEST_CASE("report: a pendulum's errors fall as the integrators' orders say") {
  const Study study = study_text(pendulum, 1.0);
  CHECK(study.step == 1.0 / 60);
  CHECK(study.size == study.moved);
  CHECK(study.size > 1.0);
  CHECK_FALSE(study.parts());
  CHECK(run_of(study, "verlet", 1.0 / 60).order == Approx(2.0).margin(0.1));
  CHECK(run_of(study, "euler", 1.0 / 240).order == Approx(1.0).margin(0.2));
  CHECK(run_of(study, "verlet", 1.0 / 60).error < run_of(study, "euler", 1.0 / 60).error);
  CHECK_THAT(report_text(study, 1.0), Catch::EndsWith(" m.\n"));
  CHECK(nlohmann::json::parse(report_json(study, 1.0))["advice"] == advice(study));
}

TEST_CASE("report: integrators of fourth order and accuracies are tried too, in a scene that asks for one as well") {
  const Study study = study_text(std::string("scene.accuracy = 1e-3\n") + pendulum, 1.0);
  CHECK(run_of(study, "suzuki4", 1.0 / 60).order == Approx(4.0).margin(0.3));
  CHECK(run_of(study, "suzuki4", 1.0 / 60).error < 0.01 * run_of(study, "verlet", 1.0 / 60).error);
  std::vector<double> errors;
  for (const StudyRun& run : study.runs)
    if (run.accuracy > 0.0) errors.push_back(run.error);
  REQUIRE(errors.size() >= 3);  // the coarsest may be what the scene's own step gives
  CHECK(errors.back() < 0.1 * errors.front());
  CHECK(study.finest().accuracy == 0.0);
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("rk4       scene.lua") || Catch::Contains("no constraint ties"));
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("accuracy: that scene.accuracy with verlet and step 1/60"));
}

TEST_CASE("report: every run is one thread's, and its cost the least of what each part of it took") {
  const Study study = study_text(pendulum, 1.0);
  for (const StudyRun& run : study.runs) {
    double sum = 0.0;
    for (const double seconds : run.portions) sum += seconds;
    CHECK(run.seconds == Approx(sum));
    CHECK(run.portions.size() == run.positions.size());
  }
  CHECK_THAT(report_text(study, 1.0),
             Catch::Contains("milliseconds of processor time per simulated second, on one thread"));
  const char* const words[] = {"pantin", "report", "chain", "--threads", "2"};
  CHECK_THROWS_AS(read_options(5, words), UsageError);
}

TEST_CASE("report: a step that is too long for the scene is a line of the table, and shorter ones are compared") {
  const Study study = study_text(R"(
    scene.step = 1 / 10
    scene.gravity = vec(0, 0, 0)
    local bob = scene:particle { at = vec(1, 0, 0) }
    scene:on("step", function() if bob.position:length() > 3 then error "it flew away" end end)
    scene:field(scene, force.point { force = function(p) return -900 * p.position end })
  )",
                                 2.0);
  CHECK_THAT(run_of(study, "verlet", 1.0 / 10).trouble, Catch::Contains("it flew away"));
  CHECK_FALSE(study.parts());
  CHECK_THAT(advice(study), Catch::Contains("choose scene.step = 1/"));
}

TEST_CASE("report: what goes wrong with every step is told, and a script's own end is the end") {
  CHECK_THROWS_WITH(study_text(std::string(pendulum) + "scene:at(0.5, function() bob.wight = 2 end)", 1.0),
                    Catch::Contains("wight"));
  CHECK_THROWS_WITH(study_text(std::string(pendulum) + "for i = 1, 20 do scene:particle { at = vec(i, 3, 0) } end\n"
                                                       "scene:at(0.001, function() bob.wight = 2 end)",
                               1000.0),
                    Catch::Contains("wight"));
  const Study study = study_text(std::string(pendulum) + "scene:at(0.7, function() scene:finish() end)", 3.0);
  CHECK(study.until <= 0.72);
  CHECK(study.until >= 0.6);
  for (const StudyRun& run : study.runs) CHECK(run.portions.size() == study.times.size());
  CHECK_THAT(advice(study), Catch::Contains("choose scene.step = 1/"));
}

TEST_CASE("report: comparing ends where it is asked to") {
  for (const double until : {0.4, 2.0, 3.2}) {
    const Study study =
        study_text("scene:particle {} scene:particle { at = vec(1, 0, 0) } scene.step = 1 / 500", until);
    CHECK(study.until == Approx(until));
    CHECK(study.times.size() >= 40);
    CHECK(study.times.size() <= 120);
  }
}

TEST_CASE("report: where shorter steps show nothing new longer ones are tried still") {
  const Study study = study_text(R"(
    local bob = scene:particle { at = vec(1, 0, 0) }
    scene:particle { at = vec(3, 0, 0), velocity = vec(1, 0, 0) }
    scene:field(scene, force.point { force = function(p) return vec(0, 1, 0) end })
  )",
                                 1.0, 100.0);
  CHECK(run_of(study, "verlet", 1.0 / 60).error < 1e-9);
  CHECK(run_of(study, "verlet", 1.0 / 480).error < 1e-9);
  CHECK_THROWS(run_of(study, "verlet", 1.0 / 960));
  CHECK_THAT(advice(study), Catch::Contains("scene.step = 1/60 (the longest tried)"));
}

TEST_CASE("report: what rests on a floor before something moves loses no energy") {
  const Study study = study_text(R"(
    scene:floor {}
    for k = 1, 3 do scene:box { size = 1, at = vec(3, k - 0.5, 0) } end
    local ball = scene:ball { radius = 0.2, at = vec(0, 0.2, 0) }
    scene:at(0.5, function() ball.velocity = vec(1, 0, 0) end)
  )",
                                 1.0);
  CHECK_THAT(advice(study), !Catch::Contains("No step can be recommended"));
  CHECK_THAT(advice(study), Catch::Contains("choose scene.step"));
}

TEST_CASE("report: where something moves that no step followed, no scene is said to be at rest") {
  const Study study = study_text(R"(
    scene.gravity = vec(0, 0, 0)
    scene:particle { at = vec(1, 0, 0) }
    scene:field(scene, force.point { force = function(p, own, t)
      return vec(where(t > 1.0005 and t < 1.0015, 1000, 0), 0, 0) end })
  )",
                                 1.5);
  CHECK_THAT(advice(study), Catch::StartsWith("Nothing moves by itself until 1 s, and") &&
                                Catch::Contains("Something moves after that, and no step that was tried followed it."));
}

TEST_CASE("report: a scene in which nothing moves says so, and one that is over at once is refused") {
  CHECK_THAT(
      advice(study_text("scene.gravity = vec(0, 0, 0) scene:particle {} scene:particle { at = vec(1, 0, 0) }", 0.5)),
      Catch::StartsWith("Nothing moves by itself"));
  CHECK_THROWS_WITH(study_text(pendulum, 0.05), Catch::Contains("at least 4 steps"));
  CHECK_THROWS_WITH(study_text("scene:nail(1)", 1.0), Catch::Contains("scene.lua:1:"));
}
