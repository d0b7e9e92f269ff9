#include "player/program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <thread>

#include "lua/meta/annotations.hpp"
#include "lua/meta/reference.hpp"
#include "player/bench.hpp"
#include "player/home.hpp"
#include "player/lammps/lammps.hpp"
#include "player/message.hpp"
#include "player/options.hpp"
#include "player/play.hpp"
#include "player/plot_table.hpp"
#include "player/replay.hpp"
#include "player/report.hpp"
#include "player/run.hpp"
#include "player/sweep/ranks.hpp"
#include "player/sweep/sweep.hpp"
#include "player/test.hpp"
#include "player/unfinished.hpp"
#include "scene/errors.hpp"
#include "scene/interrupt.hpp"
#include "view/keys.hpp"

namespace pantin::player {
namespace {

std::string meta(const std::string& what) {
  if (what == "reference") return lua::reference() + key_reference();
  if (what == "man") return manual_page();
  if (what == "bash") return bash_completion(shipped_names(find_home()));
  return lua::annotations();
}

LammpsScene lammps_scene(const RunOptions& run, const std::string& home) {
  return {find_scene(run.scene, home), scene_options(run, home), run.until, run.scene};
}

int do_command(const Options& options) {
  switch (options.command) {
    case Options::Command::none: return 0;
    case Options::Command::play: return play(options.run, find_home());
    case Options::Command::run: return run(options.run, find_home());
    case Options::Command::replay: return replay(options.run, options.run.record, find_home());
    case Options::Command::report: return report(options.run, options.prefix, find_home());
    case Options::Command::test: return test(options.arguments, options.run.untrusted, find_home());
    case Options::Command::fuzz: return fuzz(options.fuzz, find_home());
    case Options::Command::soak: return soak(options.soak, find_home());
    case Options::Command::sweep: return sweep(options.sweep, find_home());
    case Options::Command::plot: return plot_table(options.plot);
    case Options::Command::lammps: return run_lammps(options.lammps, lammps_scene(options.run, find_home()));
    case Options::Command::export_scene: return export_lammps(options.lammps, lammps_scene(options.run, find_home()));
    case Options::Command::bench: return bench({options.arguments, options.peers});
    case Options::Command::meta: std::cout << meta(options.arguments.empty() ? "" : options.arguments[0]); return 0;
  }
  return 2;
}

/// Where standard input or an output was closed, so that no file or pipe takes its number: it still cannot be used.
void keep_standard_numbers() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) < 0) (void)!::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void end_at_once(const char* why) {
  std::fprintf(stderr, "pantin: %s, and cannot be stopped in what it does: the program ends here\n", why);
  Unfinished::remove_all();
  std::_Exit(1);
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  keep_standard_numbers();
  last_resort = end_at_once;
  // A full pipe, disk or quota is a failed write, which is told as such.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Without this variable OpenGL's libraries write to standard error, even where there is no display to look for.
  setenv("XDG_RUNTIME_DIR", "/tmp", 0);
  try {
    const int code = do_command(read_options(argc, argv));
    require(std::cout.flush().good() && std::fflush(stdout) == 0 && !std::ferror(stdout),
            "what this tells cannot be written: ", std::strerror(errno));
    return code;
  } catch (const UsageError& error) {
    // Of what mpirun started the first says it, and mpirun ends this one meanwhile, unless it is of this one alone.
    if (is_later_rank()) std::this_thread::sleep_for(std::chrono::seconds(2));
    say(error.what());
    return 2;
  } catch (const std::bad_alloc&) { say("there is not enough memory for this"); } catch (const std::exception& error) {
    say(error.what());
  }
  return 1;
}

}  // namespace pantin::player
