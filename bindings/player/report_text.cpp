// What a report says in words and numbers.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "player/doubt.hpp"
#include "player/home.hpp"
#include "player/plot.hpp"
#include "player/report.hpp"

namespace pantin::player {
namespace {

constexpr double wanted = 1e-3;  // error, relative to the size

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char line[1000];
  std::snprintf(line, sizeof line, pattern, values...);
  return line;
}

/// "1/240", or "0.0123" where that is no whole number.
std::string show_step(double step) {
  const double rate = 1.0 / step;
  if (rate >= 1.0 && std::fabs(rate - std::round(rate)) < 1e-9 * rate) return format("1/%.0f", std::round(rate));
  return format("%.4g", step);
}

/// With so many digits behind the point, and never less than the number itself.
std::string at_most(double x, int digits) {
  if (!std::isfinite(x) || x <= 0.0) return x == 0.0 ? "0" : "-";
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - digits);
  return format("%.*e", digits, std::ceil(x / unit * (1 - 1e-12)) * unit);
}

std::string number(const char* pattern, double x) { return std::isfinite(x) ? format(pattern, x) : "-"; }

double per_solve(const Stats& stats) {
  return stats.solves > 0 ? static_cast<double>(stats.newton_iterations) / static_cast<double>(stats.solves) : 0.0;
}

/// What the runs of its series have in common.
std::string series_name(const StudyRun& run) { return run.accuracy > 0.0 ? "accuracy" : run.integrator; }

std::string row(const Study& study, const StudyRun& run) {
  const bool finest = &run == &study.finest();
  std::string line =
      format("%-9s %-9s %12s %6s %10s %12s %6.2f %6llu %5llu %10s %10s", series_name(run).c_str(),
             run.accuracy > 0.0 ? number("%.0e", run.accuracy).c_str() : show_step(run.step).c_str(),
             finest ? ("(" + at_most(run.error, 1) + ")").c_str() : at_most(study.error_of(run), 2).c_str(),
             number("%.1f", run.order).c_str(), number("%.4g", 1e3 * run.cost()).c_str(),
             number("%.4g", 1e9 * run.seconds / static_cast<double>(run.steps)).c_str(), per_solve(run.stats),
             static_cast<unsigned long long>(run.stats.halved_steps),
             static_cast<unsigned long long>(run.stats.fallback_steps), number("%.1e", run.worst.constraint).c_str(),
             number("%.1e", run.worst.energy).c_str());
  line += format(" %10.4g", run.true_until);
  if (!run.trouble.empty()) line += "  " + run.trouble;
  return line + "\n";
}

std::string table(const Study& study) {
  std::string lines =
      format("%-9s %-9s %12s %6s %10s %12s %6s %6s %5s %10s %10s %10s\n", "integr.", "step, s", "error, m", "order",
             "ms/s", "ns/step", "iter.", "halved", "safe", "gap, m", "energy", "true to, s");
  for (const StudyRun& run : study.runs) lines += row(study, run);
  for (const Refused& refused : study.refused)
    lines += format("%-9s ", refused.integrator.c_str()) + refused.why + "\n";
  return lines;
}

/// The lines that are not 0, and what the ledger says of itself.
std::string ledger_line(const Study& study) {
  if (!study.ledger || !study.ledger->posts.kept) return "";
  const LedgerLines& ledger = *study.ledger;
  std::string line = format("ledger, J, %g s with step %s and %s:", ledger.time, show_step(study.step).c_str(),
                            study.integrator.c_str());
  const auto add = [&](const std::string& name, double joules) {
    if (joules != 0.0) line += " " + name + format(" %.4g", joules);
  };
  add("gravity", ledger.posts.gravity);
  for (const auto& [name, joules] : ledger.laws.given) add(name, joules);
  add("laws without energy", ledger.laws.open);
  for (std::size_t i = 0; i < source_names.size(); i++) add(std::string(source_names[i]), ledger.posts.given[i]);
  line += format("; closure %.1e; truncation", ledger.closure);
  for (const auto& [name, joules] : ledger.truncation) line += " " + name + format(" %.1e", joules);
  return line + "\n";
}

bool still(const Study& study) { return !study.unresolved() && !(study.moved > 1e-9 * study.size); }

/// Runs of different steps differ from the first times on, or draw different noise.
bool never_together(const Study& study) {
  return study.together <= 0.05 * study.until || (study.noisy && study.parts());
}

std::string cause(const Study& study) {
  if (study.random) return " Its script draws random numbers while it runs, others with every step.";
  if (study.noisy) return " It has a law with noise in it, which is different with every step.";
  if (study.emits) return " It has emitters, whose particles meet other ones with every step.";
  return "";
}

/// The order that the last two halvings of a series show, NaN where they do not agree.
double sure_order(const Study& study, const StudyRun& last) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (&last == &study.runs.front() || !same_series(*(&last - 1), last)) return nan;
  return std::fabs((&last - 1)->order - last.order) < 0.5 ? last.order : nan;
}

bool is_last(const Study& study, const StudyRun& run) {
  return &run == &study.runs.back() || !same_series(*(&run + 1), run);
}

/// Whether dampers took energy in the run for the ledger.
bool is_damped(const Study& study) {
  return study.ledger && study.ledger->posts.given[static_cast<std::size_t>(Source::damper)] != 0.0;
}

/// Integrators of higher order are at an order of 1 where the steps themselves are what is seen, or laws are solved at
/// their end.
std::string first_order(const Study& study) {
  bool any = false;
  for (const StudyRun& run : study.runs) {
    if (run.integrator == "euler" || run.accuracy > 0.0 || !is_last(study, run)) continue;
    const double order = sure_order(study, run);
    if (!(order > 0.7 && order < 1.5)) return "";
    any = true;
  }
  if (!any) return "";
  const std::string told = " Halving the step only halves the error, with each integrator: ";
  return told + (is_damped(study)
                     ? "dampers that are strong for the step are of first order, and so is what happens in "
                       "whole steps, as events, impacts and hands do."
                     : "something happens in whole steps, as events, impacts and hands do.");
}

std::string of_touch(const Study& study) {
  if (!study.touches()) return "";
  return " Shapes touch in it: impacts and friction begin and end in whole steps, so errors need not fall with the "
         "step "
         "as the order says, and nothing is told by it.";
}

/// The run in which shapes overlapped most, where that was by more than is meant, and that in which islands of contacts were
/// solved loosely most often.
std::string loose_touch(const Study& study) {
  const StudyRun *deepest = nullptr, *loosest = nullptr;
  for (const StudyRun& run : study.runs) {
    if (!run.overlap.empty() && (!deepest || run.worst.penetration > deepest->worst.penetration)) deepest = &run;
    if (!run.loosely.empty() && (!loosest || run.stats.unsolved_islands > loosest->stats.unsolved_islands))
      loosest = &run;
  }
  const auto line = [](const StudyRun& run, const std::string& told) {
    return "at the most, with " + series_name(run) + " " +
           (run.accuracy > 0.0 ? number("%.0e", run.accuracy) : show_step(run.step)) + ", " + told + "\n";
  };
  return (deepest ? line(*deepest, deepest->overlap) : "") + (loosest ? line(*loosest, loosest->loosely) : "");
}

std::string told_until(const Study& study) {
  return study.comparable > 0.0 ? format(" Errors are told until %g s.", study.comparable) : " No error is told.";
}

/// What the energy of the finest runs says, where they part.
std::string losing(const Study& study) {
  const StudyRun& run = study.runs[*study.loser];
  return format(
      "Unresolved: the finest runs part after %g s, where they lose or make energy (%s with step %s is right until "
      "%g s, and wrong by %.1e of what is exchanged at the worst): how it goes on takes shorter steps.",
      study.together, run.integrator.c_str(), show_step(run.step).c_str(), run.right_until, run.worst.energy);
}

/// No error is told by fewer than three runs of one integrator that come to the end.
bool too_few(const Study& study) {
  const auto complete = [&](const StudyRun* run) { return run && run->positions.size() == study.times.size(); };
  for (std::size_t i = 2; i < study.runs.size(); i++)
    if (complete(&study.runs[i]) && complete(coarser(study, i)) && complete(coarser(study, i - 1))) return false;
  return true;
}

std::string course(const Study& study) {
  if (too_few(study))
    return "No error is told: that takes three runs of one integrator that come to the end. A shorter --until leaves "
           "time for more.\n";
  if (study.unresolved()) return losing(study) + told_until(study) + of_touch(study) + "\n";
  if (never_together(study))
    return format(
               "Runs with different steps go different ways (they part after %g s by more than a hundredth of the "
               "size): ",
               study.together) +
           "no step can be told to be right." + cause(study) + of_touch(study) +
           " Compare averages of many runs instead.\n";
  if (!study.parts())
    return format("The finest runs stay together for all of the %g s", study.until) +
           (study.comparable < study.until ? format("; errors are told until %g s, while small ones are"
                                                    " sure.",
                                                    study.comparable)
                                           : ".") +
           first_order(study) + of_touch(study) + "\n";
  std::string result = format("The finest runs part after %g s", study.together);
  if (study.chaotic)
    result += format(": the motion is chaotic, a small error grows tenfold in %.2g s", std::log(10.0) / study.growth);
  return result + "." + told_until(study) + cause(study) + first_order(study) + of_touch(study) + "\n";
}

/// Where no run is exact enough: how far the best integrator would have to go by its order.
std::string extrapolated(const Study& study, double error) {
  if (study.touches())
    return "none of the steps tried is surely that exact, and where shapes touch no shorter one is foretold.";
  const StudyRun* best = nullptr;
  double cost = 0.0, step = 0.0;
  for (const StudyRun& run : study.runs) {
    const double order = sure_order(study, run), exact = study.error_of(run);
    if (!is_last(study, run) || run.accuracy > 0.0 || !run.trouble.empty() || !(order > 0.5) || !(exact > error))
      continue;
    const double factor = std::pow(error / exact, 1.0 / order);
    if (best && run.cost() / factor >= cost) continue;
    best = &run;
    cost = run.cost() / factor;
    step = run.step * factor;
  }
  if (!best)
    return std::any_of(study.runs.begin(), study.runs.end(),
                       [](const StudyRun& run) { return std::isfinite(run.order); })
               ? "none of the steps tried is that exact, and the error does not fall with the step."
               : "none of the steps tried is that exact, and there was no time for more: a shorter --until leaves "
                 "some.";
  return format(
      "none of the steps tried is that exact; by its order %s would need scene.step of about 1/%.0f: some %.2g ms per "
      "simulated second.",
      best->integrator.c_str(), std::ceil(1.0 / step), 1e3 * cost);
}

}  // namespace

std::string advice(const Study& study) {
  if (still(study) && study.parts())
    return format(
        "Nothing moves by itself until %g s, and until then errors can be told. Something moves after that, and "
        "no step that was tried followed it.",
        study.comparable);
  if (still(study)) return "Nothing moves by itself in this scene, so there is no step to choose.";
  const double error = wanted * study.size;
  const std::string beginning =
      format("For an error of %.2g m (1e-3 of the scene's size of %.3g m)", error, study.size) +
      (study.comparable < study.wanted_until * (1 - 1e-9) ? format(" until %.4g s ", study.comparable) : " ");
  if (never_together(study))
    return std::string("No step can be recommended by its error, for ") +
           (too_few(study)       ? "too few runs came to the end."
            : study.unresolved() ? "the finest runs lose or make energy."
                                 : "runs with different steps go different ways.");
  const StudyRun* const run = cheapest(study, error);
  if (!run) return beginning + extrapolated(study, error);
  const bool longest = run == &study.runs.front() || !same_series(*run, *(run - 1));
  return beginning + "choose " + (run->accuracy > 0.0 ? format("scene.accuracy = %g, ", run->accuracy) : "") +
         format(
             "scene.step = %s%s and scene.integrator = \"%s\": it costs %.2g ms of processor time per simulated "
             "second, and its error is at most %s m, that of its worst point %s m.",
             show_step(run->step).c_str(), longest && run->accuracy == 0.0 ? " (the longest tried)" : "",
             run->integrator.c_str(), 1e3 * run->cost(), at_most(study.error_of(*run), 1).c_str(),
             at_most(study.farthest_of(*run), 1).c_str());
}

std::string report_text(const Study& study, double product_ns) {
  std::string result = scene_name(study.path) + format(": %g s", study.until);
  if (study.until < study.wanted_until * (1 - 1e-9)) result += format(" of its %g s", study.wanted_until);
  result += format(", compared at %zu times; %zu points and bodies in %.3g m; energy return %s\n", study.times.size(),
                   study.things, study.size, study.energy_return ? "on" : "off");
  result += format(
      "error: at most, root mean square over points and bodies: the distance to the run in brackets, and by what that\n"
      "  one may be wrong itself, as at least three runs with different steps agree\n"
      "order: halving the step divides the error by 2^order\n"
      "ms/s: milliseconds of processor time per simulated second, on one thread, while a 3x3 product took %.2g ns\n"
      "iter.: Newton iterations per step and articulate; steps that were halved, or safe ones, which only lose energy\n"
      "gap, energy: the worst of the constraints' gaps, and of the energy's error relative to what is exchanged\n"
      "true to: until then it is surely within a hundredth of the size\n",
      product_ns);
  if (std::any_of(study.runs.begin(), study.runs.end(), [](const StudyRun& run) { return run.accuracy > 0.0; }))
    result += format("accuracy: that scene.accuracy with verlet and step %s\n", show_step(study.step).c_str());
  result += table(study) + loose_touch(study) + ledger_line(study) + course(study);
  return result + advice(study) + "\n";
}

std::string report_picture(const Study& study) {
  const std::string name = scene_name(study.path);
  Plot by_cost{name + ": error against cost", "ms of processor time per simulated second", "error, m", {}};
  Plot by_step{name + ": error against step", "step, s", "error, m", {}};
  for (const StudyRun& run : study.runs) {
    if (by_cost.series.empty() || by_cost.series.back().name != series_name(run)) {
      by_cost.series.push_back({series_name(run), {}});
      if (run.accuracy == 0.0) by_step.series.push_back({series_name(run), {}});
    }
    by_cost.series.back().points.emplace_back(1e3 * run.cost(), study.error_of(run));
    if (run.accuracy == 0.0) by_step.series.back().points.emplace_back(run.step, study.error_of(run));
  }
  if (still(study) || never_together(study)) return draw_plots({by_cost, by_step}, 2);
  const StudyRun* const chosen = cheapest(study, wanted * study.size);
  for (Plot* plot : {&by_cost, &by_step}) {
    plot->level = wanted * study.size;
    plot->level_name = "1e-3 of the size";
    plot->mark_name = "chosen";
  }
  if (chosen) by_cost.mark = {1e3 * chosen->cost(), study.error_of(*chosen)};
  if (chosen && chosen->accuracy == 0.0) by_step.mark = {chosen->step, study.error_of(*chosen)};
  return draw_plots({by_cost, by_step}, 2);
}

}  // namespace pantin::player
