#include "view/film.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/check.hpp"

namespace pantin {

namespace {

std::string ending(const std::string& path) {
  std::string e = std::filesystem::path(path).extension().string();
  std::transform(e.begin(), e.end(), e.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return e;
}

std::vector<std::string> arguments(const std::string& out, const std::string& kind, int width, int height,
                                   double rate) {
  std::vector<std::string> list = {"ffmpeg",
                                   "-nostdin",
                                   "-loglevel",
                                   "error",
                                   "-y",
                                   "-f",
                                   "rawvideo",
                                   "-pix_fmt",
                                   "rgba",
                                   "-s",
                                   text(width, "x", height),
                                   "-r",
                                   to_text(rate),
                                   "-i",
                                   "-"};
  const std::string slower = text("fps=", to_text(std::min(rate, 25.0)));
  std::vector<std::string> rest;
  if (kind == ".mp4")  // libx264 wants even sizes
    rest = {"-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
            "-c:v",      "libx264",
            "-preset",   "veryfast",
            "-crf",      "18",
            "-pix_fmt",  "yuv420p",
            "-movflags", "+faststart",
            "-f",        "mp4"};
  else if (kind == ".gif")
    rest = {"-vf", slower + ",split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif"};
  else
    rest = {"-vf", slower, "-c:v", "libwebp", "-q:v", "75", "-loop", "0", "-f", "webp"};
  list.insert(list.end(), rest.begin(), rest.end());
  list.push_back(out);
  return list;
}

// In the child: becomes ffmpeg, or tells through `report` why it cannot.
[[noreturn]] void become_ffmpeg(std::vector<char*>& argv, int in, int errors, int report) {
  ::setpgid(0, 0);  // Ctrl-C in the terminal ends the run, which then finishes the film
  ::signal(SIGPIPE, SIG_DFL);
  ::dup2(in, STDIN_FILENO);
  const int nothing = ::open("/dev/null", O_WRONLY);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  ::execvp(argv[0], argv.data());
  const int why = errno;
  if (::write(report, &why, sizeof why) < 0) ::_exit(126);
  ::_exit(127);
}

/// By its first bytes a RIFF file says how long it is, an MPEG-4 file how long each of its boxes is; a GIF ends with a mark. (What
/// ffmpeg cannot write it does not always tell.)
bool is_whole(const std::string& path, const std::string& kind) {
  std::ifstream file(path, std::ios::binary);
  const auto size = static_cast<std::uint64_t>(file.seekg(0, std::ios::end).tellg());
  const auto byte = [&](std::uint64_t at) {
    return static_cast<std::uint64_t>(file.seekg(static_cast<std::streamoff>(at)).get() & 0xff);
  };
  if (!file || size < 16) return false;
  if (kind == ".gif") return byte(size - 1) == 0x3b;
  if (kind == ".webp") return size == 8 + (byte(4) | byte(5) << 8 | byte(6) << 16 | byte(7) << 24);
  std::uint64_t at = 0;
  while (at + 8 <= size) {
    std::uint64_t length = byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
    if (length == 1 && at + 16 <= size) {
      length = 0;
      for (std::uint64_t k = 8; k < 16; k++) length = length << 8 | byte(at + k);
    }
    if (length < 8) return false;
    at += length;
  }
  return at == size;
}

}  // namespace

bool Film::can_write(const std::string& path) {
  const std::string e = ending(path);
  return e == ".mp4" || e == ".gif" || e == ".webp";
}

Film::Film(std::string path, int width, int height, double rate) : path_(std::move(path)) {
  require(can_write(path_), "film '", path_, "': the ending must be .mp4, .gif or .webp");
  require(width > 0 && height > 0, "film '", path_, "': the size must be > 0, got ", width, " x ", height);
  require(std::isfinite(rate) && rate > 0.0, "film '", path_, "': the rate must be > 0 frames/s, got ", rate);
  frame_size_ = 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  temporary_ = text(path_, ".", ::getpid(), ".part");
  const int probe = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  require(probe >= 0, "film '", path_, "' cannot be written: ", std::strerror(errno));
  ::close(probe);
  start(width, height, rate);
}

void Film::start(int width, int height, double rate) {
  ::signal(SIGPIPE, SIG_IGN);  // a dead ffmpeg shows as a failed write
  std::vector<std::string> list = arguments(temporary_, ending(path_), width, height, rate);
  std::vector<char*> argv;
  for (std::string& a : list) argv.push_back(a.data());
  argv.push_back(nullptr);

  int frames[2] = {-1, -1}, report[2] = {-1, -1};
  if (std::FILE* file = std::tmpfile()) {
    errors_ = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 3);
    std::fclose(file);
  }
  if (errors_ < 0 || ::pipe2(frames, O_CLOEXEC) != 0 || ::pipe2(report, O_CLOEXEC) != 0) fail(std::strerror(errno));
  process_ = ::fork();
  if (process_ == 0) become_ffmpeg(argv, frames[0], errors_, report[1]);
  const int why_no_fork = errno;
  ::close(frames[0]);
  ::close(report[1]);
  pipe_ = frames[1];
  int why = 0;
  const bool failed = process_ > 0 && ::read(report[0], &why, sizeof why) > 0;
  ::close(report[0]);
  if (process_ < 0) fail(std::strerror(why_no_fork));
  if (failed && why == ENOENT) fail("the program ffmpeg is not installed (Debian: apt-get install ffmpeg)");
  if (failed) fail(text("ffmpeg does not start: ", std::strerror(why)));
}

void Film::add(std::span<const std::uint8_t> pixels) {
  require(pixels.size() == frame_size_, "film '", path_, "': a frame has ", frame_size_, " bytes, got ", pixels.size());
  require(pipe_ >= 0, "film '", path_, "' is finished");
  const std::uint8_t* next = pixels.data();
  std::size_t left = pixels.size();
  while (left > 0) {
    const ssize_t n = ::write(pipe_, next, left);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const std::string why = std::strerror(errno);
      stop();
      const std::string said = complaint();
      fail(said.empty() ? why : said);
    }
    next += n;
    left -= static_cast<std::size_t>(n);
  }
  frames_++;
}

void Film::finish() {
  if (pipe_ < 0) return;
  stop();
  if (frames_ == 0) fail("it has no frames");
  if (status_ != 0) fail(text("ffmpeg failed: ", complaint()));
  if (!is_whole(temporary_, ending(path_))) fail("it was cut off; is the disk full?");
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(std::strerror(errno));
  if (errors_ >= 0) ::close(errors_);
  errors_ = -1;
}

void Film::stop() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
  while (process_ > 0 && ::waitpid(process_, &status_, 0) < 0 && errno == EINTR) {}
  process_ = -1;
}

void Film::fail(const std::string& why) {
  stop();
  ::unlink(temporary_.c_str());
  if (errors_ >= 0) ::close(errors_);
  errors_ = -1;
  throw Error(text("film '", path_, "' cannot be written: ", why));
}

std::string Film::complaint() const {
  char buffer[2000];
  const ssize_t n = errors_ < 0 ? 0 : ::pread(errors_, buffer, sizeof buffer, 0);
  std::string said(buffer, n > 0 ? static_cast<std::size_t>(n) : 0);
  while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
  for (std::size_t at; (at = said.find(temporary_)) != std::string::npos;) said.replace(at, temporary_.size(), path_);
  return said;
}

Film::~Film() {
  const bool unfinished = pipe_ >= 0;
  stop();
  if (unfinished) ::unlink(temporary_.c_str());
  if (errors_ >= 0) ::close(errors_);
}

}  // namespace pantin
