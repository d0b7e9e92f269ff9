#include "player/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "base/check.hpp"
#include "player/message.hpp"

namespace pantin::player {
namespace {

using namespace std::chrono_literals;

constexpr ProgressLine::Clock::duration between_moves = 100ms, between_lines = 10s, without_lines = 300s;

std::string fixed(double value, int digits) {
  char all[64];
  std::snprintf(all, sizeof all, "%.*f", digits, value);
  return all;
}

}  // namespace

ProgressLine::ProgressLine(Clock::duration quiet) : terminal_(isatty(STDERR_FILENO) != 0), next_(start_ + quiet) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

bool ProgressLine::is_due(double part) const {
  const auto now = Clock::now();
  if (terminal_) return now >= next_;
  return now >= last_ + between_lines && (part >= part_ + 0.1 || now >= last_ + without_lines || last_ == start_);
}

void ProgressLine::show(double part, const std::string& line) {
  part_ = part;
  last_ = Clock::now();
  next_ = last_ + between_moves;
  if (!terminal_) {
    say(line);
    return;
  }
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  shown_ = true;
}

double ProgressLine::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

std::string ProgressLine::time_left(double done) const {
  const double left = seconds() * (1.0 - done) / done;
  if (left < 120.0) return fixed(left, 0) + " s left";
  return left < 7200.0 ? fixed(left / 60.0, 0) + " min left" : fixed(left / 3600.0, 1) + " h left";
}

Progress::Progress(double from) : from_(from) {}

void Progress::show(double time, double until) {
  const double done = std::clamp((time - from_) / (until - from_), 1e-9, 1.0);
  if (!line_.is_due(done)) return;
  std::string line = text(fixed(100.0 * done, 0), " %  ", fixed(time, 2), " of ", until, " s  ",
                          rounded((time - from_) / line_.seconds()), " x real time  ", line_.time_left(done));
  if (line_.moves()) {
    constexpr double width = 30.0;
    const auto filled = static_cast<std::size_t>(done * width);
    line = "[" + std::string(filled, '#') + std::string(static_cast<std::size_t>(width) - filled, '.') + "] " + line;
  }
  line_.show(done, line);
}

}  // namespace pantin::player
