#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/color.hpp"
#include "view/views.hpp"
#include "world/world.hpp"

namespace pantin {

/// How the colour of a thing is changed.
struct Tint {
  std::optional<Color> color;  ///< instead of its own
  bool dim = false;
  Color of(const Color& own) const;  ///< keeps the opacity
};

/// Colours that stand for something, by the views that colour things; and what sleeps, where that is shown.
class Tints {
 public:
  /// `size` [m] of the scene, to which gaps are compared.
  void update(const World& world, const Views& views, double size);
  bool none() const { return !on_; }
  Tint of_body(std::uint32_t slot) const { return {read(bodies_, slot), is_set(sleeping_bodies_, slot)}; }
  Tint of_particle(std::uint32_t slot) const { return {read(particles_, slot), is_set(sleeping_particles_, slot)}; }
  /// The scale that the colours belong to, in words; empty where there is none.
  const std::string& legend() const { return legend_; }

 private:
  static std::optional<Color> read(const std::vector<Color>& list, std::uint32_t slot);
  static bool is_set(const std::vector<char>& list, std::uint32_t slot) { return slot < list.size() && list[slot]; }
  void find_sleepers(const World& world);
  void by_family(const World& world);
  void by_articulate(const World& world);
  void by_island(const World& world);
  void by_temperature(const World& world);
  void by_error(const World& world, double size);

  bool on_ = false;
  std::vector<Color> bodies_, particles_;                   // (slots); opacity 0: none
  std::vector<char> sleeping_bodies_, sleeping_particles_;  // (slots)
  std::vector<std::uint32_t> joined_;                       // (slots of bodies) another body of its island, or itself
  std::string legend_;
};

}  // namespace pantin
