#pragma once
// `pantin test fuzz`: random scenes, and whether they keep what is promised of all scenes.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pantin::player {

inline constexpr const char* unopened = "cannot be opened";

struct FuzzOptions {
  double seconds = 60.0;  ///< [s] of real time; a scene that is begun is finished, and there is one
  std::uint64_t seed = 1;
  std::string folder;  ///< for what is found; empty: tests/corpus of the program's folder
  std::vector<std::string>
      files;  ///< scenes to look at in place of random ones; what is found or cannot be opened is told alone
};

/// What a scene does not keep; nothing found has no kind, and what stops with an error before its first step is `unopened`.
struct Find {
  /// "crash", "slow", "exception", "not_finite", "repeat", "threads", "snapshot", "save", "gap", "energy", "ledger".
  std::string kind;
  std::string text;
};

/// The text of a random scene, one statement a line; `home` holds tests/fuzz.
std::vector<std::string> random_scene(std::uint64_t seed, const std::string& home);
/// A scene's whole text.
std::string fuzz_source(const std::vector<std::string>& statements);
/// Runs a scene several times, in a process of its own that may crash; it is forked, so this process must have no thread
/// but this one.
Find examine(const std::string& source, const std::string& home);
/// Leaves statements out as long as `fails` says yes of the rest; what is left needs each of its statements, unless
/// `seconds` of real time are over.
std::vector<std::string> smallest(std::vector<std::string> statements,
                                  const std::function<bool(const std::vector<std::string>&)>& fails, double seconds);

/// Returns the exit code: 1 if something was found, or a file could not be opened.
int fuzz(const FuzzOptions& options, const std::string& home);

}  // namespace pantin::player
