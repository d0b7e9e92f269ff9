// Pictures, films and tables that a person takes in the window.
#include "player/marks.hpp"
#include "player/message.hpp"
#include "player/output.hpp"
#include "player/player.hpp"
#include "view/picture.hpp"

namespace pantin::player {

void Player::write_picture(const std::string& path) {
  Overlay overlay;
  overlay.pace = scene_->pace();
  overlay.views = views_;
  write_marks_of(*scene_, overlay.marks);
  renderer_.draw(scene_->world(), camera_, overlay);
  write_png(path, renderer_.read_pixels(), renderer_.pixels_wide(), renderer_.pixels_high());
}

void Player::save_picture() {
  try {
    Output file(free_name(".png"));
    write_picture(file.temporary());
    file.keep();
    wrote(file.path());
  } catch (const std::exception& error) { complain(error.what()); }
}

void Player::write_table() {
  try {
    Output file(free_name(".csv"));
    file.write(probe_table(times_, scene_->world().probes));
    file.keep();
    wrote(file.path());
  } catch (const std::exception& error) { complain(error.what()); }
}

void Player::toggle_film() {
  if (film_) return end_film();
  try {
    film_ = std::make_unique<LiveFilm>(free_name(".mp4"), renderer_);
    status_.note(film_panels_ ? "filming all that is on the screen" : "filming the scene");
  } catch (const std::exception& error) { complain(error.what()); }
}

void Player::add_to_film() {
  if (!film_) return;
  if (!film_->fits(renderer_)) {
    complain("the film ends here: the window has another size");
    return end_film();
  }
  try {
    film_->add(renderer_);
  } catch (const std::exception& error) {
    film_.reset();
    complain(error.what());
  }
}

void Player::end_film() {
  if (!film_) return;
  const std::unique_ptr<LiveFilm> film = std::move(film_);
  try {
    film->finish();
    wrote(film->path());
  } catch (const std::exception& error) { complain(error.what()); }
}

void Player::wrote(const std::string& path) {
  const std::string what = "wrote " + path;
  status_.note(what);
  log(what, true);
}

}  // namespace pantin::player
