#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/color.hpp"
#include "base/handle.hpp"

namespace pantin {

/// How a particle is drawn: a lit ball, a soft disc of light, or a line of light along its velocity.
enum class Look : std::uint8_t { ball, glow, streak };

struct Curves;
struct Cover;

/// How particles touch: as balls of their radius that do not turn.
struct Solid {
  double friction = 0.5;     ///< >= 0: as a shape's
  double restitution = 0.0;  ///< 0 … 1
  std::uint32_t layer = 0;   ///< in Model::layers; 0: none
};

/// Particles of a kind, with named numeric attributes that laws may read.
struct Family {
  struct Attribute {
    std::string name;
    double value = 0.0;  ///< of a particle that gives none
  };
  std::vector<Attribute> attributes;  ///< sorted by name
  std::optional<Color> color;         ///< of a particle that gives none, like the next two
  std::optional<double> radius;       ///< [m]
  std::optional<double> mass;         ///< [kg]
  std::optional<Look> look;
  std::shared_ptr<const Cover> sprite;   ///< drawn instead of its free particles; null: none
  std::shared_ptr<const Curves> curves;  ///< of a particle that gives none; null: none
  std::optional<Solid> solid;            ///< none: its particles touch nothing
  std::string name;
  std::uint64_t serial = 0;

  /// Index of an attribute, or -1.
  std::ptrdiff_t find(std::string_view attribute) const {
    const auto found = std::lower_bound(attributes.begin(), attributes.end(), attribute,
                                        [](const Attribute& a, std::string_view wanted) { return a.name < wanted; });
    return found != attributes.end() && found->name == attribute ? found - attributes.begin() : -1;
  }
};

using FamilyId = Handle<Family>;

}  // namespace pantin
