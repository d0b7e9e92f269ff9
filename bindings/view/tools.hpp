#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pantin {

enum class ToolKind : std::uint8_t { drag, cut, join, nail, push, spin, remove, make, heat };

/// A tool that hands use.
struct Tool {
  ToolKind kind;
  const char* name;
  const char* icon;  ///< a letter of DejaVu Sans, UTF-8
  const char* help;
  std::vector<const char*> variants;  ///< what it can be of; its key, pressed again, takes the next
};

const std::vector<Tool>& tools();

/// Which tool all hands use.
struct ToolChoice {
  ToolKind kind = ToolKind::drag;
  std::size_t variant = 0;

  const Tool& tool() const { return tools()[static_cast<std::size_t>(kind)]; }
  /// Of which corners are clicked.
  bool is_polygon() const;
  /// Takes a tool; the one that is chosen already changes its variant.
  void choose(ToolKind wanted);
  /// Takes the tool so many places on, less than there are, round and round.
  void move_on(int places);
};

}  // namespace pantin
