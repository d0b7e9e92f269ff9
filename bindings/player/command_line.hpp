#pragma once
// What the program can be asked for: its commands, their options, help and checks.
#include <string>
#include <vector>

#include "player/options.hpp"

namespace CLI {
class App;
}

namespace pantin::player {

/// What is read after the command line as a whole is known to be right.
struct Texts {
  std::vector<std::string> settings;
  std::string size, memory, views;
};

/// All commands; their values go into `options` and `texts`.
void add_commands(CLI::App& app, Options& options, Texts& texts);

}  // namespace pantin::player
