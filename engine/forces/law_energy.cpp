// What the laws at work tell: their energies, loads, and what went wrong.
#include <algorithm>

#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"

namespace pantin {

namespace {

/// Calls `read` with the laws of the present state at work, which it may run; what they were is put back.
template <class Read>
auto with_present_laws(const World& world, Read read) -> decltype(read(*world.forces)) {
  if (!acting_now(world) && (world.forces || world.force_elements_changed)) {
    const std::unique_ptr<Forces> fresh = build_forces(world);
    if (!fresh) return {};
    start(world, *fresh);
    refresh_ages(world, *fresh, world.time);
    return read(*fresh);
  }
  if (!world.forces) return {};
  Forces& f = *world.forces;
  const auto force = f.sites.force, open = f.sites.nonconservative_force;
  auto result = read(f);
  f.sites.force = force;
  f.sites.nonconservative_force = open;
  return result;
}

Instant present(const World& world) { return instant_of(world, world.time, world.instant); }

}  // namespace

namespace {

/// Number of a connection among those of its law.
std::optional<std::size_t> find(const World& world, const ActingConnections& acting, ConnectionId id) {
  const auto at = std::lower_bound(acting.serials.begin(), acting.serials.end(), world.connections[id].serial);
  const auto k = static_cast<std::size_t>(at - acting.serials.begin());
  if (k == acting.ids.size() || acting.ids[k] != id) return {};
  return k;
}

}  // namespace

double law_energy(const World& world) {
  return with_present_laws(world, [&](Forces& f) { return run_laws(world, f, present(world), true); });
}

std::optional<double> law_energy(const World& world, InteractionId id) {
  const Interaction& row = world.interactions[id];
  if (!row.law->has_energy()) return {};
  return with_present_laws(world, [&](Forces& f) -> std::optional<double> {
    for (ActingInteraction& a : f.interactions)
      if (a.id == id && a.law == row.law)
        return a.pairs.add_forces_and_energy(f.sites, a.neighbours, present(world),
                                             present_parameters(world, *a.law, row.parameters), *world.workers);
    return {};
  });
}

std::optional<double> law_energy(const World& world, FieldId id) {
  const pantin::Field& row = world.fields[id];
  if (!row.law->has_energy()) return {};
  return with_present_laws(world, [&](Forces& f) -> std::optional<double> {
    for (ActingField& a : f.fields)
      if (a.id == id && a.law == row.law)
        return a.fields.add_forces_and_energy(f.sites, box_of(world), present(world),
                                              present_parameters(world, *a.law, row.parameters), *world.workers);
    return {};
  });
}

/// One connection by itself.
double energy_of(const World& world, Forces& f, const ActingConnections& acting, std::size_t k) {
  const auto count = static_cast<std::ptrdiff_t>(acting.bond_list.count), at = static_cast<std::ptrdiff_t>(k) * count;
  BondList one{
      acting.bond_list.count, {acting.bond_list.sites.begin() + at, acting.bond_list.sites.begin() + at + count}, {}};
  for (const auto& column : acting.bond_list.parameters) one.parameters.push_back({column[k]});
  Bonds bond(acting.law, f.sites.names, *world.workers);
  bond.arrange(one, f.sites);
  return bond.add_forces_and_energy(f.sites, box_of(world), present(world), {}, *world.workers);
}

std::optional<double> law_energy(const World& world, ConnectionId id) {
  const Connection& row = world.connections[id];
  if (!row.law->has_energy()) return {};
  return with_present_laws(world, [&](Forces& f) -> std::optional<double> {
    for (ActingConnections& a : f.connections) {
      const auto k = a.law == row.law ? find(world, a, id) : std::nullopt;
      if (k) return energy_of(world, f, a, *k);
    }
    return {};
  });
}

double tension(const World& world, ConnectionId id) {
  const Connection& row = world.connections[id];
  if (row.solve != Solve::explicitly) return row.tension;
  if (!world.forces || row.law->kind != LawKind::central) return 0.0;
  double sum = 0.0;
  for (const ActingConnections& a : world.forces->connections)
    if (const auto k = find(world, a, id)) sum += a.bonds.tension(*k, world.forces->sites, box_of(world));
  return sum;
}

std::vector<double> tensions(const World& world) {
  std::vector<double> list(world.connections.slots(), 0.0);
  for (ConnectionId id : world.connections.ids())
    if (world.connections[id].solve != Solve::explicitly) list[id.slot - 1] = world.connections[id].tension;
  if (!world.forces) return list;
  for (const ActingConnections& a : world.forces->connections)
    for (std::size_t k = 0; a.law->kind == LawKind::central && k < a.ids.size(); k++)
      list[a.ids[k].slot - 1] += a.solved ? 0.0 : a.bonds.tension(k, world.forces->sites, box_of(world));
  return list;
}

LawLedger law_ledger(const World& world) {
  LawLedger ledger{world.given_by_laws, {}, world.nonconservative_work};
  if (!acting_now(world)) return ledger;
  law_energy(world);
  each_law(world, *world.forces, [&](const std::string& name, const Law& law, const auto& acting) {
    if (law.has_energy())
      ledger.given[name] += acting.at_first - acting.energy;
    else
      ledger.without_energy.push_back(name);
  });
  std::sort(ledger.without_energy.begin(), ledger.without_energy.end());
  const auto end = std::unique(ledger.without_energy.begin(), ledger.without_energy.end());
  ledger.without_energy.erase(end, ledger.without_energy.end());
  return ledger;
}

namespace {

/// Whether the sites have one velocity, or the only one has none.
bool rest(const Sites& sites, const BadForce& bad) {
  const Vec3 v = bad.count == 1 ? zero3() : sites.v[bad.sites[0]];
  return std::all_of(bad.sites, bad.sites + bad.count, [&](std::uint32_t site) { return same(sites.v[site], v); });
}

std::string where_at_rest(const Sites& sites, const BadForce& bad) {
  const Vec3 x = sites.x[bad.sites[0]];
  return text(bad.count == 1 ? ", at rest at (" : ", at rest relative to each other, the first at (", x[0], ", ", x[1],
              ", ", x[2], ") m, where v / |v| is 0 / 0: a direction of motion has no meaning there");
}

/// The first law whose force, or if wanted its energy, is not finite where the sites now are, and what to try against it.
std::string find_bad_force(const World& world, Forces& f, double time, const std::string& advice, bool with_energies) {
  const Instant instant = instant_of(world, time, world.instant);
  const auto name = [&](std::uint32_t site) {
    return f.sites.particle[site] == Forces::none ? std::string("a position")
                                                  : describe(world, world.particles.id_at(f.sites.particle[site]));
  };
  const auto message = [&](const auto& row, const BadForce& bad) {
    std::string between = name(bad.sites[0]);
    for (int i = 1; i < bad.count; i++) between += " and " + name(bad.sites[i]);
    const std::string distance = bad.count == 1 ? "" : text(", at a distance of ", bad.distance, " m");
    const bool met = bad.count > 1 && bad.distance == 0.0, rests = row.law->velocity_dependent && rest(f.sites, bad);
    const bool hopeless = met || rests;  // no step is short enough
    return text(law_in_place(row), ": the force ", bad.count == 1 ? "on " : "between ", between,
                " is not a finite number", distance, rests ? where_at_rest(f.sites, bad) : "", hopeless ? "" : advice);
  };
  const auto energy = [&](const auto& row, const auto& acting) {
    if (!with_energies || std::isfinite(acting.energy)) return std::string();
    return text(law_in_place(row), ": its energy is not a finite number", advice);
  };
  for (ActingInteraction& a : f.interactions) {
    const Interaction& row = world.interactions[a.id];
    const auto bad =
        a.pairs.find_bad(f.sites, a.neighbours, instant, present_parameters(world, *a.law, row.parameters));
    if (bad) return message(row, *bad);
    if (const std::string lost = energy(row, a); !lost.empty()) return lost;
  }
  for (ActingConnections& a : f.connections) {
    if (a.ids.empty()) continue;
    const Connection& row = world.connections[a.ids[0]];
    if (const auto bad = a.bonds.find_bad(f.sites, box_of(world), instant, {})) return message(row, *bad);
    if (const std::string lost = energy(row, a); !lost.empty()) return lost;
  }
  for (ActingField& a : f.fields) {
    const pantin::Field& row = world.fields[a.id];
    const auto parameters = present_parameters(world, *a.law, row.parameters);
    if (const auto bad = a.fields.find_bad(f.sites, box_of(world), instant, parameters)) return message(row, *bad);
    if (const std::string lost = energy(row, a); !lost.empty()) return lost;
  }
  return {};
}

}  // namespace

std::string bad_force(const World& world) {
  if (!world.forces) return {};
  Forces& f = *world.forces;
  const auto x = f.sites.x, v = f.sites.v;
  const bool sound =
      std::all_of(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(f.sites.n), [](Vec3 at) { return finite(at); });
  read_positions(world, f, false);
  read_velocities(world, f, false);
  // What is not finite before anything moves no step makes so.
  if (std::string bad = find_bad_force(world, f, world.time, "", false); !bad.empty()) return bad;
  if (sound) {
    f.sites.x = x;
    f.sites.v = v;
  }
  return find_bad_force(world, f, next_time(world), try_accuracy(world), true);
}

}  // namespace pantin
