#include "view/film.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/check.hpp"

using namespace pantin;
namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / ("pantin_film_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  long files() const { return std::distance(fs::directory_iterator(path), fs::directory_iterator()); }
};

std::string probe(const fs::path& film, const std::string& entry) {
  const std::string command = "ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + entry +
                              " -of default=nokey=1:noprint_wrappers=1 '" + film.string() + "'";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string out;
  for (int c; pipe && (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
  if (pipe) ::pclose(pipe);
  while (!out.empty() && out.back() == '\n') out.pop_back();
  return out;
}

void add_frames(Film& film, int n, int width, int height) {
  std::vector<std::uint8_t> pixels(4u * static_cast<std::size_t>(width * height));
  for (int i = 0; i < n; i++) {
    for (std::size_t k = 0; k < pixels.size(); k++)
      pixels[k] = static_cast<std::uint8_t>(k % 4 == 3 ? 255u : (k + 9u * static_cast<unsigned>(i)) % 251u);
    film.add(pixels);
  }
}

// Sets PATH for a scope.
struct Path {
  std::string before = std::getenv("PATH");
  explicit Path(const char* path) { ::setenv("PATH", path, 1); }
  ~Path() { ::setenv("PATH", before.c_str(), 1); }
};

}  // namespace

TEST_CASE("a film holds the frames that were added, and appears only when finished", "[view][slow]") {
  const Folder folder;
  const std::string path = folder.path / "a.mp4";
  {
    Film film(path, 65, 49, 30);  // odd sizes are filled up
    add_frames(film, 31, 65, 49);
    CHECK_FALSE(fs::exists(path));
    film.finish();
    CHECK(film.frames() == 31);
  }
  CHECK(probe(path, "nb_read_frames") == "31");
  CHECK(probe(path, "width") == "66");
  CHECK(folder.files() == 1);
}

TEST_CASE("a gif and a webp are written too", "[view][slow]") {
  const Folder folder;
  const std::string path = folder.path / GENERATE("a.gif", "A.GIF", "a.webp");
  Film film(path, 64, 48, 25);
  add_frames(film, 10, 64, 48);
  film.finish();
  CHECK(fs::file_size(path) > 100);
  if (path.back() != 'p') CHECK(probe(path, "nb_read_frames") == "10");  // ffprobe cannot read moving webp
  CHECK(folder.files() == 1);
}

TEST_CASE("a film that is not finished leaves nothing", "[view]") {
  const Folder folder;
  {
    Film film(folder.path / "a.mp4", 64, 48, 30), none(folder.path / "b.mp4", 64, 48, 30);
    add_frames(film, 3, 64, 48);
  }
  CHECK(folder.files() == 0);
  Film empty(folder.path / "c.mp4", 64, 48, 30);
  CHECK_THROWS_WITH(empty.finish(), Catch::Contains("no frames"));
  CHECK(folder.files() == 0);
}

TEST_CASE("a film that cannot be written is an error that names it and the cause", "[view]") {
  const Folder folder;
  const std::string missing = folder.path / "no" / "a.mp4";
  CHECK_THROWS_WITH(Film(missing, 64, 48, 30), Catch::Contains(missing) && Catch::Contains("No such file"));
  CHECK_THROWS_WITH(Film("a.avi", 64, 48, 30), Catch::Contains(".mp4, .gif or .webp"));
  CHECK_THROWS_WITH(Film("a.mp4", 64, 48, 0.0), Catch::Contains("rate must be > 0"));
  CHECK_THROWS_WITH(Film("a.mp4", 0, 48, 30.0), Catch::Contains("size must be > 0"));
  {
    const Path path("/nowhere");
    CHECK_THROWS_WITH(Film(folder.path / "a.mp4", 64, 48, 30), Catch::Contains("ffmpeg is not installed"));
  }
  Film film(folder.path / "b.mp4", 64, 48, 30);
  const std::vector<std::uint8_t> few(10);
  CHECK_THROWS_WITH(film.add(few), Catch::Contains("a frame has 12288 bytes, got 10"));
}

TEST_CASE("an ffmpeg that fails is told with its own words", "[view]") {
  const Folder folder;
  const fs::path program = folder.path / "ffmpeg";
  {
    std::FILE* file = std::fopen(program.c_str(), "w");
    std::fputs("#!/bin/sh\necho it is broken >&2\nexit 3\n", file);
    std::fclose(file);
    fs::permissions(program, fs::perms::owner_all);
  }
  const Path path((folder.path.string() + ":/usr/bin:/bin").c_str());
  const auto make = [&] {
    Film film(folder.path / "a.mp4", 640, 480, 30);
    add_frames(film, 20, 640, 480);
    film.finish();
  };
  CHECK_THROWS_WITH(make(), Catch::Contains("it is broken"));
  CHECK(folder.files() == 1);
}
