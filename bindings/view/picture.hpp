#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace pantin {

/// Writes RGBA pixels, top row first, as a PNG. Throws Error that names the path.
void write_png(const std::string& path, std::span<const std::uint8_t> pixels, int width, int height);

}  // namespace pantin
