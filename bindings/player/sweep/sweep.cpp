#include "player/sweep/sweep.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include "player/confine.hpp"
#include "player/csv.hpp"
#include "player/hdf5_table.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/options.hpp"
#include "player/output.hpp"
#include "player/saved_state.hpp"
#include "player/sweep/bundle.hpp"
#include "player/sweep/course.hpp"
#include "player/sweep/foreman.hpp"
#include "player/sweep/journal.hpp"
#include "player/sweep/look.hpp"
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

SceneOptions case_options(const SweepOptions& options, const std::string& home, const CaseOrder& order) {
  SceneOptions result = limits(options, home);
  for (const auto& [name, value] : order.set) result.set[name] = value;
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

/// What makes a sweep another one: all on which a row depends that did not fail.
std::string identity(const SweepOptions& options, const std::string& path, std::uint64_t cases) {
  std::string all = text("pantin " PANTIN_VERSION " sweep of ", cases, " cases");
  for (const std::string& setting : options.settings) all += " --set " + setting;
  if (!options.seeds.empty()) all += " --seeds " + options.seeds;
  if (options.sample > 0) all += text(" --sample ", options.sample);
  if (options.until) all += text(" --until ", *options.until);
  if (options.timed) all += " --timed";
  if (!options.wanted.column.empty())
    all += (options.wanted.least ? " --least " : " --best ") + options.wanted.column + ", by " + Search::library();
  all += ", scene " + hash_text(file_content(path).value_or(""));
  std::ranges::replace(all, '\n', ' ');
  return all;
}

int jobs_of(const SweepOptions& options, std::uint64_t cases) {
  const int most = options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return static_cast<int>(std::min<std::uint64_t>(static_cast<std::uint64_t>(most), std::max<std::uint64_t>(1, cases)));
}

/// False where Ctrl-C came first.
bool do_cases(const SweepOptions& options, Ranks* ranks, const Cases& cases, Journal& journal, Best* best,
              const std::function<std::string(const std::string&)>& work) {
  const int hands = ranks ? ranks->hands() : jobs_of(options, cases.count() - journal.rows().size());
  Course course(cases, journal, best, hands);
  const auto next = [&] { return course.next(); };
  const auto done = [&](const std::string& result) { course.keep(result); };
  if (ranks) return ranks->hand_out(next, done, [&] { return course.is_quick(); });
  Workers workers(hands, work);
  return workers.run(
      next, done, [&](const std::string& bundle, const std::string& how) { course.keep(result_of_dead(bundle, how)); });
}

/// What it came to. The exit code.
int tell_end(const SweepOptions& options, const Rows& rows, const Best* best) {
  const std::uint64_t bad = failures(rows);
  const std::string found = best ? best->told(rows) : "";
  if (bad == rows.size())
    say(text("all failed, the first with: ", error_of(rows.begin()->second)));
  else if (best && found.empty())
    say(text("nothing is best: no case that did not fail told a finite '", options.wanted.column, "'"));
  std::printf("%zu cases, %llu of them failed: %s\n", rows.size(), static_cast<unsigned long long>(bad),
              options.out.c_str());
  if (!found.empty()) std::printf("%s\n", found.c_str());
  return bad == rows.size() || (best && found.empty()) ? 1 : 0;
}

void write_table(const std::string& path, const std::string& content, Journal& journal) {
  try {
    Output table(path);
    table.write(content);
    journal.check_table();
    journal.finish([&] { table.keep(); }, content);
  } catch (const UsageError&) { throw; } catch (const Error& error) {
    throw Error(text(error.what(), ": all rows are in ", path,
                     ".journal, and the same command writes the table from it once it can"));
  }
}

/// Of the process that writes it.
int write_sweep(const SweepOptions& options, const std::string& sweep, Ranks* ranks, Cases& cases,
                const std::function<std::string(const std::string&)>& work) {
  Output(options.out).drop();  // whether it can be written is known now
  Journal journal(options.out, sweep, {options.retry_failed, options.overwrite});
  std::optional<Best> best;
  if (!options.wanted.column.empty()) best.emplace(cases, options.wanted);
  const Rows& rows = journal.rows();
  const bool all_are_done = best ? journal.is_finished() : rows.size() == cases.count();
  if (all_are_done && journal.is_finished())
    say("nothing is left to do: this sweep is finished");
  else if (!rows.empty())
    say(text("going on: ", rows.size(), " of ", cases.count(), " cases are done already"));
  if (!do_cases(options, ranks, cases, journal, best ? &*best : nullptr, work)) {
    say(text("stopped: ", rows.size(), " of ", cases.count(),
             " cases are done; the same command goes on with the rest"));
    return 1;
  }
  const std::string content = table_content(options.out, case_columns(cases, rows, options.timed));
  if (!journal.is_finished() || file_content(options.out) != content) write_table(options.out, content, journal);
  if (!best && failures(rows) > 0) say("the same command with --retry-failed runs those that failed again");
  return tell_end(options, rows, best ? &*best : nullptr);
}

/// What is left to a process that runs a case: it writes nothing.
Reach reach_of_case(const SweepOptions& options, const std::string& path, const std::string& home) {
  RunOptions run;
  run.threads = 1;
  run.memory_limit = options.memory_limit;
  return reach_of(run, path, home);
}

/// By a process of its own, which may die of it, or be confined.
SceneLook look_aside(const SweepOptions& options, const std::vector<Axis>& axes, const std::string& path,
                     const std::string& home) {
  Workers worker(1, [&](const std::string&) {
    std::vector<std::string> lacks;
    if (options.untrusted) lacks = hold_back(reach_of_case(options, path, home));
    SceneLook look = look_at_scene(axes, path, limits(options, home));
    look.lacks = std::move(lacks);
    return text_of(look);
  });
  SceneLook look;
  std::optional<std::string> piece = "look";
  worker.run([&] { return std::exchange(piece, std::nullopt); }, [&](const std::string& told) { look = look_of(told); },
             [](const std::string&, const std::string&) {});  // the cases tell how
  for (const std::string& line : look.lacks) say(line);
  return look;
}

/// Throws UsageError.
Cases cases_of(std::vector<Axis> axes, const SweepOptions& options) {
  if (options.wanted.column.empty()) return {std::move(axes), options.sample};
  const std::uint64_t count = Best::count(axes, options.sample);
  return Cases::unplaced(std::move(axes), count);
}

}  // namespace

int sweep(const SweepOptions& options, const std::string& home) {
  const std::string path = find_scene(options.scene, home);
  if (path.ends_with(state_ending))
    throw UsageError(text(path, " is a state, whose parameters are set already: a sweep opens a scene, a .lua"));
  keep_apart(options.out, path);
  std::vector<Axis> axes = read_axes(options);
  if (axes.empty()) throw UsageError("a sweep needs --set NAME=VALUES or --seeds FIRST:LAST");
  if (options.out.ends_with(hdf5_ending)) need_hdf5();
  if (options.retry_failed && !options.wanted.column.empty())
    throw UsageError(
        "--retry-failed is of no use to --best and --least: where they went after a failed case depends on it");
  const std::uint64_t known = cases_of(axes, options).count();
  Interrupt interrupt;
  settle_whole(axes, look_aside(options, axes, path, home));
  Cases cases = cases_of(std::move(axes), options);
  bool confined = !options.untrusted;  // the process that does it
  const auto work = [&](const std::string& bundle) {
    if (!std::exchange(confined, true)) hold_back(reach_of_case(options, path, home));
    return run_bundle(bundle, [&](const CaseOrder& order) {
      return run_case(order.number, path, case_options(options, home, order), options.until, options.timed);
    });
  };
  std::optional<Ranks> ranks;
  std::optional<Foreman> foreman;
  if (ranks_started() > 1) {
    foreman.emplace(work, result_of_dead);
    ranks.emplace();
  }
  if (ranks && !ranks->first()) {
    ranks->serve([&](const std::string& piece) { return foreman->result_of(piece); });
    return 0;
  }
  return write_sweep(options, identity(options, path, known), ranks ? &*ranks : nullptr, cases, work);
}

}  // namespace pantin::player
