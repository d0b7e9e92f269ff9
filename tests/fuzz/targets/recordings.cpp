// Recordings: what can be read of one is played again, and ends; its lines are written as they are read.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/check.hpp"
#include "player/recording.hpp"
#include "player/replay.hpp"

using namespace pantin;
using namespace pantin::player;

namespace {

const char* const home = std::getenv("PANTIN_HOME");

const std::string& file() {
  static const std::string path =
      std::filesystem::temp_directory_path() / ("pantin_recording_" + std::to_string(getpid()) + ".json");
  return path;
}

void check_lines(const Recording& recording) {
  for (const RecordedAct& act : recording.acts) {
    const std::string line = line_of(act);
    if (line_of(act_of(line)) != line) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::ofstream(file(), std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  RunOptions options;
  options.script_limit = 0.5;
  options.memory_limit = std::size_t{256} << 20;
  options.threads = 1;
  options.headless = true;
  try {
    const Recording recording = read_recording(file());
    check_lines(recording);
    Replay replay(recording, options, home);
    for (int i = 0; i < 20 && replay.step(); i++) {}
  } catch (const Error&) {}
  return 0;
}
