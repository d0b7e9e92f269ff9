#include "view/player_input.hpp"

#include <cmath>

#include "view/pick.hpp"
#include "view/sketch.hpp"
#include "world/measure.hpp"

namespace pantin {

using Kind = PointerEvent::Kind;
using Button = PointerEvent::Button;

struct PlayerInput::Frame {
  const Gestures& gestures;
  const World& world;
  const Stage& stage;
  int width, height;
  bool on_panel;
  Camera& camera;
  StepInput& input;
  Actions& actions;
};

const std::vector<std::pair<std::string, std::string>>& key_help() {
  static const std::vector<std::pair<std::string, std::string>> list = {
      {"left drag", "pull a point"},
      {"right drag", "turn the view"},
      {"middle drag", "shift the view (or shift + right)"},
      {"wheel", "zoom"},
      {"x", "cut the hinge under the pointer (or ctrl + click)"},
      {"f", "see the whole scene"},
      {"space", "pause, run"},
      {".", "one step"},
      {"- + 0", "slower, faster, the scene's own pace"},
      {"r", "restart"},
      {"page up, down", "the scene before, the next"},
      {"F1 …, tab", "panels; hide them all"},
      {"s", "take a picture"},
      {"h", "show or hide the keys"},
      {"q, Esc", "quit"},
  };
  return list;
}

Actions PlayerInput::apply(const Gestures& gestures, const World& world, const Stage& stage, int width, int height,
                           bool on_panel, Camera& camera, StepInput& input) {
  Actions actions;
  actions.quit = gestures.quit;
  if (width <= 0 || height <= 0) return actions;
  const Frame frame{gestures, world, stage, width, height, on_panel, camera, input, actions};
  for (const PointerEvent& event : gestures.events) pointer_event(frame, event);
  for (const std::string& name : gestures.keys) key(frame, name);
  move_hands(frame);
  return actions;
}

void PlayerInput::reset() {
  holds_.clear();
  highlight_ = {};
}

PlayerInput::Hold& PlayerInput::hold_of(PointerId pointer) {
  Hold& hold = holds_[pointer];
  if (hold.hand < 0) hold.hand = new_hand_();
  return hold;
}

void PlayerInput::pointer_event(const Frame& frame, const PointerEvent& event) {
  if (event.kind == Kind::move) drag_camera(frame, event);
  if (event.kind == Kind::wheel && !frame.on_panel)
    frame.camera.zoom_at(std::pow(0.88, event.dy), event.x, event.y, frame.width, frame.height);
  if (event.kind == Kind::press && event.button == Button::left && !frame.on_panel) press(frame, event);
  if (event.kind == Kind::release && event.button == Button::left) {
    const auto found = holds_.find(event.pointer);
    if (found == holds_.end() || !found->second.holding) return;
    found->second.holding = false;
    Command command;
    command.kind = Command::Kind::release;
    command.hand = found->second.hand;
    frame.input.commands.push_back(command);
  }
}

void PlayerInput::press(const Frame& frame, const PointerEvent& event) {
  if (event.control) return cut(frame, event.x, event.y);
  const PointId point = pick_point(frame.world, frame.stage, frame.camera, event.x, event.y, frame.width, frame.height);
  if (!point) return;
  const Vec3 at = position(frame.world, point);
  const auto seen = frame.camera.project(shown_place(frame.world, point), frame.width, frame.height);
  if (!seen) return;
  Hold& hold = hold_of(event.pointer);
  hold.holding = true;
  hold.point = point;
  hold.depth = seen->depth;
  hold.offset = at - frame.camera.place(event.x, event.y, hold.depth, frame.width, frame.height);
  Command command;
  command.kind = Command::Kind::grab;
  command.hand = hold.hand;
  command.point = point;
  frame.input.moves.push_back({hold.hand, at, true});
  frame.input.commands.push_back(command);
}

void PlayerInput::cut(const Frame& frame, double x, double y) {
  Command command;
  command.kind = Command::Kind::cut;
  const ParticleId hinge = pick_hinge(frame.world, frame.stage, frame.camera, x, y, frame.width, frame.height);
  if (!hinge) return;
  command.thing = hinge;
  command.hand = hold_of(0).hand;
  frame.input.commands.push_back(command);
}

void PlayerInput::drag_camera(const Frame& frame, const PointerEvent& event) {
  const auto found = frame.gestures.pointers.find(event.pointer);
  if (found == frame.gestures.pointers.end()) return;
  const Pointer& pointer = found->second;
  const double height = frame.height;
  if (pointer.middle || (pointer.right && event.shift))
    frame.camera.pan(event.dx / height, event.dy / height);
  else if (pointer.right)
    frame.camera.orbit(-event.dx / height * 3.0, event.dy / height * 3.0);
}

void PlayerInput::key(const Frame& frame, const std::string& name) {
  Actions& a = frame.actions;
  if (name == "space") a.pause = !a.pause;
  if (name == ".") a.step = true;
  if (name == "r") a.restart = true;
  if (name == "s") a.picture = true;
  if (name == "h") a.help = !a.help;
  if (name == "q" || name == "escape") a.quit = true;
  if (name == "f") {
    const std::optional<Vec3>& edges = frame.world.settings.box;
    const Bounds box = edges ? Bounds{zero3(), *edges} : bounds(frame.world, everything(frame.world));
    const Vec3 margin = vec(1, 1, 1) * (0.12 * frame.stage.unit);
    frame.camera.frame(box.lower - margin, box.upper + margin, static_cast<double>(frame.width) / frame.height);
  }
  if (const auto mouse = frame.gestures.pointers.find(0); name == "x" && mouse != frame.gestures.pointers.end())
    cut(frame, mouse->second.x, mouse->second.y);
  Command command;
  command.kind = Command::Kind::key;
  command.name = name;
  frame.input.commands.push_back(command);
}

void PlayerInput::move_hands(const Frame& frame) {
  const auto mouse = frame.gestures.pointers.find(0);
  if (mouse != frame.gestures.pointers.end()) hold_of(0);
  for (auto& [pointer, hold] : holds_) {
    const auto found = frame.gestures.pointers.find(pointer);
    if (hold.hand < 0 || found == frame.gestures.pointers.end()) continue;
    if (hold.holding && !frame.world.points.alive(hold.point)) hold.holding = false;
    const double depth = hold.holding ? hold.depth : frame.camera.distance;
    Vec3 at = frame.camera.place(found->second.x, found->second.y, depth, frame.width, frame.height);
    if (hold.holding) at += hold.offset;
    frame.input.moves.push_back({hold.hand, at, found->second.left});
  }
  if (mouse == frame.gestures.pointers.end()) return;
  const Hold& hold = holds_[0];
  highlight_ = hold.holding     ? hold.point
               : frame.on_panel ? PointId{}
                                : pick_point(frame.world, frame.stage, frame.camera, mouse->second.x, mouse->second.y,
                                             frame.width, frame.height);
}

}  // namespace pantin
