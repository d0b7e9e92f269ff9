#include "player/fuzz.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "lua/scene/open.hpp"
#include "player/output.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"
#include "scene/printable.hpp"

namespace pantin::player {
namespace {

constexpr double minimise_seconds = 120.0;

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string one_line(std::string message) {
  std::ranges::replace(message, '\n', ' ');
  return message;
}

/// Leaves out what is not needed, and writes the rest. Returns the file.
std::string keep_find(std::vector<std::string> statements, const Find& find, std::uint64_t seed,
                      const std::string& folder, const std::string& home) {
  statements = smallest(
      std::move(statements),
      [&](const std::vector<std::string>& some) { return examine(fuzz_source(some), home).kind == find.kind; },
      minimise_seconds);
  const std::string path = std::filesystem::path(folder) / text(find.kind, "_", seed, ".lua");
  Output output(path);
  output.write(text("-- ", find.kind, ", seed ", seed, ": ", one_line(find.text), "\n", fuzz_source(statements)));
  output.keep();
  return path;
}

void tell(const std::string& name, const Find& find) {
  std::printf("%s\n", printable(one_line(text(name, ": ", find.kind, ": ", find.text))).c_str());
  std::fflush(stdout);
}

int look_at_files(const std::vector<std::string>& files, const std::string& home) {
  int finds = 0, closed = 0;
  for (const std::string& file : files) {
    const auto source = file_content(file);
    const Find find = source ? examine(*source, home) : Find{unopened, "there is no such file"};
    if (find.kind.empty()) continue;
    find.kind == unopened ? closed++ : finds++;
    tell(file, find);
  }
  const std::string not_opened = closed > 0 ? text(", ", closed, " not opened") : "";
  std::printf("%zu scenes, %d finds%s\n", files.size(), finds, not_opened.c_str());
  return finds + closed == 0 ? 0 : 1;
}

}  // namespace

std::vector<std::string> random_scene(std::uint64_t seed, const std::string& home) {
  SceneOptions options;
  options.home = home;
  options.set["seed"] = std::to_string(seed);
  const auto scene = lua::open_scene(std::filesystem::path(home) / "tests" / "fuzz" / "random_scene.lua", options);
  std::istringstream source(std::get<std::string>(scene->results().at("source")));
  std::vector<std::string> statements;
  for (std::string line; std::getline(source, line);) statements.push_back(line);
  return statements;
}

std::string fuzz_source(const std::vector<std::string>& statements) {
  std::string source = "local t = {}\nlocal function try(f) return pcall(f) end\n";
  for (const std::string& statement : statements) source += statement + "\n";
  return source;
}

std::vector<std::string> smallest(std::vector<std::string> statements,
                                  const std::function<bool(const std::vector<std::string>&)>& fails, double seconds) {
  const Stopwatch watch;
  std::size_t part = statements.size();
  while (part > 0 && watch.seconds() < seconds) {
    bool dropped = false;
    for (std::size_t from = 0; from < statements.size() && watch.seconds() < seconds;) {
      std::vector<std::string> rest(statements.begin(), statements.begin() + static_cast<std::ptrdiff_t>(from));
      const std::size_t to = std::min(from + part, statements.size());
      rest.insert(rest.end(), statements.begin() + static_cast<std::ptrdiff_t>(to), statements.end());
      if (fails(rest)) {
        statements = std::move(rest);
        dropped = true;
      } else {
        from = to;
      }
    }
    if (!dropped || part > 1) part /= 2;
  }
  return statements;
}

int fuzz(const FuzzOptions& options, const std::string& home) {
  if (!options.files.empty()) return look_at_files(options.files, home);
  const std::string folder =
      options.folder.empty() ? (std::filesystem::path(home) / "tests" / "corpus").string() : options.folder;
  const Stopwatch watch;
  std::uint64_t scenes = 0;
  int finds = 0;
  for (std::uint64_t seed = options.seed; scenes == 0 || watch.seconds() < options.seconds; seed++, scenes++) {
    const std::vector<std::string> statements = random_scene(seed, home);
    const Find find = examine(fuzz_source(statements), home);
    if (find.kind.empty() || find.kind == unopened) continue;
    finds++;
    tell(text("seed ", seed), find);
    std::printf("  %s\n", printable(keep_find(statements, find, seed, folder, home)).c_str());
    std::fflush(stdout);
  }
  std::printf("%llu scenes from seed %llu in %.0f s, %d finds\n", static_cast<unsigned long long>(scenes),
              static_cast<unsigned long long>(options.seed), watch.seconds(), finds);
  return finds == 0 ? 0 : 1;
}

}  // namespace pantin::player
