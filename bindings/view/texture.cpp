#include "view/texture.hpp"

#include <epoxy/gl.h>
#include <stb_image.h>

#include <memory>
#include <utility>

#include "base/check.hpp"

namespace pantin {

Texture::Texture(std::span<const std::uint8_t> pixels, int width, int height) {
  require(width > 0 && height > 0 &&
              pixels.size() == 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
          "texture: ", pixels.size(), " bytes are not ", width, " x ", height, " pixels of 4 bytes");
  glGenTextures(1, &id_);
  glBindTexture(GL_TEXTURE_2D, id_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

Texture::~Texture() {
  if (id_) glDeleteTextures(1, &id_);
}

Texture::Texture(Texture&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

std::optional<Texture> Texture::read(const std::string& path) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(stbi_load(path.c_str(), &width, &height, &channels, 4),
                                                         stbi_image_free);
  if (!pixels || width <= 0 || height <= 0) return {};
  return Texture({pixels.get(), 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)}, width,
                 height);
}

void* Texture::id() const { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(id_)); }

}  // namespace pantin
