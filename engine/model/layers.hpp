#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pantin {

/// How shapes of two layers touch.
struct LayerRule {
  std::uint32_t a = 0, b = 0;  ///< layers, a <= b
  bool collide = true;
  std::optional<double> friction;     ///< none: as of all others
  std::optional<double> restitution;  ///< 0 … 1
};

/// Names of layers, and how they touch where that is not as usual.
struct Layers {
  std::vector<std::string> names;  ///< (layers - 1) in the order of naming
  std::vector<LayerRule> rules;    ///< by a and b

  /// Where the rule of two layers is, or belongs.
  std::size_t index(std::uint32_t x, std::uint32_t y) const {
    const auto wanted = std::minmax(x, y);
    const auto before = [](const LayerRule& rule, const std::pair<std::uint32_t, std::uint32_t>& pair) {
      return std::pair(rule.a, rule.b) < pair;
    };
    return static_cast<std::size_t>(
        std::lower_bound(rules.begin(), rules.end(), std::pair(wanted.first, wanted.second), before) - rules.begin());
  }
  /// Null: they touch as usual.
  const LayerRule* rule(std::uint32_t x, std::uint32_t y) const {
    if (rules.empty() || x == 0 || y == 0) return nullptr;
    const std::size_t i = index(x, y);
    return i < rules.size() && rules[i].a == std::min(x, y) && rules[i].b == std::max(x, y) ? &rules[i] : nullptr;
  }
};

}  // namespace pantin
