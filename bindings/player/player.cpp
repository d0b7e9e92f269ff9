#include "player/player.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "choreography/hands.hpp"
#include "lua/scene/open.hpp"
#include "player/confine.hpp"
#include "player/controls.hpp"
#include "player/hand_path.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/marks.hpp"
#include "player/message.hpp"
#include "scene/errors.hpp"
#include "view/pick.hpp"
#include "view/stroke.hpp"
#include "view/view_keys.hpp"

namespace pantin::player {
namespace {

constexpr std::chrono::milliseconds shortest_frame{12};  // where no screen sets the pace
constexpr int smooth_samples = 4;
constexpr std::chrono::seconds complaint_shown{8};
constexpr std::size_t longest_message = 180;  // [letters] of which the log has the rest

std::string short_message(const std::string& message) {
  if (message.size() <= longest_message) return message;
  const std::size_t end = message.rfind(' ', longest_message);
  const std::string log = key_for(KeyUse::panel, pane_called("Log"));
  return text(message.substr(0, end == std::string::npos ? longest_message : end), " …   (", log, ": all of it)");
}

double aspect(const Renderer& renderer) { return static_cast<double>(renderer.width()) / renderer.height(); }

}  // namespace

Player::Player(std::string path, const RunOptions& options, const std::string& home)
    : path_(std::move(path)),
      options_(options),
      scene_options_(scene_options(options, home)),
      scene_(lua::open_scene_text("", "scenes", ".", {})),
      window_(open_window(title() + " - Pantin", options.size)),
      renderer_(window_.width(), window_.height(), window_.software() ? 0 : smooth_samples, window_.scale()),
      hands_([this] { return new_hand(); }),
      browser_(home + "/scripts/scenes", home + "/examples/games", options.scenes, scene_options_),
      paused_(options.paused),
      views_(options.views) {
  renderer_.open(scene_->world());
  if (options_.untrusted) confine_window(home);
  if (path_.empty()) {
    browser_.show();
    return;
  }
  lasting_ = lasting_of(path_);
  scene_options_.saved = lasting_->values();
  adopt(load(path_, scene_options_));
  camera_ = own_camera();
  if (!options_.record.empty()) begin_recording();
}

void Player::confine_window(const std::string& home) {
  confine(reach_of_window(options_, path_.empty() ? options_.scenes + "/" : path_, home));
}

std::shared_ptr<SavedFile> Player::lasting_of(const std::string& path) const {
  return options_.untrusted ? std::make_shared<SavedFile>()
                            : std::make_shared<SavedFile>(path_as_recorded(path, scene_options_.home));
}

std::string Player::title() const {
  if (path_.empty()) return "Scenes";
  return scene_->title().empty() ? scene_name(path_) : scene_->title();
}

bool Player::frame() {
  auto now = Clock::now();
  double elapsed = std::chrono::duration<double>(now - last_).count();
  last_ = now;
  if (!window_.poll(gestures_) || Interrupt::asked()) return false;
  fit_window();
  swallow_keys();
  give_keys_to_scene();
  if (!browser_.shown() && !renderer_.writing()) steering_.move(gestures_, elapsed);
  renderer_.listen(gestures_);
  if (!browser_.shown()) take_fingers(elapsed);
  give_mouse(*scene_, viewport(), !browser_.shown(), gestures_, waiting_);
  reload();
  take_keys();
  take_view_keys(gestures_, views_, camera_);
  choose_followed();
  Actions actions = take_hands(elapsed);
  keep_last_moves(waiting_);
  if (actions.quit) return false;
  choose();
  act(actions);
  take_steps(elapsed);
  open_next();
  tell_dropped();
  follower_.move(*scene_, renderer_.stage(), aspect(renderer_), paused_ ? 0.0 : elapsed, camera_);
  draw();
  std::this_thread::sleep_until(now + shortest_frame);
  return !over_ && !(options_.until && at_end());
}

void Player::choose_followed() {
  for (const PointerEvent& event : gestures_.events) {
    if (event.kind != PointerEvent::Kind::press || event.clicks != 2 || renderer_.pointer_on_panel()) continue;
    const World& world = scene_->world();
    const PointId point =
        pick_point(world, renderer_.stage(), camera_, event.x, event.y, renderer_.width(), renderer_.height());
    const auto on_shape = pick_shape(viewport(), event.x, event.y);
    AnyId thing;
    if (on_shape && on_shape->body)
      thing = on_shape->body;
    else if (point && world.points[point].body)
      thing = world.points[point].body;
    else if (point)
      thing = world.points[point].particle;
    follower_.choose(thing);
  }
}

void Player::act(const Actions& actions) {
  if (actions.restart) restart();
  for (int i = 0; i < actions.undo + undo_wish_.undo; i++) undo();
  for (int i = 0; i < actions.redo + undo_wish_.redo; i++) redo();
  undo_wish_ = {};
  if (actions.help) help_ = !help_;
  if (actions.pause) paused_ = !paused_;
  if (actions.step) paused_ = single_step_ = true;
  if (actions.picture) save_picture();
  if (actions.film) toggle_film();
}

void Player::fit_window() { renderer_.resize(window_.width(), window_.height(), window_.scale()); }

bool Player::at_end() const {
  const World& world = scene_->world();
  return scene_->finished() || (options_.until && earlier_ + world.time >= *options_.until - 0.5 * world.settings.step);
}

void Player::take_steps(double elapsed) {
  bool one = std::exchange(single_step_, false);
  const bool over = !failure_.empty() || at_end();
  if (over) waiting_.commands.clear();  // no step is to take them
  const bool rests = over || browser_.shown() || (paused_ && !one);
  if (paused_ && !over && !one) do_at_once();
  if (rests) return pacing_.rest();
  const World& world = scene_->world();
  int due = one ? 1 : pacing_.begin_frame(elapsed, world.settings.step, scene_->pace() * speed_);
  if (due == 0) return pacing_.end_frame(0, 0.0);
  count_sent(waiting_.commands);
  HandPath path(world, std::exchange(waiting_, {}), due);
  auto start = Clock::now();
  int done = 0;
  double seconds = 0.0;
  while (done < due && failure_.empty() && !at_end() && (done == 0 || pacing_.has_time(seconds))) {
    scene_->world().input = path.input(done++);
    step_once();
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  if (!one) pacing_.end_frame(done, seconds);
}

void Player::step_once() {
  try {
    if (recorder_) recorder_->input(scene_->world().input);
    scene_->step();
    if (!scene_->world().failure.empty()) return fail_step(scene_->world().failure);
    if (recorder_) recorder_->stepped(scene_->world());
    times_.add(scene_->world());
    for (const SoundCall& call : scene_->sounds()) play(call);
  } catch (const Interrupted& error) { say(error.what()); } catch (const std::exception& error) {
    fail_step(error.what());
  }
}

void Player::fail_step(const std::string& why) {
  if (recorder_) recorder_->failed();
  fail(why);
}

void Player::fail(const std::string& why) {
  failure_ = why;
  paused_ = true;
  complain(why);
}

const Said* Player::complaint() const {
  if (Clock::now() >= complained_ + complaint_shown) return nullptr;
  const auto last = std::find_if(said_.rbegin(), said_.rend(), [](const Said& said) { return !said.good; });
  return last != said_.rend() ? &*last : nullptr;
}

void Player::fill(Overlay& overlay) {
  overlay.message.clear();
  overlay.title.clear();
  overlay.help = {};
  overlay.highlight = {};
  overlay.pace = scene_->pace() * speed_;
  overlay.views = views_;
  if (!failure_.empty())
    overlay.message = short_message(failure_) + "   (r starts the scene again)";
  else if (const Said* const said = complaint())
    overlay.message = said->times > 1 ? text(said->text, "   (", said->times, " times)") : short_message(said->text);
  if (browser_.shown()) {
    overlay.status.clear();
    overlay.buttons.clear();
    overlay.marks.clear();
    return;
  }
  write_marks_of(*scene_, overlay.marks);
  if (scene_->title().empty())
    overlay.title = title();
  else
    overlay.title = scene_->title();
  const auto* chosen = std::get_if<PointId>(&chosen_);
  overlay.highlight = hands_.highlight() || !chosen ? hands_.highlight() : *chosen;
  mark_hands(overlay);
  if (panels_.hidden()) {
    overlay.status.clear();
    overlay.title.clear();
    overlay.buttons = scene_->buttons();
    return;
  }
  edge_arrows_.mark(viewport(), overlay.marks);
  status_.write(scene_->world(), pacing_, {overlay.pace, paused_, panels_.shows("Solver") || views_.on(View::errors)},
                overlay.status);
  if (scene_->finished()) overlay.status[1] = "finished";
  if (recorder_) overlay.status.push_back("recording");
  if (film_)
    overlay.status.push_back(
        text("filming ", static_cast<int>(film_->seconds()), " s, ", key_for(KeyUse::film), " ends it"));
  if (help_)
    overlay.help = key_card();
  else
    overlay.status.push_back(text(key_for(KeyUse::help), ": keys"));
  overlay.buttons = scene_->buttons();
}

}  // namespace pantin::player
