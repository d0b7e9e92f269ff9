#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace pantin {

/// A small picture that is shown within a window. Needs a current context as long as it lives.
class Texture {
 public:
  /// RGBA, 4 bytes a pixel, top row first.
  Texture(std::span<const std::uint8_t> pixels, int width, int height);
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  /// A PNG's picture; none where it cannot be read.
  static std::optional<Texture> read(const std::string& path);

  /// A picture of a scene, to be repeated, with smaller copies; its colours are times their opacity. None where it cannot be
  /// made out.
  static std::optional<Texture> of_content(const std::string& content);

  /// OpenGL's name of it, as Dear ImGui wants it.
  void* id() const;
  /// For what is drawn next.
  void bind() const;

 private:
  unsigned id_ = 0;
};

}  // namespace pantin
