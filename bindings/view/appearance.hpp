#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "world/world.hpp"

namespace pantin {

/// What of the particles follows their age, now: worked out for all at once, only when they are drawn.
class Appearance {
 public:
  void update(const World& world);
  /// Of a particle by its slot; none where it does not follow the age.
  std::optional<double> radius(std::uint32_t slot) const;  ///< [m]
  std::optional<Color> color(std::uint32_t slot) const;

 private:
  std::vector<std::uint32_t> slots_;     // of particles that have curves
  std::vector<std::uint32_t> position_;  // (slots of particles) where in the columns, + 1; 0: nowhere
  std::vector<double> radii_;
  std::array<std::vector<double>, 4> channels_;
};

}  // namespace pantin
