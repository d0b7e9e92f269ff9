#pragma once
// What goes wrong with a scene, whatever language it is written in.
#include <string>

#include "base/check.hpp"
#include "world/queue.hpp"

namespace pantin {

/// The command line was wrong (exit code 2).
struct UsageError : Error {
  using Error::Error;
};

/// A script's error; its text starts with "file.lua:line: ".
struct ScriptError : Error {
  using Error::Error;
};

/// A script was stopped because the program is to end.
struct Interrupted : ScriptError {
  using ScriptError::ScriptError;
};

/// A removed thing was used; the text is its story.
struct StaleHandle : Gone {
  using Gone::Gone;
};

/// Whether a message begins with a file and line, "scene.lua:12: ".
bool names_place(const std::string& message);

}  // namespace pantin
