#pragma once
#include <cstdint>

namespace pantin {

/// A number of the normal distribution of mean 0 and variance 1 that belongs to two particles at an instant (the number
/// of the step): a function of these alone, the same for (first, second) and (second, first). A particle's own noise has
/// its serial twice. Mixing: splitmix64 (Steele, Lea and Flood 2014); Box and Muller 1958.
double normal(std::uint64_t seed, std::uint64_t instant, std::uint64_t first_serial, std::uint64_t second_serial,
              std::uint32_t index);

}  // namespace pantin
