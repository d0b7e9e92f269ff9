#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "view/camera.hpp"
#include "view/gestures.hpp"
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin {

/// What a person asked of the program, rather than of the world.
struct Actions {
  bool pause = false;    ///< space: change between running and paused
  bool step = false;     ///< . : one step while paused
  bool restart = false;  ///< r
  bool picture = false;  ///< s
  bool help = false;     ///< h: show or hide the keys
  bool quit = false;     ///< Esc, q, or the window was closed
};

/// {key, what it does}, for the help card.
const std::vector<std::pair<std::string, std::string>>& key_help();

/// Turns gestures into the world's input and the camera's moves. Left drags the point under the pointer in the plane
/// parallel to the screen; right turns, middle or shift-right shifts, the wheel zooms; x or ctrl-click cuts the hinge
/// under the pointer; f frames the scene. Each finger is a hand of its own.
class PlayerInput {
 public:
  /// `new_hand` makes a hand in the world and gives its index; called once for each pointer when it first touches.
  explicit PlayerInput(std::function<std::int32_t()> new_hand) : new_hand_(std::move(new_hand)) {}

  /// Appends moves and commands to `input`, for the coming step. `on_panel`: the pointer is over a button, so a press is
  /// not for the scene. Sizes in px of the picture.
  Actions apply(const Gestures& gestures, const World& world, const Stage& stage, int width, int height, bool on_panel,
                Camera& camera, StepInput& input);
  /// The world was built anew: its hands are gone, and nothing is held.
  void reset();
  /// What the mouse holds or is over, or null.
  PointId highlight() const { return highlight_; }

 private:
  struct Hold {
    std::int32_t hand = -1;
    bool holding = false;
    double depth = 0.0;     ///< [m] of what is held
    Vec3 offset = zero3();  ///< [m] from the place under the pointer to what is held
    PointId point;
  };
  struct Frame;  // what one call of `apply` works on

  Hold& hold_of(PointerId pointer);
  void pointer_event(const Frame& frame, const PointerEvent& event);
  void press(const Frame& frame, const PointerEvent& event);
  void drag_camera(const Frame& frame, const PointerEvent& event);
  void key(const Frame& frame, const std::string& name);
  void cut(const Frame& frame, double x, double y);
  void move_hands(const Frame& frame);

  std::function<std::int32_t()> new_hand_;
  std::map<PointerId, Hold> holds_;
  PointId highlight_;
};

}  // namespace pantin
