// What a report makes of runs, given as they should be.
#include "player/report.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bindings/study_support.hpp"
#include "player/plot.hpp"

using namespace pantin;
using namespace pantin::player;

namespace {

/// One thing that should be at (t, 0, 0), seen wrong by `wrong`(step, t).
template <class Wrong>
StudyRun seen(const Study& study, const std::string& integrator, double step, Wrong wrong) {
  StudyRun run;
  run.integrator = integrator;
  run.step = step;
  run.reached = run.right_until = study.until;
  run.seconds = 1e-3 / step;
  run.steps = static_cast<std::uint64_t>(study.until / step);
  for (const double t : study.times) run.positions.push_back({{1, vec(t + wrong(step, t), 0, 0)}});
  return run;
}

Study empty_study() {
  Study study;
  study.path = "thing.lua";
  study.until = study.wanted_until = 4.0;
  study.times = {1.0, 2.0, 3.0, 4.0};
  study.size = 10.0;
  study.moved = 4.0;
  return study;
}

constexpr double steps[] = {0.04, 0.02, 0.01, 0.005, 0.0025, 0.00125};

}  // namespace

TEST_CASE("report: errors, orders and the finest run are found from the positions") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  for (const double step : steps)
    study.runs.push_back(seen(study, "euler", step, [](double h, double t) { return 0.5 * h * t; }));
  compare(study);
  CHECK(study.finest().integrator == "verlet");
  CHECK(study.finest().step == 0.00125);
  CHECK_FALSE(study.parts());
  CHECK(run_of(study, "verlet", 0.02).error == Approx(3 * 4 * 0.02 * 0.02).epsilon(0.01));
  CHECK(run_of(study, "verlet", 0.02).order == Approx(2.0).margin(0.02));
  CHECK(run_of(study, "euler", 0.0025).order == Approx(1.0).margin(0.02));
  const StudyRun* const chosen = cheapest(study, 1e-2);
  REQUIRE(chosen);
  CHECK(chosen->integrator == "verlet");
  CHECK(chosen->step == 0.02);
  CHECK_THAT(advice(study), Catch::StartsWith("For an error of 0.01 m (1e-3 of the scene's size of 10 m) choose "
                                              "scene.step = 1/50 and scene.integrator = \"verlet\": it costs 12 ms "
                                              "of processor time per simulated second, and its error is at most"));
}

TEST_CASE("report: what no run reaches is told from the order") {
  Study study = empty_study();
  for (const double step : {0.04, 0.02, 0.01, 0.005})
    study.runs.push_back(seen(study, "euler", step, [](double h, double t) { return 5 * h * t; }));
  compare(study);
  CHECK(cheapest(study, 1e-2) == nullptr);
  CHECK_THAT(advice(study), Catch::Contains("none of the steps tried is that exact; by its order euler would need"));
}

TEST_CASE("report: a run that invents energy later is not recommended, however near it begins") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  compare(study);
  for (StudyRun& run : study.runs) run.worst.energy = run.step > 0.015 ? 0.9 : 0.01;
  REQUIRE(cheapest(study, 1e-2));
  CHECK(cheapest(study, 1e-2)->step == 0.01);
}

TEST_CASE("report: a step that is exact by luck, where shorter ones are not, is not recommended") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(
        seen(study, "verlet", step, [](double h, double t) { return h == 0.04 ? 0.0 : 30 * h * h * t; }));
  compare(study);
  REQUIRE(cheapest(study, 1e-2));
  CHECK(cheapest(study, 1e-2)->step == 0.005);
}

TEST_CASE("report: two fine runs that agree by chance, as where an event falls into whole steps, are no proof") {
  Study study = empty_study();
  for (const double step : {0.04, 0.02, 0.01, 0.005})
    study.runs.push_back(seen(study, "verlet", step, [](double h, double) { return std::max(h, 0.01); }));
  compare(study);
  CHECK(study.finest().step == 0.005);
  CHECK(study.uncertain >= 0.0049);  // what order 1 leaves of the halving before
  Study first_order = empty_study();
  for (const double step : steps)
    first_order.runs.push_back(seen(first_order, "euler", step, [](double h, double t) { return 0.5 * h * t; }));
  compare(first_order);
  REQUIRE(first_order.comparable > 0.0);
  CHECK(first_order.uncertain >= 0.5 * 0.00125 * first_order.comparable);
  CHECK(first_order.uncertain < 0.5 * 0.00125 * first_order.comparable * 3.1);
}

TEST_CASE("report: the run in which shapes overlapped most, and the one solved most loosely, are told") {
  Study study = empty_study();
  for (const double step : {0.04, 0.02, 0.01})
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  compare(study);
  CHECK_THAT(report_text(study, 1.0), !Catch::Contains("at the most, with"));
  study.runs[0].worst.penetration = 0.1;
  study.runs[1].worst.penetration = 0.2;
  study.runs[0].overlap = "shapes overlapped a little";
  study.runs[1].overlap = "shapes overlapped much";
  study.runs[2].stats.unsolved_islands = 7;
  study.runs[2].loosely = "loosely 7 times";
  const std::string told = report_text(study, 1.0);
  CHECK_THAT(told, Catch::Contains("at the most, with verlet 1/50, shapes overlapped much\n"
                                   "at the most, with verlet 1/100, loosely 7 times\n"));
  CHECK_THAT(told, !Catch::Contains("a little"));
  CHECK_THAT(report_json(study, 1.0), Catch::Contains("\"deep_overlap\": \"shapes overlapped much\"") &&
                                          Catch::Contains("\"unsolved_islands\": 7"));
}

TEST_CASE("report: two runs promise nothing") {
  Study study = empty_study();
  for (const double step : {0.04, 0.02})
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  compare(study);
  CHECK(study.comparable == 0.0);
  for (const StudyRun& run : study.runs) CHECK(std::isnan(study.error_of(run)));
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("No error is told: that takes three runs"));
  CHECK(advice(study) == "No step can be recommended by its error, for too few runs came to the end.");
}

TEST_CASE("report: where changes do not fall as the order says, nothing is extrapolated") {
  Study study = empty_study();
  const auto by_luck = [](double h, double) { return h == 0.00125 ? 0.9e-3 : h == 0.0025 ? 1e-3 : 200 * h * h; };
  for (const double step : steps) study.runs.push_back(seen(study, "verlet", step, by_luck));
  compare(study);
  CHECK(study.uncertain >= 0.9e-3);
  Study smooth = empty_study();
  for (const double step : steps)
    smooth.runs.push_back(seen(smooth, "verlet", step, [](double h, double t) { return 200 * h * h * t; }));
  compare(smooth);
  CHECK(smooth.uncertain < 10.0 * 200 * 0.00125 * 0.00125 * smooth.comparable);
}

TEST_CASE("report: integrators that contradict each other are both in doubt") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  for (const double step : steps)
    study.runs.push_back(seen(study, "suzuki4", step, [](double h, double t) { return 2e-3 + h * h * h * h * t; }));
  compare(study);
  CHECK(study.uncertain >= 1.9e-3);
}

TEST_CASE("report: runs that lose or make energy are no measure, and where they part nothing is called chaotic") {
  Study study = empty_study();
  const auto exploding = [](double h, double t) { return t < 2.5 ? h * h * t : t * t / h; };
  for (const double step : steps) {
    study.runs.push_back(seen(study, "verlet", step, exploding));
    study.runs.back().right_until = 2.0;
  }
  compare(study);
  CHECK(study.comparable == 2.0);
  CHECK(study.unresolved());
  CHECK_FALSE(study.chaotic);
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("Unresolved: the finest runs part after 2 s") &&
                                          Catch::Contains("Errors are told until 2 s"));
  Study never = empty_study();
  never.runs = study.runs;
  for (StudyRun& run : never.runs) run.right_until = 0.0;
  compare(never);
  CHECK_THAT(advice(never), Catch::Contains("the finest runs lose or make energy"));
}

TEST_CASE("report: a row tells no less than what is promised") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 2.7181 * h * h * t; }));
  compare(study);
  const std::string all = report_text(study, 1.0);
  std::size_t rows = 0;
  for (std::size_t at = all.find("\nverlet"); at != std::string::npos; at = all.find("\nverlet", at + 1), rows++) {
    const StudyRun& run = study.runs[rows];
    if (&run == &study.finest()) continue;
    const double told = std::stod(all.substr(at + 20, 14));
    CHECK(told >= study.error_of(run));
    CHECK(told < 1.01 * study.error_of(run));
  }
  CHECK(rows == study.runs.size());
}

TEST_CASE("report: the paper's integrator is no measure of others, however well its runs agree") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  for (const double step : steps)
    study.runs.push_back(seen(study, "euler", step, [](double h, double) { return 0.5 + 1e-9 * h; }));
  compare(study);
  CHECK(study.finest().integrator == "verlet");
  CHECK(run_of(study, "euler", 0.01).error > 0.4);
  Study alone = empty_study();
  for (const double step : steps)
    alone.runs.push_back(seen(alone, "euler", step, [](double h, double t) { return 0.01 * h * t; }));
  compare(alone);
  CHECK(alone.finest().integrator == "euler");
}

TEST_CASE("report: what is of first order with every integrator is told to happen in whole steps") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 0.05 * h * t; }));
  compare(study);
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("happens in whole steps, as events, impacts and hands do"));
  study.ledger.emplace().posts.given[static_cast<std::size_t>(Source::damper)] = -2.0;
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("dampers that are strong for the step are of first order"));
  Study second = empty_study();
  for (const double step : steps)
    second.runs.push_back(seen(second, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  compare(second);
  CHECK_THAT(report_text(second, 1.0), !Catch::Contains("whole steps"));
}

TEST_CASE("report: beside the mean over all things the error of the worst is told") {
  Study study = empty_study();
  for (const double step : steps) {
    study.runs.push_back(seen(study, "verlet", step, [](double, double) { return 0.0; }));
    for (Places& places : study.runs.back().positions)
      for (std::uint64_t other = 2; other <= 4; other++) places.emplace_back(other, vec(0, step * step, 0));
  }
  compare(study);
  const StudyRun& run = run_of(study, "verlet", 0.04);
  const double most = 0.04 * 0.04 - study.finest().step * study.finest().step;
  CHECK(run.farthest == Approx(most));
  CHECK(run.error == Approx(most * std::sqrt(0.75)));
}

TEST_CASE("report: a time that is shortened is a round one") {
  CHECK(round_time(9.99) == 5.0);
  CHECK(round_time(4.9) == 2.0);
  CHECK(round_time(1.3) == 1.0);
  CHECK(round_time(0.6) == 0.5);
  CHECK(round_time(0.03) == Approx(0.02));
  CHECK(round_time(100.0) == 100.0);
}

TEST_CASE("report: comparing ends where the two finest runs part") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(
        seen(study, "verlet", step, [](double h, double t) { return 0.65 * h * h * std::pow(10.0, 2.0 * t); }));
  compare(study);
  CHECK(study.parts());
  CHECK(study.together == 2.0);
  CHECK(study.comparable == 1.0);
  CHECK(run_of(study, "verlet", 0.04).true_until == 0.0);
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("The finest runs part after 2 s"));
}

TEST_CASE("report: what grows along a line for long is called chaotic, one jump is not") {
  Study chaos = empty_study();
  chaos.times.clear();
  for (int k = 1; k <= 40; k++) chaos.times.push_back(0.1 * k);
  Study jump = chaos;
  for (const double step : steps) {
    chaos.runs.push_back(
        seen(chaos, "verlet", step, [](double h, double t) { return h * h * std::pow(10.0, 2.0 * t); }));
    jump.runs.push_back(seen(jump, "verlet", step, [](double h, double t) { return t < 2 ? 1e-12 * h : 1e3 * h * t; }));
  }
  compare(chaos);
  compare(jump);
  CHECK(chaos.chaotic);
  CHECK(chaos.growth == Approx(2.0 * std::log(10.0)).epsilon(0.01));
  CHECK_THAT(report_text(chaos, 1.0), Catch::Contains("the motion is chaotic, a small error grows tenfold in 0.5 s"));
  CHECK(jump.parts());
  CHECK_FALSE(jump.chaotic);
}

TEST_CASE("report: runs that never agree are told not to be comparable") {
  Study study = empty_study();
  study.random = true;
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double) { return std::sin(1.0 / h); }));
  compare(study);
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("draws random numbers"));
  CHECK(advice(study) == "No step can be recommended by its error, for runs with different steps go different ways.");
}

TEST_CASE("report: an accuracy that is the cheapest way to the wanted error is told as such") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  StudyRun run = seen(study, "verlet", 0.04, [](double, double t) { return 1e-5 * t; });
  run.accuracy = 1e-3;
  study.runs.push_back(run);
  compare(study);
  CHECK(study.finest().accuracy == 0.0);
  CHECK_THAT(advice(study), Catch::Contains("choose scene.accuracy = 0.001, scene.step = 1/25 and"));
}

TEST_CASE("report: the picture shows the wanted error and what was chosen") {
  Study study = empty_study();
  for (const double step : steps)
    study.runs.push_back(seen(study, "verlet", step, [](double h, double t) { return 3 * h * h * t; }));
  compare(study);
  CHECK_THAT(report_picture(study), Catch::Contains(">1e-3 of the size<") && Catch::Contains(">chosen<") &&
                                        Catch::Contains("thing: error against cost"));
}

TEST_CASE("report: the picture names its series and holds only numbers") {
  const std::string svg =
      draw_plots({{"a < b", "x", "y", {{"one & two", {{1, 1e-3}, {10, 1e-6}, {0, 1}, {1, std::nan("")}}}}}}, 2);
  CHECK_THAT(svg, Catch::StartsWith("<svg") && Catch::EndsWith("</svg>\n"));
  CHECK_THAT(svg, Catch::Contains("one &amp; two") && Catch::Contains("a &lt; b") && Catch::Contains("10⁻⁶"));
  CHECK_THAT(svg, !Catch::Contains("nan") && !Catch::Contains("inf"));
}
