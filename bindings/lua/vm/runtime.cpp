#include "lua/vm/runtime.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "scene/interrupt.hpp"

namespace pantin::lua {
namespace {

thread_local Runtime* current_runtime = nullptr;

/// Marks the runtime as the one whose script runs, with its clock going.
struct Inside {
  Inside(Runtime& runtime, lua_State* state, double seconds)
      : watch(runtime.watch()), previous(current_runtime), previous_watch(watch.enter(state, seconds)) {
    current_runtime = &runtime;
  }
  ~Inside() {
    current_runtime = previous;
    watch.leave(previous_watch);
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  Watch& watch;
  Runtime* previous;
  Watch* previous_watch;
};

int panic(lua_State* state) {
  const char* message = lua_tostring(state, -1);
  throw std::logic_error(text("a fault of Pantin itself: unprotected error of Lua: ", message ? message : "?"));
}

/// An error's text ends at its first.
std::string with_nul_shown(std::string_view message) {
  std::string shown;
  for (const char c : message) {
    if (c == '\0')
      shown += "\\x00";
    else
      shown += c;
  }
  return shown;
}

const char weak_name = 0;  // of the text for `__mode` in the registry

/// Lua's own text becomes another, at the place where Lua looks for it: a script's is then one like any other. As text of C it is
/// not empty: Lua would find it for "".
void hide_mode(lua_State* state) {
  lua_pushliteral(state, "__mode");
  std::memcpy(const_cast<char*>(lua_tostring(state, -1)), "\1weak\1", 6);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &weak_name);
}

}  // namespace

Runtime::Runtime(Limits limits, const Opener& opener)
    : limits_(limits), describe_error_(opener.describe_error), watch_(limits.bytes) {
  if (!(limits.seconds >= 0.0)) throw UsageError(text("--script-limit: must be >= 0 s, got ", limits.seconds));
  main_ = lua_newstate(allocate, this);
  if (!main_)
    throw UsageError(text("--memory-limit: ", limits.bytes, " bytes are not enough to start Lua; give at least 1 MB"));
  lua_atpanic(main_, panic);
  *static_cast<Runtime**>(lua_getextraspace(main_)) = this;
  watch_.running = main_;
  try {
    run([&](lua_State* state) {
      hide_mode(state);
      opener.open(state);
    });
  } catch (...) {
    lua_close(main_);
    throw;
  }
}

Runtime::~Runtime() { lua_close(main_); }

Runtime* Runtime::current() { return current_runtime; }

void* Runtime::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  Runtime& runtime = *static_cast<Runtime*>(self);
  const bool is_long_string = !block && old_size == LUA_TSTRING && new_size > longest_string;
  if (!block) old_size = 0;
  if (new_size == 0) {
    runtime.give_back(block, old_size);
    runtime.bytes_ -= old_size;
    return nullptr;
  }
  if (is_long_string || (new_size > old_size && runtime.bytes_ - old_size + new_size > runtime.limits_.bytes)) {
    if (runtime.main_) runtime.refused_ = {where(runtime.active()), is_long_string};
    return nullptr;
  }
  void* fresh = runtime.take(block, old_size, new_size);
  if (fresh) runtime.bytes_ += new_size - old_size;
  return fresh;
}

void* Runtime::take(void* block, std::size_t old_size, std::size_t new_size) {
  const bool was_small = old_size <= SmallBlocks::most, is_small = new_size <= SmallBlocks::most;
  if (!was_small && !is_small) return std::realloc(block, new_size);
  if (old_size > 0 && was_small && is_small && SmallBlocks::alike(old_size, new_size)) return block;
  void* fresh = is_small ? small_.take(new_size) : std::malloc(new_size);
  if (!fresh || !block) return fresh;
  std::memcpy(fresh, block, std::min(old_size, new_size));
  give_back(block, old_size);
  return fresh;
}

void Runtime::give_back(void* block, std::size_t size) {
  if (size > SmallBlocks::most)
    std::free(block);
  else if (size > 0)
    small_.give_back(block, size);
}

int Runtime::start(lua_State* state) {
  Job& job = *static_cast<Job*>(lua_touserdata(state, 1));
  lua_settop(state, 0);
  try {
    job.call(job.body, state);
  } catch (const std::exception&) { job.thrown = std::current_exception(); }
  return 0;
}

void Runtime::run_job(Job& job) {
  lua_State* state = active();
  const Inside inside(*this, state, limits_.seconds);
  runs_++;
  require(lua_checkstack(state, 8) != 0, "the script called itself too deeply");
  lua_pushcfunction(state, describe_error_);
  lua_pushcfunction(state, start);
  lua_pushlightuserdata(state, &job);
  const int status = lua_pcall(state, 1, 0, -3);
  lua_remove(state, status == LUA_OK ? -1 : -2);
  if (status != LUA_OK) fail(state, status);
  if (job.thrown) std::rethrow_exception(job.thrown);
}

void Runtime::fail(lua_State* state, int status) {
  std::string message;
  if (status == LUA_ERRMEM) {
    message = refused_.at.empty() ? "" : refused_.at + ": ";
    message += refused_.is_long_string
                   ? text("a string would be longer than ", longest_string >> 20, " MiB: keep its parts in a table")
                   : text("Lua's memory is full: the limit is ", limits_.bytes >> 20, " MiB (--memory-limit)");
  } else {
    std::size_t size = 0;
    const char* bytes = lua_tolstring(state, -1, &size);
    message.assign(bytes, size);
  }
  lua_pop(state, 1);
  message = with_nul_shown(message);
  if (message == stale_message) throw StaleHandle(message);
  if (message == usage_message) throw UsageError(message);
  if (watch_.over && scripts_interrupted()) throw Interrupted(message);
  throw ScriptError(message);
}

void Runtime::load(lua_State* state, const std::string& source, const std::string& named) {
  require(!source.starts_with('\x1b'), named, ":1: this is compiled code, and a scene is a text");
  // A metatable may get it later.
  const auto weak = source.find("__mode");
  require(
      weak == source.npos, named, ":",
      1 + std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(std::min(weak, source.size())), '\n'),
      ": __mode is not allowed in scenes: what a weak table has lost depends on the memory of the run");
  speaks_of_reset = speaks_of_reset || source.find("reset") != source.npos;
  const SourceText chunk{named, source};
  load_text(state, chunk);
  chunks.push_back(chunk);
}

namespace {
/// A block of a text (std::string_view) for Lua's parser. Raises an error where the script has to end.
const char* next_block(lua_State* state, void* text, std::size_t* size) {
  if (Runtime::of(state).watch().over) raise_stopped(state);
  auto& rest = *static_cast<std::string_view*>(text);
  const std::string_view block = rest.substr(0, 65536);
  rest.remove_prefix(block.size());
  *size = block.size();
  return block.data();
}
}  // namespace

void make_weak(lua_State* state, const char* mode) {
  lua_newtable(state);
  lua_rawgetp(state, LUA_REGISTRYINDEX, &weak_name);
  lua_pushstring(state, mode);
  lua_rawset(state, -3);
  lua_setmetatable(state, -2);
}

void load_text(lua_State* state, const SourceText& chunk) {
  std::string_view rest = chunk.source;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);  // which editors put before UTF-8
  // A first line that begins with # is for the shell.
  if (rest.starts_with('#')) rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
  const int status = lua_load(state, next_block, &rest, ("@" + chunk.name).c_str(), "t");
  if (status == LUA_ERRRUN && !Runtime::of(state).watch().over)
    lua_pushfstring(state, "%s: %s", chunk.name.c_str(), lua_tostring(state, -1));
  if (status != LUA_OK) lua_error(state);
}

const std::string* Runtime::read(const std::string& path, std::size_t largest) {
  const std::size_t share = limits_.bytes / 4;
  std::optional<std::string> content;
  try {
    content = reader(path, std::min(largest, share));
  } catch (const FileTooLarge& error) {
    if (share < largest) throw Error(text(error.what(), ", a quarter of --memory-limit"));
    throw;
  }
  if (!content) return nullptr;
  FileRead told{path, std::move(*content)};
  if (on_read) on_read(told);
  return &(files[path] = std::move(told.content));
}

Outside::Outside() : paused_(current_runtime) {
  if (paused_) left_ = paused_->watch().pause();
  current_runtime = nullptr;
}

Outside::~Outside() {
  current_runtime = paused_;
  if (paused_) paused_->watch().resume(left_);
}

}  // namespace pantin::lua
