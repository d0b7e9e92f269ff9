#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "player/panels/layout.hpp"
#include "player/panels/pane.hpp"

namespace pantin::player {

/// The bar of buttons, and the panels that it shows and hides.
class Panels {
 public:
  Panels();

  /// Within a frame of Dear ImGui.
  void draw(Desk& desk);
  /// Shows or hides a panel, or all that are shown.
  void toggle(std::size_t which);
  void hide();
  bool hidden() const { return hidden_; }  ///< the bar, too
  /// Whether a panel is seen, by its title.
  bool shows(std::string_view title) const;
  /// Closes the panel that was opened last and is still open; false where nobody opened one.
  bool close_last();
  /// Another scene was opened.
  void reset();
  /// Shows a panel by its title.
  void show(const std::string& title);

 private:
  struct Slot {
    const PaneKind* kind = nullptr;
    std::unique_ptr<Pane> pane;
    bool open = false, moved = false;  ///< moved by hand
    float x = 0.0f, y = 0.0f;          ///< [px] where it was put
    float height = 0.0f;               ///< [px] when last drawn
  };
  void draw_bar(Desk& desk);
  void draw_list(Desk& desk);
  void place(const Desk& desk);
  static void draw_pane(Slot& slot, Desk& desk);

  std::array<Slot, std::size(pane_kinds)> slots_;
  std::vector<Slot*> shown_, put_;  ///< in this frame, and those of them that no hand moved
  std::vector<Tile> tiles_;         ///< (put_)
  Layout layout_;
  std::vector<std::size_t> opened_;  ///< by a person, in that order
  bool hidden_ = false;
};

}  // namespace pantin::player
