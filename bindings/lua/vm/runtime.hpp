#pragma once
// A Lua state with its limits of time and memory.
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/random.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/prototypes.hpp"
#include "lua/vm/small_blocks.hpp"
#include "lua/vm/watchdog.hpp"
#include "scene/files.hpp"
#include "scene/options.hpp"

namespace pantin::lua {

class LawRun;

/// What a state begins with.
struct Opener {
  void (*open)(lua_State* state);  ///< gives it what a script finds
  lua_CFunction describe_error;    ///< message handler: makes a text of any error
};

/// [bytes] What Lua's own functions go once over, asking no clock, takes a fraction of a second then.
inline constexpr std::size_t longest_string = std::size_t{64} << 20;

/// [bytes] The largest files that are read, of data and of code, and the longest line of numbers: what asks no clock takes
/// a fraction of a second then.
inline constexpr std::size_t largest_file = std::size_t{256} << 20, largest_source = std::size_t{16} << 20,
                             longest_line = std::size_t{1} << 20;

struct Limits {
  double seconds = 0.0;   ///< [s] of one call into the script; 0: none
  std::size_t bytes = 0;  ///< of Lua's memory
};

class Runtime {
 public:
  Runtime(Limits limits, const Opener& opener);
  ~Runtime();
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;

  static Runtime& of(lua_State* state) { return **static_cast<Runtime**>(lua_getextraspace(state)); }
  /// The innermost runtime whose script runs on this thread, or null.
  static Runtime* current();

  /// Runs `body(state)` protected and within the limits. Errors of Lua leave as ScriptError, Interrupted, StaleHandle or UsageError;
  /// exceptions of C++ leave as they are.
  template <class Body>
  void run(Body&& body) {
    Job job{&body, [](void* b, lua_State* state) { (*static_cast<std::remove_reference_t<Body>*>(b))(state); }, {}};
    run_job(job);
  }
  /// Pushes the chunk of a text; `name` is what messages call it.
  void load(lua_State* state, const std::string& source, const std::string& name);
  /// All of a file, which `on_read` is told and `files` keeps, or null where it cannot be read. Throws Error where it has
  /// more than `largest` bytes, or than a quarter of the memory: who is told may keep it, too, and so may what is made of it.
  const std::string* read(const std::string& path, std::size_t largest);

  /// How often scripts ran.
  std::uint64_t runs() const { return runs_; }
  /// The state that runs: the main one, or a coroutine.
  lua_State* active() const { return watch_.running.load(std::memory_order_relaxed); }
  Watch& watch() { return watch_; }

  FileReader reader = file_content;
  std::function<void(const FileRead&)> on_read;    ///< told each file that is read; may be empty
  std::function<void(const std::string&)> notice;  ///< told what a script should know once; may be empty
  std::string name;                                ///< of the scene's file, as messages call it
  std::string folder;                              ///< of the scene: where `require` looks first, and `read_table`
  std::string home;                                ///< holds scripts/lib and scripts/behaviours
  Random* random = nullptr;                        ///< source of math.random
  lua_Integer shown = 0;                           ///< values that were given a number to be shown by
  LawRun* law = nullptr;                           ///< the law whose function runs, or null
  bool speaks_of_reset = false;                    ///< some file has the word: the start of the scene is to be kept
  std::vector<SourceText> chunks;                  ///< texts that were loaded so far
  std::map<std::string, std::string> files;        ///< that were read, by their paths
  std::uint64_t traces = 0;                        ///< that were begun so far
  std::string stale_message;                       ///< text of the last error that a StaleHandle became
  std::string usage_message;                       ///< text of the last error that a UsageError became
  std::string
      broken_off;  ///< the first error of a removed thing that ended what an event did, or could ask; empty: none

 private:
  struct Job {
    void* body;
    void (*call)(void*, lua_State*);
    std::exception_ptr thrown;
  };
  static int start(lua_State* state);
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  /// Memory for what was `old_size` bytes (0: nothing), see lua_Alloc; null where there is none.
  void* take(void* block, std::size_t old_size, std::size_t new_size);
  void give_back(void* block, std::size_t size);
  void run_job(Job& job);
  [[noreturn]] void fail(lua_State* state, int status);

  Limits limits_;
  lua_CFunction describe_error_;
  std::uint64_t runs_ = 0;
  std::size_t bytes_ = 0;
  SmallBlocks small_;
  struct Refused {
    std::string at;  ///< place in the script
    bool is_long_string = false;
  };
  Refused refused_;  ///< memory, the last time
  lua_State* main_ = nullptr;
  Watch watch_;
};

/// Makes the table at the top one with weak keys (`mode` "k") or values ("v"). No `__mode` of a script makes one: what it has
/// lost would depend on the memory of the run.
void make_weak(lua_State* state, const char* mode);

/// Pushes the chunk of a text.
void load_text(lua_State* state, const SourceText& chunk);

/// While it lives, the time of the script that is running does not count: the engine is at work.
class Outside {
 public:
  Outside();
  ~Outside();
  Outside(const Outside&) = delete;
  Outside& operator=(const Outside&) = delete;

 private:
  Runtime* paused_;
  std::int64_t left_ = 0;  ///< [ns]
};

}  // namespace pantin::lua
