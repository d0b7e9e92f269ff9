#pragma once

namespace pantin::player {

/// The whole program: reads the command line, does the command, prints errors. Returns the exit code: 0 fine, 1 the scene
/// or a test failed, 2 wrong usage.
int run_program(int argc, const char* const* argv);

}  // namespace pantin::player
