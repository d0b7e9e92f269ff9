#pragma once
#include <memory>

#include "laws/law.hpp"

namespace pantin {

/// The law as connections take it: without force and energy beyond the cutoff that it was given. A cutoff that comes of its
/// other parameters is left, which each connection may have of its own: such laws are 0 there, or nearly.
std::shared_ptr<const Law> within_cutoff(const std::shared_ptr<const Law>& law);

}  // namespace pantin
