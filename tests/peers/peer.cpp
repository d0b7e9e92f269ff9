#include "peers/peer.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "peers/pile_trial.hpp"
#include "peers/piles.hpp"

using namespace pantin::peers;

namespace {

template <class List>
auto* find(List& list, const char* name) {
  for (auto& one : list)
    if (one.name == name) return &one;
  std::fprintf(stderr, "there is no '%s'\n", name);
  std::exit(2);
}

void run(const char* setting_name, const char* mechanism_name, double rate, const Eigen::Vector2d& position) {
  const std::vector<Setting> all = settings();
  const std::vector<Mechanism> cases = mechanisms();
  const Setting& setting = *find(all, setting_name);
  const Mechanism& mechanism = *find(cases, mechanism_name);
  if (!setting.can(mechanism)) {
    std::printf("trouble: cannot do this\n");
    return;
  }
  const Trial trial = run_trial(setting, mechanism, rate, position);
  if (trial.trouble.empty())
    std::printf("%.17g %.17g %.17g %.17g\n", trial.error, trial.energy, trial.gap, trial.cost);
  else
    std::printf("trouble: %s\n", trial.trouble.c_str());
}

void list(const std::vector<Setting>& all) {
  for (const Setting& setting : all) std::printf("%s%s\n", setting.chooses_steps ? "*" : "", setting.name.c_str());
}

void run_one_pile(const char* setting_name, const char* pile_name, std::uint32_t seed, double until, double most) {
  const std::vector<Setting> all = pile_settings();
  const Setting& setting = *find(all, setting_name);
  const Mechanism mechanism = pile(pile_name, setting.in_plane, seed);
  if (!setting.can(mechanism)) {
    std::printf("trouble: too much for it\n");
    return;
  }
  PileTrial trial = run_pile(setting, mechanism, until, most);
  if (!trial.trouble.empty()) {
    std::printf("trouble: %s\n", trial.trouble.c_str());
    return;
  }
  for (const auto& [name, value] : trial.numbers()) std::printf("%.17g ", *value);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const auto asked = [&](const char* command, int count) {
    return argc == count && std::strcmp(argv[1], command) == 0;
  };
  if (asked("list", 2))
    list(settings());
  else if (asked("run", 7))
    run(argv[2], argv[3], std::atof(argv[4]), {std::atof(argv[5]), std::atof(argv[6])});
  else if (asked("piles", 2))
    list(pile_settings());
  else if (asked("pile", 7))
    run_one_pile(argv[2], argv[3], static_cast<std::uint32_t>(std::atoi(argv[4])), std::atof(argv[5]),
                 std::atof(argv[6]));
  else
    return 2;
  return 0;
}
