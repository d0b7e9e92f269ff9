#include "view/picture.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/check.hpp"

using namespace pantin;
namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / ("pantin_picture_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  long files() const { return std::distance(fs::directory_iterator(path), fs::directory_iterator()); }
};

}  // namespace

TEST_CASE("a picture is written whole, as a PNG, and replaces an older one", "[view]") {
  const Folder folder;
  const std::string path = folder.path / "a.png";
  std::ofstream(path) << "old";
  std::vector<std::uint8_t> pixels(4 * 20 * 10, 200);
  write_png(path, pixels, 20, 10);
  std::ifstream file(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  REQUIRE(bytes.size() > 33);
  CHECK(bytes.substr(1, 3) == "PNG");
  CHECK(static_cast<unsigned char>(bytes[19]) == 20);
  CHECK(static_cast<unsigned char>(bytes[23]) == 10);
  CHECK(folder.files() == 1);
}

TEST_CASE("a picture that cannot be written is an error that names it, and leaves nothing", "[view]") {
  const Folder folder;
  const std::vector<std::uint8_t> pixels(4 * 4 * 4, 1);
  const std::string missing = folder.path / "no" / "a.png";
  CHECK_THROWS_WITH(write_png(missing, pixels, 4, 4), Catch::Contains(missing) && Catch::Contains("No such file"));
  fs::create_directories(folder.path / "taken.png" / "in");
  const std::string taken = folder.path / "taken.png";
  CHECK_THROWS_WITH(write_png(taken, pixels, 4, 4), Catch::Contains(taken));
  CHECK(folder.files() == 1);
  CHECK_THROWS_WITH(write_png("a.png", pixels, 4, 5), Catch::Contains("64 bytes are not 4 x 5"));
}
