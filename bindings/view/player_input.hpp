#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "view/gestures.hpp"
#include "view/keys.hpp"
#include "view/overlay.hpp"
#include "view/selected_things.hpp"
#include "view/tool_use.hpp"

namespace pantin {

/// What a person asked of the program, rather than of the world.
struct Actions {
  bool pause = false;             ///< change between running and paused
  bool step = false;              ///< one, while paused
  bool restart = false;           ///< the scene
  bool picture = false;           ///< take one
  bool film = false;              ///< begin or end one
  bool help = false;              ///< show or hide the keys
  bool quit = false;              ///< also where the window was closed
  int undo = 0, redo = 0;         ///< how often
  std::vector<std::string> acts;  ///< names of the tools' uses whose first command is in the input
  std::vector<std::string> said;  ///< what tools did, or why they did nothing
};

/// Turns gestures into the world's input and the camera's moves. Left uses the tool; right turns the view, middle or
/// shift-right shifts it, the wheel zooms, ctrl-click cuts; keys as `window_keys` has them, of which others are for the
/// scene. Each finger, each stick and the
/// cursor of the arrow keys is a hand of its own, with the same tool.
class PlayerInput {
 public:
  /// `new_hand` makes a hand in the world and gives its index; called once for each pointer when it first touches.
  explicit PlayerInput(std::function<std::int32_t()> new_hand) : new_hand_(std::move(new_hand)) {}

  /// What a call of `apply` works with. `on_panel`: the mouse is over a button, so a press is not for the scene.
  struct Frame {
    const World& world;
    const Stage& stage;
    int width = 0, height = 0;  ///< [px] of the picture
    bool on_panel = false;
    double time = 0.0;  ///< [s] since the last
    Camera& camera;
    StepInput& input;  ///< of the coming step: moves and commands are added
  };
  Actions apply(const Gestures& gestures, const Frame& frame);
  /// The world was built anew: its hands are gone, and nothing is held.
  void reset();
  /// Another world is in its place: nothing of the old one is copied or under the pointer.
  void forget();
  /// The world was put back to an earlier state: its hands let go, and what was begun is not finished.
  void let_go(const World& world, StepInput& input);
  /// All hands stop what they do; false where none did anything.
  bool cancel(StepInput& input);
  /// Whether one of them does something now.
  bool active() const;
  /// The world goes on in another: its hands have other numbers, and what is held is another point, or null.
  void carry_over(const std::map<std::int32_t, std::int32_t>& hands,
                  const std::function<PointId(PointId)>& counterpart);
  /// What the mouse holds or could take hold of, or null.
  PointId highlight() const { return highlight_; }
  /// Number of the mouse's hand, which is made where there is none yet.
  std::int32_t mouse_hand() { return hold_of(0).hand; }
  /// Marks of all hands, for the overlay.
  void add_marks(const Gestures& gestures, const Viewport& viewport, bool on_panel, std::vector<Mark>& marks) const;

  ToolChoice tool;  ///< what all hands use

 private:
  struct Hold {
    std::int32_t hand = -1;
    ToolUse use;
  };
  struct Work;  // a frame with its gestures and what is asked

  Hold& hold_of(PointerId pointer);
  void pointer_event(const Work& work, const PointerEvent& event);
  bool select(const Work& work, const PointerEvent& event);
  std::vector<AnyId> meant(const Work& work) const;
  void key(const Work& work, const std::string& name);
  void use_key(const Work& work, KeyMeaning key);
  void cut(const Work& work, double x, double y);
  void use_whole(const Work& work, WholeUse use);
  void copy(const Work& work);
  void paste(const Work& work, bool mirrored);
  void remove_whole(const Work& work);
  void move_hands(const Work& work);

  std::function<std::int32_t()> new_hand_;
  std::map<PointerId, Hold> holds_;
  PointId highlight_;
  SelectedThings selection_;
  std::vector<AnyId> copied_;  ///< one of each whole that was: a body, or the point of a free particle
};

}  // namespace pantin
