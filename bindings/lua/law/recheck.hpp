#pragma once
// Traced laws are compared with their functions on what really meets, ever more rarely: after 1, 2, 4, 8 … steps.
#include <vector>

#include "lua/law/force.hpp"
#include "lua/vm/runtime.hpp"
#include "world/world.hpp"

namespace pantin::lua {

/// A traced law at work.
struct TracedAtWork {
  AnyId id;  ///< of a connection, interaction or field
  ResolvedLaw law;
  int traced_again = 0;
};

/// Those of a scene.
struct LawsAtWork {
  std::vector<TracedAtWork> traced;
  std::uint64_t runs_seen = 0;  ///< Runtime::runs when these were looked at
};

/// Remembers a law that was put to work, if it was traced from a function.
void watch_law(LawsAtWork& laws, const AnyId& id, const ResolvedLaw& law);
/// A law that reads what scripts have changed is traced again, from now on; one for which they do so all the time is called
/// from then on, with a warning.
void renew_laws(World& world, LawsAtWork& laws);
/// The same after scripts may have run; and a law that disagrees with its function is called from then
/// on, with a warning, in a step whose time for that has come.
void recheck_laws(World& world, LawsAtWork& laws, const Runtime& runtime);

}  // namespace pantin::lua
