#include "support/sources.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace pantin::sources {

namespace fs = std::filesystem;

std::string folder() { return PANTIN_SOURCE_DIR; }

std::string program() { return PANTIN_PROGRAM; }

std::string preload(const std::string& name) {
  const std::string folder = PANTIN_PRELOADS;
  return folder.empty() ? "" : folder + "/libpantin_" + name + ".so";
}

Files read(std::initializer_list<const char*> folders) {
  const fs::path root = folder();
  Files files;
  for (const char* folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".cpp" && ending != ".hpp") continue;
      std::ifstream file(entry.path());
      files[entry.path().lexically_relative(root).generic_string()] =
          std::string(std::istreambuf_iterator<char>(file), {});
    }
  }
  return files;
}

}  // namespace pantin::sources
