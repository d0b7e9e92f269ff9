#pragma once
#include <memory>
#include <set>
#include <span>
#include <string>

#include "view/camera.hpp"
#include "view/finger_scroll.hpp"
#include "view/gestures.hpp"
#include "view/overlay.hpp"

struct ImGuiContext;
struct ImDrawList;

namespace pantin {

/// What the views add to an overlay.
struct ShownViews {
  std::span<const Mark> marks;
  std::string_view colors, forces;  ///< legends, or empty
};

/// The overlay's text, buttons and windows, by Dear ImGui. It hears of hands from gestures alone.
class Panel {
 public:
  /// `scale` pixels of the framebuffer in each px.
  explicit Panel(double scale);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  void set_scale(double scale);
  /// Hears what hands did, and takes out of it what is for the panel.
  void take(Gestures& gestures);
  /// Into the framebuffer that is bound, of that size [px] times the scale; marks as the camera sees them.
  void draw(const Overlay& overlay, const ShownViews& views, const Camera& camera, int width, int height);
  const std::string& pressed() const { return pressed_; }
  bool writing() const;
  bool under_pointer() const { return under_pointer_; }

 private:
  bool covers(double x, double y) const;
  void take_events(Gestures& gestures);
  void take_keys(Gestures& gestures);
  ImDrawList& own_list();
  void marks(const Overlay& overlay, const ShownViews& views, const Camera& camera, int width, int height);
  void status(const Overlay& overlay, float width, float height);
  void help(const Overlay& overlay, float width, float height);
  void buttons(const Overlay& overlay);

  ImGuiContext* context_;
  float scale_;
  bool dark_ = false;
  std::unique_ptr<ImDrawList> list_;  ///< of what is drawn before the rest
  std::string pressed_;
  bool under_pointer_ = false;
  PointerId pointer_ = 0;  ///< whom it listens to: the mouse, or the finger that touched it last
  FingerScroll scroll_;
  std::set<PointerId> engaged_;  ///< went down on it
};

}  // namespace pantin
