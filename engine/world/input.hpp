#pragma once
#include <array>
#include <cstdint>
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

/// What a person did before a step, besides moving. Each kind reads the fields that name it.
struct Command {
  enum class Kind : std::uint8_t { grab, release, cut, key, button, join, nail, push, spin, remove, make, heat };
  Kind kind = Kind::key;
  std::int32_t hand = 0;
  PointId point;  ///< grab, nail, push, spin (its body); join: the first; make: what the first end is hinged to
  PointId other;  ///< join: the second; make: what the last end is hinged to
  AnyId thing;    ///< cut: a hinge, connection or constraint; remove: anything
  Vec3 position = zero3();   ///< [m] make: of what is made; heat: the middle of the ball that is heated
  Vec3 amount = zero3();     ///< [N s] push: an impulse; [rad/s] spin: what is added to the body's, world axes
  std::vector<Vec3> points;  ///< [m] make: from `position`; one makes a free particle, more a rigid body
  double max_force = 0.0;    ///< [N] grab, join; 0 takes `usual_grab_force`
  double mass = 0.0;         ///< [kg] make: of all points
  double radius = 0.0;       ///< [m] make: of the points; heat: of the ball
  double energy = 0.0;       ///< [J] heat: given to what is in the ball; a negative one cools, at most to rest
  std::string name;          ///< key, button
};

/// (kinds) as recordings and the log call them
inline constexpr std::array<std::string_view, 12> command_names = {
    "grab", "release", "cut", "key", "button", "join", "nail", "push", "spin", "remove", "make", "heat"};
inline std::string_view name_of(Command::Kind kind) { return command_names[static_cast<std::size_t>(kind)]; }

/// All that the outside told the world for one step; plain data, so that play can be replayed.
struct StepInput {
  std::vector<HandMove> moves;
  std::vector<Command> commands;
};

}  // namespace pantin
