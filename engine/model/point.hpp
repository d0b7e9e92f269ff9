#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/color.hpp"
#include "base/handle.hpp"
#include "base/lanes.hpp"

namespace pantin {

struct Body;
struct Constraint;
struct Particle;

/// A point mass with local data. It belongs to at most one body, and always to one particle.
struct Point {
  Vec3 position = zero3();                      ///< [m] in the body's frame; unused when free
  Vec3 force = zero3();                         ///< [N] pushes on a free point in this step
  double mass = 0.0;                            ///< [kg] 0: an anchor (of a body only)
  Handle<Body> body;                            ///< null when free
  Handle<Particle> own;                         ///< the particle made with it, of this one point
  Handle<Particle> particle;                    ///< the ring it is in now: `own`, or a hinge
  std::vector<Handle<Constraint>> constraints;  ///< that hold this point, in the order of making
  Vec3 row_force = zero3();                     ///< [N] of its ring on this point in the last step
  std::int32_t articulate = -1;                 ///< of a free point: index of its articulate, or -1
  std::int32_t node = -1;                       ///< of a free point: its index in there
  Color color;
  double radius = 0.0;  ///< [m] drawn size
  std::string name;     ///< of a body's named point
  std::uint64_t serial = 0;
};

/// What a step reads and writes of a free point; at the same slot as its Point.
struct FreeMotion {
  Vec3 x = zero3();  ///< [m]
  Vec3 v = zero3();  ///< [m/s]
};

using PointId = Handle<Point>;

}  // namespace pantin
