#include "player/saved_values.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "base/check.hpp"
#include "base/hash.hpp"
#include "player/home.hpp"
#include "player/json.hpp"
#include "player/message.hpp"
#include "scene/files.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

constexpr std::chrono::seconds between_writes{1};

/// Empty: there is none.
fs::path data_folder() {
  const auto from = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const fs::path given = from("XDG_DATA_HOME"); given.is_absolute()) return given;
  const fs::path home = from("HOME");
  return home.is_absolute() ? home / ".local" / "share" : fs::path();
}

std::string text_of_values(const SavedValues& values) {
  Json json = Json::object();
  for (const auto& saved : values) std::visit([&](const auto& plain) { json[saved.first] = plain; }, saved.second);
  return text_of(json);
}

/// Throws where it is no table of plain values.
SavedValues values_of_text(const std::string& content) {
  SavedValues values;
  const Json table = Json::parse(content);
  for (const auto& [name, json] : table.items()) {
    if (json.is_boolean())
      values[name] = json.get<bool>();
    else if (json.is_string())
      values[name] = json.get<std::string>();
    else
      values[name] = json.get<double>();
  }
  return values;
}

/// Scenes of one name lie in different folders.
std::string file_name(const std::string& scene) {
  Hash hash;
  for (const char c : scene) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  return text(scene_name(scene), "-", std::to_string(hash.value % 100'000'000), ".json");
}

}  // namespace

SavedFile::SavedFile(const std::string& scene) {
  const fs::path folder = data_folder();
  if (folder.empty()) return;
  path_ = (folder / "pantin" / "saved" / file_name(scene)).string();
  const auto content = file_content(path_);
  if (!content) return;
  try {
    *values_ = values_of_text(*content);
  } catch (const std::exception& error) { say(text(path_, ": what was saved cannot be read: ", error.what())); }
  written_ = *values_;
}

SavedFile::SavedFile(SavedFile&& other) noexcept = default;

SavedFile& SavedFile::operator=(SavedFile&& other) noexcept {
  if (this == &other) return *this;
  write();
  path_ = std::move(other.path_);
  other.path_.clear();
  values_ = std::move(other.values_);
  written_ = std::move(other.written_);
  return *this;
}

SavedFile::~SavedFile() { write(); }

void SavedFile::keep() {
  const auto now = std::chrono::steady_clock::now();
  if (now < last_ + between_writes) return;
  last_ = now;
  write();
}

void SavedFile::write() {
  if (path_.empty() || !values_ || *values_ == written_) return;
  written_ = *values_;
  std::error_code error;
  fs::create_directories(fs::path(path_).parent_path(), error);
  const std::string aside = path_ + ".new";
  std::ofstream file(aside, std::ios::binary);
  file << text_of_values(written_) << '\n';
  file.close();
  if (file) fs::rename(aside, path_, error);
  if (!file || error) say(text(path_, ": what the scene saves cannot be written"));
}

}  // namespace pantin::player
