#pragma once
#include <cstdint>

namespace pantin {

/// Counter-based random numbers: the nth number of a seed is a function of (seed, n) alone, so a copy of the struct
/// repeats the sequence. Mixing function: splitmix64 (Steele, Lea and Flood 2014).
struct Random {
  std::uint64_t seed = 1;
  std::uint64_t count = 0;

  std::uint64_t bits() {
    std::uint64_t z = seed * 0xd1342543de82ef95u + ++count * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
};

}  // namespace pantin
