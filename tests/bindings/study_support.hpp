#pragma once
// The study that a report tells of, of scenes given as text.
#include <string>

#include "player/report.hpp"
#include "support/process.hpp"

namespace pantin::player {

inline Study study_text(const std::string& source, double until) {
  const support::Folder folder;
  support::write_file(folder / "scene.lua", source);
  RunOptions options;
  options.scene = folder / "scene.lua";
  options.until = until;
  return study(options, folder.path, 5.0, [](const std::string&, double) {});
}

}  // namespace pantin::player
