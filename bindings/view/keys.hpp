#pragma once
// The keys of the window: one table, which the handling of input, the card of keys, hints and the reference read.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pantin {

/// What a key is for. `told`: it stands in the table to be read, for it is no key, or one that is held.
enum class KeyUse : std::uint8_t {
  told,
  tool,
  tool_before,
  tool_next,
  cut,
  whole,
  undo,
  redo,
  pause,
  step,
  step_back,
  slower,
  faster,
  own_pace,
  restart,
  scenes,
  scene_before,
  scene_next,
  panel,
  panels,
  picture,
  film,
  save_state,
  save_scene,
  open_state,
  help,
  fullscreen,
  leave,
  see_all,
  see_start,
  see_freely,
  see_front,
  see_right,
  see_top,
  view
};

/// What `whole` does to a thing and all that is joined to it.
enum class WholeUse : std::uint8_t { copy, paste, mirror, remove };

/// A window in which a scene is played, or a recording of it.
enum class KeyPlace : std::uint8_t { play, replay };

struct WindowKeys {
  const char* group;
  KeyUse use;
  std::vector<const char*> keys;  ///< as `Gestures::keys` has them
  const char* shown;              ///< as they are told
  std::string help;
  std::size_t first = 0;  ///< of tools, wholes, panels and views: which the first key is for; the next is for the next
  std::optional<KeyPlace> only = {};  ///< where it counts; nothing: everywhere
};

/// All, group by group.
const std::vector<WindowKeys>& window_keys();

/// What a key is for, and for which tool, panel or view.
struct KeyMeaning {
  KeyUse use;
  std::size_t which;
};
/// Nothing where the window has no use for it, so that it is the scene's.
std::optional<KeyMeaning> meaning_of(std::string_view key, KeyPlace place = KeyPlace::play);
/// The key of a tool, panel or view, or the first that serves a use.
const char* key_for(KeyUse use, std::size_t which = 0);

/// {keys, what they do}, with a heading before each group, which does nothing: for the card of keys.
std::span<const std::pair<std::string, std::string>> key_card(KeyPlace place = KeyPlace::play);
/// The same as Markdown, for the reference.
std::string key_reference();

}  // namespace pantin
