#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/lanes.hpp"
#include "model/group.hpp"

namespace pantin {

/// Where a hand is at the end of the coming step.
struct HandMove {
  std::int32_t hand = 0;
  Vec3 position = zero3();  ///< [m]
  bool pressed = false;
};

/// What a thing that hands make touches with: nothing; round a rod's length; a ball; a box; a wheel; the hull of its points; a prism
/// over the outline that its points are, or where that is not convex several prisms.
enum class MadeForm : std::uint8_t { bare, rod, ball, box, wheel, hull, polygon };
/// (forms) as recordings call them
inline constexpr std::array<std::string_view, 7> form_names = {"bare",  "rod",  "ball",   "box",
                                                               "wheel", "hull", "polygon"};

/// What a person did before a step, besides moving. Each kind reads the fields that name it.
struct Command {
  enum class Kind : std::uint8_t {
    grab,
    release,
    cut,
    key,
    button,
    join,
    nail,
    push,
    spin,
    remove,
    make,
    heat,
    tie,
    drive,
    control,
    bring,
    mouse
  };
  Kind kind = Kind::key;
  std::int32_t hand = 0;
  PointId point;  ///< grab, nail, push, spin (its body), bring, tie: the first; make: what the first end is hinged to
  PointId other;  ///< join, tie: the second; make: what the last end is hinged to
  AnyId thing;  ///< cut: a hinge, connection or constraint; remove: anything; else the body meant where `point` is null
  AnyId other_thing;  ///< join, tie, make: the body meant where `other` is null
  Vec3 position =
      zero3();  ///< [m] make: of what is made; bring: where to, the middle of its box; heat: the middle of the ball that is heated; mouse: where it is; else on the body
  Vec3 amount =
      zero3();  ///< [N s] push: an impulse; [rad/s] spin: what is added to the body's; drive: its motor's; make: half the edges
  ///< of a box [m], a wheel's axle or a polygon's, half its thickness long [m], of a rod the axis of its hinges;
  ///< join: the hinge's axis, 0: it turns freely; world axes
  std::vector<Vec3> points;  ///< [m] make: from `position`, the two ends of a rod first; join, tie: the other end alone
  MadeForm form =
      MadeForm::bare;      ///< make: what of it touches; bare: one point makes a free particle, more a rigid body
  double max_force = 0.0;  ///< [N] grab, join; 0 takes `usual_grab_force`
  double mass = 0.0;       ///< [kg] make: of all; 0: by the usual density of what touches
  double radius = 0.0;     ///< [m] make: of the points, of a rod, ball or wheel; tie: of a chain; heat: of the ball
  double energy = 0.0;     ///< [J] heat: given to what is in the ball; a negative one cools, at most to rest
  double value = 0.0;      ///< control: how far it is pressed, -1 to 1; 0: let go; mouse: notches of the wheel, up > 0
  std::string
      name;  ///< key, button, control; mouse: its buttons that are down, as "left right"; tie: "rod", "rope", "chain", "spring"; make: "copy" of `thing` or `point` with all
             ///< that is joined to it, mirrored along `amount`; remove: "whole", it with all that is joined to it
};

/// (kinds) as recordings and the log call them
inline constexpr std::array<std::string_view, 17> command_names = {
    "grab",   "release", "cut",  "key", "button", "join",    "nail",  "push", "spin",
    "remove", "make",    "heat", "tie", "drive",  "control", "bring", "mouse"};
inline std::string_view name_of(Command::Kind kind) { return command_names[static_cast<std::size_t>(kind)]; }

/// Whether only a step can carry it out: hands pull in steps, and scripts hear of keys in them. All else may be done between two.
inline bool needs_step(Command::Kind kind) {
  using Kind = Command::Kind;
  return kind == Kind::grab || kind == Kind::release || kind == Kind::key || kind == Kind::button ||
         kind == Kind::control || kind == Kind::mouse;
}

/// A button of the mouse as scripts read it.
struct MouseButton {
  bool held = false, pressed = false, released = false;  ///< the last two in this step
};

/// The mouse as scripts read it.
struct Mouse {
  std::optional<Vec3> position;  ///< [m] nothing until it is told
  double wheel = 0.0;            ///< notches in this step, up > 0
  MouseButton left, middle, right;

  MouseButton* button(std::string_view name) {
    return name == "left" ? &left : name == "middle" ? &middle : name == "right" ? &right : nullptr;
  }
};

/// All that the outside told the world for one step; plain data, so that play can be replayed.
struct StepInput {
  std::vector<HandMove> moves;
  std::vector<Command> commands;
};

}  // namespace pantin
