#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// Whether damped rows that were solved are to settle, see constraints/stiff.cpp.
bool is_to_settle(const Articulate& articulate);
/// Has them, at the end of a full sub-step, once no velocity is left that the rows forbid, and so that none comes back.
void settle_velocities(Articulate& articulate, DriftReport& report);

}  // namespace pantin
