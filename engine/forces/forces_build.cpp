// From the model's rows to what the hot loops read.
#include "forces/forces_parts.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "laws/draws_noise.hpp"

namespace pantin {

namespace {

template <class Row>
std::vector<Handle<Row>> enabled(const Store<Row>& rows) {
  std::vector<Handle<Row>> list = rows.ids();
  std::erase_if(list, [&](Handle<Row> id) { return !rows[id].enabled; });
  return list;
}

/// The law of a force element, and what acts with it.
template <class Use>
void each_part(const ForceElement& row, Use use) {
  for (auto law = row.law; law; law = law->also) use(law);
}

/// Finds what becomes a site.
struct Builder {
  const World& world;
  Forces& forces;
  std::vector<Wanted> how = {};      // (slots of particles)
  std::vector<Vec3> positions = {};  // of sites that are positions of the world

  void find_wanted() {
    std::vector<char>& family = forces.families;
    family.assign(world.families.slots(), 0);
    for (InteractionId id : enabled(world.interactions)) {
      const Interaction& row = world.interactions[id];
      family[row.a.slot - 1] = family[row.b.slot - 1] = 1;
    }
    how.assign(world.particles.slots(), Wanted::not_at_all);
    for (FieldId id : enabled(world.fields)) {
      const Field& row = world.fields[id];
      if (row.family) family[row.family.slot - 1] = 1;
      forces.grouped = forces.grouped || row.group;
      forces.everybody = forces.everybody || (!row.family && !row.group);
      if (!row.group || !world.groups.alive(row.group)) continue;
      for (ParticleId p : particles_of(world, AnyId(row.group))) how[awake(world, p).slot - 1] = Wanted::by_others;
    }
    for (std::uint32_t s = 0; s < world.particles.slots(); s++)
      if (world.particles.alive_at(s) && !world.particles.at_slot(s).asleep_in)
        how[s] = std::max(how[s], wanted(world, forces, world.particles.id_at(s)));
  }

  std::vector<std::uint32_t> slots_by_serial() const {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t s = 0; s < how.size(); s++)
      if (how[s] != Wanted::not_at_all) slots.push_back(s);
    std::sort(slots.begin(), slots.end(), [&](std::uint32_t i, std::uint32_t j) {
      return world.particles.at_slot(i).serial < world.particles.at_slot(j).serial;
    });
    return slots;
  }

  void add_sites() {
    const std::vector<std::uint32_t> slots = slots_by_serial();
    Sites& sites = forces.sites;
    sites.resize(slots.size() + positions.size());
    sites.clear_forces();
    forces.point.assign(sites.n, Forces::none);
    forces.attached_of.assign(sites.n, Forces::none);
    forces.inverse_mass.assign(sites.n, 0.0);
    forces.image.assign(sites.n, zero3());
    forces.site_of.assign(world.particles.slots(), Forces::none);
    for (std::uint32_t i = 0; i < slots.size(); i++)
      bind_site(world, forces, i, world.particles.id_at(slots[i]), how[slots[i]]);
    for (std::size_t k = 0; k < positions.size(); k++) {
      const std::size_t i = slots.size() + k;
      sites.x[i] = positions[k];
      sites.v[i] = zero3();
      sites.particle[i] = sites.family[i] = Forces::none;
      sites.kin[i] = {};
      sites.serial[i] = 0;
    }
  }
};

/// Force elements that act, before there are sites.
struct Active {
  /// Connections of one law.
  struct Batch {
    std::shared_ptr<const Law> law;
    bool solved;
    std::vector<ConnectionId> ids;
  };
  std::vector<InteractionId> interactions;
  std::vector<FieldId> fields;
  std::vector<Batch> connections;  // in the order of their first connection

  explicit Active(const World& world) : interactions(enabled(world.interactions)), fields(enabled(world.fields)) {
    std::unordered_map<const Law*, std::size_t> positions[2];  // only looked up: their order reaches nothing
    for (ConnectionId id : enabled(world.connections)) {
      const bool solved = world.connections[id].solve != Solve::explicitly;
      each_part(world.connections[id], [&](const std::shared_ptr<const Law>& law) {
        const auto [found, is_new] = positions[solved].try_emplace(law.get(), connections.size());
        if (is_new) connections.push_back({law, solved, {}});
        connections[found->second].ids.push_back(id);
      });
    }
  }

  bool none_at_all() const { return interactions.empty() && fields.empty() && connections.empty(); }

  template <class Use>
  void each_law(const World& world, Use use) const {
    const auto part = [&](const std::shared_ptr<const Law>& law) { use(*law); };
    for (InteractionId id : interactions) each_part(world.interactions[id], part);
    for (FieldId id : fields) each_part(world.fields[id], part);
    for (const Batch& batch : connections) use(*batch.law);
  }
};

void add_connections(const World& world, Forces& forces, const Active::Batch& batch,
                     std::span<const std::uint32_t> position_sites, std::size_t& next_position) {
  ActingConnections acting(batch.law, batch.solved, forces, *world.workers);
  for (ConnectionId id : batch.ids) {
    const Connection& row = world.connections[id];
    BondEnds ends{};
    for (std::uint32_t i = 0; i < row.count; i++)
      ends[i] =
          row.particles[i] ? forces.site_of[awake(world, row.particles[i]).slot - 1] : position_sites[next_position++];
    add_bond(world, acting, id, ends);
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
  builder.find_wanted();
  for (const Active::Batch& batch : acting.connections)
    for (ConnectionId id : batch.ids) {
      const Connection& row = world.connections[id];
      for (std::size_t i = 0; i < row.positions.size(); i++)
        if (!row.particles[i]) builder.positions.push_back(row.positions[i]);
    }
  acting.each_law(world, [&](const Law& law) {
    for (const Input& input : inputs_of(law))
      if (input.role == Role::attribute) forces->sites.names.push_back(input.name);
    forces->thermal = forces->thermal || law.thermal;
    if (law.thermal) return;
    forces->velocity_dependent = forces->velocity_dependent || law.velocity_dependent;
    forces->timed = forces->timed || law.timed;
    forces->noisy = forces->noisy || draws_noise(law);
    forces->workless = forces->workless || law.workless;
    forces->nonconservative = forces->nonconservative || !law.has_energy();
    forces->nonconservative_still = forces->nonconservative_still || !(law.has_energy() || law.velocity_dependent);
  });
  std::vector<std::string>& names = forces->sites.names;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  builder.add_sites();
  std::vector<std::uint32_t> all(forces->sites.n);
  std::iota(all.begin(), all.end(), 0u);
  fill_attributes(world, *forces, all);

  std::vector<std::uint32_t> position_sites(builder.positions.size());
  std::iota(position_sites.begin(), position_sites.end(),
            static_cast<std::uint32_t>(forces->sites.n - builder.positions.size()));
  std::size_t next_position = 0;
  for (const Active::Batch& batch : acting.connections)
    add_connections(world, *forces, batch, position_sites, next_position);
  for (InteractionId id : acting.interactions)
    each_part(world.interactions[id],
              [&](const auto& law) { forces->interactions.emplace_back(id, law, *forces, *world.workers); });
  for (FieldId id : acting.fields)
    each_part(world.fields[id],
              [&](const auto& law) { forces->fields.emplace_back(id, law, *forces, *world.workers); });
  check_attributes(world, *forces, all);
  return forces;
}

}  // namespace pantin
