#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "view/tools.hpp"

namespace pantin {

/// What can be undone, by name, or why nothing can.
struct UndoState {
  std::string_view undo, redo;            ///< names of acts; empty: there is none
  std::function<std::string()> obstacle;  ///< not empty: neither can be done, and it says why
};

/// What was pressed beside the tools.
struct PaletteWish {
  bool undo = false, redo = false;
};

/// A row of buttons of the tools, and of undo and redo, at the lower edge of a picture of that size [px], the chosen one marked, and what it can be
/// of; beside it, where there is room, its name and key; above it what hands were told last. Within a frame of Dear ImGui.
PaletteWish draw_palette(ToolChoice& choice, const UndoState& undo, const std::string& told, float width, float height);

}  // namespace pantin
