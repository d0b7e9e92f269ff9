#include "view/picture.hpp"

#include <stb_image_write.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "base/check.hpp"

namespace pantin {

namespace {

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* from = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), from, from + size);
}

}  // namespace

void write_png(const std::string& path, std::span<const std::uint8_t> pixels, int width, int height) {
  require(width > 0 && height > 0 &&
              pixels.size() == 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
          "picture '", path, "': ", pixels.size(), " bytes are not ", width, " x ", height, " pixels of 4 bytes");
  std::vector<std::uint8_t> bytes;
  require(stbi_write_png_to_func(append, &bytes, width, height, 4, pixels.data(), 4 * width) != 0, "picture '", path,
          "' could not be packed");
  std::FILE* file = std::fopen(path.c_str(), "wb");
  require(file != nullptr, "picture '", path, "' cannot be written: ", std::strerror(errno));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  int why = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && !closed) why = errno;
  require(written && closed, "picture '", path, "' cannot be written: ", std::strerror(why));
}

}  // namespace pantin
