// From the model's rows to what the hot loops read.
#include "world/forces_parts.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "articulates/articulate.hpp"
#include "world/editing.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t none = Forces::none;

/// Finds what becomes a site, and where its state comes from.
struct Builder {
  const World& world;
  Forces& forces;
  std::vector<char> wanted = {};  // (slots of particles) 1: by solved connections only, 2: by other laws too
  std::vector<Vec3> places = {};  // of sites that are places of the world
  std::vector<std::uint32_t> mover_of_body = {}, mover_of_point = {};

  void want(ParticleId id, char how = 2) {
    char& mark = wanted[awake(world, id).slot - 1];
    mark = std::max(mark, how);
  }
  void want(const AnyId& thing) {
    for (ParticleId p : particles_of(world, thing)) want(p);
  }

  void want_all() {
    wanted.assign(world.particles.slots(), 0);
    std::vector<char>& family = forces.families;
    family.assign(world.families.slots(), 0);
    for (InteractionId id : world.interactions.ids()) {
      const Interaction& row = world.interactions[id];
      if (!row.enabled) continue;
      family[row.a.slot - 1] = family[row.b.slot - 1] = 1;
    }
    for (FieldId id : world.fields.ids()) {
      const Field& row = world.fields[id];
      if (!row.enabled) continue;
      if (row.family) family[row.family.slot - 1] = 1;
      if (row.group && world.groups.alive(row.group)) want(AnyId(row.group));
      forces.everybody = forces.everybody || (!row.family && !row.group);
    }
    for (std::uint32_t s = 0; s < world.particles.slots(); s++) {
      const Particle& p = world.particles.at_slot(s);
      if (!world.particles.alive_at(s) || p.asleep_in) continue;
      if (acts_on_all(forces, p.family)) wanted[s] = 2;
    }
    for (ConnectionId id : world.connections.ids()) {
      const Connection& row = world.connections[id];
      for (std::uint32_t i = 0; row.enabled && i < row.count; i++)
        if (row.particles[i]) want(row.particles[i], row.solve == Solve::explicitly ? 2 : 1);
    }
  }

  std::vector<std::uint32_t> slots_by_serial() const {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t s = 0; s < wanted.size(); s++)
      if (wanted[s]) slots.push_back(s);
    std::sort(slots.begin(), slots.end(), [&](std::uint32_t i, std::uint32_t j) {
      return world.particles.at_slot(i).serial < world.particles.at_slot(j).serial;
    });
    return slots;
  }

  std::uint32_t mover(std::vector<std::uint32_t>& known, std::uint32_t slot, bool is_body, std::int32_t articulate) {
    if (known.size() <= slot) known.resize(slot + 1, none);
    if (known[slot] == none) {
      known[slot] = static_cast<std::uint32_t>(forces.movers.size());
      Mover m;
      m.slot = slot;
      m.is_body = is_body;
      m.articulate = articulate;
      if (articulate >= 0)
        m.node = static_cast<std::uint32_t>(is_body ? world.motion[slot].node : world.points.at_slot(slot).node);
      forces.movers.push_back(m);
    }
    return known[slot];
  }

  /// The state of a site is that of a loose point, or of the mover of its star's point.
  void place(std::uint32_t site, std::uint32_t slot) {
    const ParticleId id = world.particles.id_at(slot);
    const PointId centre = star(world, id);
    const Point& p = world.points[centre];
    if (!p.body && p.articulate < 0) {
      forces.point[site] = centre.slot - 1;
      forces.inverse_mass[site] = 1.0 / p.mass;
      return;
    }
    Attached a;
    a.site = site;
    a.arm = arm(world, centre);
    a.mover = p.body ? mover(mover_of_body, p.body.slot - 1, true, world.motion_of(p.body).articulate)
                     : mover(mover_of_point, centre.slot - 1, false, p.articulate);
    forces.movers[a.mover].pulled = forces.movers[a.mover].pulled || wanted[slot] == 2;
    forces.attached.push_back(a);
    const Particle& ring = world.particles.at_slot(slot);
    if (!ring.is_hinge() && p.body) forces.sites.kin[site] = p.body.slot;
  }

  void add_sites() {
    const std::vector<std::uint32_t> slots = slots_by_serial();
    Sites& sites = forces.sites;
    sites.resize(slots.size() + places.size());
    sites.clear_forces();
    std::fill(sites.kin.begin(), sites.kin.end(), 0u);
    std::fill(sites.family.begin(), sites.family.end(), none);
    forces.point.assign(sites.n, none);
    forces.inverse_mass.assign(sites.n, 0.0);
    forces.image.assign(sites.n, zero3());
    forces.site_of.assign(world.particles.slots(), none);
    for (std::uint32_t i = 0; i < slots.size(); i++) {
      const Particle& p = world.particles.at_slot(slots[i]);
      sites.particle[i] = slots[i];
      sites.serial[i] = p.serial;
      if (p.family) sites.family[i] = p.family.slot - 1;
      forces.site_of[slots[i]] = i;
      place(i, slots[i]);
    }
    for (std::size_t k = 0; k < places.size(); k++) {
      const std::size_t i = slots.size() + k;
      sites.x[i] = places[k];
      sites.v[i] = zero3();
      sites.particle[i] = none;
      sites.serial[i] = 0;
    }
  }

  /// Hinges never interact with what shares a body with them.
  void exclude_relatives() {
    Sites& sites = forces.sites;
    std::vector<std::vector<std::uint32_t>> of_body(world.bodies.slots());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<std::uint32_t> hinges;
    for (std::uint32_t i = 0; i < sites.n; i++) {
      if (sites.particle[i] == none) continue;
      const Particle& ring = world.particles.at_slot(sites.particle[i]);
      if (ring.is_hinge()) hinges.push_back(i);
      for (PointId p : ring.points)
        if (const BodyId body = world.points[p].body) of_body[body.slot - 1].push_back(i);
    }
    for (std::uint32_t hinge : hinges)
      for (PointId p : world.particles.at_slot(sites.particle[hinge]).points)
        if (const BodyId body = world.points[p].body)
          for (std::uint32_t other : of_body[body.slot - 1])
            if (other != hinge) pairs.insert(pairs.end(), {{hinge, other}, {other, hinge}});
    sites.excluded = exclusions(sites.n, std::move(pairs));
  }
};

/// Laws at work with what they act on, before there are sites.
struct Active {
  std::vector<InteractionId> interactions;
  std::vector<FieldId> fields;
  struct Batch {
    std::shared_ptr<const Law> law;
    bool solved;
    std::vector<ConnectionId> ids;
  };
  std::vector<Batch> connections;  // in the order of their first connection

  explicit Active(const World& world) {
    for (InteractionId id : world.interactions.ids())
      if (world.interactions[id].enabled) interactions.push_back(id);
    for (FieldId id : world.fields.ids())
      if (world.fields[id].enabled) fields.push_back(id);
    std::unordered_map<const Law*, std::size_t> places[2];  // only looked up: their order reaches nothing
    for (ConnectionId id : world.connections.ids()) {
      const Connection& row = world.connections[id];
      if (!row.enabled) continue;
      const bool solved = row.solve != Solve::explicitly;
      for (auto law = row.law; law; law = law->also) {
        const auto [found, is_new] = places[solved].try_emplace(law.get(), connections.size());
        if (is_new) connections.push_back({law, solved, {}});
        connections[found->second].ids.push_back(id);
      }
    }
  }

  bool none_at_all() const { return interactions.empty() && fields.empty() && connections.empty(); }

  template <class Use>
  void each_law(const World& world, Use&& use) const {
    for (InteractionId id : interactions)
      for (auto law = world.interactions[id].law; law; law = law->also) use(*law);
    for (FieldId id : fields)
      for (auto law = world.fields[id].law; law; law = law->also) use(*law);
    for (const Batch& batch : connections) use(*batch.law);
  }
};

/// The law with its energy alone.
std::shared_ptr<const Law> energy_alone(const Law& law) {
  auto told = std::make_shared<Law>(law);
  told->force = {told->graph.constant(0.0)};
  told->also = nullptr;
  return told;
}

void add_connections(const World& world, Forces& forces, const Active::Batch& batch,
                     std::span<const std::uint32_t> place_sites, std::size_t& next_place) {
  const auto law = batch.solved ? energy_alone(*batch.law) : batch.law;
  ActingConnections acting{batch.law, batch.solved, {}, {}, {}, Bonds(law, forces.sites.names, *world.workers)};
  acting.ties.count = static_cast<int>(world.connections[batch.ids[0]].count);
  acting.ties.parameters.resize(batch.law->parameters.size());
  for (ConnectionId id : batch.ids) {
    const Connection& row = world.connections[id];
    std::uint32_t ends[4];
    bool apart = true;
    for (std::uint32_t i = 0; i < row.count; i++) {
      ends[i] = row.particles[i] ? forces.site_of[awake(world, row.particles[i]).slot - 1] : place_sites[next_place++];
      for (std::uint32_t j = 0; j < i; j++) apart = apart && ends[i] != ends[j];
    }
    if (!apart) continue;  // a hinge has joined its ends
    acting.ids.push_back(id);
    acting.serials.push_back(row.serial);
    acting.ties.sites.insert(acting.ties.sites.end(), ends, ends + row.count);
    for (std::size_t k = 0; k < row.parameters.size(); k++) acting.ties.parameters[k].push_back(row.parameters[k]);
  }
  forces.connections.push_back(std::move(acting));
}

}  // namespace

std::vector<ParticleId> particles_of(const World& world, const AnyId& thing) {
  std::vector<ParticleId> list;
  const auto visit = [&](const auto& self, const AnyId& id) -> void {
    if (!alive(world, id)) return;
    if (const auto* particle = std::get_if<ParticleId>(&id)) list.push_back(*particle);
    if (const auto* point = std::get_if<PointId>(&id)) list.push_back(world.points[*point].own);
    if (const auto* body = std::get_if<BodyId>(&id))
      for (PointId p : world.bodies[*body].points) list.push_back(world.points[p].own);
    if (const auto* group = std::get_if<GroupId>(&id))
      for (const AnyId& member : world.groups[*group].members) self(self, member);
  };
  visit(visit, thing);
  return list;
}

std::unique_ptr<Forces> build_forces(const World& world) {
  const Active acting(world);
  if (acting.none_at_all()) return nullptr;
  auto forces = std::make_unique<Forces>();
  Builder builder{world, *forces};
  builder.want_all();
  for (const Active::Batch& batch : acting.connections)
    for (ConnectionId id : batch.ids) {
      const Connection& row = world.connections[id];
      for (std::size_t i = 0; i < row.places.size(); i++)
        if (!row.particles[i]) builder.places.push_back(row.places[i]);
    }
  acting.each_law(world, [&](const Law& law) {
    for (const Input& input : inputs_of(law))
      if (input.role == Role::attribute) forces->sites.names.push_back(input.name);
    forces->moving = forces->moving || law.moving;
    forces->open = forces->open || !law.has_energy();
    forces->open_still = forces->open_still || !(law.has_energy() || law.moving);
  });
  std::vector<std::string>& names = forces->sites.names;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  builder.add_sites();
  builder.exclude_relatives();
  std::vector<std::uint32_t> all(forces->sites.n);
  std::iota(all.begin(), all.end(), 0u);
  fill_attributes(world, *forces, all);

  std::vector<std::uint32_t> place_sites(builder.places.size());
  std::iota(place_sites.begin(), place_sites.end(),
            static_cast<std::uint32_t>(forces->sites.n - builder.places.size()));
  std::size_t next_place = 0;
  for (const Active::Batch& batch : acting.connections) add_connections(world, *forces, batch, place_sites, next_place);
  for (InteractionId id : acting.interactions)
    for (auto law = world.interactions[id].law; law; law = law->also)
      forces->interactions.push_back(
          {id, law, Pairs(law, names, *world.workers), Rows{}, bonded(*forces, law->exclude)});
  for (FieldId id : acting.fields)
    for (auto law = world.fields[id].law; law; law = law->also)
      forces->fields.push_back({id, law, Fields(law, names, *world.workers)});
  check_attributes(world, *forces, all);
  return forces;
}

}  // namespace pantin
