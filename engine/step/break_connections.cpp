#include <algorithm>

#include "articulates/articulate.hpp"
#include "articulates/solve/state.hpp"
#include "choreography/joins_that_met.hpp"
#include "edit/assemble.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "forces/forces.hpp"
#include "step/phases.hpp"

namespace pantin::phases {

namespace {

void break_by_load(World& world, BrokenThings& broken) {
  std::vector<std::pair<ConnectionId, double>> found;
  for (const ActingConnections& acting : world.forces->connections)
    for (ConnectionId id : acting.ids) {
      const Connection& c = world.connections[id];
      if (c.law != acting.law) continue;
      if (!std::isfinite(c.max_force) && !std::isfinite(c.max_length)) continue;
      const double force = tension(world, id), length = norm(end_of(world, c, 1) - end_of(world, c, 0));
      if (std::fabs(force) > c.max_force || length > c.max_length) found.push_back({id, force});
    }
  for (const auto& [id, force] : found) {
    broken.emplace_back(id, world.connections[id].serial);
    internal::break_connection(world, id, force);
  }
}

}  // namespace

void break_connections(World& world) {
  if (!world.trouble.empty()) return;
  const auto any = [&](auto has) { return std::any_of(world.articulates.begin(), world.articulates.end(), has); };
  const bool breakable = any([](const auto& a) { return a->breakable; });
  const bool varied = any([](const auto& a) { return !a->all_rigid; });
  if (!breakable && !varied && !world.forces) return;
  const Timed timed(world.profile, Phase::break_connections);
  const std::size_t told = world.notices.size();
  BrokenThings broken;
  if (breakable) broken = break_constraints(world);
  if (varied) make_met_hinges(world);
  if (world.forces) break_by_load(world, broken);
  if (broken.size() > 1) tell_in_order(world, told, broken);
}

}  // namespace pantin::phases
