// Loaded before the C library into `pantin --untrusted`: at the moment at which it opens the script, tries to reach out, and tells on
// standard error what was allowed. With PANTIN_ATTACK=children the process that was started does not.
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

namespace {

const pid_t started = getpid();

/// What processes tell that were started by this one, whose standard error leads nowhere.
struct Board {
  std::atomic<std::size_t> length;
  char text[65536 - sizeof(std::size_t)];
};
Board* const board =
    static_cast<Board*>(mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));

__attribute__((destructor)) void read_out() {
  if (getpid() == started && write(STDERR_FILENO, board->text, board->length) < 0) abort();
}

void tell(const char* what, bool allowed) {
  const std::string line = std::string(allowed ? "ALLOWED " : "refused ") + what + "\n";
  const std::size_t at = board->length.fetch_add(line.size());
  if (at + line.size() < sizeof board->text) memcpy(board->text + at, line.data(), line.size());
}

void try_open(const char* what, const char* path, int flags) {
  const int file = open(path, flags, 0666);
  tell(what, file >= 0);
  if (file >= 0) close(file);
}

void end_child(long process) {
  if (process == 0) _exit(0);
  if (process > 0) waitpid(static_cast<pid_t>(process), nullptr, 0);
}

void attack_files() {
  try_open("reads the scene's folder", "attacked.lua", O_RDONLY);
  try_open("writes beside the outputs", "out/new", O_WRONLY | O_CREAT);
  try_open("reads /etc/passwd", "/etc/passwd", O_RDONLY);
  try_open("reads it through /proc", "/proc/self/root/etc/passwd", O_RDONLY);
  try_open("reads it through a link", "link", O_RDONLY);
  try_open("reads another's memory", "/proc/1/environ", O_RDONLY);
  try_open("lists a folder above", "..", O_RDONLY | O_DIRECTORY);
  try_open("writes the scene", "attacked.lua", O_WRONLY);
  try_open("makes a file elsewhere", "/tmp/pantin-attack", O_WRONLY | O_CREAT);
  tell("links out of its folder", symlink("/etc/passwd", "out/link") == 0);
}

void attack_processes() {
  tell("opens a socket", socket(AF_INET, SOCK_STREAM, 0) >= 0);
  tell("opens a local socket", socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
  const long forked = syscall(SYS_fork);
  end_child(forked);
  tell("forks", forked >= 0);
  const long cloned = syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr);
  end_child(cloned);
  tell("clones", cloned >= 0);
  clone_args arguments{};
  arguments.exit_signal = SIGCHLD;
  const long cloned3 = syscall(SYS_clone3, &arguments, sizeof arguments);
  end_child(cloned3);
  tell("clones by its newer call", cloned3 >= 0);
  char* const none[] = {nullptr};
  execve("/nowhere", none, none);
  tell("starts a program", errno != EPERM);
  tell("signals its parent", kill(getppid(), 0) == 0);
  tell("traces its parent", ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr) == 0);
  tell("asks for another machine's calls", syscall(0x40000000L | SYS_getpid) >= 0);
  tell("asks for io_uring", syscall(SYS_io_uring_setup, 1, nullptr) >= 0 || errno != EPERM);
}

bool starts_a_thread() {
  bool ran = false;
  try {
    std::thread([&] { ran = true; }).join();
  } catch (const std::system_error&) {}
  return ran;
}

/// Of a regular file.
bool holds_a_file_to_write_to() {
  for (int file = STDERR_FILENO + 1; file < 1024; file++) {
    struct stat of {};
    if (fstat(file, &of) == 0 && S_ISREG(of.st_mode) && (fcntl(file, F_GETFL) & O_ACCMODE) != O_RDONLY) return true;
  }
  return false;
}

bool has_a_limit(__rlimit_resource resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 && limit.rlim_max < 100000;
}

void attack_limits() {
  if (getpid() != started) tell("holds a file of the one that started it", holds_a_file_to_write_to());
  tell("starts threads without a limit", starts_a_thread() && !has_a_limit(RLIMIT_NPROC));
  tell("types into the terminal's selection", ioctl(0, TIOCLINUX, "\3") == 0 || errno != EPERM);
  tell("binds another to one processor", syscall(SYS_sched_setaffinity, getppid(), 0, nullptr) == 0 || errno != EPERM);
  void* const shared = mmap(nullptr, std::size_t{16} << 30, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  tell("shares 16 GiB", shared != MAP_FAILED);
  const long nameless = syscall(SYS_memfd_create, "large", 0);
  tell("makes a file of memory", nameless >= 0);
  void* const memory = mmap(nullptr, std::size_t{16} << 30, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  tell("takes 16 GiB", memory != MAP_FAILED);
  const int file = open("out/large", O_WRONLY | O_CREAT, 0666);
  tell("makes a file of 5 GiB", ftruncate(file, off_t{5} << 30) == 0);
  unlink("out/large");
  tell("starts a thread", starts_a_thread());
}

void attack(const char* path) {
  static bool done = false;
  if (done || !std::string_view(path).ends_with("attacked.lua")) return;
  if (std::getenv("PANTIN_ATTACK") && getpid() == started) return;
  done = true;
  attack_files();
  attack_processes();
  attack_limits();
}

using Open = FILE*(const char*, const char*);

}  // namespace

extern "C" {

FILE* fopen(const char* path, const char* mode) {
  attack(path);
  return reinterpret_cast<Open*>(dlsym(RTLD_NEXT, "fopen"))(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  attack(path);
  return reinterpret_cast<Open*>(dlsym(RTLD_NEXT, "fopen64"))(path, mode);
}
}
