#pragma once
#include "laws/law.hpp"

namespace pantin {

/// Whether a law, or one that acts with it, draws random numbers.
bool draws_noise(const Law& law);

}  // namespace pantin
