#pragma once
// What a scene lets be heard.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pantin {

/// Sounds that need no file, as scripts call them.
enum class SoundKind : std::uint8_t { wood, metal, glass, rubber, blip, noise };
inline constexpr std::array<std::string_view, 6> sound_names = {"wood", "metal", "glass", "rubber", "blip", "noise"};
/// Nothing where there is none of this name.
std::optional<SoundKind> sound_kind(std::string_view name);

/// A sound that begins.
struct SoundCall {
  std::string name;     ///< of `sound_names`, or the path of a .wav file
  double volume = 1.0;  ///< 0 to 1
  double pitch = 1.0;   ///< 1/8 to 8: times the usual frequency
};

/// In one step; more are not heard.
constexpr std::size_t most_sounds = 32;

}  // namespace pantin
