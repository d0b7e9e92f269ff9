#pragma once
// What two laws of distance have in common that differ by a factor alone, as those of charges.
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "laws/law.hpp"

namespace pantin::player {

/// A law with all that it reads but the distance put in: a factor of its energy and force, and a hash of what is left.
struct LawShape {
  std::uint64_t hash = 0;
  double factor = 1.0;
};

LawShape shape_of(const Law& law, std::span<const double> parameters,
                  const std::function<double(int who, const std::string& attribute)>& attribute);

}  // namespace pantin::player
