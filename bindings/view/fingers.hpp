#pragma once
#include <functional>
#include <map>

#include "view/camera.hpp"
#include "view/gestures.hpp"

namespace pantin {

/// What fingers do beside being hands. Two, of which not both hold something, zoom by a pinch, shift by a drag and turn by
/// a twist; one that rests for a while where nothing is becomes the right button of a mouse, which turns the view. A double
/// tap is a double click.
class Fingers {
 public:
  struct Frame {
    double time = 0.0;                                   ///< [s] since the last
    std::function<bool(double x, double y)> takes_hold;  ///< of something, by a press at that pixel; null: never
    bool draws = false;                                  ///< what one finger does needs no thing, and may take its time
    int width = 0, height = 0;                           ///< [px] of the picture
    Camera& camera;
  };
  /// Takes out of the gestures, once panels took what is theirs, what moves the camera.
  void take(Gestures& gestures, const Frame& frame);

 private:
  enum class Role : std::uint8_t { hand, right_button, camera, nothing };
  struct Finger {
    Role role = Role::hand;
    double x0 = 0.0, y0 = 0.0, x = 0.0, y = 0.0;  ///< [px] of the press, and now
    double since = 0.0;                           ///< [s]
    bool holds = false, moved = false;
  };
  bool take(PointerEvent& event, const Frame& frame);
  void press(PointerEvent& event, const Frame& frame);
  void move_camera(const Finger& moved, double x, double y, const Frame& frame);
  void look_for_rest(const Frame& frame);
  void show(Gestures& gestures) const;

  std::map<PointerId, Finger> fingers_;
  double time_ = 0.0;                                          ///< [s]
  double tapped_at_ = -1.0, tapped_x_ = 0.0, tapped_y_ = 0.0;  ///< [s, px] the last press
  double turned_ = 0.0;                                        ///< [rad] by which two fingers twisted so far
  PointerId fresh_ = 0;                                        ///< became the right button in this frame
};

}  // namespace pantin
