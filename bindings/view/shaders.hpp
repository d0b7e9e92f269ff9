#pragma once
#include <string_view>
#include <vector>

namespace pantin {

/// A file of assets/shaders, put into the program when it is built.
struct ShaderText {
  std::string_view name;
  std::string_view text;
};
extern const std::vector<ShaderText> shader_texts;

}  // namespace pantin
