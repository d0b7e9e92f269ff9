#pragma once
#include <string>

namespace pantin {

/// Runs LAMMPS' melt of 32,000 atoms for 100 steps, with the lists of its benchmark (skin 0.3, built in every 20th step);
/// gives its processor time of the steps [s]. `suffix`: "" or "opt". Throws Error where LAMMPS cannot run it.
double run_lammps(const std::string& suffix);

}  // namespace pantin
