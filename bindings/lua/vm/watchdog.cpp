#include "lua/vm/watchdog.hpp"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "lua/vm/runtime.hpp"
#include "scene/interrupt.hpp"

namespace pantin::lua {

namespace {

std::int64_t nanoseconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return t.tv_sec * 1'000'000'000 + t.tv_nsec;
}

/// Of a thread that may be another.
std::int64_t processor_ns(pthread_t thread) {
  clockid_t clock{};
  return pthread_getcpuclockid(thread, &clock) == 0 ? nanoseconds(clock) : 0;
}

std::int64_t processor_ns() { return nanoseconds(CLOCK_THREAD_CPUTIME_ID); }

/// [ns] that what cannot be stopped, as one operation of Lua's own on a huge table, may go on for.
constexpr std::int64_t longest_end = 10'000'000'000;

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max() / 2;  // [ns]
/// The watchdog sets it when it looks next: what is called at each step comes back before, and a look at a thread's clock takes
/// as long as a probe.
constexpr std::int64_t to_be_set = never - 1;

std::int64_t in_ns(double seconds) { return static_cast<std::int64_t>(std::min(seconds, 1e9) * 1e9); }

bool time_is_over(const Watch& watch) {
  const std::int64_t deadline = watch.deadline;
  return deadline != 0 && (processor_ns(watch.thread) >= deadline || watch.full || scripts_must_end());
}

/// The watch whose script runs on this thread: the handler touches no other.
thread_local std::atomic<Watch*> watched{nullptr};

void stop_script(lua_State* state, lua_Debug*) {
  if (!Runtime::of(state).watch().over) {  // left over on a coroutine that slept when the time was up
    lua_sethook(state, nullptr, 0, 0);
    return;
  }
  raise_stopped(state);
}

void time_is_up(Watch& watch) {
  if (!time_is_over(watch)) return;
  watch.over = true;
  if (lua_State* state = watch.running) lua_sethook(state, stop_script, LUA_MASKCOUNT, 1);
}

void on_signal(int, siginfo_t* info, void*) {
  if (info->si_code != SI_QUEUE) return;
  Watch* watch = watched;
  if (watch && watch == info->si_value.sival_ptr) time_is_up(*watch);
}

void send(Watch& watch) {
#if defined(__SANITIZE_THREAD__)
  time_is_up(watch);  // the sanitizer holds signals back while a loop calls nothing
#else
  sigval value{};
  value.sival_ptr = &watch;
  pthread_sigqueue(watch.thread, SIGURG, value);
#endif
}

/// [bytes] that one step, which nobody looks at meanwhile, may take beyond the limit.
constexpr std::size_t most_beyond = std::size_t{1} << 30;

/// What has to be ended from outside, or null.
const char* unstoppable(const Watch& watch) {
  if (watch.memory.exceeded(most_beyond)) return MemoryLimit::message();
  const std::int64_t since = watch.ending_since;
  if (watch.deadline == 0 || since == 0 || processor_ns(watch.thread) <= since + longest_end) return nullptr;
  return "the script is 10 s past its end (--script-limit)";
}

/// The thread that looks at all watches.
class Watchdog {
 public:
  static Watchdog& instance() {
    static const int told = pthread_atfork(nullptr, nullptr, [] { current = nullptr; });  // its thread stays behind
    if (Watchdog* watchdog = told == 0 ? current.load() : nullptr) return *watchdog;
    auto made = std::unique_ptr<Watchdog>(new Watchdog);
    Watchdog* other = nullptr;
    return current.compare_exchange_strong(other, made.get()) ? *made.release() : *other;
  }
  void add(Watch* watch) {
    const std::lock_guard lock(mutex_);
    watches_.push_back(watch);
  }
  void remove(Watch* watch) {
    const std::lock_guard lock(mutex_);
    std::erase(watches_, watch);
  }

 private:
  Watchdog() {
    struct sigaction action {};
    action.sa_sigaction = on_signal;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigaction(SIGURG, &action, nullptr);
    thread_ = std::jthread([this](std::stop_token stop) { look(stop); });
  }
  void look(const std::stop_token& stop) {
    using namespace std::chrono_literals;
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      wake_.wait_for(lock, stop, 20ms, [] { return false; });
      for (Watch* watch : watches_) {
        if (auto* end = last_resort.load())
          if (const char* why = unstoppable(*watch)) end(why);
        if (watch->over || watch->deadline == 0) continue;
        std::int64_t unset = to_be_set;
        watch->deadline.compare_exchange_strong(unset, processor_ns(watch->thread) + in_ns(watch->limit));
        if (watch->memory.exceeded()) watch->full = true;
        if (!time_is_over(*watch)) continue;
        send(*watch);
        std::int64_t going_on = 0;
        watch->ending_since.compare_exchange_strong(going_on, processor_ns(watch->thread));
      }
    }
  }

  static inline std::atomic<Watchdog*> current{nullptr};  ///< stays until the process ends
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<Watch*> watches_;
  std::jthread thread_;  // last: it stops before the others go
};

}  // namespace

void start_watchdog() { Watchdog::instance(); }

std::string why_stopped(lua_State* state) {
  const std::string place = where(state), begin = place.empty() ? "" : place + ": ";
  if (scripts_interrupted()) return begin + "the script was interrupted";
  if (Runtime::of(state).watch().full) return begin + MemoryLimit::message();
  return text(begin, "the script did not come back within ", Runtime::of(state).watch().limit.load(),
              " s and was stopped (--script-limit)");
}

void raise_stopped(lua_State* state) {
  const std::string message = why_stopped(state);
  lua_pushlstring(state, message.data(), message.size());
  lua_error(state);
}

Watch::Watch(std::size_t bytes) : memory(bytes) { Watchdog::instance().add(this); }
Watch::~Watch() { Watchdog::instance().remove(this); }

Watch* Watch::enter(lua_State* state, double seconds) {
  Watch* previous = watched.exchange(this);
  given_up = &over;
  if (depth++ > 0) return previous;
  limit = seconds;
  running = state;
  thread = pthread_self();
  over = full = false;
  ending_since = 0;
  deadline = seconds > 0 ? to_be_set : never;
  return previous;
}

void Watch::leave(Watch* previous) {
  if (--depth == 0) {
    deadline = 0;
    if (over) lua_sethook(running, nullptr, 0, 0);
    over = false;
  }
  watched = previous;
  given_up = previous ? &previous->over : nullptr;
}

void Watch::switch_to(lua_State* state) {
  running = state;
  if (over) lua_sethook(state, stop_script, LUA_MASKCOUNT, 1);
}

std::int64_t Watch::pause() {
  if (deadline == 0) return 0;
  const std::int64_t end = deadline.exchange(never);
  return std::max<std::int64_t>(end == to_be_set ? in_ns(limit) : end - processor_ns(), 1);
}

void Watch::resume(std::int64_t left) {
  if (left > 0) deadline = processor_ns() + left;
}

}  // namespace pantin::lua
