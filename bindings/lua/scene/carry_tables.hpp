#pragma once
#include "snapshot/carry_over.hpp"

namespace pantin::lua {

struct Script;

/// Copies `scene.store` and the `data` of things from one scene to their counterparts in another: what of them is plain,
/// in place of what the other's file put there.
void carry_tables(Script& from, Script& to, const Counterparts& counterparts);

}  // namespace pantin::lua
