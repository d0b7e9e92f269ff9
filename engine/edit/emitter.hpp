#pragma once
// Emitters: made and changed between two steps, and what they make in one. See edit.hpp for the manner.
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/edit.hpp"

namespace pantin {

/// Where particles begin: at a position, in a box, or on a point.
struct EmitterPosition {
  PointId point;           ///< null: the rest is a position of the world
  Vec3 at = zero3();       ///< [m] a position, or one corner of a box; relative to the point, if there is one
  std::optional<Vec3> to;  ///< [m] the opposite corner
};

struct EmitterDef {
  EmitterPosition position;
  double rate = 0.0;                                              ///< [1/s] >= 0
  std::function<double(double)> rate_at;                          ///< rate at time t [s], instead
  Vec3 velocity = zero3();                                        ///< [m/s] relative to the point
  double spread = 0.0;                                            ///< [rad] half angle of a cone, 0 … π
  double shortest = std::numeric_limits<double>::infinity();      ///< [s] > 0: lifetimes are uniform from this
  double longest = std::numeric_limits<double>::infinity();       ///< [s] to this
  std::uint64_t max = std::numeric_limits<std::uint64_t>::max();  ///< alive at once, > 0
  FamilyId family;                                                ///< null: of none
  std::vector<AttributeDef> attributes;                           ///< of its family's
  std::optional<double> mass;                                     ///< [kg] as of a particle, like the next ones
  std::optional<double> radius;                                   ///< [m]
  std::optional<Color> color;
  std::optional<Look> look;
  std::shared_ptr<const Curves> curves;  ///< besides its family's
  bool enabled = true;
  std::string name;
};

EmitterId add_emitter(World& world, const EmitterDef& def);
void set_position(World& world, EmitterId emitter, const EmitterPosition& position);
void set_rate(World& world, EmitterId emitter, double rate);                           ///< [1/s] >= 0
void set_rate(World& world, EmitterId emitter, std::function<double(double)> rate);    ///< of time [s]
void set_velocity(World& world, EmitterId emitter, Vec3 velocity);                     ///< [m/s]
void set_spread(World& world, EmitterId emitter, double spread);                       ///< [rad]
void set_lifetimes(World& world, EmitterId emitter, double shortest, double longest);  ///< [s]
void set_max(World& world, EmitterId emitter, std::uint64_t max);
void set_enabled(World& world, EmitterId emitter, bool enabled);

/// Makes what is due in the coming step. Each particle gets the position and velocity at the start of the step from which
/// free fall takes it to its emitter at the moment of its birth. Only for the phase age_particles.
void emit(World& world);

}  // namespace pantin
