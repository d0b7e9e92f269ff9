#include "world/bonding.hpp"

#include <algorithm>

#include "laws/library.hpp"
#include "world/assemble.hpp"
#include "world/editing.hpp"
#include "world/measure.hpp"
#include "world/query.hpp"

namespace pantin {

using namespace editing;

namespace {

constexpr double never = 1e300;  // [s]

std::vector<ParticleId> particles_of(const World& world, const BondingDef& def) {
  std::vector<ParticleId> list;
  for (FamilyId family : def.families)
    for (ParticleId id : particles(world, family)) list.push_back(id);
  return list;
}

Things things_of(const World& world, const std::vector<ParticleId>& list) {
  Things things;
  for (ParticleId id : list)
    for (PointId p : world.particles[id].points)
      if (const BodyId body = world.points[p].body)
        things.bodies.push_back(body);
      else
        things.free_points.push_back(p);
  std::sort(things.bodies.begin(), things.bodies.end());
  things.bodies.erase(std::unique(things.bodies.begin(), things.bodies.end()), things.bodies.end());
  return things;
}

bool is_bond(const World& world, const BondingDef& def, ParticleId a, ParticleId b) {
  const FamilyId first = def.families.front(), second = def.families.back();
  const FamilyId of_a = world.particles[awake(world, a)].family, of_b = world.particles[awake(world, b)].family;
  return (of_a == first && of_b == second) || (of_a == second && of_b == first);
}

void melt(World& world, const BondingDef& def, const std::vector<ParticleId>& list) {
  for (ConnectionId id : connections_among(world, list)) {
    const Connection& c = world.connections[id];
    if (c.count == 2 && is_bond(world, def, c.particles[0], c.particles[1])) remove(world, id);
  }
  for (ParticleId id : list)
    if (world.particles.alive(id) && world.particles[id].is_hinge()) cut(world, id);
}

void solidify(World& world, const BondingDef& def, const std::vector<ParticleId>& list) {
  for (const auto& [a, b] : pairs_within(world, list, def.near)) {
    if (!is_bond(world, def, a, b)) continue;
    ConnectionDef bond;
    bond.ends = {{a, zero3()}, {b, zero3()}};
    bond.parameters = def.parameters;
    const Vec3 places[] = {position(world, a), position(world, b)};
    for (std::size_t k = 0; k < bond.parameters.size(); k++)
      if (def.law->parameters[k].present) bond.parameters[k] = present_value(places);
    add_connection(world, def.law, bond);
  }
}

void act(World& world, const BondingDef& def) {
  const std::vector<ParticleId> list = particles_of(world, def);
  if (list.size() < 2) return;
  const double now = temperature(world, things_of(world, list));
  if (now > def.above) melt(world, def, list);
  if (now < def.below) solidify(world, def, list);
}

}  // namespace

EventId add_bonding(World& world, BondingDef def) {
  require(def.families.size() == 1 || def.families.size() == 2, "bonding: it is of one family or two, got ",
          def.families.size());
  for (FamilyId family : def.families) require(world.families.alive(family), "bonding: ", world.families.story(family));
  require_positive("bonding", "near", def.near, "m");
  require_not_negative("bonding", "below", def.below, "K");
  require(def.above >= def.below, "bonding: above must not be less than below, got ", def.above, " and ", def.below,
          " K");
  require(def.law && (def.law->kind == LawKind::central || def.law->kind == LawKind::pair),
          "bonding: it needs a pair law");
  Event event;
  event.kind = EventKind::over;
  event.time = world.time;
  event.until = never;
  event.label = def.label;
  event.progress = [&world, def = std::move(def)](double) {
    for (FamilyId family : def.families)
      if (!world.families.alive(family)) return;
    act(world, def);
  };
  return add_event(world, std::move(event));
}

}  // namespace pantin
