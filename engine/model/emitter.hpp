#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/color.hpp"
#include "model/family.hpp"
#include "model/point.hpp"

namespace pantin {

struct Curves;

/// Makes particles at a rate. The k-th since `origin` is due at origin + (k - phase) / rate, however long ago that was.
struct Emitter {
  PointId point;            ///< it sits on; null: it stays where it is
  Vec3 lower = zero3();     ///< [m] box in which particles begin; relative to the point, if there is one
  Vec3 upper = zero3();     ///< [m] >= lower
  Vec3 velocity = zero3();  ///< [m/s] relative to the point's
  double spread = 0.0;      ///< [rad] half angle of the cone of velocities, uniform in solid angle; 0 … π
  double rate = 0.0;        ///< [1/s] >= 0; of the last step where `rate_at` gives it
  std::function<double(double)> rate_at;                      ///< rate at time t [s]; empty: constant
  double shortest = std::numeric_limits<double>::infinity();  ///< [s] lifetimes are uniform from this
  double longest = std::numeric_limits<double>::infinity();   ///< [s] to this
  std::uint64_t max =
      std::numeric_limits<std::uint64_t>::max();  ///< alive at once; what is due beyond that is not made
  FamilyId family;
  std::vector<double> values;  ///< (attributes of the family)
  double mass = 1.0;           ///< [kg]
  double radius = 0.05;        ///< [m]
  Color color;
  std::optional<Look> look;
  std::shared_ptr<const Curves> curves;  ///< of its particles, or null

  double origin = 0.0;      ///< [s] last change of the rate
  double phase = 0.0;       ///< part of a particle that was due then
  std::uint64_t since = 0;  ///< due since then
  std::uint64_t due = 0;    ///< all that were due: the n-th draws its random numbers by n
  std::uint64_t made = 0;
  std::uint64_t count = 0;  ///< of its particles that live
  bool enabled = true;
  std::string name;
  std::string rate_from;  ///< "scene.lua:12", where its rate was given, or empty
  std::uint64_t serial = 0;
};

using EmitterId = Handle<Emitter>;

}  // namespace pantin
