#include "player/portraits.hpp"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "base/hash.hpp"
#include "lua/scene/open.hpp"
#include "player/aim.hpp"
#include "player/output.hpp"
#include "scene/interrupt.hpp"
#include "view/picture.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

constexpr double most_wall = 5.0;     // [s] for a picture; what is slower is drawn as far as it came
constexpr double script_limit = 5.0;  // [s]

std::uint64_t hash_of(const std::string& bytes) {
  Hash hash;
  for (const char c : bytes) hash.add(std::uint64_t{static_cast<unsigned char>(c)});
  return hash.value;
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

SceneOptions for_pictures(SceneOptions options) {
  options.set.clear();
  options.script_limit = script_limit;
  options.threads = 1;
  return options;
}

}  // namespace

std::string cache_folder() {
  if (const char* given = std::getenv("XDG_CACHE_HOME"); given && *given == '/') return std::string(given) + "/pantin";
  if (const char* home = std::getenv("HOME"); home && *home == '/') return std::string(home) + "/.cache/pantin";
  return {};
}

Portraits::Portraits(SceneOptions options, std::string folder)
    : options_(for_pictures(std::move(options))), folder_(std::move(folder)), thread_([this] { run(); }) {}

Portraits::~Portraits() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  interrupt_scripts();
  thread_.join();
  allow_scripts();
}

void* Portraits::picture(const std::string& path, double at) {
  Entry& entry = entries_[path];
  entry.at = at;
  if (!entry.asked && !entry.tried) {
    entry.asked = true;
    queue_.push_back(path);
  }
  return entry.texture ? entry.texture->id() : nullptr;
}

const std::string& Portraits::error(const std::string& path) { return entries_[path].error; }

void Portraits::rest() {
  for (auto& [path, entry] : entries_) entry.asked = entry.tried;
  queue_.clear();
  const std::lock_guard lock(mutex_);
  given_up_ = state_ != State::none;
}

bool Portraits::done() const {
  for (const auto& [path, entry] : entries_)
    if (entry.asked && !entry.tried) return false;
  return true;
}

/// Where the picture of a scene as it is now is kept, or empty.
std::string Portraits::file_of(const std::string& path, double at) const {
  if (folder_.empty()) return {};
  char name[40];
  const std::string key = text(contents(path), PANTIN_VERSION, width, "x", height, dark_, at);
  std::snprintf(name, sizeof name, "/%016llx.png", static_cast<unsigned long long>(hash_of(key)));
  return folder_ + name;
}

void Portraits::work(bool dark) {
  if (dark != dark_) {
    entries_.clear();
    queue_.clear();
    dark_ = dark;
  }
  std::unique_lock lock(mutex_);
  if (state_ == State::opened || state_ == State::stepped || state_ == State::failed) {
    const State reached = state_;
    if (reached != State::failed && !given_up_) draw(path_, reached == State::stepped);
    const bool over = reached != State::opened || given_up_;
    if (over && !given_up_) {
      entries_[path_].tried = true;
      entries_[path_].error = std::exchange(error_, {});
    }
    state_ = over ? State::dropping : State::stepping;
    lock.unlock();
    return changed_.notify_all();
  }
  if (state_ != State::none || queue_.empty()) return;
  const std::string path = queue_.front();
  queue_.pop_front();
  Entry& entry = entries_[path];
  const std::string file = file_of(path, entry.at);
  if (!file.empty()) entry.texture = Texture::read(file);
  entry.tried = entry.texture.has_value();
  if (entry.tried) return;
  path_ = path;
  at_ = entry.at;
  given_up_ = false;
  state_ = State::opening;
  lock.unlock();
  changed_.notify_all();
}

void Portraits::draw(const std::string& path, bool keep) {
  if (!renderer_) renderer_ = std::make_unique<Renderer>(width, height, 4);
  if (!keep) {
    renderer_->open(scene_->world());
    camera_ = std::make_unique<Camera>(aim(*scene_, renderer_->stage(), static_cast<double>(width) / height));
  }
  Overlay overlay;
  overlay.views.set(View::dark, dark_ || scene_->dark());
  renderer_->draw(scene_->world(), *camera_, overlay);
  const std::vector<std::uint8_t> pixels = renderer_->read_pixels();
  entries_[path].texture.emplace(pixels, width, height);
  if (const std::string file = file_of(path, at_); keep && !file.empty()) {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    try {
      Output output(file);
      write_png(output.temporary(), pixels, width, height);
      output.keep();
    } catch (const Error&) {}  // it will be made again
  }
}

/// The thread's work. The window goes before it.
void Portraits::run() {
  setpriority(PRIO_PROCESS, 0, 10);  // of this thread alone
  std::unique_lock lock(mutex_);
  while (!ending_) {
    changed_.wait(lock, [&] {
      return ending_ || state_ == State::opening || state_ == State::stepping || state_ == State::dropping;
    });
    if (ending_) return;
    const State asked = state_;
    const std::string path = path_;
    const double at = at_;
    std::unique_ptr<Scene> scene = std::move(scene_);
    std::string error;
    lock.unlock();
    try {
      if (asked == State::opening) scene = lua::open_scene(path, options_);
      if (asked == State::stepping) step(*scene, at);
      if (asked == State::dropping) scene.reset();
    } catch (const std::exception& thrown) { error = thrown.what(); }
    lock.lock();
    scene_ = std::move(scene);
    state_ = asked == State::dropping  ? State::none
             : !error.empty()          ? State::failed
             : asked == State::opening ? State::opened
                                       : State::stepped;
    error_ = std::move(error);
  }
}

void Portraits::step(Scene& scene, double until) {
  const auto start = std::chrono::steady_clock::now();
  while (scene.world().time < until && scene.world().failure.empty() && !scene.finished()) {
    scene.step();
    const std::lock_guard lock(mutex_);
    const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (ending_ || given_up_ || taken > most_wall) return;
  }
}

}  // namespace pantin::player
