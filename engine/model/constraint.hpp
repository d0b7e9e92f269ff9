#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "base/lanes.hpp"
#include "model/point.hpp"

namespace pantin {

/// nail: a point stays at a place of the world. follow: a point keeps to a moving target; with a finite `max_force` it
/// is a spring that never pulls harder. rod: two points, or a point and a place, keep their distance.
enum class ConstraintKind : std::uint8_t { nail, follow, rod };

struct Constraint {
  ConstraintKind kind = ConstraintKind::nail;
  PointId a;
  PointId b;                     ///< of a rod; null where its other end is a place of the world
  Vec3 place = zero3();          ///< [m] nail's place, target of a follow at the end of this step, world end of a rod
  Vec3 previous = zero3();       ///< [m] `place` one step ago
  Vec3 before = zero3();         ///< [m] `place` two steps ago, once `moves` is 2 or more
  Vec3 velocity = zero3();       ///< [m/s] of `place` at the end of this step
  double length = 0.0;           ///< [m] of a rod, > 0
  double excess = 0.0;           ///< [m] of a rod: length still to be drawn in
  double excess_rate = 0.0;      ///< [m/s]
  double previous_excess = 0.0;  ///< [m] `excess` one step ago
  double max_force = std::numeric_limits<double>::infinity();  ///< [N] of a follow, > 0
  double time_constant = 0.0;          ///< [s] how fast a deviation is drawn in, or a limited follow answers; > 0
  Vec3 away = zero3();                 ///< [m] deviation still to be drawn in (nail; follow without max_force)
  Vec3 away_rate = zero3();            ///< [m/s]
  Vec3 previous_away = zero3();        ///< [m] `away` one step ago
  std::function<Vec3(double)> target;  ///< of a follow: place at time t [s]; empty where `place` is set by hand
  std::int32_t hand = -1;              ///< of a hand's grab: index of the hand
  std::uint32_t moves = 0;             ///< samples of the target since it last jumped
  bool enabled = true;
  Vec3 force = zero3();  ///< [N] on a in the last step; of a rod along it
  double tension = 0.0;  ///< [N] of a rod in the last step, > 0 when it pulls
  std::string name;
  std::uint64_t serial = 0;
};

using ConstraintId = Handle<Constraint>;

}  // namespace pantin
