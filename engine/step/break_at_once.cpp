#include "step/break_at_once.hpp"

#include <algorithm>

#include "articulates/articulate.hpp"
#include "edit/constrain.hpp"
#include "step/phases.hpp"
#include "step/reject.hpp"
#include "step/touch.hpp"

namespace pantin {

bool may_break_at_once(const World& world) {
  return (may_touch(world) || world.pushed) &&
         std::any_of(world.articulates.begin(), world.articulates.end(),
                     [](const auto& a) { return a->breakable && !a->rest.asleep; });
}

bool breaks_at_once(World& world) {
  if (!world.start || !world.start->kept || !world.trouble.empty() || !may_break_at_once(world)) return false;
  const Overloads found = overloads_at_once(world);
  if (found.empty()) return false;
  put_start_back(world);
  break_overloaded(world, found);
  phases::find_articulates(world);
  phases::refresh_forces(world);
  keep_start(world);
  return world.failure.empty();
}

}  // namespace pantin
