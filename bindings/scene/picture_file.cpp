#include "scene/picture_file.hpp"

#include <stb_image.h>

#include <array>
#include <memory>

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

/// Of the bytes of a chunk of a PNG (ISO 15948, annex D).
std::uint32_t checksum(std::string_view bytes) {
  static constexpr auto table = [] {
    std::array<std::uint32_t, 256> sums{};
    for (std::uint32_t n = 0; n < 256; n++) {
      std::uint32_t sum = n;
      for (int bit = 0; bit < 8; bit++) sum = (sum & 1u) != 0 ? 0xedb88320u ^ (sum >> 1) : sum >> 1;
      sums[n] = sum;
    }
    return sums;
  }();
  std::uint32_t sum = 0xffffffffu;
  for (const char byte : bytes) sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xffu] ^ (sum >> 8);
  return ~sum;
}

void check_chunks(std::string_view content) {
  for (std::size_t at = png_mark.size(), next = 0; at < content.size(); at = next) {
    next = at + 12 + number_at(content, at, 4);
    const std::string_view kind_and_data = content.substr(at + 4, next - at - 8);
    require(checksum(kind_and_data) == number_at(content, next - 4, 4), "is damaged: the checksum of its ",
            next - at - 12, " bytes from ", at + 8, " is another");
    if (kind_and_data.starts_with("IEND")) break;
  }
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

void check_pixels(std::string_view content) {
  if (content.starts_with(png_mark)) check_chunks(content);
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(content.data()), static_cast<int>(content.size()), &width,
                            &height, &channels, 4),
      stbi_image_free);
  require(pixels != nullptr, "has pixels that cannot be made out: ", stbi_failure_reason());
}

}  // namespace pantin
