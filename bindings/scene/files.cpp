#include "scene/files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace pantin {

std::optional<std::string> file_content(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  return std::string{std::istreambuf_iterator<char>(file), {}};
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
