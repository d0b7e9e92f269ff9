// What the player does beside the frames: opening scenes, and what was asked for in the panels.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <thread>

#include "fields/property.hpp"
#include "player/controls.hpp"
#include "player/home.hpp"
#include "player/message.hpp"
#include "player/player.hpp"
#include "player/saved_scene.hpp"
#include "player/saved_state.hpp"
#include "scene/files.hpp"
#include "scene/interrupt.hpp"
#include "view/keys.hpp"
#include "view/pick.hpp"

namespace pantin::player {
namespace {

constexpr double quick_load = 0.04;  // [s] so long a scene may take to be opened in each frame
constexpr std::size_t most_said = 200;
constexpr std::chrono::seconds one_change{1};  // of a parameter, from value to value
constexpr std::chrono::seconds patience_of_question{4};
constexpr std::chrono::milliseconds patience{300};  // before it is told that a scene is being opened

std::string act_of_change(const std::string& parameter) { return "change of " + parameter; }

}  // namespace

/// Opens a scene while the window stays alive, so that one that does not come to an end can be stopped.
std::unique_ptr<Scene> Player::load(const std::string& path, const SceneOptions& options, bool anew) {
  const auto start = Clock::now();
  std::unique_ptr<Scene> scene;
  std::exception_ptr error;
  std::atomic<bool> done = false;
  std::thread loader([&] {
    try {
      scene = reload_.open(path, options, anew);
    } catch (...) { error = std::current_exception(); }
    done = true;
  });
  try {
    wait_for(done, scene_name(path));
  } catch (...) {
    interrupt_scripts();
    loader.join();
    allow_scripts();
    throw;
  }
  loader.join();
  load_seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
  if (error) std::rethrow_exception(error);
  return scene;
}

void Player::wait_for(const std::atomic<bool>& done, const std::string& what) {
  const auto start = Clock::now();
  bool stopped = false;
  Gestures meanwhile;
  while (!done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (Clock::now() < start + patience) continue;
    const bool goes_on = window_.poll(meanwhile);
    if (!stopped && (!goes_on || std::ranges::count(meanwhile.keys, "escape") > 0)) {
      interrupt_scripts();
      stopped = true;
    }
    fit_window();
    Overlay shown;
    shown.title =
        text("opening ", what, ", ", std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start).count(),
             " s", stopped ? ": stopping it" : "   (Esc stops it)");
    renderer_.draw(scene_->world(), camera_, shown);
    window_.present(renderer_);
  }
  if (stopped) allow_scripts();
}

void Player::adopt(std::shared_ptr<Scene> fresh) {
  const std::shared_ptr<Scene> old = std::exchange(scene_, std::move(fresh));
  note_opened();
  waiting_ = {};
  times_ = {};
  failure_.clear();
  tried_ = false;
  acted_ = false;
  log_read_ = 0;
  adopted_ = Clock::now();
  hands_.reset();
  put_in_place(*old);
}

void Player::note_opened() {
  std::erase_if(opened_, [](const auto& opened) { return opened.first.expired(); });
  opened_[scene_] = {path_, scene_options_, lasting_, reload_.read()};
}

/// Whether something was done that has to come back before what was done earlier does.
bool Player::loses_by(std::string_view act) const { return acted_ || (!undo_.last().empty() && undo_.last() != act); }

/// Another scene is about to take the place of the one that plays, which is an act.
void Player::replace(const std::string& act, const std::string& told) {
  undo_.replace(scene_, times_, waiting_, act);
  tell(told + ": ctrl+z brings back what was");
}

/// Another scene is shown from now on; what hands and eyes know of the old one they forget.
void Player::put_in_place(const Scene& old) {
  changes_++;
  if (scene_->dark() != old.dark()) views_.set(View::dark, scene_->dark());
  hands_.forget();
  follower_ = {};
  pacing_ = {};
  chosen_ = {};
  lost_.forget();
  renderer_.open(scene_->world());
  window_.set_title(title() + " - Pantin");
}

Camera Player::own_camera() const {
  return aim(*scene_, renderer_.stage(), static_cast<double>(renderer_.width()) / renderer_.height());
}

/// Where something was done, or opened, that is an act, and undone. What is paused stays so, but for a failure.
void Player::restart() {
  const bool stays_paused = paused_ && failure_.empty();
  try {
    std::shared_ptr<Scene> fresh = load(path_, scene_options_);
    if (loses_by("restart")) replace("restart", "the scene starts again");
    adopt(std::move(fresh));
    if (recorder_) recorder_->restarted();
    paused_ = stays_paused;
  } catch (const std::exception& error) { fail(error.what()); }
}

bool Player::open(const std::string& path) { return take_over({path, {}, ""}, ""); }

/// Where that is an act, and something was done, it can be undone.
bool Player::take_over(const NextScene& next, const std::string& act) {
  const std::string& path = next.path;
  SceneOptions options = scene_options_;
  std::erase_if(options.set, [](const auto& setting) { return !setting.first.starts_with("scene."); });
  for (const auto& [name, value] : next.parameters) options.set[name] = setting_text(value);
  options.set_by = next.place.empty() ? SceneOptions().set_by : next.place + ": open: ";
  std::unique_ptr<Scene> fresh;
  lasting_->write();
  std::shared_ptr<SavedFile> lasting = lasting_of(path);
  options.saved = lasting->values();
  try {
    fresh = load(path, options, true);
  } catch (const std::exception& error) { return complain(error.what()), false; }
  lasting_ = std::move(lasting);
  if (path.ends_with(state_ending)) stop_recording("what goes on from a state is not recorded");
  if (act.empty()) {
    undo_.clear();
    earlier_ += scene_->world().time;
  } else if (loses_by(act)) {
    replace(act, text(scene_name(path), " goes on"));
  }
  const bool first = path_.empty();
  path_ = path;
  scene_options_ = options;
  adopt(std::move(fresh));
  if (recorder_)
    recorder_->opened({recorded_path(path_), scene_options_.set, lasting_->written(), scene_->world().settings.step});
  if (first && !options_.record.empty()) begin_recording();
  panels_.reset();
  paused_ = false;
  speed_ = 1.0;
  for (const View view : {View::bodies, View::loads, View::shadows})
    if (options_.views.on(view)) views_.set(view, true);
  camera_ = own_camera();
  return true;
}

void Player::save_state() {
  try {
    saved_ = player::save_state(*scene_, "");
    wrote(saved_);
  } catch (const std::exception& error) { complain(error.what()); }
}

/// Beside the script, or, of what comes with the program, where pictures and films go.
void Player::save_scene() {
  try {
    require(!path_.ends_with(state_ending),
            "a scene that goes on from a state has no script to write what was built to");
    const auto read = reload_.files().find(path_);
    const std::optional<std::string> source =
        read == reload_.files().end() ? file_content(path_) : std::optional(read->second);
    require(source.has_value(), path_, ": the scene's file cannot be read");
    const std::string below = std::filesystem::path(path_).parent_path().string();
    const std::string folder = below.empty() || lies_below(path_, scene_options_.home) ? "." : below;
    const SavedScene saved =
        player::save_scene(*scene_, path_, *source, scene_options_, free_scene_name(path_, folder));
    wrote(saved.file);
    for (const std::string& what : saved.left_out) complain(saved.file + " leaves out " + what);
    for (const SceneParameter& p : scene_->parameters())
      if (p.value != p.initial)
        complain(text(saved.file, " is to be opened with --set ", p.name, "=", setting_text(p.value)));
  } catch (const std::exception& error) { complain(error.what()); }
}

void Player::open_state() {
  if (saved_.empty()) return complain(text("no state was saved yet: ", key_for(KeyUse::save_state), " saves it"));
  const bool paused = paused_;
  if (take_over({saved_, {}, ""}, "opening of a state")) paused_ = paused;
}

/// What the scene asked for; where it cannot be opened, that is told once.
void Player::open_next() {
  lasting_->keep();
  if (const NextScene next = scene_->take_next(); !next.path.empty()) take_over(next, "");
}

void Player::play(const SoundCall& call) {
  if (const std::string why = speaker_.play(call); !why.empty()) log(why, false);
}

void Player::open_neighbour(int places) {
  if (const std::string path = browser_.neighbour(path_, places); !path.empty()) open(path);
}

bool Player::set_parameter(const std::string& name, const SceneValue& value) {
  const auto& parameters = scene_->parameters();
  const auto parameter = std::ranges::find(parameters, name, &SceneParameter::name);
  if (parameter == parameters.end()) return false;
  const bool live = parameter->live;
  if (!live && path_.ends_with(state_ending))
    return complain(name + " cannot change here: the scene goes on from a state, which has it as it is"), false;
  const auto before = scene_options_.set;
  scene_options_.set[name] = setting_text(value);
  if (live && !goes_on_changing(name)) keep_for_undo(act_of_change(name), waiting_);
  changes_++;
  bool taken = true;
  try {
    if (!scene_->set_parameter(name, value)) {
      const double size = renderer_.stage().size;
      std::shared_ptr<Scene> fresh = load(path_, scene_options_);
      if (!goes_on_changing(name)) undo_.replace(scene_, times_, waiting_, act_of_change(name));
      adopt(std::move(fresh));
      camera_ = fit_to_size(camera_, own_camera(), size, renderer_.stage().size);
    }
  } catch (const std::exception& error) {
    taken = false;
    scene_options_.set = before;
    complain(error.what());
    if (!live) return false;
  }
  changed_at_ = Clock::now();
  if (recorder_) recorder_->parameter(name, value);
  return taken;
}

/// What a slider that is drawn does is one act.
bool Player::goes_on_changing(const std::string& name) const {
  return undo_.last() == act_of_change(name) && Clock::now() <= changed_at_ + one_change;
}

void Player::take_keys() {
  gestures_.erase_keys([&](const std::string& name) { return browser_.shown() || take_key(name); });
}

bool Player::take_key(const std::string& name) {
  const std::optional<KeyMeaning> key = meaning_of(name);
  if (!key) return false;
  switch (key->use) {
    case KeyUse::scenes: browser_.show(); break;
    case KeyUse::leave: return leave(name == "escape");
    case KeyUse::scene_before: open_neighbour(-1); break;
    case KeyUse::scene_next: open_neighbour(1); break;
    case KeyUse::slower: speed_ = std::max(0.5 * speed_, slowest); break;
    case KeyUse::faster: speed_ = std::min(2.0 * speed_, fastest); break;
    case KeyUse::own_pace: speed_ = 1.0; break;
    case KeyUse::panel: panels_.toggle(key->which); break;
    case KeyUse::panels:
      panels_.hide();
      if (panels_.hidden()) tell(text(key_for(KeyUse::panels), " shows panels and tools again"));
      break;
    case KeyUse::fullscreen: window_.toggle_fullscreen(); break;
    case KeyUse::see_start: camera_ = own_camera(); break;
    case KeyUse::save_state: save_state(); break;
    case KeyUse::save_scene: save_scene(); break;
    case KeyUse::open_state: open_state(); break;
    default: return false;
  }
  return true;
}

/// Esc first lets go of what hands hold, then closes what was opened, then asks. False where the program is to end.
bool Player::leave(bool step_by_step) {
  if (step_by_step && hands_.cancel(waiting_)) return true;
  if (step_by_step && std::exchange(help_, false)) return true;
  if (step_by_step && panels_.close_last()) return true;
  if (from_browser_) return browser_.show(), true;
  if (!step_by_step || Clock::now() < asked_at_ + patience_of_question) return false;
  asked_at_ = Clock::now();
  tell("Esc again quits");
  return true;
}

/// What the scene asked for by its name; Esc stays the window's.
std::set<std::string> Player::keys_of_scene() const {
  std::set<std::string> wanted;
  for (const std::string& key : scene_->keys()) wanted.insert(key);
  for (const std::string& control : scene_->controls()) wanted.insert(control);
  wanted.erase("escape");
  return wanted;
}

void Player::give_keys_to_scene() {
  give_controls(*scene_, !browser_.shown() && !renderer_.writing(), gestures_, waiting_);
  if (browser_.shown()) return;
  const auto for_scene = [wanted = keys_of_scene()](const std::string& key) { return wanted.contains(key); };
  gestures_.erase_keys([&](const std::string& key) {
    if (!for_scene(key)) return false;
    Command command;
    command.kind = Command::Kind::key;
    command.name = key;
    waiting_.commands.push_back(command);
    return true;
  });
  std::erase_if(gestures_.held, for_scene);
}

/// What was pressed in the browser is not for the scene.
void Player::swallow_keys() {
  const auto held = [&](const std::string& key) {
    return std::find(gestures_.held.begin(), gestures_.held.end(), key) != gestures_.held.end();
  };
  std::erase_if(swallowed_, [&](const std::string& key) { return !held(key); });
  for (const std::string& key : swallowed_) std::erase(gestures_.held, key);
}

/// A press in the scene chooses what is under it, for the inspector.
void Player::choose() {
  for (const PointerEvent& event : gestures_.events)
    if (event.kind == PointerEvent::Kind::press && event.button == PointerEvent::Button::left) {
      chosen_ = {};
      World& world = scene_->world();
      if (const PointId point = hands_.highlight(); world.points.alive(point))
        chosen_ = point;
      else
        chosen_ = pick_shape(world, camera_, event.x, event.y, renderer_.width(), renderer_.height());
    }
}

void Player::edit(const FieldEdit& edit) {
  changes_++;
  const std::uint64_t act = keep_for_undo(text("edit of ", edit.field), waiting_);
  try {
    fields::write(scene_->world(), edit.thing, edit.field, edit.value);
  } catch (const std::exception& error) {
    undo_.forget(act);
    complain(error.what());
  }
  if (recorder_) recorder_->edited(edit);
}

void Player::fulfil(const Wishes& wishes) {
  if (wishes.speed) speed_ = *wishes.speed;
  if (wishes.pause) paused_ = !paused_;
  if (wishes.step) paused_ = single_step_ = true;
  if (wishes.parameter) set_parameter(wishes.parameter->first, wishes.parameter->second);
  if (wishes.edit) edit(*wishes.edit);
  if (!wishes.told.empty()) tell(wishes.told);
  if (wishes.save_table) write_table();
  if (wishes.picture) save_picture();
  if (wishes.film) toggle_film();
  if (wishes.save_state) save_state();
  if (wishes.save_scene) save_scene();
  if (wishes.open_state) open_state();
  if (wishes.restart) restart();
  if (wishes.browse) browser_.show();
  if (wishes.next || wishes.previous) open_neighbour(wishes.next ? 1 : -1);
}

void Player::complain(const std::string& why) {
  complained_ = Clock::now();
  log(why, false);
}

void Player::log(const std::string& what, bool good) {
  const auto same = std::find_if(said_.begin(), said_.end(), [&](const Said& s) { return s.text == what; });
  if (same != said_.end()) {
    same->times++;
    return std::rotate(same, same + 1, said_.end()), void();
  }
  said_.push_back({what, 1, good});
  if (said_.size() > most_said) said_.pop_front();
  say(what);
}

Desk Player::desk() {
  AnyId hovered;
  if (const PointId point = hands_.highlight(); scene_->world().points.alive(point)) hovered = point;
  Desk desk{*scene_, times_, pacing_, said_, chosen_, hovered, views_, film_panels_, {}};
  desk.speed = speed_;
  desk.paused = paused_;
  desk.filming = film_ != nullptr;
  desk.changes = changes_;
  desk.quick = load_seconds_ < quick_load;
  desk.width = static_cast<float>(renderer_.width());
  desk.height = static_cast<float>(renderer_.height());
  return desk;
}

void Player::draw() {
  Desk seen = desk();
  fill(overlay_);
  overlay_.windows = [&] {
    if (browser_.shown()) return browser_.draw(path_, seen.width, seen.height);
    draw_tools();
    panels_.draw(seen);
  };
  browser_.work(seen.dark() && !scene_->dark());  // pictures are not made anew for a scene on dark ground
  const bool films_all = film_panels_;
  if (film_ && !films_all) overlay_.without_panels = [this] { add_to_film(); };
  renderer_.draw(scene_->world(), camera_, overlay_);
  overlay_.windows = overlay_.without_panels = nullptr;
  if (const std::string& name = renderer_.pressed_button(); !name.empty()) {
    Command command;
    command.kind = Command::Kind::button;
    command.name = name;
    waiting_.commands.push_back(command);
  }
  if (films_all) add_to_film();
  window_.present(renderer_);
  status_.frame(scene_->world());
  fulfil(seen.wishes);
  if (browser_.shown()) leave_browser();
}

/// Opens what was chosen in the browser, or goes back to the scene, or ends where there is none.
void Player::leave_browser() {
  swallowed_ = gestures_.held;
  if (!browser_.chosen().empty()) {
    from_browser_ = true;
    if (browser_.chosen() == path_) return browser_.hide();
    open(browser_.chosen()) ? browser_.hide() : browser_.show();
  } else if (browser_.left()) {
    if (path_.empty()) over_ = true;
    browser_.hide();
  }
}

}  // namespace pantin::player
