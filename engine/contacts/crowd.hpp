#pragma once
// Too much in one place: what would ask for more memory and time than there is, is told instead.
#include <cstddef>

#include "base/bounds.hpp"

namespace pantin {

/// Throws Error where so many pairs of so many things are near each other that things must lie in one place; `at`: the bounds
/// of one of them.
void require_no_crowd(std::size_t pairs, std::size_t things, const Bounds& at);

}  // namespace pantin
