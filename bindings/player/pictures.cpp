#include "player/pictures.hpp"

#include <algorithm>
#include <cmath>

#include "player/marks.hpp"
#include "view/picture.hpp"

namespace pantin::player {
namespace {

constexpr double animation_rate =
    25.0;  ///< [1/s] of .gif and .webp, whose frame times are whole hundredths of a second

bool is_mp4(const std::string& path) { return path.ends_with(".mp4"); }

}  // namespace

Pictures::Pictures(const Scene& scene, Size size, const Views& views, const std::vector<std::string>& film_paths)
    : scene_(scene),
      views_(views),
      window_(scene.title(), size.width, size.height, true),
      renderer_(size.width, size.height, 4),
      clock_{std::any_of(film_paths.begin(), film_paths.end(), is_mp4) ? usual_frame_rate : animation_rate,
             scene.pace()} {
  if (scene.dark()) views_.set(View::dark, true);
  renderer_.open(scene.world());
  camera_ = aim(scene, renderer_.stage(), static_cast<double>(size.width) / size.height);
  for (const std::string& path : film_paths)
    films_.push_back(std::make_unique<Film>(path, size.width, size.height, clock_.rate));
}

Overlay Pictures::overlay() const {
  Overlay overlay;
  overlay.pace = scene_.pace();
  overlay.views = views_;
  write_marks_of(scene_, overlay.marks);
  return overlay;
}

void Pictures::draw() {
  renderer_.draw(scene_.world(), camera_, overlay());
  renderer_.read_pixels(pixels_);
}

void Pictures::add_frames() {
  const double time = scene_.world().time;
  follower_.move(scene_, renderer_.stage(), static_cast<double>(renderer_.width()) / renderer_.height(),
                 std::fmax(0.0, time - seen_) / scene_.pace(), camera_);
  seen_ = time;
  renderer_.watch(scene_.world(), views_, scene_.pace());
  if (films_.empty()) return;
  const World& world = scene_.world();
  bool drawn = false;
  while (clock_.take(world)) {
    if (!drawn) draw();
    drawn = true;
    for (auto& film : films_) film->add(pixels_);
  }
}

void Pictures::finish_film(const std::string& path) {
  for (auto& film : films_)
    if (film->path() == path) film->finish();
}

void Pictures::write_picture(const std::string& path) {
  draw();
  write_png(path, pixels_, renderer_.pixels_wide(), renderer_.pixels_high());
}

}  // namespace pantin::player
