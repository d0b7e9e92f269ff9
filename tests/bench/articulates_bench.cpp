// `pantin bench articulates [CASE…]`: speed against error of the hard cases; with --peers, in the other engines too.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>

#include "base/check.hpp"
#include "bench/pantin_rig.hpp"
#include "bench/peer_programs.hpp"
#include "player/bench.hpp"
#include "player/plot.hpp"
#include "support/process.hpp"
#include "support/reference.hpp"

using namespace pantin;

namespace {

constexpr std::array rates = {10.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0};
constexpr std::array wanted = {1e-2, 1e-3, 1e-6};  // [m]
constexpr std::array wanted_names = {"1 cm", "1 mm", "1 um"};
constexpr const char* picture = "articulates.svg";

/// One setting of an engine at one step.
struct Tried {
  std::string setting;
  double rate = 0.0;
  peers::Trial trial;
};

/// An engine and how to try it.
struct Contender {
  std::string name;
  std::vector<std::string> settings;  ///< "*" before one that chooses its steps
  std::function<peers::Trial(const std::string& setting, const peers::Mechanism&, double rate, const Eigen::Vector2d&)>
      run;
};

reference::PlaneChain plane(const peers::Mechanism& mechanism) {
  const int solids = static_cast<int>(mechanism.solids.size());
  if (mechanism.joints.size() > mechanism.solids.size()) return reference::plane_ring(solids);
  const double last = mechanism.solids.back().mass;
  return last == 1.0 ? reference::plane_chain(solids) : reference::heavy_plane_chain(solids - 1, last);
}

struct Place {
  Eigen::Vector2d at;      ///< [m] of the measured body at compare_at
  double uncertain = 0.0;  ///< [m] how much it changes when the reference's pieces are halved
};

Place reference_place(const peers::Mechanism& mechanism) {
  const reference::PlaneChain chain = plane(mechanism);
  const double stiff = chain.links.back().mass > 1e4 ? 10.0 : 1.0, many = chain.links.size() > 50 ? 0.2 : 1.0;
  const int pieces = static_cast<int>(mechanism.compare_at * 300 * stiff * many);
  const auto with = [&](int n) {
    return reference::centre(chain, reference::advance(chain, mechanism.compare_at, n), mechanism.measured);
  };
  const Eigen::Vector2d fine = with(pieces);
  return {fine, (fine - with(pieces / 2)).norm()};
}

std::vector<Contender> own_contenders() {
  std::vector<Contender> list = {{"Pantin", {}, {}}, {"Pantin + return", {}, {}}};
  for (const peers::Setting& setting : pantin_settings())
    list[setting.name.ends_with("return") ? 1 : 0].settings.push_back((setting.chooses_steps ? "*" : "") +
                                                                      setting.name);
  for (Contender& contender : list)
    contender.run = [](const std::string& name, const peers::Mechanism& mechanism, double rate,
                       const Eigen::Vector2d& position) {
      const std::vector<peers::Setting> all = pantin_settings();
      const auto found = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
      return peers::run_trial(*found, mechanism, rate, position);
    };
  return list;
}

peers::Trial run_peer(const std::string& program, const std::string& setting, const peers::Mechanism& mechanism,
                      double rate, const Eigen::Vector2d& position) {
  const auto exact = [](double x) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", x);
    return std::string(digits);
  };
  const support::Finished ended = support::finish(
      {{program, "run", setting, mechanism.name, exact(rate), exact(position.x()), exact(position.y())}, {}, "", -1});
  peers::Trial trial;
  if (std::sscanf(ended.out.c_str(), "%lf %lf %lf %lf", &trial.error, &trial.energy, &trial.gap, &trial.cost) != 4)
    trial.trouble = ended.code == 0 ? ended.out : text("ended with ", ended.code);
  return trial;
}

std::vector<Contender> peer_contenders() {
  std::vector<Contender> list;
  for (const PeerProgram& peer : peer_programs({"bullet", "ode", "simbody", "mujoco"}, "articulates", "list")) {
    Contender contender{peer.label, peer.settings, {}};
    contender.run = [program = peer.path](const std::string& setting, const peers::Mechanism& mechanism, double rate,
                                          const Eigen::Vector2d& position) {
      return run_peer(program, setting, mechanism, rate, position);
    };
    list.push_back(contender);
  }
  return list;
}

/// From the longest step to where it is exact, or takes more than 0.3 s of the processor for one.
std::vector<Tried> try_all(const Contender& contender, const peers::Mechanism& mechanism, const Place& position) {
  std::vector<Tried> tried;
  for (const std::string& listed : contender.settings) {
    const bool chooses_steps = listed.front() == '*';
    const std::string setting = listed.substr(chooses_steps ? 1 : 0);
    for (const double rate : rates) {
      if (chooses_steps && rate > 60.0) continue;
      show_progress(text(mechanism.name, ": ", contender.name, ", ", setting, ", 1/", rate, " s"));
      tried.push_back({setting, rate, contender.run(setting, mechanism, rate, position.at)});
      const peers::Trial& trial = tried.back().trial;
      if (trial.trouble.empty() && (trial.error <= 1e-8 || trial.cost > 0.3)) break;
    }
  }
  show_progress("");
  return tried;
}

/// Those that nothing cheaper outdoes by being more exact, cheapest first. A run that loses more than all its energy is
/// no motion, wherever it ends.
std::vector<Tried> front(std::vector<Tried> tried) {
  std::erase_if(tried, [](const Tried& t) { return !t.trial.trouble.empty() || t.trial.energy > 1.0; });
  std::sort(tried.begin(), tried.end(), [](const Tried& a, const Tried& b) { return a.trial.cost < b.trial.cost; });
  std::vector<Tried> best;
  for (const Tried& t : tried)
    if (best.empty() || t.trial.error < 0.8 * best.back().trial.error) best.push_back(t);
  return best;
}

void print_tried(const std::string& name, const std::vector<Tried>& list) {
  for (const Tried& t : list)
    std::printf("%-16s %-24s 1/%-6g %10.4g %12s %10s %10s\n", name.c_str(), t.setting.c_str(), t.rate,
                1e3 * t.trial.cost, number("%.2e", t.trial.error).c_str(), number("%.1e", t.trial.energy).c_str(),
                number("%.1e", t.trial.gap).c_str());
  std::fflush(stdout);
}

void print_troubles(const std::string& name, const std::vector<Tried>& list) {
  std::string settings;
  for (const Tried& t : list)
    if (!t.trial.trouble.empty() || t.trial.energy > 1.0)
      settings += text(settings.empty() ? "" : ", ", t.setting, " 1/", t.rate);
  if (!settings.empty())
    std::printf("%-16s failed or gained more than all its energy: %s\n", name.c_str(), settings.c_str());
}

/// The least cost [s] per simulated second for errors up to `error` [m], or infinity.
double cheapest(const std::vector<Tried>& tried, double error) {
  double least = std::numeric_limits<double>::infinity();
  for (const Tried& t : tried)
    if (t.trial.error <= error) least = std::min(least, t.trial.cost);
  return least;
}

struct Case {
  peers::Mechanism mechanism;
  std::vector<std::vector<Tried>> fronts;  ///< (contenders)
};

void print_case(const Case& of, const std::vector<Contender>& contenders) {
  std::printf("%-16s %8s %8s %8s   CPU ms per simulated second of the cheapest setting for an error of ...\n", "",
              wanted_names[0], wanted_names[1], wanted_names[2]);
  for (std::size_t i = 0; i < contenders.size(); i++) {
    std::printf("%-16s", contenders[i].name.c_str());
    for (const double error : wanted) std::printf(" %8s", number("%.3g", 1e3 * cheapest(of.fronts[i], error)).c_str());
    std::printf("\n");
  }
  if (contenders.size() <= 2) return;
  for (const std::size_t own : {0u, 1u}) {
    std::printf("%-16s", text("peers / ", own == 0 ? "Pantin" : "return").c_str());
    for (const double error : wanted) {
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t i = 2; i < contenders.size(); i++) best = std::min(best, cheapest(of.fronts[i], error));
      const double mine = cheapest(of.fronts[own], error);
      std::printf(" %8s", std::isinf(best) && std::isfinite(mine) ? "alone" : number("%.3g", best / mine).c_str());
    }
    std::printf("\n");
  }
}

Case run_case(const peers::Mechanism& mechanism, const std::vector<Contender>& contenders) {
  const Place position = reference_place(mechanism);
  std::printf("\n%s: error of body %d at %g s (the reference is exact to %.0e m)\n", mechanism.name.c_str(),
              mechanism.measured + 1, mechanism.compare_at, position.uncertain);
  std::printf("%-16s %-24s %-8s %10s %12s %10s %10s\n", "", "", "step, s", "ms/s", "error, m", "energy", "gap, m");
  Case result{mechanism, {}};
  for (const Contender& contender : contenders) {
    const std::vector<Tried> tried = try_all(contender, mechanism, position);
    result.fronts.push_back(front(tried));
    print_tried(contender.name, result.fronts.back());
    print_troubles(contender.name, tried);
  }
  print_case(result, contenders);
  return result;
}

void draw(const std::vector<Case>& cases, const std::vector<Contender>& contenders) {
  std::vector<player::Plot> plots;
  for (const Case& of : cases) {
    player::Plot plot{
        of.mechanism.name, "CPU ms per simulated second", text("error at ", of.mechanism.compare_at, " s, m"), {}};
    for (std::size_t i = 0; i < contenders.size(); i++) {
      plot.series.push_back({contenders[i].name, {}});
      for (const Tried& t : of.fronts[i]) plot.series.back().points.emplace_back(1e3 * t.trial.cost, t.trial.error);
    }
    plots.push_back(plot);
  }
  std::ofstream file(picture);
  file << player::draw_plots(plots, 3);
  file.close();
  require(file.good(), "cannot write ", picture);
  std::printf("\nwritten: %s\n", picture);
}

std::vector<peers::Mechanism> chosen(const std::vector<std::string>& names) {
  const std::vector<peers::Mechanism> all = peers::mechanisms();
  if (names.empty()) return all;
  std::vector<peers::Mechanism> list;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& m) { return m.name == name; });
    std::string known;
    for (const peers::Mechanism& m : all) known += (known.empty() ? "'" : ", '") + m.name + "'";
    require(found != all.end(), "bench articulates: there is no case '", name, "'; there are ", known);
    list.push_back(*found);
  }
  return list;
}

void bench_articulates(const player::BenchOptions& options) {
  std::vector<Contender> contenders = own_contenders();
  if (options.peers)
    for (const Contender& peer : peer_contenders()) contenders.push_back(peer);
  std::printf(
      "CPU ms per simulated second, the best of up to ten runs until the time of comparison; energy: largest\n"
      "change in 5 s, relative to the largest kinetic energy (- where 5 s would take too long); of each engine the\n"
      "settings that no cheaper one outdoes\n");
  std::vector<Case> cases;
  for (const peers::Mechanism& mechanism : chosen(options.arguments)) cases.push_back(run_case(mechanism, contenders));
  draw(cases, contenders);
}

const player::Register registered({"articulates",
                                   "speed against error of the hard cases; with --peers, other engines too",
                                   bench_articulates});

}  // namespace
