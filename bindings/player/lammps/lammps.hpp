#pragma once
// Scenes of particles for LAMMPS.
#include <map>
#include <optional>
#include <string>

#include "scene/options.hpp"

namespace pantin::player {

struct LammpsOptions {
  std::string folder;      ///< for its files; of `lammps` empty: the state's name without its ending
  std::string out;         ///< the state that is brought back; empty: the scene's name and -lammps.pantin
  std::string dump;        ///< that LAMMPS wrote elsewhere, to be brought back; empty: it is run
  int ranks = 0;           ///< processes; 0: one for each processor
  double error = 1e-6;     ///< of tables, see TableWish
  bool overwrite = false;  ///< a state that is there may be lost
};

/// The scene that is meant, how it is opened, and the time at which the run is to end [s]; none: the scene's duration.
struct LammpsScene {
  std::string path;  ///< a scene's file, or a state's
  SceneOptions options;
  std::optional<double> until;
  std::string given;  ///< as it was named on the command line
};

/// `pantin export SCENE --lammps FOLDER`: writes what `lmp` runs. Returns the exit code; throws UsageError, Error.
int export_lammps(const LammpsOptions& options, const LammpsScene& scene);
/// `pantin lammps SCENE`: has `lmp` run it, and saves where all is then as a state of the scene; with a dump that alone.
int run_lammps(const LammpsOptions& options, const LammpsScene& scene);

}  // namespace pantin::player
