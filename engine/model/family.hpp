#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/color.hpp"
#include "base/handle.hpp"

namespace pantin {

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
