#include "bench/lammps.hpp"

#include <cstdlib>

#include "base/check.hpp"
#include "support/process.hpp"

namespace pantin {

namespace {

constexpr const char* melt = R"(units lj
atom_style atomic
lattice fcc 0.8442
region box block 0 20 0 20 0 20
create_box 1 box
create_atoms 1 box
mass 1 1.0
velocity all create 1.44 87287 loop geom
pair_style lj/cut 2.5
pair_coeff 1 1 1.0 1.0 2.5
neighbor 0.3 bin
neigh_modify )";

constexpr const char* run_of_melt = R"(
fix 1 all nve
run 100
)";

double number_before(const std::string& out, const std::string& what) {
  const std::size_t end = out.find(what);
  require(end != std::string::npos, "LAMMPS does not tell '", what, "'");
  const std::size_t line = out.rfind('\n', end) + 1;
  return std::strtod(out.c_str() + line, nullptr);
}

}  // namespace

double run_lammps(const std::string& suffix, const std::string& lists) {
  const support::Folder folder;
  support::write_file(folder / "in.melt", melt + lists + run_of_melt);
  std::vector<std::string> arguments = {"lmp", "-in", "in.melt", "-log", "none"};
  if (!suffix.empty()) arguments.insert(arguments.end(), {"-sf", suffix});
  const support::Finished ended = support::finish({arguments, {"OMP_NUM_THREADS=1"}, folder.path, -1});
  require(ended.code == 0, "LAMMPS ended with ", ended.code, ": ", ended.out, ended.err);
  const std::size_t time = ended.out.find("Loop time of ");
  require(time != std::string::npos, "LAMMPS does not tell its time");
  return std::strtod(ended.out.c_str() + time + 13, nullptr) * 0.01 * number_before(ended.out, "% CPU use");
}

}  // namespace pantin
