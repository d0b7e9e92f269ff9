#pragma once
// Stops a script that takes too much processor time of its thread, which what else runs on the machine does not
// lengthen. A hook in place would cost half the speed of tight loops, so one is set only when the time is up: a thread
// looks every few milliseconds and sends the script's thread a signal, whose handler sets the hook (the one thing Lua
// allows there). The hook raises at every instruction, so that `pcall` cannot swallow it.
#include <pthread.h>
#include <lua.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/interruptible.hpp"
#include "scene/memory.hpp"

namespace pantin::lua {

/// The clock of one runtime.
struct Watch {
  /// `bytes` may come to what the program holds now.
  explicit Watch(std::size_t bytes);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Begins a call that may take `seconds` of its thread's processor time (0: as long as it likes), counted from when the
  /// watchdog looks first, a few milliseconds later; nested calls share the time of the outermost. Returns the watch of this thread so far, to be given to `leave`.
  Watch* enter(lua_State* state, double seconds);
  void leave(Watch* previous);
  /// Moves to another coroutine, which meets its end too if the time is up.
  void switch_to(lua_State* state);
  /// [ns] left; stops the clock, not the watch over the memory, until `resume`.
  std::int64_t pause();
  void resume(std::int64_t left);

  std::atomic<double> limit{0.0};  ///< [s]
  std::atomic<lua_State*> running{nullptr};
  std::atomic<std::int64_t> deadline{0};      ///< [ns] of the thread's processor time; 0: no call is going on
  std::atomic<std::int64_t> ending_since{0};  ///< [ns] of the same, when it was first told to end; 0: it was not
  std::atomic<bool> over{false};              ///< the time is up, or the memory
  std::atomic<bool> full{false};              ///< it is the memory
  MemoryLimit memory;
  std::atomic<pthread_t> thread{};
  int depth = 0;
};

/// While it lives, another coroutine runs.
struct Switched {
  Switched(Watch& w, lua_State* to) : watch(w), from(w.running) { watch.switch_to(to); }
  ~Switched() { watch.switch_to(from); }
  Switched(const Switched&) = delete;
  Switched& operator=(const Switched&) = delete;
  Watch& watch;
  lua_State* from;
};

/// Its thread is there from here on, where a process may start none later.
void start_watchdog();

/// Why the script that runs has to end, with its place.
std::string why_stopped(lua_State* state);
/// Raises that as an error of Lua.
void raise_stopped(lua_State* state);

}  // namespace pantin::lua
