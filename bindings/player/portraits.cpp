#include "player/portraits.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "lua/watchdog.hpp"
#include "player/aim.hpp"
#include "view/picture.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

constexpr double shown_time = 2.0;    // [s] simulated, unless it takes too long
constexpr double most_wall = 2.5;     // [s]
constexpr double script_limit = 5.0;  // [s]

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

lua::SceneOptions for_pictures(lua::SceneOptions options) {
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

Portraits::Portraits(lua::SceneOptions options, std::string folder)
    : options_(for_pictures(std::move(options))), folder_(std::move(folder)), thread_([this] { run(); }) {}

Portraits::~Portraits() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void* Portraits::picture(const std::string& path) {
  Entry& entry = entries_[path];
  if (!entry.asked && !entry.tried) {
    entry.asked = true;
    queue_.push_back(path);
  }
  return entry.texture ? entry.texture->id() : nullptr;
}

const std::string& Portraits::error(const std::string& path) { return entries_[path].error; }

void Portraits::rest() {
  for (const std::string& path : queue_) entries_[path].asked = false;
  queue_.clear();
}

bool Portraits::done() const {
  for (const auto& [path, entry] : entries_)
    if (entry.asked && !entry.tried) return false;
  return true;
}

/// Where the picture of a scene as it is now is kept, or empty.
std::string Portraits::file_of(const std::string& path) const {
  if (folder_.empty()) return {};
  char name[40];
  const std::string key = text(contents(path), PANTIN_VERSION, width, "x", height, dark_);
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
    if (reached != State::failed) draw(path_, reached == State::stepped);
    if (reached != State::opened) {
      entries_[path_].tried = true;
      entries_[path_].error = std::exchange(error_, {});
      scene_.reset();
    }
    state_ = reached == State::opened ? State::stepping : State::none;
    lock.unlock();
    return changed_.notify_all();
  }
  if (state_ != State::none || queue_.empty()) return;
  const std::string path = queue_.front();
  queue_.pop_front();
  const std::string file = file_of(path);
  Entry& entry = entries_[path];
  if (!file.empty()) entry.texture = Texture::read(file);
  entry.tried = entry.texture.has_value();
  if (entry.tried) return;
  path_ = path;
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
  overlay.views.set(View::dark, dark_);
  renderer_->draw(scene_->world(), *camera_, overlay);
  const std::vector<std::uint8_t> pixels = renderer_->read_pixels();
  entries_[path].texture.emplace(pixels, width, height);
  if (const std::string file = file_of(path); keep && !file.empty()) {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    try {
      write_png(file, pixels, width, height);
    } catch (const Error&) {}  // it will be made again
  }
}

/// The thread's work.
void Portraits::run() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    changed_.wait(lock, [&] { return ending_ || state_ == State::opening || state_ == State::stepping; });
    if (ending_) return;
    const bool open = state_ == State::opening;
    const std::string path = path_;
    lua::Scene* scene = scene_.get();
    lock.unlock();
    std::unique_ptr<lua::Scene> fresh;
    std::string error;
    bool good = true;
    try {
      if (open)
        fresh = lua::Scene::open(path, options_);
      else
        step(*scene);
    } catch (const std::exception& thrown) {
      good = false;
      error = thrown.what();
    }
    lock.lock();
    if (open) scene_ = std::move(fresh);
    error_ = std::move(error);
    state_ = !good ? State::failed : open ? State::opened : State::stepped;
  }
}

void Portraits::step(lua::Scene& scene) {
  const auto start = std::chrono::steady_clock::now();
  while (scene.world().time < shown_time && scene.world().failure.empty() && !scene.finished()) {
    scene.step();
    const std::lock_guard lock(mutex_);
    if (ending_ || std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > most_wall) return;
  }
}

}  // namespace pantin::player
