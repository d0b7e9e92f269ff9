#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "player/options.hpp"

namespace pantin::player {

/// What is left to a process that runs a scene of a stranger.
struct Reach {
  std::vector<std::string> read;   ///< files, and folders with all in them; one that is not there is left out
  std::vector<std::string> write;  ///< files to write to, and folders to make, replace and remove files in
  std::size_t memory = 0;          ///< [bytes] that it may take beyond what it has
  int threads = 1;                 ///< that run laws
  bool draws = false;              ///< by drivers, which start threads and share memory as they need
};

/// What a scene needs: its folder, the program's own files, the folders of what it is to write.
Reach reach_of(const RunOptions& options, const std::string& scene, const std::string& home);
/// The same, and what drivers need to draw: the system's libraries, and the graphics card.
Reach reach_of_window(const RunOptions& options, const std::string& scene, const std::string& home);

/// From here on this thread and all that it starts reach no other file, no socket, no other program or process, and write
/// no file above 4 GiB. Its threads are started before, and none after; of what draws at most 256. A line for each of them
/// that the kernel cannot hold back.
std::vector<std::string> hold_back(const Reach& reach);
/// The same; the lines go to standard error.
void confine(const Reach& reach);

}  // namespace pantin::player
