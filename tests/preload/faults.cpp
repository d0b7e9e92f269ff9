// Loaded before the C library into `pantin`: the n-th call of one kind fails, as PANTIN_FAULT says ("write:3"). Whether it came to
// that stands in the file PANTIN_FAULT_TOLD, and how many calls there were.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
}

namespace {

const char* kind = nullptr;
long wanted = 0;
pid_t process = 0;
std::atomic<long> calls{0}, failed{0};

/// Only of the program itself, not of what it starts.
[[gnu::constructor]] void begin() {
  const char* const fault = std::getenv("PANTIN_FAULT");
  if (!fault || std::strcmp(program_invocation_short_name, "pantin") != 0) return;
  const char* const colon = std::strchr(fault, ':');
  wanted = std::atol(colon + 1);
  process = getpid();
  kind = fault;
}

[[gnu::destructor]] void end() {
  const char* const path = std::getenv("PANTIN_FAULT_TOLD");
  if (!kind || !path || getpid() != process) return;
  char text[64];
  const int size = std::snprintf(text, sizeof text, "%ld %ld\n", failed.load(), calls.load());
  const long file = syscall(SYS_open, path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  syscall(SYS_write, file, text, size);
  syscall(SYS_close, file);
}

bool fails(const char* call, int error) {
  if (!kind) return false;
  const std::size_t size = std::strlen(call);
  if (std::strncmp(kind, call, size) != 0 || kind[size] != ':' || getpid() != process) return false;
  if (++calls != wanted) return false;
  failed = 1;
  errno = error;
  return true;
}

template <class F>
F* next(const char* name) {
  return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
}

mode_t mode_of(int flags, va_list list) { return (flags & O_CREAT) != 0 ? va_arg(list, mode_t) : 0; }

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = mode_of(flags, list);
  va_end(list);
  return fails("open", EMFILE) ? -1 : static_cast<int>(syscall(SYS_open, path, flags, mode));
}
int open64(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = mode_of(flags, list);
  va_end(list);
  return fails("open", EMFILE) ? -1 : static_cast<int>(syscall(SYS_open, path, flags, mode));
}
FILE* fopen(const char* path, const char* mode) {
  return fails("open", EMFILE) ? nullptr : next<FILE*(const char*, const char*)>("fopen")(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  return fails("open", EMFILE) ? nullptr : next<FILE*(const char*, const char*)>("fopen64")(path, mode);
}

// What is told on standard error has nobody to be told to.
ssize_t write(int file, const void* data, std::size_t size) {
  return file != 2 && fails("write", ENOSPC) ? -1 : syscall(SYS_write, file, data, size);
}
ssize_t writev(int file, const iovec* parts, int count) {
  return file != 2 && fails("write", ENOSPC) ? -1 : syscall(SYS_writev, file, parts, count);
}
std::size_t fwrite(const void* data, std::size_t size, std::size_t count, FILE* file) {
  if (file != stderr && fails("write", ENOSPC)) return 0;
  return next<std::size_t(const void*, std::size_t, std::size_t, FILE*)>("fwrite")(data, size, count, file);
}

// What fails to be closed is closed all the same.
int close(int file) {
  const long done = syscall(SYS_close, file);
  return fails("close", EIO) ? -1 : static_cast<int>(done);
}
int fclose(FILE* file) {
  const int done = next<int(FILE*)>("fclose")(file);
  return fails("close", EIO) ? EOF : done;
}

int rename(const char* from, const char* to) {
  return fails("rename", EACCES) ? -1 : static_cast<int>(syscall(SYS_rename, from, to));
}
int fsync(int file) { return fails("fsync", EIO) ? -1 : static_cast<int>(syscall(SYS_fsync, file)); }
pid_t fork() { return fails("fork", EAGAIN) ? -1 : next<pid_t()>("fork")(); }

void* malloc(std::size_t size) { return fails("malloc", ENOMEM) ? nullptr : __libc_malloc(size); }
void* realloc(void* block, std::size_t size) { return fails("malloc", ENOMEM) ? nullptr : __libc_realloc(block, size); }
}
