#include "player/output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "scene/errors.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw UsageError(text("cannot write ", path, ": ", why));
}

std::string temporary_name(const fs::path& target, int attempt) {
  std::string name = text(".", target.stem().string(), ".part-", getpid(), "-", attempt, target.extension().string());
  return target.parent_path() / name;
}

}  // namespace

std::string followed(const std::string& path) {
  constexpr int most_links = 40;
  std::error_code none;
  const fs::path start = fs::absolute(path, none);
  fs::path end = start;
  for (int i = 0; i < most_links && fs::is_symlink(end, none); i++)
    end = end.parent_path() / fs::read_symlink(end, none);
  const fs::path whole = fs::weakly_canonical(fs::is_symlink(end, none) ? start : end, none);
  return none ? path : whole.string();
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code missing;
  return followed(a) == followed(b) || (fs::equivalent(a, b, missing) && !missing);
}

void keep_apart(const std::string& written, const std::string& read) {
  if (same_file(written, read)) refuse(written, "it is the file that is read, " + read);
}

std::string free_name(const std::string& ending) {
  char number[16];
  std::string name;
  int next = 1;
  do {
    std::snprintf(number, sizeof number, "%04d", next++);
    name = text("pantin-", number, ending);
  } while (fs::exists(name));
  return name;
}

Output::Output(std::string path) : path_(std::move(path)) {
  std::error_code failed;
  fs::file_status status = fs::status(path_, failed);
  if (failed && status.type() == fs::file_type::none) refuse(path_, failed.message());
  if (fs::is_directory(status)) refuse(path_, "it is a folder");
  if (path_.empty() || path_.back() == '/') refuse("'" + path_ + "'", "it names no file");
  if (fs::exists(status) && access(path_.c_str(), W_OK) != 0) refuse(path_, std::strerror(errno));
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    target_ = temporary_ = path_;
    return;
  }
  target_ = followed(path_);
  if (fs::exists(status) && target_.ends_with(".lua")) refuse(path_, "it is a script, which would be lost");
  int file = -1;
  for (int attempt = 0; attempt < 100 && file < 0; attempt++) {
    temporary_ = temporary_name(target_, attempt);
    file = open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file < 0 && errno != EEXIST) refuse(path_, std::strerror(errno));
  }
  if (file < 0) refuse(path_, std::strerror(errno));
  close(file);
  try {
    unfinished_ = Unfinished(temporary_);
  } catch (...) {
    unlink(temporary_.c_str());
    throw;
  }
}

Output::Output(Output&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, "")),
      unfinished_(std::move(other.unfinished_)) {}

Output::~Output() { drop(); }

void Output::drop() {
  if (!temporary_.empty() && temporary_ != target_) unlink(temporary_.c_str());
  temporary_.clear();
  unfinished_ = {};
}

void Output::write(const std::string& text_) const {
  std::ofstream file(temporary_, std::ios::binary);
  file << text_;
  file.close();
  require(file.good(), "cannot write ", path_, ": ", std::strerror(errno));
}

std::string Output::in_own_name(std::string message) const {
  if (temporary_.empty()) return message;
  for (std::size_t at; (at = message.find(temporary_)) != std::string::npos && temporary_ != path_;)
    message.replace(at, temporary_.size(), path_);
  return message;
}

void Output::keep() {
  if (temporary_.empty()) return;
  const auto do_or_tell = [&](bool done) { require(done, "cannot write ", path_, ": ", std::strerror(errno)); };
  if (temporary_ != target_) {
    const int file = open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
    do_or_tell(file >= 0);
    const bool flushed = fsync(file) == 0;
    close(file);
    do_or_tell(flushed);
    require(fs::file_size(temporary_) > 0, "cannot write ", path_, ": nothing was written to it");
    do_or_tell(std::rename(temporary_.c_str(), target_.c_str()) == 0);
  }
  temporary_.clear();
  unfinished_ = {};
}

}  // namespace pantin::player
