#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/color.hpp"
#include "view/views.hpp"
#include "world/world.hpp"

namespace pantin {

/// Colours that stand for something, by the views that colour things.
class Tints {
 public:
  /// `size` [m] of the scene, to which gaps are compared.
  void update(const World& world, const Views& views, double size);
  bool none() const { return !on_; }
  /// None: as it looks otherwise.
  std::optional<Color> of_body(std::uint32_t slot) const { return read(bodies_, slot); }
  std::optional<Color> of_particle(std::uint32_t slot) const { return read(particles_, slot); }
  /// The scale that the colours belong to, in words; empty where there is none.
  const std::string& legend() const { return legend_; }

 private:
  static std::optional<Color> read(const std::vector<Color>& list, std::uint32_t slot);
  void by_family(const World& world);
  void by_articulate(const World& world);
  void by_temperature(const World& world);
  void by_error(const World& world, double size);

  bool on_ = false;
  std::vector<Color> bodies_, particles_;  // (slots); opacity 0: none
  std::string legend_;
};

}  // namespace pantin
