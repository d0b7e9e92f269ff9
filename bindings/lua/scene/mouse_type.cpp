// `scene.mouse`: where the pointer is in the scene, and what of it is held.
#include "lua/law/law_run.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "scene/controls.hpp"

namespace pantin::lua {
namespace {

/// What is read is the scene's from then on.
Mouse& read_mouse(const Self& self, const char* what) {
  if (LawRun* law = Runtime::of(self.state).law) law->mistake(self.state, "a law cannot read the mouse");
  self.script.controls.insert(std::string(mouse_prefix) + what);
  return self.world.mouse;
}

void read_position(const Self& self) {
  const std::optional<Vec3>& position = read_mouse(self, "position").position;
  if (position)
    push(self.state, *position);
  else
    lua_pushnil(self.state);
}

void read_wheel(const Self& self) { lua_pushnumber(self.state, read_mouse(self, "wheel").wheel); }

enum class Of : std::uint8_t { left, middle, right };
constexpr const char* button_names[] = {"left", "middle", "right"};

template <Of button, bool MouseButton::*field>
void read_button(const Self& self) {
  const char* name = button_names[static_cast<std::size_t>(button)];
  lua_pushboolean(self.state, read_mouse(self, name).button(name)->*field);
}

template <Of button>
void add_button(std::vector<Field>& fields, const char* held, const char* pressed, const char* released) {
  fields.push_back({held, "boolean", "", "whether it is down", read_button<button, &MouseButton::held>, nullptr});
  fields.push_back({pressed, "boolean", "", "whether it went down in this step",
                    read_button<button, &MouseButton::pressed>, nullptr});
  fields.push_back({released, "boolean", "", "whether it went up in this step",
                    read_button<button, &MouseButton::released>, nullptr});
}

}  // namespace

const Type& mouse_type() {
  static const Type type = [] {
    Type made{
        "Mouse",
        "mouse",
        "The pointer: the mouse, or a finger, which is its left button: `if scene.mouse.left_pressed then "
        "scene:ball { radius = 0.2, at = scene.mouse.position } end`. A button that a script reads is the "
        "scene's and not the window's from then on: with the left one no hand takes hold, with the right one the "
        "view does not turn, and with the wheel it does not zoom. To know where the pointer is takes nothing from "
        "the window. Without a window there is none, unless a test or a recording has one.",
        {},
        {}};
    made.fields.push_back({"position", "vec?", "m",
                           "the place that it points at: in the scene's plane, else in that through what the camera "
                           "looks at, facing it; nil where there is no pointer",
                           read_position, nullptr});
    add_button<Of::left>(made.fields, "left", "left_pressed", "left_released");
    add_button<Of::middle>(made.fields, "middle", "middle_pressed", "middle_released");
    add_button<Of::right>(made.fields, "right", "right_pressed", "right_released");
    made.fields.push_back(
        {"wheel", "number", "1", "notches that it was turned in this step, up > 0", read_wheel, nullptr});
    return made;
  }();
  return type;
}

}  // namespace pantin::lua
