#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/color.hpp"
#include "model/particle.hpp"
#include "model/point.hpp"
#include "view/views.hpp"

namespace pantin {

/// A line, arrow, text, dot or circle over the scene, hidden by nothing.
struct Mark {
  enum class Kind : std::uint8_t { line, arrow, text, point, ring };
  Kind kind = Kind::line;
  Vec3 from = zero3();  ///< [m], or on the screen [px] from its upper left corner, negative from the opposite edge
  Vec3 to = zero3();    ///< the same; of a line or arrow
  std::optional<Color> color;  ///< none: the ink that goes with the background
  double size = 2.0;           ///< [px] width of a line, diameter of a point or ring, height of letters
  bool on_screen = false;
  std::string text;
};

/// What a picture shows beside the world. Empty: the world alone. (Grabs are constraints of the world and need nothing
/// here.)
struct Overlay {
  double pace = 1.0;  ///< simulated s per real s, for what is shown for a while
  Views views;
  std::vector<Mark> marks;
  PointId highlight;                                          ///< ringed, when alive: what the pointer is over
  std::vector<std::string> status;                            ///< parts of the quiet line at the bottom
  std::string message;                                        ///< above the tools, in warning colour: an error
  std::string title;                                          ///< upper left
  std::span<const std::pair<std::string, std::string>> help;  ///< {key, what it does}; shown as a card when not empty
  std::vector<std::string> buttons;      ///< names; `Renderer::pressed_button` tells which was pressed
  std::function<void()> windows;         ///< makes windows of Dear ImGui beside all that, or empty
  std::function<void()> without_panels;  ///< is called once all but text, buttons and windows is drawn, or empty
};

}  // namespace pantin
