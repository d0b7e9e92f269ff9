// What the player does beside the frames: opening scenes, and what was asked for in the panels.
#include <algorithm>
#include <filesystem>

#include "player/home.hpp"
#include "player/message.hpp"
#include "player/player.hpp"

namespace pantin::player {
namespace {

constexpr double quick_load = 0.04;  // [s] so long a scene may take to be opened in each frame
constexpr std::size_t most_said = 200;

std::string text_of(const lua::Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return to_text(*number);
  if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  return std::get<std::string>(value);
}

}  // namespace

std::unique_ptr<lua::Scene> Player::load(const std::string& path, const lua::SceneOptions& options) {
  const auto start = Clock::now();
  std::unique_ptr<lua::Scene> scene = lua::Scene::open(path, options);
  load_seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
  return scene;
}

void Player::adopt(std::unique_ptr<lua::Scene> fresh) {
  undo_.clear();
  scene_ = std::move(fresh);
  hands_.reset();
  log_read_ = 0;
  follower_ = {};
  waiting_ = {};
  times_ = {};
  failure_.clear();
  pacing_ = {};
  chosen_ = {};
  renderer_.open(scene_->world());
  window_.set_title(title() + " - Pantin");
}

void Player::restart() {
  try {
    adopt(load(path_, lua_options_));
    paused_ = false;
  } catch (const std::exception& error) { fail(error.what()); }
}

void Player::open(const std::string& path) {
  lua::SceneOptions options = lua_options_;
  std::erase_if(options.set, [](const auto& setting) { return !setting.first.starts_with("scene."); });
  std::unique_ptr<lua::Scene> fresh;
  try {
    fresh = load(path, options);
  } catch (const std::exception& error) { return complain(error.what()); }
  path_ = path;
  lua_options_ = options;
  adopt(std::move(fresh));
  panels_.reset();
  paused_ = false;
  camera_ = aim(*scene_, renderer_.stage(), static_cast<double>(renderer_.width()) / renderer_.height());
}

void Player::open_neighbour(int places) {
  const std::string folder = std::filesystem::path(path_).parent_path();
  const std::vector<SceneEntry> scenes = list_scenes({home_ + "/scripts/scenes", folder.empty() ? "." : folder});
  if (scenes.empty()) return;
  const auto count = static_cast<int>(scenes.size());
  const auto at = static_cast<int>(find_entry(scenes, path_));
  open(scenes[static_cast<std::size_t>((at + places + count) % count)].path);
}

void Player::set_parameter(const std::string& name, const lua::Value& value) {
  const auto before = lua_options_.set;
  lua_options_.set[name] = text_of(value);
  try {
    if (!scene_->set_parameter(name, value)) adopt(load(path_, lua_options_));
  } catch (const std::exception& error) {
    lua_options_.set = before;
    complain(error.what());
  }
}

void Player::take_keys() {
  std::erase_if(gestures_.keys, [&](const std::string& name) {
    if (name == "pagedown" || name == "pageup")
      open_neighbour(name == "pagedown" ? 1 : -1);
    else if (name == "-" || name == "keypad -")
      speed_ = std::max(0.5 * speed_, slowest);
    else if (name == "=" || name == "+" || name == "keypad +")
      speed_ = std::min(2.0 * speed_, fastest);
    else if (name == "0")
      speed_ = 1.0;
    else
      return panels_.key(name);
    return true;
  });
}

void Player::fulfil(const Wishes& wishes) {
  if (wishes.speed) speed_ = *wishes.speed;
  if (wishes.pause) paused_ = !paused_;
  if (wishes.step) paused_ = single_step_ = true;
  if (wishes.parameter) set_parameter(wishes.parameter->first, wishes.parameter->second);
  if (wishes.restart) restart();
  if (wishes.next || wishes.previous) open_neighbour(wishes.next ? 1 : -1);
}

void Player::complain(const std::string& why) {
  complained_ = Clock::now();
  const auto same = std::find_if(said_.begin(), said_.end(), [&](const Said& s) { return s.text == why; });
  if (same != said_.end()) {
    same->times++;
    return std::rotate(same, same + 1, said_.end()), void();
  }
  said_.push_back({why, 1});
  if (said_.size() > most_said) said_.pop_front();
  say(why);
}

Desk Player::desk() {
  AnyId hovered;
  if (const PointId point = hands_.highlight(); scene_->world().points.alive(point)) hovered = point;
  Desk desk{*scene_, times_, pacing_, said_, chosen_, hovered, {}};
  desk.speed = speed_;
  desk.paused = paused_;
  desk.dark = views_.on(View::dark);
  desk.quick = load_seconds_ < quick_load;
  desk.width = static_cast<float>(renderer_.width());
  desk.height = static_cast<float>(renderer_.height());
  return desk;
}

void Player::draw() {
  Desk seen = desk();
  Overlay shown = overlay();
  shown.windows = [&] {
    draw_tools();
    panels_.draw(seen);
  };
  renderer_.draw(scene_->world(), camera_, shown);
  if (const std::string& name = renderer_.pressed_button(); !name.empty()) {
    Command command;
    command.kind = Command::Kind::button;
    command.name = name;
    waiting_.commands.push_back(command);
  }
  window_.present(renderer_);
  status_.frame(scene_->world());
  fulfil(seen.wishes);
}

}  // namespace pantin::player
