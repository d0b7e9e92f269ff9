#include "player/live_film.hpp"

#include <algorithm>
#include <utility>

namespace pantin::player {
namespace {

constexpr double rate = 30.0;           // [1/s]
constexpr double longest_still = 0.25;  // [s]

}  // namespace

LiveFilm::LiveFilm(std::string path, const Renderer& renderer)
    : path_(std::move(path)),
      width_(renderer.pixels_wide()),
      height_(renderer.pixels_high()),
      film_(path_, width_, height_, rate) {}

bool LiveFilm::fits(const Renderer& renderer) const {
  return renderer.pixels_wide() == width_ && renderer.pixels_high() == height_;
}

void LiveFilm::add(Renderer& renderer) {
  const Clock::time_point now = Clock::now();
  seconds_ += std::min(std::chrono::duration<double>(now - std::exchange(last_, now)).count(), longest_still);
  if (static_cast<double>(film_.frames()) > seconds_ * rate) return;
  renderer.read_pixels(pixels_);
  while (static_cast<double>(film_.frames()) <= seconds_ * rate) film_.add(pixels_);
}

}  // namespace pantin::player
