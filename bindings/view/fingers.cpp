#include "view/fingers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pantin {

namespace {

using Kind = PointerEvent::Kind;

constexpr double long_press = 0.5, double_tap = 0.35;  // [s]
constexpr double together = 0.3;                       // [s] in which two fingers come that are to move the camera
constexpr double slop = 12.0, tap_slop = 30.0;         // [px] that fingers move though they rest
constexpr double least_twist = 0.25;                   // [rad] nobody pinches quite straight

bool of_finger(const PointerEvent& event) { return event.pointer > 0 && event.pointer < key_cursor; }

}  // namespace

void Fingers::take(Gestures& gestures, const Frame& frame) {
  time_ += frame.time;
  fresh_ = 0;
  std::vector<PointerEvent> others;
  for (PointerEvent event : gestures.events)
    if (!of_finger(event) || !take(event, frame)) others.push_back(event);
  gestures.events = std::move(others);
  look_for_rest(frame);
  show(gestures);
}

/// What was between the two stays between them.
void Fingers::move_camera(const Finger& moved, double x, double y, const Frame& frame) {
  const auto other = std::ranges::find_if(
      fingers_, [&](const auto& entry) { return entry.second.role == Role::camera && &entry.second != &moved; });
  if (other == fingers_.end()) return;
  const Finger& still = other->second;
  const double x0 = moved.x - still.x, y0 = moved.y - still.y, x1 = x - still.x, y1 = y - still.y;
  frame.camera.pan(0.5 * (x - moved.x) / frame.height, 0.5 * (y - moved.y) / frame.height);
  frame.camera.zoom_at(std::max(1.0, std::hypot(x0, y0)) / std::max(1.0, std::hypot(x1, y1)), 0.5 * (x + still.x),
                       0.5 * (y + still.y), frame.width, frame.height);
  const double twist = std::remainder(std::atan2(y1, x1) - std::atan2(y0, x0), 2.0 * M_PI);
  turned_ += twist;
  if (std::fabs(turned_) > least_twist) frame.camera.orbit(twist, 0.0);
}

/// Whether it is for nobody else.
bool Fingers::take(PointerEvent& event, const Frame& frame) {
  if (event.kind == Kind::press) press(event, frame);
  const auto found = fingers_.find(event.pointer);
  if (found == fingers_.end()) return false;
  Finger& finger = found->second;
  const Role role = finger.role;
  if (role == Role::camera && event.kind == Kind::move) move_camera(finger, event.x, event.y, frame);
  finger.x = event.x;
  finger.y = event.y;
  finger.moved |= std::hypot(event.x - finger.x0, event.y - finger.y0) > slop;
  if (event.kind == Kind::release) {
    if (role == Role::right_button) event.button = PointerEvent::Button::right;
    fingers_.erase(found);
    if (role == Role::camera)
      for (auto& [id, other] : fingers_)
        if (other.role == Role::camera) other.role = Role::nothing;
  }
  return role == Role::camera || role == Role::nothing;
}

void Fingers::press(PointerEvent& event, const Frame& frame) {
  const bool near = std::hypot(event.x - tapped_x_, event.y - tapped_y_) < tap_slop;
  if (fingers_.empty() && near && time_ - tapped_at_ < double_tap) event.clicks = 2;
  tapped_at_ = event.clicks == 2 ? -1.0 : time_;
  tapped_x_ = event.x;
  tapped_y_ = event.y;
  Finger finger{Role::hand, event.x, event.y, event.x, event.y, time_};
  finger.holds = frame.takes_hold && frame.takes_hold(event.x, event.y);
  const auto is_camera = [](const auto& entry) { return entry.second.role == Role::camera; };
  if (std::ranges::any_of(fingers_, is_camera)) {
    finger.role = Role::nothing;
  } else if (fingers_.size() == 1) {
    Finger& first = fingers_.begin()->second;
    const bool just_came = !first.moved && time_ - first.since < together;
    if (first.role != Role::nothing && (!first.holds || (!finger.holds && just_came))) {
      first.role = finger.role = Role::camera;
      turned_ = 0.0;
    }
  }
  fingers_[event.pointer] = finger;
}

void Fingers::look_for_rest(const Frame& frame) {
  if (fingers_.size() != 1 || frame.draws) return;
  auto& [id, finger] = *fingers_.begin();
  if (finger.role != Role::hand || finger.holds || finger.moved || time_ - finger.since < long_press) return;
  finger.role = Role::right_button;
  fresh_ = id;
}

/// A finger that is away lets go.
void Fingers::show(Gestures& gestures) const {
  for (const auto& [id, finger] : fingers_) {
    const auto found = gestures.pointers.find(id);
    if (found == gestures.pointers.end() || finger.role == Role::hand) continue;
    if (finger.role != Role::right_button || id == fresh_) {
      gestures.pointers.erase(found);
    } else {
      found->second.left = false;
      found->second.right = true;
    }
  }
  if (fresh_ != 0) gestures.notes.push_back("the finger turns the view");
}

}  // namespace pantin
