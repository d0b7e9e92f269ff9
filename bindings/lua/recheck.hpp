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
  int traced_again = 0;
};

/// Remembers a law that was put to work, if it was traced from a function.
void watch_law(Script& script, const AnyId& id, const ResolvedLaw& law);
/// After scripts may have run: a law that reads what they changed is traced again, from now on; one for which they do so all
/// the time is called from then on, with a warning. The same for a law that disagrees with its function, in a step whose time
/// for it has come.
void recheck_laws(Script& script);

}  // namespace pantin::lua
