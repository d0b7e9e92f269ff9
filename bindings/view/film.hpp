#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace pantin {

/// A film written by the program ffmpeg: .mp4, .gif or .webp by the path's ending. The file appears when `finish`
/// returns, or not at all. Every function throws Error that names the path.
class Film {
 public:
  /// `rate` [1/s] frames. (A .gif or .webp keeps at most 25 of them per second.)
  Film(std::string path, int width, int height, double rate);
  /// Without `finish`, nothing is left.
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// RGBA, top row first, of the size given at the start.
  void add(std::span<const std::uint8_t> pixels);
  void finish();
  std::uint64_t frames() const { return frames_; }
  const std::string& path() const { return path_; }

  /// The endings it knows.
  static bool can_write(const std::string& path);

 private:
  void start(int width, int height, double rate);
  void stop();  // end ffmpeg and wait for it
  [[noreturn]] void fail(const std::string& why);
  std::string complaint() const;  // what ffmpeg wrote on stderr

  std::string path_;
  std::string temporary_;
  int pipe_ = -1;
  int errors_ = -1;
  int process_ = -1;
  int status_ = 0;
  std::size_t frame_size_ = 0;  // bytes
  std::uint64_t frames_ = 0;
};

}  // namespace pantin
