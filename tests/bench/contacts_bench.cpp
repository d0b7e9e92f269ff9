// `pantin bench contacts [CASE…]`: what touch costs and how still it gets; with --peers, in the other engines too.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "base/check.hpp"
#include "bench/pantin_rig.hpp"
#include "bench/peer_programs.hpp"
#include "peers/pile_trial.hpp"
#include "peers/piles.hpp"
#include "player/bench.hpp"
#include "player/plot.hpp"
#include "support/process.hpp"

using namespace pantin;

namespace {

constexpr double short_seconds = 3.0, named_seconds = 100.0, growth_seconds = 30.0;  // [s] of the processor, at most
constexpr const char *table = "contacts.csv", *picture = "contacts.svg";

/// What is run, until when [s], how much of the processor [s] each fall may use, and how many falls of a heap there are.
struct Task {
  std::vector<std::string> cases;
  double until = peers::pile_end, most = named_seconds;
  std::uint32_t falls = 3;
  bool grows = false;
};

struct Contender {
  std::string engine, setting;
  std::function<peers::PileTrial(const std::string& pile, std::uint32_t seed, const Task& task)> run;
  std::string name() const { return setting.empty() ? engine : engine + ", " + setting; }
};

struct Result {
  std::string pile;
  std::vector<peers::PileTrial> trials;  ///< (contenders)
};

peers::PileTrial run_peer(const PeerProgram& peer, const std::string& setting, const std::string& pile,
                          std::uint32_t seed, const Task& task) {
  const support::Finished ended = support::finish({{peer.path, "pile", setting, pile, std::to_string(seed),
                                                    number("%.17g", task.until), number("%.17g", task.most)},
                                                   {},
                                                   "",
                                                   -1});
  peers::PileTrial trial;
  const char* rest = ended.out.c_str();
  for (const auto& [name, value] : trial.numbers()) {
    char* end = nullptr;
    *value = std::strtod(rest, &end);
    if (end == rest) {
      const std::string line = ended.out.substr(0, ended.out.find('\n'));
      trial.trouble = ended.code == 0 ? line.substr(line.find(' ') + 1) : text("ended with ", ended.code);
      break;
    }
    rest = end;
  }
  return trial;
}

std::vector<Contender> contenders_of(const player::BenchOptions& options, bool first_settings) {
  std::vector<Contender> list;
  for (const peers::Setting& setting : pantin_pile_settings())
    list.push_back({"Pantin", setting.name, [setting](const std::string& pile, std::uint32_t seed, const Task& task) {
                      return peers::run_pile(setting, peers::pile(pile, false, seed), task.until, task.most);
                    }});
  if (!options.peers) return list;
  for (const PeerProgram& peer : peer_programs({"bullet", "ode", "mujoco", "box2d"}, "contacts", "piles"))
    for (const std::string& setting : peer.settings) {
      if (first_settings && setting != peer.settings.front()) continue;
      list.push_back(
          {peer.label, setting, [peer, setting](const std::string& pile, std::uint32_t seed, const Task& task) {
             return run_peer(peer, setting, pile, seed, task);
           }});
    }
  return list;
}

void print_trial(const std::string& name, const peers::PileTrial& t, double until) {
  std::printf("%-26s", name.c_str());
  if (!t.trouble.empty()) {
    std::printf(" %s\n", t.trouble.c_str());
    return;
  }
  for (const peers::Stretch& s : {t.moving, t.rest})
    std::printf(" %6s %8s %7s %8s |", number("%.0f", s.contacts).c_str(), number("%.1f", s.step / 1e3).c_str(),
                number("%.0f", s.per_contact()).c_str(), number("%.1e", s.overlap).c_str());
  std::printf(" %7s %8s %8.1e %8s", std::isinf(t.settled) ? "never" : number("%.2f", t.settled).c_str(),
              number("%.1e", t.creep).c_str(), t.rise, t.gap > 0 ? number("%.1e", t.gap).c_str() : "-");
  if (t.unsolved > 0) std::printf("  %.0f islands unsolved", t.unsolved);
  if (t.simulated < until) std::printf("  stopped at %.2f s", t.simulated);
  std::printf("\n");
}

/// What falls by chance falls several times.
peers::PileTrial run_falls(const Contender& contender, const std::string& pile, const Task& task) {
  const std::string kind = pile.substr(0, pile.find('('));
  const std::uint32_t falls = kind == "stack" || kind == "pyramid" ? 1 : task.falls;
  std::vector<peers::PileTrial> trials;
  for (std::uint32_t seed = 1; seed <= falls; seed++) {
    show_progress(text(pile, ": ", contender.name(), falls > 1 ? text(", fall ", seed) : ""));
    trials.push_back(contender.run(pile, seed, task));
    show_progress("");
    if (!trials.back().trouble.empty()) break;
  }
  return peers::together(trials);
}

Result run_case(const std::string& pile, const std::vector<Contender>& contenders, const Task& task) {
  const peers::Mechanism made = peers::pile(pile);
  std::printf("\n%s: %zu bodies, %zu joints\n", pile.c_str(), made.solids.size(), made.joints.size());
  std::printf("%-26s %33s | %33s | %7s %8s %8s %8s\n", "", "in motion", "at rest", "", "", "", "");
  std::printf("%-26s", "");
  for (int i = 0; i < 2; i++) std::printf(" %6s %8s %7s %8s |", "points", "us/step", "ns each", "deep, m");
  std::printf(" %7s %8s %8s %8s\n", "settled", "creep, m", "rise, J", "gap, m");
  Result result{pile, {}};
  for (const Contender& contender : contenders) {
    result.trials.push_back(run_falls(contender, pile, task));
    print_trial(contender.name(), result.trials.back(), task.until);
    std::fflush(stdout);
  }
  return result;
}

/// A table for a page: a line for each case, a column for each engine.
void print_summary(const char* title, const std::vector<Result>& results, const std::vector<Contender>& contenders,
                   const std::function<std::string(const peers::PileTrial&)>& cell) {
  std::printf("\n| %s |", title);
  for (const Contender& contender : contenders) std::printf(" %s |", contender.name().c_str());
  std::printf("\n| --- |");
  for (std::size_t i = 0; i < contenders.size(); i++) std::printf(" --- |");
  std::printf("\n");
  for (const Result& result : results) {
    std::printf("| %s |", result.pile.c_str());
    for (const peers::PileTrial& t : result.trials) std::printf(" %s |", t.trouble.empty() ? cell(t).c_str() : "-");
    std::printf("\n");
  }
}

void print_summaries(const std::vector<Result>& results, const std::vector<Contender>& contenders) {
  using Trial = peers::PileTrial;
  const auto both = [](const char* format, const Trial& t, double moving, double rest) {
    if (t.simulated < peers::pile_moves) return number(format, moving) + number(" until %.1f s", t.simulated);
    return number(format, moving) + "; " + number(format, rest);
  };
  print_summary("ns per contact and step, in motion; at rest", results, contenders,
                [&](const Trial& t) { return both("%.0f", t, t.moving.per_contact(), t.rest.per_contact()); });
  print_summary("creep at rest, m", results, contenders, [](const Trial& t) { return number("%.0e", t.creep); });
  print_summary("overlap in motion; at rest, m", results, contenders,
                [&](const Trial& t) { return both("%.0e", t, t.moving.overlap, t.rest.overlap); });
  print_summary("largest rise of the energy in a step, J", results, contenders,
                [](const Trial& t) { return number("%.0e", t.rise); });
}

void write(const char* path, const std::string& content) {
  std::ofstream file(path);
  file << content;
  file.close();
  require(file.good(), "cannot write ", path);
  std::printf("written: %s\n", path);
}

std::string csv(const std::vector<Result>& results, const std::vector<Contender>& contenders) {
  std::ostringstream file;
  file << "case,engine,setting";
  for (const auto& [name, value] : peers::PileTrial().numbers()) file << ',' << name;
  file << ",trouble\n";
  for (const Result& result : results)
    for (std::size_t i = 0; i < contenders.size(); i++) {
      peers::PileTrial trial = result.trials[i];
      file << result.pile << ',' << contenders[i].engine << ',' << contenders[i].setting;
      for (const auto& [name, value] : trial.numbers()) file << ',' << *value;
      file << ",\"" << trial.trouble << "\"\n";
    }
  return file.str();
}

/// Cost against creep of each case, or against the number of bodies of cases that differ in that alone.
std::vector<player::Plot> plots_of(const std::vector<Result>& results, const std::vector<Contender>& contenders,
                                   bool grows) {
  std::vector<player::Plot> plots;
  for (const Result& result : results) {
    const std::string kind = result.pile.substr(0, result.pile.find('('));
    if (!grows || plots.empty() || plots.back().title != kind) {
      plots.push_back(grows ? player::Plot{kind, "bodies", "us per step in motion", {}}
                            : player::Plot{result.pile, "us per step at rest", "creep at rest, m", {}});
      for (const Contender& contender : contenders) plots.back().series.push_back({contender.name(), {}});
    }
    for (std::size_t i = 0; i < contenders.size(); i++) {
      const peers::PileTrial& t = result.trials[i];
      if (!t.trouble.empty()) continue;
      const auto bodies = static_cast<double>(peers::pile(result.pile).solids.size());
      plots.back().series[i].points.push_back(grows ? std::pair{bodies, t.moving.step / 1e3}
                                                    : std::pair{t.rest.step / 1e3, t.creep});
    }
  }
  return plots;
}

Task task_of(const std::vector<std::string>& arguments) {
  Task task;
  task.cases = arguments;
  if (arguments.empty()) {
    task.cases = peers::usual_piles();
    task.most = short_seconds;
  } else if (arguments.size() == 1 && arguments[0] == "all") {
    task.cases = peers::usual_piles();
    task.cases.push_back("boxes(1000)");
  } else if (arguments.size() == 1 && arguments[0] == "growth") {
    task = {{}, peers::pile_moves, growth_seconds, 1, true};
    for (const char* kind : {"boxes", "balls"})
      for (const int n : {100, 300, 1000, 3000}) task.cases.push_back(text(kind, "(", n, ")"));
  }
  for (const std::string& name : task.cases) peers::pile(name);
  return task;
}

/// Random islands or pairs of shapes, which another program judges.
void judge(const std::string& program, const std::string& what) {
  for (const PeerProgram& judge : peer_programs({program}, "contacts", what))
    for (const std::string& line : judge.settings) std::printf("%s\n", line.c_str());
}

void bench_contacts(const player::BenchOptions& options) {
  if (options.arguments == std::vector<std::string>{"islands"}) return judge("siconos", "islands");
  if (options.arguments == std::vector<std::string>{"shapes"}) return judge("libccd", "shapes");
  const Task task = task_of(options.arguments);
  const std::vector<Contender> contenders = contenders_of(options, task.grows);
  std::printf(
      "1/%g s, friction %g, nothing sleeps, one thread; time of the processor. In motion: until %g s; at rest: from %g "
      "s\n"
      "to %g s, over which centres creep. points: of contact, as each engine counts them (Pantin and Bullet also some "
      "that\n"
      "are open by less than a margin). deep: the deepest overlap, by Pantin's shapes at the poses of each engine. "
      "rise: the\n"
      "largest of the energy in a step. settled: when all centres stay below %g m/s. Box2D: the same in a plane. What "
      "falls\n"
      "into a bin does so %u times, differently: means of times and points, the largest of the rest. Each fall may use "
      "%g s\n",
      peers::pile_rate, peers::friction, peers::pile_moves, peers::pile_rests, peers::pile_end, peers::still,
      task.falls, task.most);
  std::vector<Result> results;
  for (const std::string& pile : task.cases) results.push_back(run_case(pile, contenders, task));
  print_summaries(results, contenders);
  std::printf("\n");
  write(table, csv(results, contenders));
  write(picture, player::draw_plots(plots_of(results, contenders, task.grows), task.grows ? 2 : 3));
}

const player::Register registered(
    {"contacts",
     "cost and rest of what touches; with --peers, other engines too; arguments: cases, as "
     "boxes(300), or all, or growth, or islands or shapes (random ones, judged by Siconos and by libccd)",
     bench_contacts});

}  // namespace
