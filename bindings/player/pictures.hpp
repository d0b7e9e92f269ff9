#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "player/aim.hpp"
#include "player/frame_clock.hpp"
#include "player/options.hpp"
#include "scene/scene.hpp"
#include "view/film.hpp"
#include "view/renderer.hpp"
#include "view/window.hpp"

namespace pantin::player {

/// Draws a scene without a window, for a last picture and for films at the scene's pace.
class Pictures {
 public:
  /// `film_paths` are files to write films to, by their endings.
  Pictures(const Scene& scene, Size size, const Views& views, const std::vector<std::string>& film_paths);

  /// Adds the frames that are due at the scene's present time; call it at the start and after each step.
  void add_frames();
  /// By its path.
  void finish_film(const std::string& path);
  void write_picture(const std::string& path);

 private:
  void draw();
  Overlay overlay() const;

  const Scene& scene_;
  Views views_;
  Window window_;
  Renderer renderer_;
  Camera camera_;
  Follower follower_;
  double seen_ = 0.0;  ///< [s] time of the scene when the camera was moved last
  std::vector<std::unique_ptr<Film>> films_;
  std::vector<std::uint8_t> pixels_;
  FrameClock clock_;
};

}  // namespace pantin::player
