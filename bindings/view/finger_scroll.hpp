#pragma once
#include <cstdint>

namespace pantin {

/// A finger that goes up or down over a window of Dear ImGui that is longer than it shows scrolls it, and presses nothing.
class FingerScroll {
 public:
  /// Before each frame, where the finger is [px]; true where the finger is not to be told as the mouse.
  bool take(float x, float y);
  /// No finger touches.
  void end() { *this = {}; }

 private:
  bool down_ = false, scrolls_ = false, refused_ = false;
  float x0_ = 0.0f, y0_ = 0.0f, y_ = 0.0f;
  std::uint32_t window_ = 0;
};

}  // namespace pantin
