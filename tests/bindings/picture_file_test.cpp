#include "scene/picture_file.hpp"

#include <stb_image_write.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "base/check.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

void put(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

std::string made(bool png, int columns, int rows) {
  const std::vector<unsigned char> pixels(3u * static_cast<std::size_t>(columns * rows), 90);
  std::string content;
  const int done = png ? stbi_write_png_to_func(put, &content, columns, rows, 3, pixels.data(), 3 * columns)
                       : stbi_write_jpg_to_func(put, &content, columns, rows, 3, pixels.data(), 80);
  REQUIRE(done != 0);
  return content;
}

}  // namespace

TEST_CASE("picture file: a PNG and a JPEG tell their size") {
  const bool png = GENERATE(true, false);
  const PictureSize size = size_of_picture(made(png, 300, 17));
  CHECK(size.columns == 300);
  CHECK(size.rows == 17);
}

TEST_CASE("picture file: what is cut off anywhere is an error, and nothing else happens") {
  const std::string content = made(GENERATE(true, false), 20, 30);
  for (std::size_t length = 0; length < content.size(); length++)
    CHECK_THROWS_AS(size_of_picture(std::string_view(content).substr(0, length)), Error);
}

TEST_CASE("picture file: what is neither, and a JPEG of another kind, are told") {
  CHECK_THROWS_WITH(size_of_picture("GIF89a"), Contains("is neither a PNG nor a JPEG"));
  std::string other = made(false, 20, 30);
  other[other.find("\xff\xc0") + 1] = '\xc9';
  CHECK_THROWS_WITH(size_of_picture(other), Contains("arithmetic codes"));
  std::string headless = made(true, 20, 30);
  headless[12] = 'J';
  CHECK_THROWS_WITH(size_of_picture(headless), Contains("without a head"));
}

TEST_CASE("picture file: a PNG one byte of which is another is told, wherever that is") {
  const std::string content = made(true, 20, 30);
  CHECK_NOTHROW(check_pixels(content));
  for (std::size_t at = 8; at < content.size(); at++) {
    std::string damaged = content;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    CAPTURE(at);
    CHECK_THROWS_AS((size_of_picture(damaged), check_pixels(damaged)), Error);
  }
}

TEST_CASE("picture file: a JPEG whose pixels cannot be made out is told") {
  std::string content = made(false, 20, 30);
  CHECK_NOTHROW(check_pixels(content));
  const std::size_t tables = content.find("\xff\xc4");
  REQUIRE(tables != content.npos);
  for (std::size_t i = 5; i < 21; i++) content[tables + i] = '\xff';  // more codes than there can be
  CHECK_NOTHROW(size_of_picture(content));
  CHECK_THROWS_WITH(check_pixels(content), Contains("has pixels that cannot be made out: "));
}
