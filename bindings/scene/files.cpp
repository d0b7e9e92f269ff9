#include "scene/files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/interruptible.hpp"

namespace pantin {

namespace {
/// To two decimals.
double mebibytes(std::size_t bytes) { return std::round(100.0 * static_cast<double>(bytes) / (1 << 20)) / 100.0; }
}  // namespace

FileTooLarge::FileTooLarge(const std::string& path, std::size_t bytes, std::size_t largest)
    : Error(text("'", path, "' has ", mebibytes(bytes), " MiB; at most ", mebibytes(largest), " are read")) {}

std::optional<std::string> file_content(const std::string& path, std::size_t largest) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  const std::size_t size = std::filesystem::file_size(path, error);
  if (error) return {};
  if (size > largest) throw FileTooLarge(path, size, largest);
  std::string content;
  content.reserve(size);
  std::array<char, 65536> block;
  do {
    stop_if_given_up();
    file.read(block.data(), block.size());
    content.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (content.size() > largest) throw FileTooLarge(path, content.size(), largest);  // it grows, or tells no size
  } while (file);
  return content;
}

bool holds_other(const std::string& path, const std::string& content) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size != content.size()) return !error;
  std::ifstream file(path, std::ios::binary);
  std::string found(content.size(), '\0');
  return file && (!file.read(found.data(), static_cast<std::streamsize>(found.size())) || found != content);
}

std::string path_in(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + "/" + name;
}

bool stays_inside(const std::string& path) {
  const std::filesystem::path p(path);
  if (path.empty() || p.is_absolute() || path.find('\\') != std::string::npos || path.find('\0') != std::string::npos)
    return false;
  for (const auto& part : p)
    if (part == "..") return false;
  return true;
}

bool lies_below(const std::string& path, const std::string& folder) {
  std::error_code missing;
  const std::filesystem::path file = std::filesystem::canonical(path, missing);
  if (missing) return true;
  const std::filesystem::path top = std::filesystem::canonical(folder.empty() ? "." : folder, missing);
  return !missing && std::mismatch(top.begin(), top.end(), file.begin(), file.end()).first == top.end();
}

}  // namespace pantin
