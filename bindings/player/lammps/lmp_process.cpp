#include "player/lammps/lmp_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <optional>
#include <sstream>
#include <thread>

#include "player/interrupt.hpp"
#include "scene/errors.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

constexpr int least_date = 20210929;
constexpr std::size_t most_kept_lines = 200;

/// Whether the shell would find a program.
bool is_there(const std::string& program) {
  std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

/// A program whose output and errors come as lines. It ends with this one.
class Child {
 public:
  Child(std::vector<std::string> arguments, const std::string& folder) {
    std::array<int, 2> ends{};
    require(pipe2(ends.data(), O_CLOEXEC) == 0, "lammps: no pipe: ", std::strerror(errno));
    std::vector<char*> list;
    for (std::string& argument : arguments) list.push_back(argument.data());
    list.push_back(nullptr);
    process_ = fork();
    require(process_ >= 0, "lammps: no process: ", std::strerror(errno));
    if (process_ == 0) start(list, folder, ends[1]);
    close(ends[1]);
    from_ = ends[0];
  }
  ~Child() {
    if (process_ > 0) {
      kill(-process_, SIGTERM);
      (void)end();
    }
    close(from_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Calls `tell` with each line, up to the end of the output. False where Ctrl-C came before.
  bool read(const std::function<void(const std::string&)>& tell) {
    std::string line;
    std::array<char, 4096> buffer{};
    while (true) {
      if (Interrupt::asked()) return false;
      pollfd end{from_, POLLIN, 0};
      if (poll(&end, 1, 200) <= 0) continue;
      const ssize_t n = ::read(from_, buffer.data(), buffer.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      for (const char c : std::string_view(buffer.data(), static_cast<std::size_t>(n)))
        if (c == '\n')
          tell(std::exchange(line, ""));
        else
          line += c;
    }
    if (!line.empty()) tell(line);
    return true;
  }

  /// Its status as of waitpid.
  int end() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
    process_ = -1;
    return status;
  }

 private:
  pid_t process_ = -1;
  int from_ = -1;

  [[noreturn]] static void start(const std::vector<char*>& list, const std::string& folder, int to) {
    setpgid(0, 0);  // Ctrl-C is this program's, which ends all of that group
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    std::signal(SIGPIPE, SIG_DFL);
    const int nothing = ::open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(to, STDOUT_FILENO);
    dup2(to, STDERR_FILENO);
    setenv("OMP_NUM_THREADS", "1", 0);
    if (geteuid() == 0) {  // which mpirun refuses unless it is told
      setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
      setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    }
    if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(127);
    execvp(list[0], list.data());
    _exit(127);
  }
};

int month_number(const std::string& month) {
  constexpr const char* names[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  for (int i = 0; i < 12; i++)
    if (month.starts_with(names[i])) return i + 1;
  return 0;
}

/// "… Simulator - 29 Sep 2021 - Update 2"
std::optional<LmpVersion> version_in(const std::string& line) {
  const std::size_t at = line.find("Simulator - ");
  if (at == std::string::npos) return {};
  LmpVersion version{line.substr(at + 12), 0, ""};
  std::istringstream words(version.name);
  int day = 0, year = 0;
  std::string month;
  words >> day >> month >> year;
  version.date = 10000 * year + 100 * month_number(month) + day;
  return version;
}

/// The last lines that a program printed.
class LastLines {
 public:
  void add(const std::string& line) {
    lines_.push_back(line);
    if (lines_.size() > most_kept_lines) lines_.pop_front();
  }
  /// The first that has one of some texts in it; else empty.
  std::string with(std::initializer_list<const char*> texts) const {
    for (const std::string& line : lines_)
      for (const char* wanted : texts)
        if (line.find(wanted) != std::string::npos) return line;
    return "";
  }
  std::string last() const {
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line)
      if (line->find_first_not_of(" -*\t\r") != std::string::npos) return *line;
    return "";
  }

 private:
  std::deque<std::string> lines_;
};

/// What to do about an error of LAMMPS; empty: nothing is known.
std::string remedy_for(const std::string& error) {
  constexpr std::pair<const char*, const char*> known[] = {
      {"inner cutoff",
       "; two particles came nearer than their table begins, which in.scene tells: the step is too long, or the law "
       "too weak to keep them apart"},
      {"outer cutoff",
       "; a bond became longer than its table, which in.scene tells: the step is too long, or the bond gets many times "
       "as long as now, or longer than half the box"},
      {"Bond atoms", "; a bond became longer within one step than processes know of each other: the step is too long"},
      {"Lost atoms", "; particles flew away: the step is too long"},
      {"out of range", "; particles flew away: the step is too long"},
      {"Too many", "; particles are too far apart for its cells: take away what flew off, or give the scene a box"},
      {"Unknown", "; this lmp was built without it: Debian's package lammps has it"},
      {"Unrecognized", "; this lmp was built without it: Debian's package lammps has it"}};
  for (const auto& [part, remedy] : known)
    if (error.find(part) != std::string::npos) return remedy;
  return "";
}

constexpr const char* killed = ", as the system does where memory is short";

std::string ended_by(int signal) {
  return text("it was ended by signal ", signal, " (", strsignal(signal), ")", signal == SIGKILL ? killed : "");
}

std::string what_went_wrong(int status, int ranks, const LastLines& lines) {
  if (!lines.with({"not enough slots"}).empty())
    return text("mpirun has no place for ", ranks, " processes on this machine, which has ",
                std::thread::hardware_concurrency(),
                " processors: give fewer --ranks, or let them take turns (export OMPI_MCA_rmaps_base_oversubscribe=1)");
  if (const std::string error = lines.with({"ERROR"}); !error.empty()) return error + remedy_for(error);
  if (const std::string signal = lines.with({"exited on signal"}); !signal.empty())
    return signal + (signal.find("signal 9") != std::string::npos ? killed : "");
  if (WIFSIGNALED(status)) return ended_by(WTERMSIG(status));
  constexpr int of_signal = 128;  // what mpirun and shells add to it
  if (const int signal = WEXITSTATUS(status) - of_signal; signal > 0 && signal < NSIG) return ended_by(signal);
  const std::string last = lines.last();
  return text("it ended with exit code ", WEXITSTATUS(status), last.empty() ? "" : ", and said last: " + last);
}

/// Whether mpirun starts so many processes is known before the scene is opened.
void check_mpirun(int ranks) {
  if (ranks == 1) return;
  require(is_there("mpirun"),
          "mpirun is not there, and more than one rank needs it; install Debian's package openmpi-bin");
  LastLines lines;
  Child child({"mpirun", "-np", text(ranks), "true"}, "");
  if (!child.read([&](const std::string& line) { lines.add(line); })) throw Interrupted("stopped");
  const int status = child.end();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error(what_went_wrong(status, ranks, lines));
}

}  // namespace

LmpVersion check_lmp(int ranks) {
  require(is_there("lmp"), "LAMMPS is not there: no program `lmp` is found; install Debian's package lammps");
  std::optional<LmpVersion> version;
  bool in_packages = false;
  LastLines lines;
  Child child({"lmp", "-h"}, "");
  const bool whole = child.read([&](const std::string& line) {
    lines.add(line);
    if (!version) version = version_in(line);
    if (line.starts_with("Installed packages")) in_packages = true;
    if (line.starts_with("List of")) in_packages = false;
    if (in_packages && version) version->packages += " " + line + " ";
  });
  const int status = child.end();
  if (!whole) throw Interrupted("stopped");
  if (!version && status != 0) throw Error(text("`lmp -h` fails: ", what_went_wrong(status, 1, lines)));
  require(version && version->date > 0,
          "`lmp -h` does not tell its version as LAMMPS does: is another program called lmp?");
  require(version->date >= least_date, "lmp is LAMMPS of ", version->name,
          ", and 29 Sep 2021 or newer is needed; install Debian 12's package lammps");
  check_mpirun(ranks);
  return *version;
}

void require_package(const LmpVersion& version, const char* package) {
  require(version.packages.find(text(' ', package, ' ')) != std::string::npos,
          "this lmp was built without its package ", package,
          ", which the scene needs; Debian's package lammps has it");
}

void run_lmp(const std::string& folder, int ranks, const std::function<void(const std::string&)>& tell) {
  std::vector<std::string> arguments;
  if (ranks > 1) {
    require(is_there("mpirun"),
            "mpirun is not there, and more than one rank needs it; install Debian's package openmpi-bin");
    arguments = {"mpirun", "-np", text(ranks)};
  }
  for (const char* argument : {"lmp", "-in", "in.scene", "-log", "log.lammps", "-var", "check", "yes"})
    arguments.emplace_back(argument);
  LastLines lines;
  Child child(arguments, folder);
  const bool whole = child.read([&](const std::string& line) {
    lines.add(line);
    tell(line);
  });
  if (!whole) throw Interrupted("stopped: LAMMPS was ended, and nothing is brought back");
  const int status = child.end();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && fs::exists(fs::path(folder) / "end.dump")) return;
  const fs::path log = fs::path(folder) / "log.lammps";
  throw Error(
      text("LAMMPS: ", what_went_wrong(status, ranks, lines), fs::exists(log) ? text(" (", log.string(), ")") : ""));
}

}  // namespace pantin::player
