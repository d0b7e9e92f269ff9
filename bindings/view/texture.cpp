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

std::optional<Texture> Texture::of_content(const std::string& content) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(content.data()), static_cast<int>(content.size()), &width,
                            &height, &channels, 4),
      stbi_image_free);
  if (!pixels || width <= 0 || height <= 0) return {};
  const std::span<stbi_uc> bytes(pixels.get(), 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < bytes.size(); i += 4)
    for (std::size_t c = i; c < i + 3; c++) bytes[c] = static_cast<stbi_uc>((bytes[c] * bytes[i + 3] + 127) / 255);
  Texture made(bytes, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  glGenerateMipmap(GL_TEXTURE_2D);
  return made;
}

void Texture::bind() const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, id_);
}

void* Texture::id() const { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(id_)); }

}  // namespace pantin
