#include "view/steering.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

using Kind = PointerEvent::Kind;

constexpr double speed = 0.9;         // [picture heights per s] of a stick that is pressed fully
constexpr double key_speed = 0.45;    // the same of an arrow key
constexpr double dead_zone = 0.18;    // a stick at rest is never quite in its middle
constexpr double longest_time = 0.1;  // [s]

bool down(const Gestures& gestures, std::initializer_list<const char*> names) {
  return std::ranges::any_of(names, [&](const char* name) {
    return std::ranges::count(gestures.held, name) > 0 || std::ranges::count(gestures.keys, name) > 0;
  });
}

Stick arrow_keys(const Gestures& gestures) {
  Stick stick;
  stick.x = down(gestures, {"right", "keypad 6"}) - down(gestures, {"left", "keypad 4"});
  stick.y = down(gestures, {"down", "keypad 2"}) - down(gestures, {"up", "keypad 8"});
  stick.pressed = down(gestures, {"return", "keypad enter", "keypad 5"});
  return stick;
}

/// Slow in the middle, fast at the rim.
double answer(double deflection) {
  const double beyond = std::clamp((deflection - dead_zone) / (1.0 - dead_zone), 0.0, 1.0);
  return beyond * beyond;
}

void tell(Gestures& gestures, PointerEvent event) {
  event.shift = gestures.shift;
  event.control = gestures.control;
  gestures.events.push_back(event);
}

}  // namespace

void Steering::move(Gestures& gestures, double seconds) {
  const double time = std::clamp(seconds, 0.0, longest_time);
  std::map<PointerId, Stick> sticks = gestures.sticks;
  const Stick keys = arrow_keys(gestures);
  if (keys.x != 0.0 || keys.y != 0.0 || cursors_.contains(key_cursor)) sticks[key_cursor] = keys;
  for (const auto& [id, stick] : sticks) {
    const bool by_keys = id == key_cursor;
    const double slow = by_keys && gestures.shift ? 0.2 : 1.0;
    follow(gestures, id, stick, slow * time * (by_keys ? key_speed : speed) * gestures.height);
  }
  std::erase_if(cursors_, [&](auto& entry) {
    if (sticks.contains(entry.first)) return false;
    if (entry.second.pressed)
      tell(gestures, {.kind = Kind::release,
                      .button = PointerEvent::Button::left,
                      .pointer = entry.first,
                      .x = entry.second.x,
                      .y = entry.second.y});
    return true;
  });
}

void Steering::follow(Gestures& gestures, PointerId id, const Stick& stick, double pixels) {
  const double deflection = std::hypot(stick.x, stick.y), part = answer(std::min(deflection, 1.0));
  if (!cursors_.contains(id)) {
    if (!(part > 0.0) && !stick.pressed) return;
    cursors_[id] = {0.5 * gestures.width, 0.5 * gestures.height, false};
  }
  Cursor& cursor = cursors_[id];
  PointerEvent event;
  event.pointer = id;
  if (part > 0.0) {
    const double x = cursor.x, y = cursor.y;
    cursor.x = std::clamp(x + pixels * part * stick.x / deflection, 0.0, static_cast<double>(gestures.width));
    cursor.y = std::clamp(y + pixels * part * stick.y / deflection, 0.0, static_cast<double>(gestures.height));
    event.dx = cursor.x - x;
    event.dy = cursor.y - y;
  }
  event.x = cursor.x;
  event.y = cursor.y;
  if (part > 0.0) tell(gestures, event);
  if (stick.pressed != cursor.pressed) {
    cursor.pressed = stick.pressed;
    event.kind = stick.pressed ? Kind::press : Kind::release;
    event.button = PointerEvent::Button::left;
    event.dx = event.dy = 0.0;
    tell(gestures, event);
  }
  gestures.pointers[id] = {cursor.x, cursor.y, cursor.pressed, false, false};
}

}  // namespace pantin
