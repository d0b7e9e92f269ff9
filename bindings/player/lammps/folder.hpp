#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "player/lammps/system.hpp"
#include "scene/scene.hpp"

namespace pantin::player {

/// What LAMMPS is to do of a scene.
struct LammpsTask {
  std::string name;  ///< of the scene
  std::uint64_t steps = 0;
  std::uint64_t every = 1;         ///< steps from line to line
  double law_energy = 0.0;         ///< [J] of all laws here, at the beginning
  std::string back;                ///< the command that brings its end back; empty: none is told
  std::string set;                 ///< a line: the parameters of the scene
  std::vector<std::string> notes;  ///< what is done otherwise than here, a sentence each
};

/// A folder, made where it is not there, that no other export or run of LAMMPS writes to while this lives. Throws UsageError where one
/// does, and where it holds something else.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;
};

/// Writes a system as files that `lmp -in in.scene` reads in their folder: in.scene, scene.data, pair.table, bond.table,
/// laws.tables, laws.lepton.
void write_lammps(const std::string& folder, const World& world, const LammpsSystem& system, const LammpsTask& task);

/// The parameters of a folder's export where they are others; else empty.
std::string other_set_in(const std::string& folder, const std::string& set);

/// Renames what LAMMPS left of an export before, dumps and restarts, and returns the new names.
std::vector<std::string> set_results_aside(const std::string& folder);

}  // namespace pantin::player
