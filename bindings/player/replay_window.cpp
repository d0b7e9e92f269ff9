#include "player/replay_window.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "player/confine.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/marks.hpp"
#include "player/message.hpp"
#include "player/panels/desk.hpp"
#include "player/panels/icons.hpp"
#include "view/camera_moves.hpp"
#include "view/hand_marks.hpp"
#include "view/keys.hpp"
#include "view/panel_style.hpp"
#include "view/view_keys.hpp"

namespace pantin::player {
namespace {

constexpr std::chrono::milliseconds shortest_picture{12};  // where no screen sets the pace
constexpr std::chrono::milliseconds longest_seek{50};      // in a frame
constexpr std::chrono::seconds shown_for{4};
constexpr const char* no_hands = "this is recorded: hands do nothing here";
constexpr const char* no_undo = "this is recorded: nothing is undone here; a step back (,) or the slider goes back";

/// Ticks at which something was done, beside moving hands.
std::vector<std::uint64_t> ticks_of_acts(const std::vector<RecordedAct>& acts) {
  std::vector<std::uint64_t> ticks;
  for (const RecordedAct& act : acts) {
    const auto* input = std::get_if<StepInput>(&act.what);
    const bool of_no_one = std::holds_alternative<StateCheck>(act.what) ||
                           std::holds_alternative<StateKept>(act.what) || std::holds_alternative<HandCame>(act.what) ||
                           std::holds_alternative<RecordingEnd>(act.what);
    if (of_no_one || (input && input->commands.empty())) continue;
    if (ticks.empty() || ticks.back() != act.tick) ticks.push_back(act.tick);
  }
  return ticks;
}

/// Where the window is there to draw it.
Replay open_replay(const std::string& recording, const RunOptions& options, const std::string& home) {
  if (options.untrusted) confine(reach_of_window(options, recording, home));
  return {read_recording(recording), options, home};
}

}  // namespace

ReplayWindow::ReplayWindow(const std::string& recording, const RunOptions& options, const std::string& home)
    : options_(options),
      window_(open_window(scene_name(recording) + " - Pantin", options.size)),
      renderer_(window_.width(), window_.height(), window_.software() ? 0 : 4, window_.scale()),
      replay_(open_replay(recording, options, home)),
      openings_(replay_.openings()),
      place_(replay_.place()),
      views_(options.views),
      marked_(ticks_of_acts(replay_.acts())),
      paused_(options.paused) {
  renderer_.open(replay_.scene().world());
  look_at_scene();
}

void ReplayWindow::look_at_scene() {
  window_.set_title(title() + " - Pantin");
  views_.set(View::dark, replay_.scene().dark() || options_.views.on(View::dark));
  camera_ = aim(replay_.scene(), renderer_.stage(), static_cast<double>(renderer_.width()) / renderer_.height());
}

std::string ReplayWindow::title() {
  const std::string& title = replay_.scene().title();
  return (title.empty() ? scene_name(replay_.path()) : title) + ", recorded";
}

bool ReplayWindow::frame() {
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  if (!window_.poll(gestures_) || Interrupt::asked()) return false;
  renderer_.resize(window_.width(), window_.height(), window_.scale());
  renderer_.listen(gestures_);
  fingers_.take(gestures_, {elapsed, nullptr, false, renderer_.width(), renderer_.height(), camera_});
  take_view_keys(gestures_, views_, camera_);
  for (const PointerEvent& event : gestures_.events) take(event);
  for (const std::string& name : gestures_.keys)
    if (!take_key(name)) return false;
  advance(elapsed);
  if (openings_ != replay_.openings()) adopt();
  follower_.move(replay_.scene(), renderer_.stage(), static_cast<double>(renderer_.width()) / renderer_.height(),
                 elapsed, camera_);
  Overlay shown = overlay();
  shown.windows = [this] { draw_bar(); };
  renderer_.draw(replay_.scene().world(), camera_, shown);
  window_.present(renderer_);
  status_.frame(replay_.scene().world());
  std::this_thread::sleep_until(now + shortest_picture);
  return !(options_.until && replay_.played() >= *options_.until - 0.5 * replay_.scene().world().settings.step);
}

void ReplayWindow::adopt() {
  openings_ = replay_.openings();
  follower_ = {};
  renderer_.open(replay_.scene().world());
  if (std::exchange(place_, replay_.place()) != place_) look_at_scene();
}

void ReplayWindow::take(const PointerEvent& event) {
  const bool on_panel = renderer_.pointer_on_panel();
  move_camera(gestures_, event, on_panel, renderer_.width(), renderer_.height(), camera_);
  const bool press = event.kind == PointerEvent::Kind::press && event.button == PointerEvent::Button::left;
  if (press && !(on_panel && event.pointer == 0)) tell(no_hands);
}

/// False where the key ends the replay.
bool ReplayWindow::take_key(const std::string& name) {
  const std::optional<KeyMeaning> key = meaning_of(name, KeyPlace::replay);
  if (!key) return tell_of_play(name), true;
  switch (key->use) {
    case KeyUse::pause: run_or_pause(); break;
    case KeyUse::step: step_on(); break;
    case KeyUse::step_back: step_back(); break;
    case KeyUse::restart: target_ = 0; break;
    case KeyUse::slower: change_speed(0.5); break;
    case KeyUse::faster: change_speed(2.0); break;
    case KeyUse::own_pace: speed_ = 1.0; break;
    case KeyUse::help: help_ = !help_; break;
    case KeyUse::fullscreen: window_.toggle_fullscreen(); break;
    case KeyUse::leave: return name == "escape" && std::exchange(help_, false);
    case KeyUse::see_all:
      see_all(replay_.scene().world(), renderer_.stage(), static_cast<double>(renderer_.width()) / renderer_.height(),
              camera_);
      break;
    default: break;
  }
  return true;
}

/// A key that serves where a scene is played.
void ReplayWindow::tell_of_play(const std::string& name) {
  const std::optional<KeyMeaning> key = meaning_of(name);
  if (!key) return;
  if (key->use == KeyUse::undo || key->use == KeyUse::redo) tell(no_undo);
  if (key->use == KeyUse::tool || key->use == KeyUse::cut) tell(no_hands);
}

void ReplayWindow::tell(const std::string& what) {
  told_ = what;
  told_at_ = Clock::now();
}

std::string ReplayWindow::told() const { return Clock::now() < told_at_ + shown_for ? told_ : std::string(); }

void ReplayWindow::run_or_pause() {
  paused_ = !paused_;
  if (!at_end()) return;
  target_ = 0;
  paused_ = false;
}

void ReplayWindow::step_back() {
  paused_ = true;
  const std::uint64_t from = target_.value_or(replay_.tick());
  target_ = from > 0 ? from - 1 : 0;
}

void ReplayWindow::step_on() {
  paused_ = true;
  target_ = target_.value_or(replay_.tick()) + 1;
}

void ReplayWindow::change_speed(double factor) { speed_ = std::clamp(factor * speed_, slowest, fastest); }

bool ReplayWindow::at_end() { return replay_.tick() >= replay_.ticks(); }

void ReplayWindow::advance(double elapsed) {
  if (target_) {
    seek();
    return pacing_.rest();
  }
  if (paused_ || scrubbing_ || !failure_.empty() || at_end()) return pacing_.rest();
  const auto start = Clock::now();
  const int due = pacing_.begin_frame(elapsed, replay_.scene().world().settings.step, replay_.scene().pace() * speed_);
  int done = 0;
  double seconds = 0.0;
  while (done < due && (done == 0 || pacing_.has_time(seconds)) && step_once()) {
    done++;
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  pacing_.end_frame(done, seconds);
}

bool ReplayWindow::step_once() {
  const std::uint64_t before = replay_.tick();
  try {
    const bool goes_on = replay_.step();
    if (replay_.tick() < before) target_ = before + 1;
    for (const SoundCall& call : replay_.scene().sounds())
      if (const std::string why = speaker_.play(call); !why.empty()) say(why);
    return goes_on && !target_;
  } catch (const std::exception& error) { fail(error.what()); }
  return false;
}

void ReplayWindow::seek() {
  const auto start = Clock::now();
  try {
    failure_.clear();
    bool there = false;
    while (!there && Clock::now() < start + longest_seek) there = replay_.go_to(*target_, 1);
    if (there) target_.reset();
  } catch (const std::exception& error) {
    target_.reset();
    fail(error.what());
  }
}

void ReplayWindow::fail(const std::string& why) {
  failure_ = why;
  paused_ = true;
  say(why);
}

std::string ReplayWindow::message() const {
  if (target_) return text("going to ", replay_.time_at(*target_), " s");
  if (const std::string now = told(); !now.empty()) return now;
  return text("step ", replay_.tick(), " of ", replay_.ticks(), ", ", replay_.checked(), " hashes as recorded");
}

Overlay ReplayWindow::overlay() {
  Scene& scene = replay_.scene();
  Overlay shown;
  shown.pace = scene.pace() * speed_;
  shown.views = views_;
  shown.title = title();
  write_marks_of(scene, shown.marks);
  mark_hands(shown);
  status_.write(scene.world(), pacing_, {shown.pace, paused_, views_.on(View::errors)}, shown.status);
  if (at_end()) shown.status[1] = "the end of the recording";
  if (help_)
    shown.help = key_card(KeyPlace::replay);
  else
    shown.status.push_back(text(key_for(KeyUse::help), ": keys"));
  return shown;
}

/// The recorded hands: a ring that is narrower while it presses, and a number.
void ReplayWindow::mark_hands(Overlay& shown) {
  const World& world = replay_.scene().world();
  for (std::size_t i = 0; i < world.hands.size(); i++) {
    const Hand& hand = world.hands[i];
    if (!hand.placed || !finite(hand.position)) continue;
    Mark mark;
    mark.kind = Mark::Kind::ring;
    mark.from = hand.position;
    mark.size = hand.pressed ? 13.0 : 20.0;
    mark.color = hand_color(static_cast<std::int32_t>(i));
    shown.marks.push_back(mark);
    mark.kind = Mark::Kind::text;
    mark.size = 14.0;
    mark.text = " " + std::to_string(i + 1);
    shown.marks.push_back(mark);
  }
}

void ReplayWindow::draw_bar() {
  const float scale = ImGui::GetFontSize() / 14.0f;
  const float width = 0.8f * static_cast<float>(renderer_.width());
  ImGui::SetNextWindowPos(
      {0.5f * static_cast<float>(renderer_.width()), static_cast<float>(renderer_.height()) - 44.0f * scale},
      ImGuiCond_Always, {0.5f, 1.0f});
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, 1e6f});
  ImGui::SetNextWindowBgAlpha(0.72f);
  ImGui::Begin("replay", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  draw_remarks();
  draw_slider(width);
  draw_buttons();
  ImGui::End();
}

void ReplayWindow::draw_remarks() {
  std::string failure = failure_;
  if (failure.empty() && !replay_.failure().empty()) failure = "as it was recorded: " + replay_.failure();
  ImGui::PushStyleColor(ImGuiCol_Text, warning_ink(views_.on(View::dark)));
  for (const std::string& wrong : {failure, replay_.mismatch()})
    if (!wrong.empty()) ImGui::TextWrapped("%s", wrong.c_str());
  ImGui::PopStyleColor();
  for (const std::string& remark : replay_.remarks()) ImGui::TextWrapped("%s", remark.c_str());
}

void ReplayWindow::draw_slider(float width) {
  const double from = 0.0, until = replay_.duration();
  double at = replay_.time_at(target_.value_or(replay_.tick()));
  const std::string label = text("%.2f of ", std::round(100.0 * until) / 100.0, " s");
  ImGui::SetNextItemWidth(width - 2.0f * ImGui::GetStyle().WindowPadding.x);
  if (ImGui::SliderScalar("##time", ImGuiDataType_Double, &at, &from, &until, label.c_str(),
                          ImGuiSliderFlags_NoRoundToFormat | ImGuiSliderFlags_AlwaysClamp))
    target_ = replay_.tick_at(at);
  scrubbing_ = ImGui::IsItemActive();
  draw_marks();
}

/// Below the slider: when something was done, and from when on it is not as recorded.
void ReplayWindow::draw_marks() const {
  constexpr float edge = 2.0f, height = 3.0f;  // [px] as Dear ImGui draws a slider
  const float grab = ImGui::GetStyle().GrabMinSize;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float left = low.x + edge + 0.5f * grab, right = high.x - edge - 0.5f * grab;
  const auto place = [&](std::uint64_t tick) {
    return left + (right - left) * static_cast<float>(replay_.time_at(tick) / std::max(replay_.duration(), 1e-9));
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 done = ImGui::GetColorU32(ImGuiCol_Text, 0.6f);
  for (const std::uint64_t tick : marked_)
    list.AddRectFilled({place(tick), high.y - height}, {place(tick) + 1.0f, high.y}, done);
  if (!replay_.mismatch().empty())
    list.AddRectFilled({place(replay_.agreed()), low.y}, {right, low.y + height},
                       ImGui::GetColorU32(warning_ink(views_.on(View::dark))));
}

void ReplayWindow::draw_buttons() {
  if (icon_button(Icon::restart, "to the start (r)")) target_ = 0;
  ImGui::SameLine();
  if (icon_button(Icon::previous, "one step back (,)")) step_back();
  ImGui::SameLine();
  if (paused_ || at_end() ? icon_button(Icon::play, "run (space)") : icon_button(Icon::pause, "pause (space)"))
    run_or_pause();
  ImGui::SameLine();
  if (icon_button(Icon::step, "one step on (.)")) step_on();
  ImGui::SameLine();
  if (icon_button(Icon::slower, "slow motion (-)")) change_speed(0.5);
  ImGui::SameLine();
  if (icon_button(Icon::faster, "fast forward (+)")) change_speed(2.0);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(message().c_str());
}

}  // namespace pantin::player
