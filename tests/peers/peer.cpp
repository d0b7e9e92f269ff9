#include "peers/peer.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

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

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "list") == 0) {
    for (const Setting& setting : settings())
      std::printf("%s%s\n", setting.chooses_steps ? "*" : "", setting.name.c_str());
    return 0;
  }
  if (argc != 7 || std::strcmp(argv[1], "run") != 0) return 2;
  run(argv[2], argv[3], std::atof(argv[4]), {std::atof(argv[5]), std::atof(argv[6])});
  return 0;
}
