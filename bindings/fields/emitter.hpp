#pragma once
#include <cstdint>

namespace pantin::fields {

/// Of a whole number > 0, or infinity.
std::uint64_t most_of_number(double max);

}  // namespace pantin::fields
