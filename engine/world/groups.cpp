#include <algorithm>

#include "world/edit.hpp"
#include "world/editing.hpp"

namespace pantin {

using namespace editing;

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
  const bool there = inner ? world.groups.alive(std::get<GroupId>(thing)) : alive(world, thing);
  require(there, who, ": what is added must be alive: ", describe(world, thing));
  require(!inner || !holds(world, std::get<GroupId>(thing), group), who, ": a group cannot hold itself");
  Group& row = world.groups[group];
  if (row.known.insert(thing).second) row.members.push_back(std::move(thing));
}

void remove_from_group(World& world, GroupId group, AnyId thing) {
  require_unlocked(world, "group");
  Group& row = world.groups[group];
  require(row.known.erase(thing) == 1, describe(world, group), ": ", describe(world, thing), " is not in it");
  std::erase(row.members, thing);
}

}  // namespace pantin
