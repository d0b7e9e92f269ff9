#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pantin {

constexpr std::size_t largest_picture_file = std::size_t{16} << 20;  ///< bytes
constexpr std::uint32_t largest_picture = 4096;                      ///< [pixels] along an edge

struct PictureSize {
  std::uint32_t columns = 0, rows = 0;  ///< [pixels]
};

/// Of a PNG or JPEG, by its head; throws Error that says what is wrong with it where it is neither, or not whole.
PictureSize size_of_picture(std::string_view content);
/// Of one that has a size: throws Error that says so where its pixels are damaged, as by their checksums, or cannot be made
/// out.
void check_pixels(std::string_view content);

}  // namespace pantin
