#pragma once
#include "contacts/features.hpp"

namespace pantin {

/// Keeps of a loop what lies over a face, seen along the face's normal; corners no farther out than `near` [m] are over it.
/// Over a disc: corners, where edges cross the rim, and the rim's own points that the loop is over, if it is closed: those
/// are put at its height over them. `normal` [unit length] is that of the loop's own plane, used only then.
void clip(Loop& loop, Vec3 normal, const Feature& face, double near);

}  // namespace pantin
