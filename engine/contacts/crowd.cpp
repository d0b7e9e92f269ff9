#include "contacts/crowd.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace pantin {

void require_no_crowd(std::size_t pairs, std::size_t things, const Bounds& at) {
  constexpr std::size_t always = 100'000, each = 200, most = 30'000'000;  // a heap has some 10 for each thing
  const std::size_t allowed = std::min(always + each * things, most);
  const Vec3 x = (at.low + at.high) * 0.5;
  require(pairs <= allowed, "too much touches in one place, about (", x[0], ", ", x[1], ", ", x[2], ") m: of ", things,
          " shapes and solid particles so many overlap or are within reach in a step, more than ", allowed,
          " pairs, that their contacts cannot be solved");
}

}  // namespace pantin
