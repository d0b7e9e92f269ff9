#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/color.hpp"
#include "model/breaking.hpp"
#include "model/family.hpp"
#include "model/point.hpp"

namespace pantin {

struct Connection;
struct Emitter;

/// A ring of one or more points with global data. A ring of two or more is a hinge: its points coincide. While a point
/// is in a hinge, the particle made with the point sleeps (`asleep_in`), and answers for the hinge.
struct Particle {
  std::vector<PointId> points;                                ///< members; of a sleeping particle its one point
  Handle<Particle> asleep_in;                                 ///< the hinge its point is in now, or null
  FamilyId family;                                            ///< null: of no family
  std::vector<double> values;                                 ///< (attributes of its family)
  std::vector<Handle<Connection>> connections;                ///< that hold it, in the order of making
  double born = 0.0;                                          ///< [s]
  double lifetime = std::numeric_limits<double>::infinity();  ///< [s]; a hinge is cut at its end, others removed
  double awaited = std::numeric_limits<double>::infinity();   ///< [s] time for which it is in World::mortals
  std::optional<Color> color;                                 ///< overrides its points'
  std::optional<double> radius;                               ///< [m] overrides its points'
  std::optional<Look> look;                                   ///< overrides its family's
  std::shared_ptr<const Curves> curves;                       ///< what of it follows its age; null: nothing
  Handle<Emitter> emitter;                                    ///< that made it, or null
  bool enabled = true;                                        ///< of a hinge: whether its points stay together
  bool collide = false;                                       ///< of a hinge: whether its bodies touch each other
  Breaking breaks_at;                                         ///< of a hinge
  std::vector<Handle<Constraint>> axes;  ///< of a hinge with an axis: one from its first body to each other
  std::string name;
  std::uint64_t serial = 0;

  /// Whether it joins points, and whether it does so now.
  bool joins() const { return is_hinge() && enabled; }
  bool is_hinge() const { return points.size() > 1; }
};

using ParticleId = Handle<Particle>;

}  // namespace pantin
