#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "view/camera.hpp"
#include "view/gestures.hpp"
#include "view/overlay.hpp"
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin {

/// Draws a world with OpenGL 3.3 into a framebuffer of its own. Needs a current context: make a Window first.
class Renderer {
 public:
  /// Marks, text, gestures and `width` and `height` are in px of a display of ordinary density; the picture has `scale`
  /// pixels in each. `samples` 0 for speed, 4 for pictures.
  Renderer(int width, int height, int samples = 0, double scale = 1.0);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  void resize(int width, int height, double scale = 1.0);
  int width() const;
  int height() const;
  double scale() const;
  int pixels_wide() const;  ///< of the picture
  int pixels_high() const;

  /// Sets the ground and the sizes of what is drawn by a world at its start. Call it whenever a world was built anew; the
  /// first `draw` does it by itself.
  void open(const World& world);
  const Stage& stage() const;

  /// Notes what only shows over time, for views that show it. `draw` does it, too: call it where few pictures are drawn.
  void watch(const World& world, const Views& views, double pace);
  void draw(const World& world, const Camera& camera, const Overlay& overlay = {});

  /// RGBA, 4 bytes a pixel, top row first.
  std::vector<std::uint8_t> read_pixels();
  /// The same, without a new vector.
  void read_pixels(std::vector<std::uint8_t>& into);
  /// Copies the picture to the window's own framebuffer of that size [pixels].
  void show(int window_width, int window_height);

  /// Hands gestures to the overlay's buttons, cards and windows, and takes out of them what is theirs: presses and the
  /// wheel over them, and keys while a text is being written. Call it before the gestures serve the scene.
  void listen(Gestures& gestures);
  /// Name of the overlay's button that was pressed in the last `draw`, or empty.
  const std::string& pressed_button() const;
  /// A text is being written in the overlay: keys are not for the scene.
  bool writing() const;
  /// The mouse is over a button, card or window of the overlay, or drags in one.
  bool pointer_on_panel() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pantin
