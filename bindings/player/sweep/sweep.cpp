#include "player/sweep/sweep.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <thread>

#include "lua/scene/open.hpp"
#include "player/csv.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/output.hpp"
#include "player/sweep/journal.hpp"
#include "player/sweep/ranks.hpp"
#include "player/sweep/workers.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::player {
namespace {

SceneOptions limits(const SweepOptions& options, const std::string& home) {
  SceneOptions result;
  result.script_limit = options.script_limit;
  result.memory_limit = options.memory_limit;
  result.home = home;
  return result;
}

SceneOptions case_options(const SweepOptions& options, const std::string& home, const Cases& cases,
                          std::uint64_t number) {
  SceneOptions result = limits(options, home);
  for (auto& [name, value] : cases.settings(number)) result.set[name] = value;
  return result;
}

std::vector<Axis> read_axes(const SweepOptions& options) {
  std::vector<Axis> axes;
  for (const std::string& setting : options.settings) axes.push_back(read_axis(setting));
  if (!options.seeds.empty()) axes.push_back(read_seeds(options.seeds));
  for (std::size_t i = 0; i < axes.size(); i++)
    for (std::size_t j = 0; j < i; j++)
      if (axes[i].name == axes[j].name) throw UsageError(text("'", axes[i].name, "' is set twice"));
  return axes;
}

/// What is known of the scene before the first case.
struct SceneLook {
  std::map<std::string, bool>
      whole;            ///< its parameters: whether they are whole numbers; empty where it cannot be opened so
  std::string unknown;  ///< why what is set is none of it; empty: it is
};

/// Opens the scene once.
SceneLook look_at_scene(const std::vector<Axis>& axes, const std::string& path, const std::string& home,
                        const SweepOptions& options) {
  SceneOptions first = limits(options, home);
  for (const Axis& axis : axes)
    if (!axis.values.empty() || axis.whole) first.set[axis.name] = axis.value(0);
  SceneLook look;
  try {
    const auto scene = lua::open_scene(path, first);
    for (const SceneParameter& p : scene->parameters()) look.whole[p.name] = p.integer;
    for (const Axis& axis : axes)
      if (!look.whole.contains(axis.name) && !axis.name.starts_with("scene."))
        look.unknown = text("the scene has no parameter '", axis.name, "'");
  } catch (const UsageError& error) { look.unknown = error.what(); } catch (const Error&) {
    look.whole.clear();  // the cases tell, each its own
  }
  return look;
}

/// Ranges of whole numbers have whole numbers.
void settle_whole(std::vector<Axis>& axes, const SceneLook& look) {
  if (!look.unknown.empty()) throw UsageError(look.unknown);
  for (Axis& axis : axes) {
    const auto known = look.whole.find(axis.name);
    if (known == look.whole.end() || !known->second || !axis.values.empty()) continue;
    axis.whole = true;
    if (static_cast<double>(axis.count) > std::abs(axis.to - axis.from) + 1.0)
      throw UsageError(text("'", axis.name,
                            "' is a whole number in this scene, as its default has no point: there are no ", axis.count,
                            " of them from ", axis.from, " to ", axis.to));
  }
}

/// What makes a sweep another one.
std::string identity(const SweepOptions& options, const std::string& path, std::uint64_t cases) {
  std::string all = text("pantin " PANTIN_VERSION " sweep of ", cases, " cases");
  for (const std::string& setting : options.settings) all += " --set " + setting;
  if (!options.seeds.empty()) all += " --seeds " + options.seeds;
  if (options.sample > 0) all += text(" --sample ", options.sample);
  if (options.until) all += text(" --until ", *options.until);
  if (options.timed) all += " --timed";
  all += text(" --script-limit ", options.script_limit, " --memory-limit ", options.memory_limit, ", scene ",
              hash_text(file_content(path).value_or("")));
  std::ranges::replace(all, '\n', ' ');
  return all;
}

/// A line on standard error that moves, where that is a terminal.
class CaseProgress {
 public:
  CaseProgress(std::uint64_t done, std::uint64_t all) : before_(done), all_(all) {}
  ~CaseProgress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  CaseProgress(const CaseProgress&) = delete;
  CaseProgress& operator=(const CaseProgress&) = delete;
  void show(std::uint64_t done, std::uint64_t failed) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now < next_ || done <= before_) return;
    next_ = now + std::chrono::milliseconds(200);
    const double spent = std::chrono::duration<double>(now - start_).count();
    const double left = spent * static_cast<double>(all_ - done) / static_cast<double>(done - before_);
    std::fprintf(stderr, "\r\033[K%llu of %llu cases, %llu failed, %.0f s left", static_cast<unsigned long long>(done),
                 static_cast<unsigned long long>(all_), static_cast<unsigned long long>(failed), left);
    std::fflush(stderr);
    shown_ = true;
  }

 private:
  std::uint64_t before_, all_;
  bool terminal_ = isatty(STDERR_FILENO) != 0, shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), next_ = start_;
};

std::string error_of(const CaseRow& row) {
  const auto error = std::ranges::find(row.measured, "error", [](const auto& cell) { return cell.first; });
  return error == row.measured.end() ? "" : error->second;
}

bool failed(const CaseRow& row) { return !error_of(row).empty(); }

std::uint64_t failures(const Journal& journal) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(journal.rows(), [](const auto& row) { return failed(row.second); }));
}

int jobs_of(const SweepOptions& options, std::uint64_t cases) {
  const int most = options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return static_cast<int>(std::min<std::uint64_t>(static_cast<std::uint64_t>(most), std::max<std::uint64_t>(1, cases)));
}

/// What is to be done of a sweep, and what is done.
class Course {
 public:
  Course(const Cases& cases, Journal& journal)
      : cases_(cases), journal_(journal), progress_(journal.rows().size(), cases.count()), bad_(failures(journal)) {
    for (const auto& [number, row] : journal.rows())
      for (const auto& [path, hash] : row.files) {
        note_file(path, hash);
        kept_.insert(path);
      }
    for (const auto& [path, hash] : files_)
      if (hash_text(file_content(path).value_or("")) != hash)
        throw UsageError(
            text(path, " was changed since the sweep was begun: put it back as it was, or delete the journal"));
  }
  /// The next case that has no row.
  std::optional<std::uint64_t> next() {
    while (next_ < cases_.count() && journal_.rows().contains(next_)) next_++;
    if (next_ == cases_.count()) return {};
    return next_++;
  }
  /// Throws Error where a file was changed since another case read it.
  void keep(CaseRow row) {
    for (const auto& [path, hash] : row.files) note_file(path, hash);
    std::erase_if(row.files, [&](const auto& file) { return !kept_.insert(file.first).second; });
    bad_ += failed(row) ? 1u : 0u;
    journal_.add(std::move(row));
    progress_.show(journal_.rows().size(), bad_);
  }

 private:
  void note_file(const std::string& path, const std::string& hash) {
    require(files_.try_emplace(path, hash).first->second == hash, path,
            " was changed while the sweep runs: put it back as it was, and the same command goes on with the rest; or "
            "delete the journal and begin anew");
  }

  const Cases& cases_;
  Journal& journal_;
  std::map<std::string, std::string> files_;  ///< that the cases read, and a hash of each
  std::set<std::string> kept_;                ///< of them, those that the journal has
  CaseProgress progress_;
  std::uint64_t next_ = 0, bad_;
};

/// False where Ctrl-C came first.
bool do_cases(const SweepOptions& options, Ranks* ranks, const Cases& cases, Journal& journal,
              const std::function<std::string(std::uint64_t)>& work) {
  Course course(cases, journal);
  const auto next = [&] { return course.next(); };
  const auto done = [&](std::uint64_t, const std::string& line) { course.keep(row_of(line)); };
  if (ranks) return ranks->hand_out(next, done);
  Workers workers(jobs_of(options, cases.count() - journal.rows().size()), work);
  return workers.run(next, done, [&](std::uint64_t number, const std::string& how) {
    course.keep({number, {}, {{"error", how}}, {}});
  });
}

/// Of the process that writes it.
int write_sweep(const SweepOptions& options, const std::string& sweep, Ranks* ranks, const Cases& cases,
                const std::function<std::string(std::uint64_t)>& work) {
  Output(options.out).drop();  // whether it can be written is known now
  Journal journal(options.out + ".journal", sweep);
  const std::uint64_t before = journal.rows().size(), all = cases.count();
  if (before > 0) say(text("going on: ", before, " of ", all, " cases are done already"));
  if (!do_cases(options, ranks, cases, journal, work)) {
    say(text("stopped: ", journal.rows().size(), " of ", all,
             " cases are done; the same command goes on with the rest"));
    return 1;
  }
  Output table(options.out);
  table.write(case_table(cases, journal.rows(), options.timed));
  table.keep();
  journal.remove();
  const std::uint64_t bad = failures(journal);
  if (bad == all) say(text("all failed, the first with: ", error_of(journal.rows().begin()->second)));
  std::printf("%llu cases, %llu of them failed: %s\n", static_cast<unsigned long long>(all),
              static_cast<unsigned long long>(bad), options.out.c_str());
  return bad == all ? 1 : 0;
}

}  // namespace

int sweep(const SweepOptions& options, const std::string& home) {
  const std::string path = find_scene(options.scene, home);
  std::vector<Axis> axes = read_axes(options);
  if (axes.empty()) throw UsageError("a sweep needs --set NAME=VALUES or --seeds FIRST:LAST");
  const std::uint64_t known = Cases(axes, options.sample).count();
  settle_whole(axes, look_at_scene(axes, path, home, options));
  const Cases cases(std::move(axes), options.sample);
  const auto work = [&](std::uint64_t number) {
    return line_of(run_case(number, path, case_options(options, home, cases, number), options.until, options.timed));
  };
  std::optional<Ranks> ranks;
  if (ranks_started() > 1) ranks.emplace();
  Interrupt interrupt;
  if (ranks && !ranks->first()) {
    ranks->serve(work);
    return 0;
  }
  return write_sweep(options, identity(options, path, known), ranks ? &*ranks : nullptr, cases, work);
}

}  // namespace pantin::player
