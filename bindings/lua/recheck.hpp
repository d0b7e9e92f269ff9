#pragma once
// Traced laws are compared with their functions on what really meets, ever more rarely: after 1, 2, 4, 8 … steps.
#include <vector>

#include "lua/force.hpp"
#include "model/group.hpp"

namespace pantin::lua {

/// A traced law at work.
struct TracedAtWork {
  AnyId id;  ///< of a connection, interaction or field
  ResolvedLaw law;
};

/// Remembers a law that was put to work, if it was traced from a function.
void watch_law(Script& script, const AnyId& id, const ResolvedLaw& law);
/// In a step whose time for it has come: a law that disagrees with its function is called from then on, with a warning.
void recheck_laws(Script& script);

}  // namespace pantin::lua
