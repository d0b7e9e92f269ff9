#pragma once
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "view/film.hpp"
#include "view/renderer.hpp"

namespace pantin::player {

/// A film of what a window shows, as fast as it was seen. Every function throws Error.
class LiveFilm {
 public:
  LiveFilm(std::string path, const Renderer& renderer);

  const std::string& path() const { return path_; }
  double seconds() const { return seconds_; }
  /// The picture is still of the film's size.
  bool fits(const Renderer& renderer) const;
  /// Adds the frames that are due, all of the present picture. Where the window stood still for long, the film does not.
  void add(Renderer& renderer);
  void finish() { film_.finish(); }

 private:
  using Clock = std::chrono::steady_clock;

  std::string path_;
  int width_, height_;  // [px]
  Film film_;
  Clock::time_point last_ = Clock::now();
  double seconds_ = 0.0;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace pantin::player
