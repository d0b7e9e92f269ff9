#include "bench/peer_programs.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>

#include "support/process.hpp"

namespace pantin {

std::vector<PeerProgram> peer_programs(const std::vector<std::string>& names, const std::string& bench,
                                       const std::string& list_command) {
  static const std::map<std::string, std::string> labels = {
      {"bullet", "Bullet"}, {"ode", "ODE"},         {"simbody", "Simbody"}, {"mujoco", "MuJoCo"},
      {"box2d", "Box2D"},   {"siconos", "Siconos"}, {"libccd", "libccd"}};
  std::vector<PeerProgram> list;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const std::string& name : names) {
    PeerProgram peer{labels.at(name), folder / ("pantin_peer_" + name), {}};
    if (!std::filesystem::exists(peer.path)) {
      std::printf("%s is not here: ./pantin bench %s --peers installs and builds it\n", peer.label.c_str(),
                  bench.c_str());
      continue;
    }
    std::istringstream lines(support::finish({{peer.path, list_command}, {}, "", -1}).out);
    for (std::string line; std::getline(lines, line);) peer.settings.push_back(line);
    list.push_back(peer);
  }
  return list;
}

void show_progress(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r\033[K%s", what.c_str());
  std::fflush(stderr);
}

std::string number(const char* format, double x) {
  if (!std::isfinite(x)) return "-";
  char digits[32];
  std::snprintf(digits, sizeof digits, format, x);
  return digits;
}

}  // namespace pantin
