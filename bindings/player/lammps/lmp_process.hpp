#pragma once
// LAMMPS as a program that runs beside this one.
#include <functional>
#include <string>
#include <vector>

namespace pantin::player {

/// What `lmp` there is.
struct LmpVersion {
  std::string name;      ///< "29 Sep 2021 - Update 2"
  int date = 0;          ///< 20210929
  std::string packages;  ///< that it was built with, each between spaces
};
/// Throws Error, with what to install, where there is none or it is too old, and where mpirun does not start so many processes.
LmpVersion check_lmp(int ranks);
/// Throws Error where it was built without a package that is needed.
void require_package(const LmpVersion& version, const char* package);

/// Runs in.scene of a folder on some processes, by mpirun where these are more than one. `tell` is called with each line that
/// LAMMPS prints. Throws Error with what went wrong, and where its log is; Interrupted where Ctrl-C came.
void run_lmp(const std::string& folder, int ranks, const std::function<void(const std::string&)>& tell);

}  // namespace pantin::player
