#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <memory>

#include "lua/scene/open.hpp"
#include "measure/hits.hpp"
#include "measure/ledger_closure.hpp"
#include "measure/measure.hpp"
#include "player/fuzz.hpp"
#include "scene/errors.hpp"

namespace pantin::player {
namespace {

constexpr int fuzz_steps = 60;
constexpr rlim_t processor_seconds = 30;  ///< [s] of all runs of one scene
constexpr unsigned real_seconds = 600;    ///< [s] the same; the machine may be busy

/// The states that a run went through, and the error at which it stopped.
struct Course {
  std::vector<std::uint64_t> hashes;
  std::string stopped;
  bool operator==(const Course&) const = default;
};

std::unique_ptr<Scene> open_fuzzed(const std::string& source, const std::string& home, int threads) {
  SceneOptions options;
  options.home = home;
  options.threads = threads;
  return lua::open_scene_text(source, "fuzz.lua", home, options);
}

template <class After>
void go_on(Scene& scene, int steps, Course& course, After after) {
  if (!course.stopped.empty()) return;
  try {
    for (int i = 0; i < steps && !scene.finished(); i++) {
      scene.step();
      require(scene.world().failure.empty(), scene.world().failure);
      course.hashes.push_back(state_hash(scene.world()));
      after();
    }
  } catch (const Error& error) { course.stopped = error.what(); }
}
void go_on(Scene& scene, int steps, Course& course) {
  go_on(scene, steps, course, [] {});
}

std::string difference(const Course& a, const Course& b) {
  for (std::size_t i = 0; i < std::min(a.hashes.size(), b.hashes.size()); i++)
    if (a.hashes[i] != b.hashes[i]) return text("other bits after step ", i + 1);
  return text(a.hashes.size(), " steps, then '", a.stopped, "', beside ", b.hashes.size(), ", then '", b.stopped, "'");
}

bool is_told(const World& world) {
  if (world.stats.fallback_steps > 0) return true;
  for (const LogLine& line : world.log)
    if (line.kind == "warning") return true;
  return false;
}

Find look_at_state(const World& world) {
  const Energy now = energy(world);
  const Bounds box = bounds(world, everything(world));
  const Vec3 size = box.high - box.low;
  const Accuracy error = accuracy(world);
  if (!std::isfinite(now.kinetic + now.potential) || !std::isfinite(dot(size, size)) || std::isnan(error.energy))
    return {"not_finite", text("kinetic energy ", now.kinetic, " J, potential ", now.potential, " J, error ",
                               error.energy, " after step ", world.steps)};
  const double extent = std::max({1.0, norm(box.low), norm(box.high)});
  if (error.hinge_gap > 1e-9 * extent && !is_told(world))
    return {"gap", text("a hinge gapes ", error.hinge_gap, " m after step ", world.steps, ", and nothing tells it")};
  return {};
}

/// Motion that none of the lines explains which may give any.
Find look_at_energy(const World& world, double kinetic_at_start) {
  const Ledger& ledger = world.ledger;
  const auto given = [&](Source source) { return ledger.given[static_cast<std::size_t>(source)]; };
  double honest = kinetic_at_start + std::abs(ledger.gravity) + std::abs(world.work_check.done);
  for (const auto& [name, joules] : ledger.kicks) honest += std::abs(joules);
  for (const Source source : {Source::hand, Source::motor, Source::event, Source::edit, Source::merge, Source::emitter,
                              Source::removal, Source::damper, Source::law, Source::sleep})
    honest += std::abs(given(source));
  double other = 0.0;
  for (const Source source : {Source::limit, Source::contact, Source::push_out, Source::fallback_step,
                              Source::projection, Source::energy_return, Source::unsolved, Source::integrator})
    other += given(source);
  const double told = accuracy(world).energy;
  if (other > honest + 1e-6 && told < 0.1 && !is_told(world))
    return {"energy", text(other, " J from what may give none, beside ", honest, " J; the error told is ", told)};
  if (const double open = closure(world); open > 1e-6)
    return {"ledger", text("of the kinetic energy no line explains ", open)};
  return {};
}

/// Asked by the window where the mouse is, and by panels.
void ask(World& world) {
  hits_of_endless_ray(world, vec(-9, 4, 7), vec(1, -0.4, -0.7));
  overlapping(world, BallShape{1.0}, {});
}

/// Keeping the ledger, measuring and asking change nothing.
Find look_at_run(const std::string& source, const std::string& home, const Course& first) {
  const auto scene = open_fuzzed(source, home, 1);
  World& world = scene->world();
  keep_ledger(world);
  const double kinetic = energy(world).kinetic;
  Find find;
  Course course;
  go_on(*scene, fuzz_steps, course, [&] {
    if (find.kind.empty()) find = look_at_state(world);
    ask(world);
  });
  if (course != first) return {"repeat", "measured: " + difference(first, course)};
  if (find.kind.empty() && course.stopped.empty() && source.find("surface_velocity") == std::string::npos)
    find = look_at_energy(world, kinetic);
  return find;
}

Find look_at_snapshot(const std::string& source, const std::string& home, const Course& first) {
  const auto scene = open_fuzzed(source, home, 1);
  Course begun;
  go_on(*scene, fuzz_steps / 3, begun);
  if (!begun.stopped.empty() || !scene->why_not_restore().empty()) return {};
  const auto snapshot = scene->take_snapshot();
  Course once = begun, again = begun;
  go_on(*scene, fuzz_steps - fuzz_steps / 3, once);
  if (once != first) return {"snapshot", "taken: " + difference(first, once)};
  if (!once.stopped.empty() || !scene->why_not_restore().empty()) return {};
  scene->restore(*snapshot);
  go_on(*scene, fuzz_steps - fuzz_steps / 3, again);
  if (again != first) return {"snapshot", "put back: " + difference(first, again)};
  return {};
}

Find look_at_save(const std::string& source, const std::string& home, const Course& first) {
  const auto scene = open_fuzzed(source, home, 1);
  Course begun;
  go_on(*scene, fuzz_steps / 3, begun);
  if (!begun.stopped.empty() || !scene->why_not_restore().empty()) return {};
  std::string state;
  try {
    state = scene->state();
  } catch (const Error&) { return {}; }
  SceneOptions options;
  options.home = home;
  const auto opened = lua::open_state(state, "fuzz.pantin", options);
  go_on(*opened, fuzz_steps - fuzz_steps / 3, begun);
  if (begun != first) return {"save", difference(first, begun)};
  return {};
}

Find look_at_all(const std::string& source, const std::string& home) {
  bool opened = false;
  const auto whole = [&](int threads) {
    Course course;
    try {
      const auto scene = open_fuzzed(source, home, threads);
      opened = true;
      go_on(*scene, fuzz_steps, course);
    } catch (const Error& error) { course.stopped = error.what(); }
    return course;
  };
  const Course first = whole(1);
  if (const Course again = whole(1); again != first) return {"repeat", difference(first, again)};
  if (!opened) return {unopened, first.stopped};
  if (first.hashes.empty()) return {};
  if (const Course threads = whole(2); threads != first) return {"threads", difference(first, threads)};
  for (const auto look : {look_at_run, look_at_snapshot, look_at_save})
    if (const Find find = look(source, home, first); !find.kind.empty()) return find;
  return {};
}

[[noreturn]] void examine_here(const std::string& source, const std::string& home, int to) {
  rlimit limit{processor_seconds, processor_seconds};
  setrlimit(RLIMIT_CPU, &limit);
  limit = {0, 0};
  setrlimit(RLIMIT_CORE, &limit);
  alarm(real_seconds);
  Find find;
  try {
    find = look_at_all(source, home);
  } catch (const std::exception& error) { find = {"exception", error.what()}; }
  const std::string said = find.kind.empty() ? "ok" : find.kind + "\n" + find.text;
  const bool written = write(to, said.data(), said.size()) == static_cast<ssize_t>(said.size());
  _exit(written ? 0 : 1);
}

}  // namespace

Find examine(const std::string& source, const std::string& home) {
  std::array<int, 2> ends{};
  require(pipe(ends.data()) == 0, "fuzz: no pipe: ", std::strerror(errno));
  const pid_t child = fork();
  require(child >= 0, "fuzz: no process: ", std::strerror(errno));
  if (child == 0) {
    close(ends[0]);
    examine_here(source, home, ends[1]);
  }
  close(ends[1]);
  std::string said;
  std::array<char, 4096> block{};
  for (ssize_t n = 0; (n = read(ends[0], block.data(), block.size())) > 0 || (n < 0 && errno == EINTR);)
    if (n > 0) said.append(block.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const bool slow = signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL;
    return {slow ? "slow" : "crash", text("ended by signal ", signal, " (", strsignal(signal), ")")};
  }
  if (said.empty()) return {"crash", text("ended with exit code ", WEXITSTATUS(status))};
  const auto end = said.find('\n');
  if (end == std::string::npos) return {};
  return {said.substr(0, end), said.substr(end + 1)};
}

}  // namespace pantin::player
