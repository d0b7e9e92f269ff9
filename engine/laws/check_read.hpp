#pragma once
// What is read from a file may be made on purpose: before a law, a program or a spline runs, nothing in it leads out of it.
#include "laws/law.hpp"
#include "laws/program.hpp"

namespace pantin {

/// Throw Error where it contradicts itself.
void check_read(const Law& law);
void check_read(const Program& program);

}  // namespace pantin
