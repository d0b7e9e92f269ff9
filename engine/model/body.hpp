#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/lanes.hpp"
#include "model/point.hpp"

namespace pantin {

struct Shape;
struct Cover;

/// What a body's points leave free: all six; five, where every point lies on one line and nothing has inertia about it
/// (its spin about the line is 0); three, where all lie at one position.
enum class Freedom : std::uint8_t { rigid, line, point };

/// Points at fixed relative positions. Mass, centre and inertia are the points', plus `own_mass` and `own_inertia` at
/// `own_position`; `update_mass` works them out whenever one changes.
struct Body {
  std::vector<PointId> points;
  std::vector<Handle<Shape>> shapes;            ///< that it touches others with, in the order of making
  std::vector<Handle<Constraint>> constraints;  ///< that tie its rotation, in the order of making
  double own_mass = 0.0;                        ///< [kg] given beside the points'
  Mat3 own_inertia = zero33();                  ///< [kg m²] about `own_position`, in the frame's axes
  Vec3 own_position = zero3();                  ///< [m] in the frame: its origin, until bodies are merged
  Vec3 centre = zero3();                        ///< [m] centre of mass in the body's frame
  Quat axes;                                    ///< principal axes to the body's frame
  Vec3 moments = zero3();                       ///< [kg m²] principal, that it moves with while nothing ties it
  Freedom freedom = Freedom::rigid;             ///< of what nothing ties
  bool bare = false;                            ///< has no inertia about an axis that points are off
  bool lift_told = false;                       ///< that it moves with more than it has
  std::shared_ptr<const Cover> sprite;          ///< drawn instead of its shapes and points; null: none
  std::string name;
  std::uint64_t serial = 0;
};

using BodyId = Handle<Body>;

/// How many sub-steps a thing takes in a step: a power of two.
struct SubSteps {
  std::uint16_t count = 1;
  std::uint16_t quiet = 0;  ///< steps since half as many would not have done
  std::uint16_t wait = 1;   ///< steps between trials: 1 after a change, doubled at each that changes nothing
  std::uint16_t left = 0;   ///< steps until the next
  float turn = 0.0F;        ///< [rad] of a body alone in a sub-step, at the last trial; 0: none
};

/// What the solver reads and writes of a body each sub-step; at the same slot as its Body.
struct Motion {
  Vec3 x = zero3();        ///< [m] centre of mass
  Vec3 p = zero3();        ///< [kg m/s] linear momentum
  Vec3 angular = zero3();  ///< [kg m²/s] angular momentum about the centre, in principal axes
  Vec3 inertia =
      zero3();        ///< [kg m²] principal moments that it moves with, see `settle_inertia`; 0 where freedom is point
  Quat q;             ///< principal axes to the world
  double mass = 0.0;  ///< [kg]
  Freedom freedom = Freedom::rigid;
  SubSteps sub_steps;            ///< where nothing constrains it
  std::int32_t articulate = -1;  ///< index of its articulate, or -1 where nothing constrains it
  std::int32_t node = -1;        ///< its index in there
  Vec3 force = zero3();          ///< [N] pushes in this step, at the centre
  Vec3 torque = zero3();         ///< [N m] pushes and twists in this step, about the centre, world axes
};

/// 1/I per principal axis; 0 where the body cannot turn.
Vec3 inverse_inertia(const Motion& m);
/// World axes, rad/s.
Vec3 angular_velocity(const Motion& m);
/// [J]
double kinetic_energy(const Motion& m);
/// Largest radius of gyration about the centre [m].
double gyration(const Motion& m);

}  // namespace pantin
