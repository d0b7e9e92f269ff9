#include "model/cover.hpp"

namespace pantin {

bool is_over_own_box(const Cover& cover, const Geometry& shape) {
  if (std::holds_alternative<HalfSpaceShape>(shape)) return true;
  const Bounds box = bounds_of(shape, {});
  const double round_off = 1e-12 * largest(box.high - box.low);
  return largest(cover.low - box.low) <= round_off && largest(cover.high - box.high) <= round_off;
}

}  // namespace pantin
