#include "choreography/bonding.hpp"

#include <algorithm>
#include <unordered_set>

#include "base/stable.hpp"
#include "choreography/choreography.hpp"
#include "edit/assemble.hpp"
#include "edit/common.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"

namespace pantin {

using namespace internal;

namespace {

constexpr double never = 1e300;  // [s]

std::vector<ParticleId> particles_of(const World& world, const BondingDef& def) {
  std::vector<ParticleId> list;
  for (FamilyId family : def.families)
    for (ParticleId id : particles(world, family)) list.push_back(id);
  return list;
}

bool is_bond(const BondingDef& def, FamilyId a, FamilyId b) {
  const FamilyId first = def.families.front(), second = def.families.back();
  return (a == first && b == second) || (a == second && b == first);
}

bool is_bond(const World& world, const BondingDef& def, ParticleId a, ParticleId b) {
  return is_bond(def, world.particles[awake(world, a)].family, world.particles[awake(world, b)].family);
}

/// The family that a point's particle has, or had before it became a hinge's.
FamilyId own_family(const World& world, PointId point) { return world.particles[world.points[point].own].family; }

/// Between two families only what has points of both is one of their hinges.
bool is_their_hinge(const World& world, const BondingDef& def, ParticleId id) {
  if (!world.particles[id].is_hinge()) return false;
  if (def.families.size() == 1) return true;
  const auto& points = world.particles[id].points;
  return std::all_of(def.families.begin(), def.families.end(), [&](FamilyId family) {
    return std::any_of(points.begin(), points.end(), [&](PointId p) { return own_family(world, p) == family; });
  });
}

/// Cut points are of their own families again, where these are the bonding's, so that they can be joined again.
void cut_apart(World& world, const BondingDef& def, ParticleId hinge) {
  std::vector<std::pair<ParticleId, FamilyId>> parts;
  for (PointId p : world.particles[hinge].points) parts.push_back({world.points[p].own, own_family(world, p)});
  cut(world, hinge);
  for (const auto& [part, family] : parts)
    if (std::find(def.families.begin(), def.families.end(), family) != def.families.end())
      set_family(world, part, family);
}

/// Constraints that tie points of a particle to those of others.
std::vector<ConstraintId> ties_of(const World& world, ParticleId id) {
  std::vector<ConstraintId> ties;
  for (PointId p : world.particles[id].points)
    for (ConstraintId c : world.points[p].constraints)
      if (world.constraints[c].b || world.constraints[c].passages().size() > 1 ||
          !world.constraints[c].coupled().empty())
        ties.push_back(c);
  return ties;
}

void end_joins(World& world, const BondingDef& def, ParticleId id) {
  for (ConstraintId tie : ties_of(world, id)) {
    const Constraint& c = world.constraints[tie];
    if (c.progress() && is_bond(world, def, world.points[c.a].particle, world.points[c.b].particle)) remove(world, tie);
  }
}

void melt(World& world, const BondingDef& def, const std::vector<ParticleId>& list) {
  for (ConnectionId id : connections_among(world, list)) {
    const Connection& c = world.connections[id];
    if (c.count == 2 && is_bond(world, def, c.particles[0], c.particles[1])) remove(world, id);
  }
  for (ParticleId id : list) end_joins(world, def, id);
  for (ParticleId id : list)
    if (world.particles.alive(id) && is_their_hinge(world, def, id)) cut_apart(world, def, id);
}

void connect(World& world, const BondingDef& def, ParticleId a, ParticleId b) {
  ConnectionDef bond;
  bond.ends = {{a, zero3()}, {b, zero3()}};
  bond.parameters = def.parameters;
  bond.solve = def.solve;
  for (std::size_t k = 0; k < bond.parameters.size(); k++)
    if (def.law->parameters[k].present) bond.parameters[k] = present_value(world, bond.ends);
  const ConnectionId id = add_connection(world, def.law, bond);
  if (def.on_connection) def.on_connection(id);
}

/// Draws pairs together, the nearest first; what is being joined already, or held by something else, waits.
void join_pairs(World& world, const BondingDef& def, std::vector<std::array<ParticleId, 2>> pairs) {
  const auto distance = [&](const auto& pair) { return norm(position(world, pair[0]) - position(world, pair[1])); };
  sort_stably(pairs.begin(), pairs.end(),
              [&](const auto& one, const auto& other) { return distance(one) < distance(other); });
  std::unordered_set<ParticleId> joining;
  const auto is_free = [&](ParticleId id) { return !joining.contains(id) && ties_of(world, id).empty(); };
  for (const auto& [a, b] : pairs) {
    if (!is_free(a) || !is_free(b) || (holder(world, a) && holder(world, b))) continue;
    JoinDef def_of_join;
    def_of_join.time_constant = def.time_constant;
    add_join(world, world.particles[a].points[0], world.particles[b].points[0], def_of_join);
    joining.insert({a, b});
  }
}

void solidify(World& world, const BondingDef& def, const std::vector<ParticleId>& list) {
  std::vector<std::array<ParticleId, 2>> pairs = pairs_within(world, list, def.near);
  std::erase_if(pairs, [&](const auto& pair) { return !is_bond(world, def, pair[0], pair[1]); });
  if (!def.law) return join_pairs(world, def, std::move(pairs));
  for (const auto& [a, b] : pairs) connect(world, def, a, b);
}

void act(World& world, const BondingDef& def) {
  const std::vector<ParticleId> list = particles_of(world, def);
  if (list.empty()) return;
  const double now = temperature(world, things_of(world, list));
  if (now > def.above) melt(world, def, list);
  if (now < def.below) solidify(world, def, list);
}

}  // namespace

void BondingAtWork::operator()(double) const {
  for (FamilyId family : def.families)
    if (!world->families.alive(family)) return;
  act(*world, def);
}

EventId add_bonding(World& world, BondingDef def) {
  require(def.families.size() == 1 || def.families.size() == 2, "bonding: it is of one family or two, got ",
          def.families.size());
  for (FamilyId family : def.families) require(world.families.alive(family), "bonding: ", world.families.story(family));
  require_positive("bonding", "near", def.near, "m");
  require_not_negative("bonding", "below", def.below, "K");
  require(def.above >= def.below, "bonding: above must not be less than below, got ", def.above, " and ", def.below,
          " K");
  require(!def.law || def.law->kind == LawKind::central || def.law->kind == LawKind::pair,
          "bonding: it needs a pair law");
  require_positive("bonding", "time_constant", def.time_constant, "s");
  Event event;
  event.kind = EventKind::over;
  event.time = world.time;
  event.until = never;
  event.label = def.label;
  event.progress = BondingAtWork{&world, std::move(def)};
  return add_event(world, std::move(event));
}

}  // namespace pantin
