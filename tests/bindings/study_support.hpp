#pragma once
// The study that a report tells of, of scenes given as text.
#include <cmath>
#include <stdexcept>
#include <string>

#include "player/report.hpp"
#include "support/process.hpp"

namespace pantin::player {

/// Within `budget` [s] of processor time.
inline Study study_text(const std::string& source, double until, double budget = 5.0) {
  const support::Folder folder;
  support::write_file(folder / "scene.lua", source);
  RunOptions options;
  options.scene = folder / "scene.lua";
  options.until = until;
  return study(options, folder.path, budget, [](const std::string&, double) {});
}

inline const StudyRun& run_of(const Study& study, const std::string& integrator, double step) {
  for (const StudyRun& run : study.runs)
    if (run.integrator == integrator && run.accuracy == 0.0 && std::fabs(run.step - step) < 1e-12) return run;
  throw std::runtime_error("there is no such run");
}

}  // namespace pantin::player
