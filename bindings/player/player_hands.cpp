// What the player does with hands and their tools.
#include <algorithm>

#include "choreography/commands.hpp"
#include "choreography/hands.hpp"
#include "player/player.hpp"
#include "view/keys.hpp"
#include "view/palette.hpp"
#include "view/stroke.hpp"

namespace pantin::player {
namespace {

constexpr std::chrono::seconds told_for{4}, hinted_for{30};
constexpr std::chrono::seconds played_for{20}, asked_for{10};  // before it is told how to show it, and how long

/// Whether undo takes it back; the others tell what is held, or end what another began.
bool is_act(const Command& command) {
  switch (command.kind) {
    case Command::Kind::release:
    case Command::Kind::key:
    case Command::Kind::button:
    case Command::Kind::control:
    case Command::Kind::mouse: return false;
    default: return true;
  }
}

}  // namespace

Viewport Player::viewport() const {
  return {scene_->world(), renderer_.stage(), camera_, renderer_.width(), renderer_.height()};
}

void Player::take_fingers(double elapsed) {
  const ToolKind kind = hands_.tool.kind;
  const bool has_mouse = gestures_.scene_has_mouse();
  const bool draws = kind == ToolKind::cut || kind == ToolKind::make;
  const auto takes_hold = [this, is_free = !has_mouse && !draws](double x, double y) {  // small: no memory is asked for
    return is_free && static_cast<bool>(pick_held(viewport(), x, y));
  };
  fingers_.take(gestures_, {elapsed, takes_hold, has_mouse || draws || kind == ToolKind::heat, renderer_.width(),
                            renderer_.height(), camera_});
}

Actions Player::take_hands(double elapsed) {
  const PlayerInput::Frame frame{
      scene_->world(),         renderer_.stage(), renderer_.width(), renderer_.height(), renderer_.pointer_on_panel(),
      paused_ ? 0.0 : elapsed, camera_,           waiting_};
  before_hands_ = waiting_;
  const ToolKind kind = hands_.tool.kind;
  Actions actions = hands_.apply(gestures_, frame);
  if (hands_.tool.kind != kind) tell_tool();
  for (const std::string& said : actions.said) tell(said);
  const bool tries = !actions.acts.empty() || presses_in_scene();
  if (!tried_ && tries) tried_at_ = Clock::now();
  tried_ |= tries;
  if (!actions.acts.empty()) last_act_.number = keep_for_undo(actions.acts.back(), before_hands_);
  return actions;
}

bool Player::presses_in_scene() const {
  return !renderer_.pointer_on_panel() && std::ranges::any_of(gestures_.events, [](const PointerEvent& event) {
    return event.kind == PointerEvent::Kind::press && event.button == PointerEvent::Button::left;
  });
}

std::int32_t Player::new_hand() {
  if (recorder_) recorder_->hand_came();
  return add_hand(scene_->world());
}

std::uint64_t Player::keep_for_undo(const std::string& act, const StepInput& before) {
  forget_act_that_failed();
  acted_ = true;
  try {
    return undo_.begin(scene_, times_, before, act);
  } catch (const Error& error) { tell(text(act, " cannot be undone: ", error.what())); }
  return 0;
}

/// An act of a hand all of whose commands were dropped is nothing to be undone.
void Player::forget_act_that_failed() {
  if (last_act_.failed()) undo_.forget(last_act_.number);
  last_act_ = {};
}

void Player::count_sent(const std::vector<Command>& commands) {
  last_act_.sent += static_cast<std::size_t>(std::ranges::count_if(commands, is_act));
}

void Player::undo() { go_back(&Undo::undo); }
void Player::redo() { go_back(&Undo::redo); }

void Player::go_back(bool (Undo::*way)(std::shared_ptr<Scene>&, Times&, StepInput&, std::string&)) {
  forget_act_that_failed();
  std::string told;
  const std::shared_ptr<Scene> old = scene_;
  if ((undo_.*way)(scene_, times_, waiting_, told)) {
    changes_++;
    acted_ = true;
    changed_at_ = {};  // a change of a parameter is an act of its own
    if (scene_ != old) {
      go_back_to(opened_.at(scene_), *old);
      paused_ = true;  // somebody may have been building
      told += "; paused";
    }
    hands_.let_go(scene_->world(), waiting_);
    log_read_ = scene_->world().log.size();
    failure_ = scene_->world().failure;
    take_parameters(*scene_, scene_options_.set);
  }
  tell(told);
}

/// What was saved since is not reloaded for that.
void Player::go_back_to(const Opened& opened, const Scene& old) {
  const bool is_of_other_file = path_ != opened.path;
  path_ = opened.path;
  scene_options_ = opened.options;
  lasting_ = opened.lasting;
  reload_.go_back_to(opened.read);
  put_in_place(old);
  if (is_of_other_file) camera_ = own_camera();
}

/// Of a paused scene nothing waits for play but what a step is needed for.
void Player::do_at_once() {
  std::vector<Command> now;
  std::erase_if(waiting_.commands, [&](const Command& command) {
    if (needs_step(command.kind)) return false;
    now.push_back(command);
    return true;
  });
  if (now.empty()) return;
  count_sent(now);
  if (recorder_) recorder_->done_at_once(now);
  carry_out(scene_->world(), now);
  changes_++;
}

void Player::tell(const std::string& what) {
  told_ = what;
  told_at_ = Clock::now();
}

void Player::tell_tool() { tell(text(hands_.tool.tool().name, ": ", hands_.tool.tool().help)); }

void Player::tell_dropped() {
  const std::vector<LogLine>& log = scene_->world().log;
  log_read_ = std::min(log_read_, log.size());  // a script may have gone back to when it was shorter
  for (; log_read_ < log.size(); log_read_++)
    if (log[log_read_].kind == "dropped" && log[log_read_].text.find(" by hand ") != std::string::npos) {
      tell(log[log_read_].text);
      last_act_.dropped++;
    }
  if (last_act_.failed() && !hands_.active()) forget_act_that_failed();
}

/// What a hand may do next, to one that has done nothing in this scene; and to one that has, how to show it.
/// Of keys that the scene takes for itself it says nothing.
std::string Player::hint() const {
  const Clock::time_point now = Clock::now();
  const bool is_second = tried_;
  if (is_second ? now < tried_at_ + played_for || now > tried_at_ + played_for + asked_for
                : now > adopted_ + hinted_for)
    return "";
  const std::set<std::string> taken = keys_of_scene();
  const Tool& tool = hands_.tool.tool();
  const bool is_mouse_taken = taken.contains("mouse.left");
  std::string hint = is_second                            ? "to show it to somebody"
                     : is_mouse_taken                     ? "the mouse is the scene's"
                     : hands_.tool.kind == ToolKind::drag ? "drag a point, and throw it"
                                                          : text(tool.name, ": ", tool.help);
  auto add = [&, between = is_second ? ": " : "; "](const char* key, const char* does) mutable {
    if (taken.contains(key)) return;
    hint += text(between, key, " ", does);
    between = ", ";
  };
  if (is_second) {
    add(key_for(KeyUse::picture), "takes a picture");
    add(key_for(KeyUse::film), "films the scene");
    return hint;
  }
  if (hands_.tool.kind != ToolKind::cut && !is_mouse_taken)
    add(key_for(KeyUse::tool, static_cast<std::size_t>(ToolKind::cut)), "cuts by a stroke");
  add(key_for(KeyUse::pause), "pauses");
  add(key_for(KeyUse::slower), "slows");
  add(key_for(KeyUse::scenes), "shows all scenes");
  add(key_for(KeyUse::help), "shows all keys");
  return hint;
}

void Player::draw_tools() {
  if (panels_.hidden()) return;
  lost_.look(scene_->world(), renderer_.stage(), {scene_->world().steps, changes_}, Clock::now());
  if (lost_.draw(static_cast<float>(renderer_.height()))) bring_back();
  const std::string told = Clock::now() < told_at_ + told_for ? told_ : hint();
  const ToolKind kind = hands_.tool.kind;
  const PaletteWish wish = draw_palette(hands_.tool, undo_.state(scene_), told, static_cast<float>(renderer_.width()),
                                        static_cast<float>(renderer_.height()));
  if (hands_.tool.kind != kind) tell_tool();
  undo_wish_ = wish;
}

void Player::bring_back() {
  const StepInput before = waiting_;
  for (Command& command : lost_.bring_back(scene_->world(), renderer_.stage())) {
    command.hand = hands_.mouse_hand();
    waiting_.commands.push_back(command);
  }
  lost_.forget();
  keep_for_undo("bring back", before);
}

void Player::mark_hands(Overlay& overlay) const {
  hands_.add_marks(gestures_, viewport(), renderer_.pointer_on_panel(), overlay.marks);
}

}  // namespace pantin::player
