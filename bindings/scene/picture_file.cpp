#include "scene/picture_file.hpp"

#include "base/check.hpp"

namespace pantin {
namespace {

constexpr std::string_view png_mark = "\x89PNG\r\n\x1a\n", jpeg_mark = "\xff\xd8\xff", jpeg_end = "\xff\xd9";

/// Big-endian.
std::uint32_t number_at(std::string_view content, std::size_t at, std::size_t bytes) {
  require(at + bytes <= content.size(), "is not whole");
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes; i++) number = number << 8 | static_cast<unsigned char>(content[at + i]);
  return number;
}

PictureSize size_of_png(std::string_view content) {
  for (std::size_t at = png_mark.size();;) {
    const std::size_t next = at + 12 + number_at(content, at, 4);
    require(next <= content.size(), "is not whole");
    if (content.substr(at + 4, 4) == "IEND") break;
    at = next;
  }
  require(content.substr(12, 4) == "IHDR", "is a PNG without a head");
  return {number_at(content, 16, 4), number_at(content, 20, 4)};
}

PictureSize size_of_jpeg(std::string_view content) {
  require(content.rfind(jpeg_end) != content.npos, "is not whole");
  for (std::size_t at = 2;;) {
    while (number_at(content, at, 2) == 0xffff) at++;
    const std::uint32_t mark = number_at(content, at, 2);
    if (mark >= 0xffc0 && mark <= 0xffc2) return {number_at(content, at + 7, 2), number_at(content, at + 5, 2)};
    require(mark >= 0xffc0 && mark != 0xffd9 && mark != 0xffda, "is a JPEG without a head");
    require(mark == 0xffc4 || mark > 0xffcf, "is a JPEG of a kind that is not read: lossless, or of arithmetic codes");
    at += std::size_t{2} + number_at(content, at + 2, 2);
  }
}

}  // namespace

PictureSize size_of_picture(std::string_view content) {
  if (content.starts_with(png_mark)) return size_of_png(content);
  require(content.starts_with(jpeg_mark), "is neither a PNG nor a JPEG");
  return size_of_jpeg(content);
}

}  // namespace pantin
