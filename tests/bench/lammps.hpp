#pragma once
#include <string>

namespace pantin {

/// Those of its benchmark: built in every 20th step, whether atoms have moved out of the skin or not.
inline constexpr const char* lammps_blind_lists = "delay 0 every 20 check no";
/// Built when an atom has moved half the skin.
inline constexpr const char* lammps_safe_lists = "delay 0 every 1 check yes";

/// Runs LAMMPS' melt of 32,000 atoms for 100 steps with a skin of 0.3; gives its processor time of the steps [s].
/// `suffix`: "" or "opt". Throws Error where LAMMPS cannot run it.
double run_lammps(const std::string& suffix, const std::string& lists);

}  // namespace pantin
