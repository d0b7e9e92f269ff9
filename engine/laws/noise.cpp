#include "laws/noise.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/functions.hpp"
#include "base/random.hpp"

namespace pantin {

double normal(std::uint64_t seed, std::uint64_t instant, std::uint64_t first_serial, std::uint64_t second_serial,
              std::uint32_t index) {
  const std::uint64_t lower = std::min(first_serial, second_serial), higher = std::max(first_serial, second_serial);
  std::uint64_t key = seed;
  for (std::uint64_t part : {instant, lower, higher}) key = Random{key, part}.bits();
  Random random{key, 2 * std::uint64_t{index}};
  const double u = 1.0 - random.uniform(), turn = random.uniform();
  constexpr double two_pi = 6.283185307179586;
  return std::sqrt(-2.0 * functions::log(u)) * functions::cos(two_pi * turn);
}

}  // namespace pantin
