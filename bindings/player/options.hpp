#pragma once
// What the command line says.
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "player/fuzz.hpp"
#include "player/lammps/lammps.hpp"
#include "player/plot_table.hpp"
#include "player/soak.hpp"
#include "player/sweep/sweep.hpp"
#include "player/table.hpp"
#include "scene/options.hpp"
#include "view/views.hpp"

namespace pantin::player {

inline constexpr const char* state_ending = ".pantin";

struct Size {
  int width = 1280;  ///< [pixels]
  int height = 720;  ///< [pixels]
};

/// What `play` and `run` share.
struct RunOptions {
  std::string scene;         ///< a path or a shipped scene's name; of `play` empty: the browser
  std::string scenes = ".";  ///< a folder of one's own, for the browser
  std::map<std::string, std::string> set;
  std::optional<double> until;  ///< [s] >= 0
  std::vector<std::string> outputs;
  TableRows table;                ///< of the .csv among them
  std::string summary;            ///< empty: none
  std::string from;               ///< file of a state that `run` and `play` go on from; empty: none
  std::optional<double> save_at;  ///< [s] when `run` saves the state
  std::string save_to;            ///< the file for that
  Size size;
  Views views;                                      ///< that are on at the start
  std::string record;                               ///< file that `play` records to; empty: none
  bool paused = false;                              ///< `play` and `replay` begin with a pause
  bool headless = false;                            ///< `replay` opens no window
  double script_limit = 5.0;                        ///< [s] 0: none
  std::size_t memory_limit = std::size_t{2} << 30;  ///< [bytes]
  int threads = 0;                                  ///< 0: as many as the machine has processors
  bool untrusted = false;                           ///< the process is confined before it reads the script
};

struct Options {
  enum class Command {
    none,
    play,
    run,
    replay,
    report,
    test,
    fuzz,
    soak,
    sweep,
    plot,
    lammps,
    export_scene,
    bench,
    meta
  };
  Command command = Command::none;
  RunOptions run;
  std::vector<std::string> arguments;  ///< paths to test, or a benchmark and its arguments
  bool peers = false;                  ///< of `bench`
  FuzzOptions fuzz;
  SoakOptions soak;
  SweepOptions sweep;
  PlotOptions plot;
  LammpsOptions lammps;
  std::string prefix;  ///< of the files that `report` writes; empty: after the scene
};

/// Reads the command line. Help and version are printed and leave Command::none; wrong use throws UsageError.
Options read_options(int argc, const char* const* argv);

/// A page for `man` of all commands.
std::string manual_page();
/// A script by which bash completes them, and the names of shipped scenes.
std::string bash_completion(const std::vector<std::string>& scenes);

/// How the scene is to be opened.
SceneOptions scene_options(const RunOptions& options, const std::string& home);

/// Reads "1280x720"; throws UsageError.
Size read_size(const std::string& text);
/// Reads "512MiB" as bytes, at least 1 MiB; throws UsageError.
std::size_t read_bytes(const std::string& text);

}  // namespace pantin::player
