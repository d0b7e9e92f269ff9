#include "view/player_input.hpp"

#include "choreography/copy_by_hand.hpp"
#include "view/camera_moves.hpp"
#include "view/hand_marks.hpp"
#include "view/making.hpp"
#include "view/stroke.hpp"

namespace pantin {

using Kind = PointerEvent::Kind;
using Button = PointerEvent::Button;

struct PlayerInput::Work {
  const Gestures& gestures;
  const Frame& frame;
  Viewport viewport;
  Actions& actions;

  ToolOutput output() const { return {frame.input, actions.said, actions.acts}; }
};

Actions PlayerInput::apply(const Gestures& gestures, const Frame& frame) {
  Actions actions;
  actions.quit = gestures.quit;
  actions.said = gestures.notes;
  if (frame.width <= 0 || frame.height <= 0) return actions;
  const Work work{gestures, frame, {frame.world, frame.stage, frame.camera, frame.width, frame.height}, actions};
  std::size_t taken = 0;
  const auto take_keys = [&](std::size_t end) {
    while (taken < std::min(end, gestures.keys.size())) key(work, gestures.keys[taken++]);
  };
  for (const PointerEvent& event : gestures.events) {
    take_keys(event.keys);
    pointer_event(work, event);
  }
  take_keys(gestures.keys.size());
  move_hands(work);
  return actions;
}

void PlayerInput::reset() {
  holds_.clear();
  forget();
}

void PlayerInput::forget() {
  highlight_ = {};
  copied_.clear();
  selection_.clear();
}

void PlayerInput::let_go(const World& world, StepInput& input) {
  std::erase_if(holds_,
                [&](const auto& entry) { return entry.second.hand >= static_cast<std::int32_t>(world.hands.size()); });
  for (auto& [pointer, hold] : holds_) hold.use = {};
  for (std::size_t i = 0; i < world.hands.size(); i++) {
    const auto hand = static_cast<std::int32_t>(i);
    const bool takes = std::ranges::any_of(
        input.commands, [&](const Command& c) { return c.kind == Command::Kind::grab && c.hand == hand; });
    if (world.hands[i].path || !(world.hands[i].grab || takes)) continue;
    Command command;
    command.kind = Command::Kind::release;
    command.hand = hand;
    input.commands.push_back(command);
  }
}

bool PlayerInput::active() const {
  return std::ranges::any_of(holds_, [](const auto& held) { return held.second.use.active(); });
}

bool PlayerInput::cancel(StepInput& input) {
  std::vector<std::string> said, acts;
  ToolOutput output{input, said, acts};
  bool any = !selection_.empty();
  selection_.clear();
  for (auto& [pointer, hold] : holds_) {
    any |= hold.use.active() || !hold.use.corners().empty();
    hold.use.cancel(output);
    hold.use = {};
  }
  return any;
}

void PlayerInput::carry_over(const std::map<std::int32_t, std::int32_t>& hands,
                             const std::function<PointId(PointId)>& counterpart) {
  for (auto& [pointer, hold] : holds_) {
    const auto hand = hands.find(hold.hand);
    hold.hand = hand == hands.end() ? -1 : hand->second;
    hold.use.carry_over(hold.hand, counterpart(hold.use.point()));
  }
  highlight_ = counterpart(highlight_);
  copied_.clear();
  selection_.clear();
}

PlayerInput::Hold& PlayerInput::hold_of(PointerId pointer) {
  Hold& hold = holds_[pointer];
  if (hold.hand < 0) hold.hand = new_hand_();
  return hold;
}

void PlayerInput::pointer_event(const Work& work, const PointerEvent& event) {
  const Frame& frame = work.frame;
  ToolOutput output = work.output();
  move_camera(work.gestures, event, frame.on_panel, frame.width, frame.height, frame.camera);
  if (event.pointer == 0 && select(work, event)) return;
  const bool to_press = event.kind == Kind::press && event.button == Button::left;
  if (to_press && !(frame.on_panel && event.pointer == 0)) {
    ToolChoice choice = tool;
    if (event.control) choice = {ToolKind::cut, 0};
    Hold& hold = hold_of(event.pointer);
    hold.use.cancel(output);
    hold.use.press(work.viewport, choice, hold.hand, event.x, event.y, output);
  }
  const auto found = holds_.find(event.pointer);
  if (found == holds_.end()) return;
  found->second.use.snap(event.shift || work.gestures.shift);
  if (event.kind == Kind::move) found->second.use.move(work.viewport, event.x, event.y, output);
  if (event.kind == Kind::release && event.button == Button::left) found->second.use.release(work.viewport, output);
}

void PlayerInput::cut(const Work& work, double x, double y) {
  ToolOutput output = work.output();
  ToolUse use;
  use.press(work.viewport, {ToolKind::cut, 0}, hold_of(0).hand, x, y, output);
  use.release(work.viewport, output);
}

void PlayerInput::use_whole(const Work& work, WholeUse use) {
  switch (use) {
    case WholeUse::copy: return copy(work);
    case WholeUse::paste: return paste(work, false);
    case WholeUse::mirror: return paste(work, true);
    case WholeUse::remove: return remove_whole(work);
  }
}

/// With shift, or in a paused scene upon what is selected, the drag tool selects and moves.
bool PlayerInput::select(const Work& work, const PointerEvent& event) {
  const Frame& frame = work.frame;
  const bool left = event.button == Button::left;
  if (event.kind == Kind::press && left && !frame.on_panel && tool.kind == ToolKind::drag && !event.control) {
    const bool moves = !event.shift && frame.time == 0.0 && !selection_.empty() &&
                       selection_.has(frame.world, thing_at(work.viewport, event.x, event.y));
    if (event.shift || moves) return selection_.press(event.x, event.y, moves), true;
  }
  if (!selection_.pressed()) return false;
  selection_.move(event.x, event.y);
  ToolOutput output = work.output();
  if (event.kind == Kind::release && left) selection_.release(work.viewport, hold_of(0).hand, output);
  return true;
}

/// What is selected, else what is under the pointer; one of each whole.
std::vector<AnyId> PlayerInput::meant(const Work& work) const {
  if (std::vector<AnyId> wholes = selection_.wholes(work.frame.world); !wholes.empty()) return wholes;
  const auto mouse = work.gestures.pointers.find(0);
  if (mouse == work.gestures.pointers.end()) return {};
  const AnyId thing = thing_at(work.viewport, mouse->second.x, mouse->second.y);
  if (std::holds_alternative<std::monostate>(thing)) return {};
  return {thing};
}

void PlayerInput::copy(const Work& work) {
  const std::vector<AnyId> things = meant(work);
  if (things.empty()) return work.actions.said.push_back("copy: there is nothing under the pointer");
  copied_ = things;
  const std::string what = things.size() == 1 ? describe(work.frame.world, things[0]) : text(things.size(), " things");
  work.actions.said.push_back(text("copied ", what, " with all that is joined to it: ", key_for(KeyUse::whole, 1),
                                   " pastes it, ", key_for(KeyUse::whole, 2), " mirrored"));
}

void PlayerInput::paste(const Work& work, bool mirrored) {
  const World& world = work.frame.world;
  const auto mouse = work.gestures.pointers.find(0);
  if (mouse == work.gestures.pointers.end()) return;
  std::erase_if(copied_, [&](const AnyId& thing) { return !alive(world, thing); });
  if (copied_.empty()) return work.actions.said.push_back("paste: nothing was copied, or it is gone");
  const Vec3 to = place_to_make(work.viewport, mouse->second.x, mouse->second.y, work.gestures.shift);
  const Vec3 from = centre_of(world, copied_[0]), normal = mirror_of(work.viewport);
  for (const AnyId& thing : copied_) {
    Command c = command_of(Command::Kind::make, hold_of(0).hand, thing);
    c.name = "copy";
    Vec3 beside = centre_of(world, thing) - from;
    if (mirrored) beside = beside - normal * (2.0 * dot(beside, normal));
    c.position = to + beside;
    if (mirrored) c.amount = normal;
    work.frame.input.commands.push_back(c);
  }
  work.actions.acts.push_back(mirrored ? "mirrored paste" : "paste");
  work.actions.said.push_back(mirrored ? "pasted mirrored" : "pasted");
}

void PlayerInput::remove_whole(const Work& work) {
  const std::vector<AnyId> things = meant(work);
  if (things.empty()) return work.actions.said.push_back("delete: there is nothing under the pointer");
  std::size_t count = 0;
  for (const AnyId& thing : things) {
    Command c = command_of(Command::Kind::remove, hold_of(0).hand, thing);
    c.name = "whole";
    const Things joined = whole_of(work.frame.world, c);
    count += joined.bodies.size() + joined.free_points.size();
    work.frame.input.commands.push_back(c);
  }
  selection_.clear();
  work.actions.acts.push_back("delete");
  work.actions.said.push_back(text("removed ", count, count == 1 ? " thing" : " things"));
}

void PlayerInput::key(const Work& work, const std::string& name) {
  const std::optional<KeyMeaning> meaning = meaning_of(name);
  if (meaning) return use_key(work, *meaning);
  Command command;
  command.kind = Command::Kind::key;
  command.name = name;
  work.frame.input.commands.push_back(command);
}

void PlayerInput::use_key(const Work& work, KeyMeaning key) {
  const Frame& f = work.frame;
  Actions& a = work.actions;
  switch (key.use) {
    case KeyUse::tool: tool.choose(static_cast<ToolKind>(key.which)); break;
    case KeyUse::tool_before: tool.move_on(-1); break;
    case KeyUse::tool_next: tool.move_on(1); break;
    case KeyUse::pause: a.pause = !a.pause; break;
    case KeyUse::step: a.step = true; break;
    case KeyUse::restart: a.restart = true; break;
    case KeyUse::picture: a.picture = true; break;
    case KeyUse::film: a.film = !a.film; break;
    case KeyUse::help: a.help = !a.help; break;
    case KeyUse::leave: a.quit = true; break;
    case KeyUse::whole: use_whole(work, static_cast<WholeUse>(key.which)); break;
    case KeyUse::undo: a.undo++; break;
    case KeyUse::redo: a.redo++; break;
    case KeyUse::see_all: see_all(f.world, f.stage, static_cast<double>(f.width) / f.height, f.camera); break;
    case KeyUse::cut:
      if (const auto mouse = work.gestures.pointers.find(0); mouse != work.gestures.pointers.end())
        cut(work, mouse->second.x, mouse->second.y);
      break;
    default: break;
  }
}

void PlayerInput::move_hands(const Work& work) {
  const auto mouse = work.gestures.pointers.find(0);
  if (mouse != work.gestures.pointers.end()) hold_of(0);
  ToolOutput output = work.output();
  for (auto& [pointer, hold] : holds_) {
    const auto found = work.gestures.pointers.find(pointer);
    if (found == work.gestures.pointers.end()) {
      hold.use.cancel(output);
      continue;
    }
    hold.use.snap(work.gestures.shift);
    hold.use.hold(work.viewport, work.frame.time, output);
    const Vec3 at = hold.use.place(work.viewport, found->second.x, found->second.y);
    work.frame.input.moves.push_back({hold.hand, at, found->second.left});
  }
  highlight_ = {};
  if (mouse == work.gestures.pointers.end()) return;
  const ToolUse& use = holds_[0].use;
  const bool takes_points = tool.kind != ToolKind::cut && tool.kind != ToolKind::remove &&
                            tool.kind != ToolKind::heat && tool.kind != ToolKind::make;
  if (use.active())
    highlight_ = use.point();
  else if (takes_points && !work.frame.on_panel && !work.gestures.scene_has_mouse())
    highlight_ = pick_held(work.viewport, mouse->second.x, mouse->second.y).point;
}

void PlayerInput::add_marks(const Gestures& gestures, const Viewport& viewport, bool on_panel,
                            std::vector<Mark>& marks) const {
  selection_.add_marks(viewport, marks);
  for (const auto& [id, pointer] : gestures.pointers) {
    if (id < key_cursor && gestures.scene_has_mouse()) continue;
    const auto found = holds_.find(id);
    const bool draws = found != holds_.end() && tool.is_polygon() && !found->second.use.corners().empty();
    if (draws || (found != holds_.end() && found->second.use.active())) {
      mark_hand(viewport, {found->second.hand, id == 0, pointer.x, pointer.y, tool, &found->second.use}, marks);
    } else if (!(id == 0 && on_panel)) {
      ToolUse none;
      none.snap(gestures.shift);
      const std::int32_t hand = found != holds_.end() ? found->second.hand : static_cast<std::int32_t>(holds_.size());
      mark_hand(viewport, {hand, id == 0, pointer.x, pointer.y, tool, &none}, marks);
    }
  }
}

}  // namespace pantin
