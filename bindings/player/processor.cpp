// What a processor must be able to run is looked at before anything else of the program runs: all but this file may have been
// compiled for more than the processor has. Hence nothing of C++'s library here, whose templates others share.
#include <unistd.h>

#include <climits>
#include <cstring>

namespace {

/// x86-64-v3 has more than these three; there is no processor that has them and lacks the rest.
bool is_wide() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
}

#ifdef PANTIN_WIDE_PROGRAM

/// Goes on as the program that was built for such a processor, if that is there: its path from this one's folder is given.
void settle(char** arguments, char** environment) {
  char path[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path - sizeof PANTIN_WIDE_PROGRAM);
  if (length <= 0 || !is_wide()) return;
  path[length] = '\0';
  std::strcpy(std::strrchr(path, '/') + 1, PANTIN_WIDE_PROGRAM);
  execve(path, arguments, environment);
}

#else

void settle(char**, char**) {
  if (is_wide()) return;
  constexpr char message[] =
      "pantin: this program was built for processors with AVX2 and FMA (x86-64-v3), and this one lacks them: take the "
      "Debian package, which runs on every x86-64, or build with -DPANTIN_ARCH=x86-64\n";
  (void)!write(STDERR_FILENO, message, sizeof message - 1);
  _exit(2);
}

#endif

/// Before all others, which have no number.
[[gnu::constructor(101)]] void fit_processor(int, char** arguments, char** environment) {
  settle(arguments, environment);
}

}  // namespace
