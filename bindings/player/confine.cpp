// Landlock (Linux 5.13) holds files back, a filter of system calls (seccomp) all else, limits of resources the rest. What the
// filter refuses is a list: the calls that reach beyond the process. What is newer than the list is answered as if the kernel
// did not know it.
#include "player/confine.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>

#include "base/parallel.hpp"
#include "lua/scene/open.hpp"
#include "player/message.hpp"
#include "player/output.hpp"
#include "scene/errors.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

constexpr std::uint64_t right_to_move = 1U << 13, right_to_cut = 1U << 14;  // since versions 2 and 3
constexpr std::uint64_t to_read = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t to_write_file = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE | right_to_cut;
constexpr std::uint64_t to_write =
    to_read | to_write_file | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REMOVE_FILE;
constexpr std::uint64_t file_rights = LANDLOCK_ACCESS_FS_EXECUTE | to_write_file;
constexpr rlim_t largest_file = rlim_t{4} << 30;  ///< [bytes]
constexpr rlim_t most_files = 256;                ///< open at once, where nothing is drawn
constexpr rlim_t threads_to_draw = 256;

/// What could not be held back.
class Lacks {
 public:
  void add(const std::string& what) { add(what, std::strerror(errno)); }
  void add(const std::string& what, const char* why) { lines_.push_back(text("--untrusted: ", what, ": ", why)); }
  std::vector<std::string> lines() && { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

class Ruleset {
 public:
  /// All rights of the kernel's version.
  explicit Ruleset(long version) {
    rights_ = right_to_move - 1;
    if (version >= 2) rights_ |= right_to_move;
    if (version >= 3) rights_ |= right_to_cut;
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = rights_;
    descriptor_ =
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0U));
  }
  ~Ruleset() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Ruleset(const Ruleset&) = delete;
  Ruleset& operator=(const Ruleset&) = delete;

  void allow(const std::string& path, std::uint64_t rights) {
    const int place = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (place < 0) return;
    struct stat found {};
    const bool is_folder = fstat(place, &found) == 0 && S_ISDIR(found.st_mode);
    landlock_path_beneath_attr rule{};
    rule.parent_fd = place;
    rule.allowed_access = rights & rights_ & (is_folder ? ~std::uint64_t{0} : file_rights);
    syscall(SYS_landlock_add_rule, descriptor_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0U);
    close(place);
  }
  bool hold() const { return descriptor_ >= 0 && syscall(SYS_landlock_restrict_self, descriptor_, 0U) == 0; }

 private:
  std::uint64_t rights_ = 0;
  int descriptor_ = -1;
};

void hold_files(const Reach& reach, Lacks& lacks) {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1)
    return lacks.add("this kernel has no Landlock, which files are reached is left to the program's own checks");
  Ruleset ruleset(version);
  for (const std::string& path : reach.read) ruleset.allow(path, to_read);
  for (const std::string& path : reach.write) ruleset.allow(path, to_write);
  if (!ruleset.hold()) lacks.add("files are not held back");
}

constexpr unsigned newest_known = SYS_landlock_restrict_self;

constexpr unsigned refused[] = {SYS_socket,
                                SYS_socketpair,
                                SYS_connect,
                                SYS_bind,
                                SYS_listen,
                                SYS_accept,
                                SYS_accept4,
                                SYS_execve,
                                SYS_execveat,
                                SYS_fork,
                                SYS_vfork,
                                SYS_ptrace,
                                SYS_process_vm_readv,
                                SYS_process_vm_writev,
                                SYS_process_madvise,
                                SYS_kcmp,
                                SYS_pidfd_open,
                                SYS_pidfd_getfd,
                                SYS_pidfd_send_signal,
                                SYS_tkill,
                                SYS_rt_sigqueueinfo,
                                SYS_rt_tgsigqueueinfo,
                                SYS_bpf,
                                SYS_perf_event_open,
                                SYS_userfaultfd,
                                SYS_io_uring_setup,
                                SYS_io_uring_enter,
                                SYS_io_uring_register,
                                SYS_mount,
                                SYS_umount2,
                                SYS_open_tree,
                                SYS_move_mount,
                                SYS_fsopen,
                                SYS_fsmount,
                                SYS_fspick,
                                SYS_pivot_root,
                                SYS_chroot,
                                SYS_setns,
                                SYS_unshare,
                                SYS_add_key,
                                SYS_request_key,
                                SYS_keyctl,
                                SYS_init_module,
                                SYS_finit_module,
                                SYS_delete_module,
                                SYS_kexec_load,
                                SYS_kexec_file_load,
                                SYS_reboot,
                                SYS_swapon,
                                SYS_swapoff,
                                SYS_acct,
                                SYS_quotactl,
                                SYS_iopl,
                                SYS_ioperm,
                                SYS_open_by_handle_at,
                                SYS_name_to_handle_at,
                                SYS_shmget,
                                SYS_shmat,
                                SYS_msgget,
                                SYS_semget,
                                SYS_mq_open,
                                SYS_setpriority,
                                SYS_sched_setscheduler,
                                SYS_sched_setparam,
                                SYS_sched_setattr,
                                SYS_sched_setaffinity,
                                SYS_ioprio_set,
                                SYS_migrate_pages,
                                SYS_move_pages,
                                SYS_chmod,
                                SYS_fchmod,
                                SYS_fchmodat,
                                SYS_chown,
                                SYS_fchown,
                                SYS_lchown,
                                SYS_fchownat,
                                SYS_setxattr,
                                SYS_lsetxattr,
                                SYS_fsetxattr,
                                SYS_utimensat,
                                SYS_settimeofday,
                                SYS_clock_settime,
                                SYS_sethostname,
                                SYS_setuid,
                                SYS_setgid};

/// The program of the filter. Jumps go over the instruction that follows, an answer.
class Filter {
 public:
  explicit Filter(bool draws) {
    load(offsetof(seccomp_data, arch));
    answer_unless(AUDIT_ARCH_X86_64, SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, newest_known, 0, 1));
    answer(error(ENOSYS));
    answer_if(SYS_clone3, error(ENOSYS));  // its flags lie in memory; the C library goes on with clone
    for (const unsigned call : refused) answer_if(call, error(EPERM));
    if (draws) {
      flags_only(SYS_clone, 0, CLONE_THREAD);
    } else {
      for (const unsigned call : {unsigned{SYS_clone}, unsigned{SYS_memfd_create}}) answer_if(call, error(EPERM));
      no_shared_memory();
    }
    argument_only(SYS_prlimit64, 0, 0);
    argument_only(SYS_kill, 0, static_cast<unsigned>(getpid()));
    argument_only(SYS_tgkill, 0, static_cast<unsigned>(getpid()));
    no_typing();
    answer(SECCOMP_RET_ALLOW);
  }
  bool hold() {
    sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
  }

 private:
  static unsigned error(int number) { return SECCOMP_RET_ERRNO | static_cast<unsigned>(number); }
  static unsigned place_of(unsigned argument) {
    return static_cast<unsigned>(offsetof(seccomp_data, args)) + 8 * argument;
  }
  void load(unsigned at) { code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, at)); }
  void answer(unsigned with) { code_.push_back(BPF_STMT(BPF_RET | BPF_K, with)); }
  void answer_if(unsigned value, unsigned with) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1));
    answer(with);
  }
  void answer_unless(unsigned value, unsigned with) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0));
    answer(with);
  }
  /// Only where one of the flags is set.
  void flags_only(unsigned call, unsigned argument, unsigned flags) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4));
    load(place_of(argument));
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, flags, 1, 0));
    answer(error(EPERM));
    answer(SECCOMP_RET_ALLOW);
  }
  /// Which no limit counts.
  void no_shared_memory() {
    constexpr unsigned shared = MAP_SHARED | MAP_ANONYMOUS;
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_mmap, 0, 5));
    load(place_of(3));
    code_.push_back(BPF_STMT(BPF_ALU | BPF_AND | BPF_K, shared));
    answer_if(shared, error(EPERM));
    answer(SECCOMP_RET_ALLOW);
  }
  void argument_only(unsigned call, unsigned argument, unsigned value) {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4));
    load(place_of(argument));
    answer_unless(value, error(EPERM));
    answer(SECCOMP_RET_ALLOW);
  }
  /// Into the terminal, as if its user did.
  void no_typing() {
    code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_ioctl, 0, 5));
    load(place_of(1));
    for (const unsigned call : {unsigned{TIOCSTI}, unsigned{TIOCLINUX}}) answer_if(call, error(EPERM));
  }

  std::vector<sock_filter> code_;
};

/// [bytes] of memory of its own that the process has.
rlim_t data_in_use() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  unsigned long data = 0;
  const bool read = file && std::fscanf(file, "%*u %*u %*u %*u %*u %lu", &data) == 1;
  if (file) std::fclose(file);
  return read ? static_cast<rlim_t>(data) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void limit(__rlimit_resource resource, rlim_t most, const char* what, Lacks& lacks) {
  rlimit now{};
  if (getrlimit(resource, &now) == 0) {
    now.rlim_max = std::min(now.rlim_max, most);
    now.rlim_cur = std::min(now.rlim_cur, now.rlim_max);
    if (setrlimit(resource, &now) == 0) return;
  }
  lacks.add(what);
}

/// Of all processes of this user.
rlim_t threads_of_user() {
  rlim_t all = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", fs::directory_options::skip_permission_denied, ignored)) {
    if (std::isdigit(static_cast<unsigned char>(entry.path().filename().string()[0])) == 0) continue;
    struct stat tasks {};
    if (stat((entry.path() / "task").c_str(), &tasks) == 0 && tasks.st_uid == getuid()) all += tasks.st_nlink - 2;
  }
  return all;
}

/// Of a process that draws: of others the filter allows none.
void limit_threads(const Reach& reach, Lacks& lacks) {
  if (getuid() == 0) return lacks.add("what draws may start any number of threads", "the super-user has no limit");
  limit(RLIMIT_NPROC, threads_of_user() + static_cast<rlim_t>(reach.threads) + threads_to_draw,
        "threads are not limited", lacks);
}

std::string folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path().string() : std::string(".");
}

/// Drivers that draw pictures, and what they read of the machine.
constexpr const char* drawing[] = {"/usr",       "/lib", "/lib64",       "/etc/ld.so.cache", "/etc/drirc",
                                   "/etc/glvnd", "/sys", "/dev/urandom", "/etc/fonts"};

void add_drawing(Reach& reach) {
  reach.draws = true;
  reach.read.insert(reach.read.end(), std::begin(drawing), std::end(drawing));
  reach.write.insert(reach.write.end(), {"/dev/dri", "/dev/null"});
}

}  // namespace

Reach reach_of(const RunOptions& options, const std::string& scene, const std::string& home) {
  constexpr std::size_t beside = std::size_t{1} << 30, of_thread = std::size_t{16} << 20;
  Reach reach;
  reach.threads =
      options.threads > 0 ? options.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  reach.memory = options.memory_limit + beside + of_thread * static_cast<std::size_t>(reach.threads);
  reach.read = {home + "/scripts", home + "/assets", "/proc/self"};
  std::error_code ignored;
  if (!scene.empty()) reach.read.insert(reach.read.end(), {folder_of(scene), fs::weakly_canonical(scene, ignored)});
  std::vector<std::string> files = options.outputs;
  for (const std::string& file : {options.summary, options.save_to, options.record})
    if (!file.empty()) files.push_back(file);
  for (const std::string& file : files) {
    const fs::path target = followed(file);
    const bool is_device = fs::exists(target, ignored) && !fs::is_regular_file(target, ignored);
    reach.write.push_back(is_device ? target.string() : folder_of(target));
    if (file.ends_with(".png")) add_drawing(reach);
  }
  return reach;
}

Reach reach_of_window(const RunOptions& options, const std::string& scene, const std::string& home) {
  Reach reach = reach_of(options, scene, home);
  add_drawing(reach);
  return reach;
}

std::vector<std::string> hold_back(const Reach& reach) {
  Lacks lacks;
  if (!reach.draws) {
    lua::start_limits();
    pantin::Workers(reach.threads).start();
    limit(RLIMIT_NOFILE, most_files, "files that are open are not limited", lacks);
  }
  limit(RLIMIT_CORE, 0, "a crash may leave a core file", lacks);
  limit(RLIMIT_FSIZE, largest_file, "files may grow", lacks);
  limit(RLIMIT_DATA, data_in_use() + reach.memory, "memory is limited by the program's own checks alone", lacks);
  if (reach.draws) limit_threads(reach, lacks);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) lacks.add("other programs may get more rights");
  hold_files(reach, lacks);
  if (Filter filter(reach.draws); !filter.hold())
    lacks.add("this kernel has no filter of system calls, sockets and programs are not held back");
  return std::move(lacks).lines();
}

void confine(const Reach& reach) {
  for (const std::string& line : hold_back(reach)) say(line);
}

}  // namespace pantin::player
