#include "player/controls.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "scene/controls.hpp"
#include "view/making.hpp"

namespace pantin::player {
namespace {

bool of_pad(const std::string& name) { return name.starts_with(pad_prefix); }
bool of_mouse(const std::string& name) { return name.starts_with(mouse_prefix); }

double held(const Gestures& gestures, const std::string& name) {
  if (of_pad(name)) {
    const auto found = gestures.pad.find(name);
    return found == gestures.pad.end() ? 0.0 : found->second;
  }
  const bool down = std::ranges::count(gestures.held, name) > 0 || std::ranges::count(gestures.keys, name) > 0;
  return down ? 1.0 : 0.0;
}

void tell(StepInput& waiting, const std::string& name, double known, double value) {
  const auto told = std::ranges::find_if(
      waiting.commands, [&](const Command& c) { return c.kind == Command::Kind::control && c.name == name; });
  if (told != waiting.commands.end()) {
    if (value != 0.0) told->value = value;  // what is let go meanwhile is told once the step has seen it
    return;
  }
  if (value == known) return;
  Command command;
  command.kind = Command::Kind::control;
  command.name = name;
  command.value = value;
  waiting.commands.push_back(command);
  if (!of_pad(name) || known != 0.0) return;  // keys are told as the window hears them
  command.kind = Command::Kind::key;
  command.value = 0.0;
  waiting.commands.push_back(command);
}

/// A stick of which the scene reads an axis, or its button, is no hand.
void take_sticks(const std::vector<std::string>& wanted, Gestures& gestures) {
  const auto takes = [&](std::string_view side) {
    return std::ranges::any_of(wanted, [&](const std::string& name) {
      return of_pad(name) && std::string_view(name).substr(pad_prefix.size()).starts_with(std::string(side) + "_");
    });
  };
  const bool left = takes("left"), right = takes("right");
  std::erase_if(gestures.sticks,
                [&](const auto& stick) { return (stick.first - first_stick) % 2 == 0 ? left : right; });
}

using Kind = PointerEvent::Kind;

struct NamedButton {
  const char* name;
  PointerEvent::Button button;
  bool Pointer::*down;
  MouseButton Mouse::*known;
};
constexpr NamedButton mouse_buttons[] = {{"left", PointerEvent::Button::left, &Pointer::left, &Mouse::left},
                                         {"middle", PointerEvent::Button::middle, &Pointer::middle, &Mouse::middle},
                                         {"right", PointerEvent::Button::right, &Pointer::right, &Mouse::right}};

bool is_finger(PointerId id) { return id > 0 && id < key_cursor; }

/// The first finger, also one that is up again, else the mouse; with the buttons that were down since the last frame.
std::optional<Pointer> that_points(const Gestures& gestures) {
  std::optional<std::pair<PointerId, Pointer>> first;
  for (const auto& [id, pointer] : gestures.pointers)
    if (!first && is_finger(id)) first = {id, pointer};
  for (const PointerEvent& event : gestures.events)
    if (!first && is_finger(event.pointer)) first = {event.pointer, Pointer{event.x, event.y}};
  if (const auto mouse = gestures.pointers.find(0); !first && mouse != gestures.pointers.end()) first = *mouse;
  if (!first) return {};
  for (const PointerEvent& event : gestures.events)
    for (const NamedButton& button : mouse_buttons)
      if (event.pointer == first->first && event.kind == Kind::press && event.button == button.button)
        first->second.*button.down = true;
  return first->second;
}

/// What the scene reads of the mouse is not for the window.
void take_mouse(const auto& wanted, Gestures& gestures) {
  const auto is_taken = [&](const PointerEvent& event) {
    if (event.pointer >= key_cursor) return false;
    if (event.kind == Kind::wheel) return wanted("wheel");
    return event.kind == Kind::press && std::ranges::any_of(mouse_buttons, [&](const NamedButton& button) {
             return event.button == button.button && wanted(button.name);
           });
  };
  std::erase_if(gestures.events, is_taken);
  for (auto& [id, pointer] : gestures.pointers)
    if (id < key_cursor)
      for (const NamedButton& button : mouse_buttons) pointer.*button.down &= !wanted(button.name);
}

}  // namespace

void give_mouse(const Scene& scene, const Viewport& viewport, bool heard, Gestures& gestures, StepInput& waiting) {
  const std::vector<std::string> read = scene.controls();
  if (std::ranges::none_of(read, of_mouse)) return;
  const auto wanted = [&](const char* name) { return std::ranges::count(read, std::string(mouse_prefix) + name) > 0; };
  const Mouse& known = scene.world().mouse;
  const auto told = std::ranges::find(waiting.commands, Command::Kind::mouse, &Command::kind);
  const bool is_told = told != waiting.commands.end();
  Command now;
  now.kind = Command::Kind::mouse;
  now.position = known.position.value_or(zero3());
  if (is_told) now = *told;
  bool differs = is_told;
  const std::optional<Pointer> pointer = heard ? that_points(gestures) : std::nullopt;
  if (pointer) now.position = place_pointed_at(viewport, pointer->x, pointer->y);
  differs |= pointer && (!known.position || norm2(now.position - *known.position) > 0.0);
  const std::string before = std::exchange(now.name, "");
  for (const NamedButton& button : mouse_buttons) {
    const bool held = (known.*button.known).held;
    bool down = pointer && wanted(button.name) && (*pointer).*button.down;
    if (is_told && !held) down |= before.find(button.name) != std::string::npos;  // let go once the step has seen it
    if (down) now.name += text(now.name.empty() ? "" : " ", button.name);
    differs |= down != held;
  }
  if (heard && wanted("wheel"))
    for (const PointerEvent& event : gestures.events)
      if (event.kind == Kind::wheel) now.value += event.dy;
  differs |= now.value != 0.0;
  if (is_told)
    *told = now;
  else if (differs)
    waiting.commands.push_back(now);
  if (heard) take_mouse(wanted, gestures);
}

void give_controls(const Scene& scene, bool heard, Gestures& gestures, StepInput& waiting) {
  std::vector<std::string> wanted = scene.controls();
  const std::map<std::string, double>& known = scene.world().controls;
  gestures.of_scene.clear();
  std::ranges::copy_if(wanted, std::back_inserter(gestures.of_scene),
                       [](const std::string& name) { return of_pad(name) || of_mouse(name); });
  std::erase_if(wanted, of_mouse);
  if (wanted.empty() && known.empty()) return;
  for (const std::string& name : wanted) {
    const auto at = known.find(name);
    tell(waiting, name, at == known.end() ? 0.0 : at->second, heard ? held(gestures, name) : 0.0);
  }
  for (const auto& [name, value] : known)
    if (std::ranges::count(wanted, name) == 0) tell(waiting, name, value, 0.0);
  take_sticks(wanted, gestures);
}

}  // namespace pantin::player
