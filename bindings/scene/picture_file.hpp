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

}  // namespace pantin
