#pragma once
#include <map>

#include "view/gestures.hpp"

namespace pantin {

/// Cursors that are steered, not pointed with: of each gamepad stick, and one of the arrow keys and Enter. They become
/// pointers as the mouse is one.
class Steering {
 public:
  /// Moves the cursors as sticks and keys have it for a time [s], and adds their pointers and events to the gestures. The
  /// cursor of a stick that is gone lets go.
  void move(Gestures& gestures, double seconds);

 private:
  struct Cursor {
    double x = 0.0, y = 0.0;  // [px]
    bool pressed = false;
  };
  void follow(Gestures& gestures, PointerId id, const Stick& stick, double pixels);

  std::map<PointerId, Cursor> cursors_;
};

}  // namespace pantin
