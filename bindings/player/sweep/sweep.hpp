#pragma once
// `pantin sweep`: a scene once for each combination of its parameters' values, or for those of a search, into one table.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "player/sweep/best.hpp"

namespace pantin::player {

struct SweepOptions {
  std::string scene;                                ///< a path or a shipped scene's name
  std::vector<std::string> settings;                ///< "links=10:1000:20", "ratio=1,1e3,1e6", "scene.step=1/60,1/240"
  std::string seeds;                                ///< "1:100" or "1,5,9"; empty: the scene's own
  std::optional<double> until;                      ///< [s] simulated; else the scene's duration, else 10 s
  std::string out;                                  ///< the table, .csv
  std::uint64_t sample = 0;                         ///< cases of a Latin hypercube, or of a search; 0: the grid
  Wanted wanted;                                    ///< what is searched for
  bool retry_failed = false;                        ///< cases that failed are run again, others are not
  bool overwrite = false;                           ///< a table that is there may be lost
  bool untrusted = false;                           ///< each process is confined
  int jobs = 0;                                     ///< processes; 0: as many as there are processors
  bool timed = false;                               ///< with a column of processor time, which differs from run to run
  double script_limit = 5.0;                        ///< [s] 0: none
  std::size_t memory_limit = std::size_t{2} << 30;  ///< [bytes] of a process
};

/// What is finished stays in a journal beside the table, so that the same sweep goes on where it was stopped. Returns the
/// exit code: 1 where it was stopped; a case that fails is a row with its error. Throws UsageError and Error.
int sweep(const SweepOptions& options, const std::string& home);

}  // namespace pantin::player
