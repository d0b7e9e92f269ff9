#pragma once
#include <array>
#include <string>

#include "player/panels/pane.hpp"

namespace pantin::player {

/// The bar of buttons, and the panels that it shows and hides.
class Panels {
 public:
  Panels();

  /// Within a frame of Dear ImGui.
  void draw(Desk& desk);
  /// True where the key shows or hides something here.
  bool key(const std::string& name);
  /// Another scene was opened.
  void reset();
  /// Shows a panel by its title.
  void show(const std::string& title);

 private:
  struct Slot {
    const PaneKind* kind = nullptr;
    std::unique_ptr<Pane> pane;
    bool open = false, drawn = false;
    float x = 0.0f, y = 0.0f, width = 0.0f, height = 0.0f;  ///< [px] when last drawn
  };
  void draw_bar(Desk& desk);
  void draw_list();
  void draw_pane(Slot& slot, Desk& desk);
  std::pair<float, float> free_place(const Slot& slot, const Desk& desk) const;

  std::array<Slot, std::size(pane_kinds)> slots_;
  bool hidden_ = false;  ///< all, but for the bar
};

}  // namespace pantin::player
