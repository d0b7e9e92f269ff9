#include "scene/sound.hpp"

#include <algorithm>

namespace pantin {

std::optional<SoundKind> sound_kind(std::string_view name) {
  const auto found = std::find(sound_names.begin(), sound_names.end(), name);
  if (found == sound_names.end()) return {};
  return static_cast<SoundKind>(found - sound_names.begin());
}

}  // namespace pantin
