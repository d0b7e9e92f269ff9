#pragma once
#include <vector>

#include "view/overlay.hpp"
#include "view/tool_use.hpp"

namespace pantin {

/// A hand as it is to be shown.
struct ShownHand {
  std::int32_t hand = 0;
  bool mouse = false;       ///< has a cursor already
  double x = 0.0, y = 0.0;  ///< [px]
  ToolChoice choice;        ///< what a press would do
  const ToolUse* use = nullptr;
};

/// Colour that tells hands apart.
Color hand_color(std::int32_t hand);

/// Its cursor and reach, what its tool would take hold of, cut or remove, and what it does: of a drag the force [N] and its
/// limit, of a push the impulse, of a thing that is made its edges.
void mark_hand(const Viewport& viewport, const ShownHand& hand, std::vector<Mark>& marks);

}  // namespace pantin
