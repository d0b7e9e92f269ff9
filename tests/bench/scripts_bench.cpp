// `pantin bench scripts`: the functions of Lua's libraries that scenes have made anew, beside Lua's own: how fast they are, and how
// long past the limit of time a call goes on that never ends by itself.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "bench/clock.hpp"
#include "lua/library/sandbox.hpp"
#include "lua/vm/runtime.hpp"
#include "player/bench.hpp"
#include "scene/errors.hpp"

using namespace pantin;

namespace {

constexpr double limit = 0.5;    // [s]
constexpr rlim_t patience = 10;  // [s]

/// Lua's own functions as `own_string` and `own_table`.
void run_with_own(const std::string& source, double seconds) {
  Random random{1, 0};
  lua::Runtime runtime({seconds, std::size_t{4} << 30}, lua::sandbox);
  runtime.random = &random;
  runtime.run([&](lua_State* state) {
    luaopen_string(state);
    lua_setglobal(state, "own_string");
    luaopen_table(state);
    lua_setglobal(state, "own_table");
    runtime.load(state, source, "bench.lua");
    lua_call(state, 0, 0);
  });
}

struct Speed {
  const char* name;
  const char* before;  ///< once
  const char* call;    ///< of libraries `s` and `t`
  int times;
};

constexpr const char* text = "local words = ('the quick brown fox, 42 years old, jumps. '):rep(200) ";
constexpr const char* numbers = "local list, x = {}, 1 for i = 1, 20000 do x = x * 16807 % 2147483647 list[i] = x end ";

const Speed speeds[] = {
    {"find, a plain text at the end of 8 kB", text, "s.find(words .. 'END', 'END', 1, true)", 3000},
    {"find, a class at the end of 8 kB", text, "s.find(words .. '@', '[@#]')", 300},
    {"match, two captures", "", "s.match('height = 42.5', '^(%w+)%s*=%s*([%d.]+)$')", 200000},
    {"gmatch, 1600 words", text, "for w in s.gmatch(words, '%a+') do end", 100},
    {"gsub, 1600 words", text, "s.gsub(words, '%a+', '<%0>')", 100},
    {"rep, 1 MB", "", "s.rep('0123456789', 100000)", 100},
    {"insert at the end, 1000", "", "local l = {} for i = 1, 1000 do t.insert(l, i) end", 300},
    {"insert and remove at the front of 1000", "local l = {} for i = 1, 1000 do l[i] = i end ",
     "t.insert(l, 1, 0) t.remove(l, 1)", 2000},
    {"sort, 20,000 numbers", numbers, "t.sort(t.move(list, 1, #list, 1, {}))", 5},
    {"sort, 20,000 by a function", numbers, "t.sort(t.move(list, 1, #list, 1, {}), function(a, b) return a > b end)",
     5},
};

double seconds_of(const Speed& speed, const char* libraries) {
  const std::string source = std::string(libraries) + speed.before + "for _ = 1, " + std::to_string(speed.times) +
                             " do " + speed.call + " end";
  double least = 1e9;
  for (int i = 0; i < 3; i++) {
    const double start = now();
    run_with_own(source, 0.0);
    least = std::min(least, now() - start);
  }
  return least / speed.times;
}

/// What Lua alone would do for hours, or for longer than anybody waits.
struct Endless {
  const char* name;
  const char* call;
};
const Endless endless[] = {
    {"find, a pattern that tries all ways", "s.find(('a'):rep(60), ('a?'):rep(60) .. ('a'):rep(60) .. 'b')"},
    {"find, .- 9 times over 3 kB", "s.find(('a'):rep(3000), ('.-'):rep(9) .. 'b')"},
    {"gsub, the same", "s.gsub(('a'):rep(3000), ('.-'):rep(9) .. 'b', '')"},
    {"rep, 2 GB of one letter", "s.rep('a', 2147483646)"},
    {"insert, a proxy of 2^50",
     "t.insert(setmetatable({}, { __len = function() return 1 << 50 end, __index = rawlen, "
     "__newindex = rawequal }), 1, 0)"},
    {"remove, the same",
     "t.remove(setmetatable({}, { __len = function() return 1 << 50 end, __index = rawequal, "
     "__newindex = rawequal }), 1)"},
    {"move, 2^50 of nothing", "t.move({}, 1, 1 << 50, 2)"},
};

/// [s] of the processor until it ended, or was stopped; below 0: not within patience, or it died.
double seconds_to_end(const Endless& call, const char* libraries) {
  const pid_t process = fork();
  if (process == 0) {
    const rlimit most{patience, patience};
    setrlimit(RLIMIT_CPU, &most);
    try {
      run_with_own(std::string(libraries) + call.call, limit);
    } catch (const Error&) {}
    _exit(0);
  }
  int status = 0;
  rusage used{};
  wait4(process, &status, 0, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return WIFEXITED(status) ? seconds(used.ru_utime) + seconds(used.ru_stime) : -1.0;
}

std::string time_text(double seconds) {
  char shown[32] = "not in 10";
  if (seconds >= 0.0) std::snprintf(shown, sizeof shown, "%.2f", seconds);
  return shown;
}

/// Orders that 10 runs make of one list: many compare as equal, and the least are where a search for a middle looks first.
void bench_orders() {
  std::printf("\nA sort of 20,000 by a key of 0 to 10, 10 times: ");
  for (const char* library : {"table", "own_table"}) {
    std::string source = std::string(
                             "local list = {} for i = 1, 20000 do list[i] = { key = i % 10000 < 2 and 0 or 1 + i * i % "
                             "10, i = i } end ") +
                         library +
                         ".sort(list, function(a, b) return a.key < b.key end) local h = 0 "
                         "for i = 1, 20000 do h = (h * 31 + list[i].i) % 1000003 end error(tostring(h), 0)";
    std::string first;
    int others = 0;
    for (int i = 0; i < 10; i++) try {
        run_with_own(source, 0.0);
      } catch (const Error& told) {
        if (first.empty()) first = told.what();
        others += told.what() != first ? 1 : 0;
      }
    std::printf("%s %d of 10 differ from the first; ", library, others);
  }
  std::printf("\n");
}

void bench_scripts(const player::BenchOptions&) {
  const char *ours = "local s, t = string, table ", *own = "local s, t = own_string, own_table ";
  std::printf("%-42s %12s %12s\n", "processor time of a call, us", "scenes'", "Lua's own");
  for (const Speed& speed : speeds)
    std::printf("%-42s %12.2f %12.2f\n", speed.name, 1e6 * seconds_of(speed, ours), 1e6 * seconds_of(speed, own));
  std::printf("\n%-42s %12s %12s\n", "processor time to the end, limit 0.5 s", "scenes'", "Lua's own");
  for (const Endless& call : endless) {
    const std::string with = time_text(seconds_to_end(call, ours)), without = time_text(seconds_to_end(call, own));
    std::printf("%-42s %12s %12s\n", call.name, with.c_str(), without.c_str());
    std::fflush(stdout);
  }
  bench_orders();
}

const player::Register scripts_benchmark({"scripts",
                                          "functions of Lua's libraries that are made anew, beside Lua's own",
                                          bench_scripts});

}  // namespace
