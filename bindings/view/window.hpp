#pragma once
#include <memory>
#include <string>

#include "view/gestures.hpp"

namespace pantin {

class Renderer;

/// SDL's connection to the display. While one lives, windows open on the same: a display whose last client leaves may go
/// away for a moment.
class Display {
 public:
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  /// A screen is there to open a visible window on.
  bool seen() const;

 private:
  bool open_;
};

/// An SDL window with an OpenGL 3.3 core context, which it makes current. A hidden one needs no display: it uses SDL's
/// offscreen driver. Another throws Error where it would be seen nowhere, unless SDL_VIDEODRIVER asks for that. Throws
/// Error, with SDL's words, where there is no display or no OpenGL.
class Window {
 public:
  Window(const std::string& title, int width, int height, bool hidden = false);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// The display went away; `poll` then asks for the end.
  bool lost() const;
  /// Takes all waiting events into `gestures`; false once the window is to be closed.
  bool poll(Gestures& gestures);
  /// Copies the renderer's picture to the window and shows it.
  void present(Renderer& renderer);
  void set_title(const std::string& title);
  /// Fills the screen, or is as it was.
  void toggle_fullscreen();
  int width() const;   ///< [px] as of a display of ordinary density
  int height() const;  ///< [px]
  /// Pixels in each px: 2 or so on a dense display.
  double scale() const;
  /// OpenGL is done by the processor: draw without samples when it must be quick.
  bool software() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pantin
