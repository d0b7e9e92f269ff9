#pragma once
#include <string>
#include <vector>

namespace pantin {

/// A program that runs another engine (peers/peer.hpp).
struct PeerProgram {
  std::string label, path;
  std::vector<std::string> settings;  ///< as it lists them
};

/// Those of these names ("bullet" …) that lie beside this program, with the settings that a command of theirs lists. Prints
/// which are missing, and which benchmark installs them.
std::vector<PeerProgram> peer_programs(const std::vector<std::string>& names, const std::string& bench,
                                       const std::string& list_command);

/// On a terminal, a line in place of the last one; empty: takes it away.
void show_progress(const std::string& what);

/// "-" where it is not finite.
std::string number(const char* format, double x);

}  // namespace pantin
