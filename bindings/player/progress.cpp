#include "player/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace pantin::player {

Progress::Progress(double until) : until_(until), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double time) {
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(100);
  double spent = std::chrono::duration<double>(Clock::now() - start_).count();
  double part = std::clamp(time / until_, 1e-9, 1.0);
  constexpr int width = 30;
  int filled = static_cast<int>(part * width);
  std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(width - filled), '.');
  std::fprintf(stderr, "\r\033[K[%s] %3.0f %%  %.2f of %g s  %.2g x real time  %.0f s left", bar.c_str(), 100 * part,
               time, until_, time / spent, spent * (1 - part) / part);
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace pantin::player
