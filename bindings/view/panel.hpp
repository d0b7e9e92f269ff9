#pragma once
#include <string>

#include "view/camera.hpp"
#include "view/overlay.hpp"

struct ImGuiContext;

namespace pantin {

/// The overlay's text and buttons, by Dear ImGui. It hears of the pointer from the overlay alone.
class Panel {
 public:
  explicit Panel(double scale);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  /// Into the framebuffer that is bound, of that size [px]; the overlay's marks as the camera sees them.
  void draw(const Overlay& overlay, const Camera& camera, int width, int height);
  const std::string& pressed() const { return pressed_; }
  bool under_pointer() const { return under_pointer_; }

 private:
  void status(const Overlay& overlay, float width, float height);
  void help(const Overlay& overlay, float width, float height);
  void buttons(const Overlay& overlay);

  ImGuiContext* context_;
  float scale_;
  std::string pressed_;
  bool under_pointer_ = false;
};

}  // namespace pantin
