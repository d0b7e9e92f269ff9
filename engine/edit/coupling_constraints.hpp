#pragma once
// Couplings between two steps: values of two things in a fixed proportion. Every function checks its input and throws
// Error, leaving the world as it was.
#include <functional>
#include <limits>
#include <optional>

#include "edit/constrain.hpp"

namespace pantin {

/// A proportion, and what it is at time t [s] where it changes.
struct Ratio {
  double value = 1.0;  ///< not 0
  std::function<double(double)> function;
};

struct GearDef {
  Vec3 axis_a = zero3();       ///< world axes, of any length but 0; stays fixed in a and in the carrier
  std::optional<Vec3> axis_b;  ///< of b; not given: a's
  BodyId carrier;              ///< against which both turn; null: the world
  Ratio ratio;                 ///< turns of a per turn of b, in the sense of their axes
};
/// a turns `ratio` times as far as b. It keeps neither on its axis: hinges do.
ConstraintId add_gear(World& world, BodyId a, BodyId b, const GearDef& def);

struct RackDef {
  Vec3 axis = zero3();  ///< the wheel's, world axes, of any length but 0
  Vec3 along =
      zero3();     ///< in which the rack moves when the wheel turns about the axis, world axes, any length but 0; fixed
                   ///< in the carrier
  BodyId carrier;  ///< against which the wheel turns and the rack moves; null: the world
  Ratio radius;    ///< [m]
};
/// A point moves along a direction by `radius` per radian of a wheel, both against the carrier.
ConstraintId add_rack(World& world, BodyId wheel, PointId rack, const RackDef& def);

struct PulleyDef {
  Ratio ratio;                                 ///< by how much the second side counts
  std::optional<double> length;                ///< [m] > 0; not given: the present one
  double time_constant = usual_time_constant;  ///< [s] > 0, in which a rope that is too short attracts what it ties
};
/// A rope from a point over an anchor to another anchor and a point: distance a + ratio · distance b is at most its length.
/// An anchor is a point or a position.
ConstraintId add_pulley(World& world, PointId a, const Passage& over_a, PointId b, const Passage& over_b,
                        const PulleyDef& def = {});

/// Of a pulley [m] > 0; one that is too short attracts what it ties.
void set_rope_length(World& world, ConstraintId pulley, double length);

struct ScrewDef {
  Vec3 axis = zero3();  ///< world axes, of any length but 0; stays fixed in both bodies
  Ratio lead;           ///< [m] by which the first point goes along the axis for a turn of its body about it
};
/// A point moves along an axis through another's body by the lead for each turn of its own body against that one: how far it
/// is along the axis counts, on both sides. Both must be of bodies; something else keeps them on the axis.
ConstraintId add_screw(World& world, PointId a, PointId b, const ScrewDef& def);

struct SliderDef {
  Vec3 axis = zero3();                     ///< world axes, of any length but 0; stays fixed in the carrier
  BodyId carrier;                          ///< null: the world
  bool turns = false;                      ///< the point's body may turn against the carrier
  std::optional<double> length;            ///< [m] along the axis from here; not given: it slides
  std::function<double(double)> function;  ///< of time [s], where that changes
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();  ///< [m]
  double time_constant = usual_time_constant;  ///< [s] > 0, in which it comes to where it is to be
};
/// A point stays on the line through it along an axis, which goes with the carrier.
ConstraintId add_slider(World& world, PointId point, const SliderDef& def);

/// Of a slider that keeps no length [m].
void set_ends(World& world, ConstraintId slider, double min, double max);

}  // namespace pantin
