// Loaded before the C library into `pantin --untrusted`: at the moment at which it opens the script, tries to reach out, and tells on
// standard error what was allowed. With PANTIN_ATTACK=children the process that was started does not.
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/sched.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>

namespace {

const pid_t started = getpid();
const int told = dup(STDERR_FILENO);  // workers have none

void tell(const char* what, bool allowed) { dprintf(told, "%s %s\n", allowed ? "ALLOWED" : "refused", what); }

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

void attack_limits() {
  void* const memory = mmap(nullptr, std::size_t{16} << 30, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  tell("takes 16 GiB", memory != MAP_FAILED);
  const int file = open("out/large", O_WRONLY | O_CREAT, 0666);
  tell("makes a file of 5 GiB", ftruncate(file, off_t{5} << 30) == 0);
  unlink("out/large");
  bool ran = false;
  std::thread([&] { ran = true; }).join();
  tell("starts a thread", ran);
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
