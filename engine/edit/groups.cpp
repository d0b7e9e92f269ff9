#include <algorithm>
#include <utility>

#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "forces/forces.hpp"

namespace pantin {

using namespace internal;

namespace {

/// Whether `inner` is `outer`, or a group somewhere in it.
bool holds(const World& world, GroupId outer, GroupId inner) {
  if (outer == inner) return true;
  if (!world.groups.alive(outer)) return false;
  const auto& members = world.groups[outer].members;
  return std::any_of(members.begin(), members.end(), [&](const AnyId& a) {
    return std::holds_alternative<GroupId>(a) && holds(world, std::get<GroupId>(a), inner);
  });
}

/// Whether it may be a member: an empty group may be filled again.
bool exists(const World& world, const AnyId& thing) {
  const auto* group = std::get_if<GroupId>(&thing);
  return group ? world.groups.alive(*group) : alive(world, thing);
}

/// Drops the dead but one: a set that is left without a living member is gone, one that never had any is not.
void drop_dead(const World& world, Group& group) {
  bool kept = false;
  std::erase_if(group.members, [&](const AnyId& thing) {
    if (exists(world, thing) || !std::exchange(kept, true)) return false;
    group.known.erase(thing);
    return true;
  });
  group.sweep = std::max<std::size_t>(64, 2 * group.members.size());
}

}  // namespace

GroupId add_group(World& world, std::string name) {
  require_unlocked(world, "group");
  Group group;
  group.name = std::move(name);
  group.serial = world.next_serial++;
  return world.groups.add(std::move(group));
}

void add_to_group(World& world, GroupId group, AnyId thing) {
  require_unlocked(world, "group");
  const std::string who = describe(world, group);
  const bool inner = std::holds_alternative<GroupId>(thing);
  require(exists(world, thing), who, ": what is added must be alive: ", describe(world, thing));
  require(!inner || !holds(world, std::get<GroupId>(thing), group), who, ": a group cannot hold itself");
  Group& row = world.groups[group];
  if (world.forces && world.forces->grouped) disturb_forces(world);
  if (!row.known.insert(thing).second) return;
  row.members.push_back(thing);
  if (row.members.size() >= row.sweep) drop_dead(world, row);
}

void remove_from_group(World& world, GroupId group, AnyId thing) {
  require_unlocked(world, "group");
  Group& row = world.groups[group];
  require(exists(world, thing) && row.known.erase(thing) == 1, describe(world, group), ": ", describe(world, thing),
          " is not in it");
  if (world.forces && world.forces->grouped) disturb_forces(world);
  std::erase(row.members, thing);
}

}  // namespace pantin
