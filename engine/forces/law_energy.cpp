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
  const KeptForces kept(f.sites);
  return read(f);
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

PresentForces present_forces(const World& world) {
  PresentForces all = with_present_laws(world, [&](Forces& f) {
    PresentForces found;
    found.energy = run_still_laws(world, f, present(world), true);
    keep_in_plane(world.plane, f.sites);
    found.on.resize(world.particles.slots(), zero3());
    for (std::size_t i = 0; i < f.sites.n; i++)
      if (f.sites.particle[i] != Forces::none)
        found.on[f.sites.particle[i]] = f.sites.force[i] + f.sites.nonconservative_force[i];
    return found;
  });
  all.on.resize(world.particles.slots(), zero3());
  return all;
}

namespace {

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

std::optional<double> energy_of(const World& world, Forces& f, ActingConnections& acting, const ForceElementId& id) {
  const auto* connection = std::get_if<ConnectionId>(&id);
  const auto k = connection ? find(world, acting, *connection) : std::nullopt;
  return k ? std::optional(energy_of(world, f, acting, *k)) : std::nullopt;
}

template <class Acting>
std::optional<double> energy_of(const World& world, Forces& f, Acting& acting, const ForceElementId& id) {
  if (id != ForceElementId(acting.id)) return {};
  return run_law(world, f, acting, present(world), true);
}

}  // namespace

std::optional<double> law_energy(const World& world, const ForceElementId& id) {
  const ForceElement& row = force_element(world, id);
  if (!row.law->has_energy()) return {};
  return with_present_laws(world, [&](Forces& f) {
    std::optional<double> energy;
    each_element(f, [&](auto& acting) {
      if (!energy && acting.law == row.law) energy = energy_of(world, f, acting, id);
    });
    return energy;
  });
}

double tension(const World& world, ConnectionId id) {
  const Connection& row = world.connections[id];
  if (row.solve != Solve::explicitly) return row.tension;
  if (!world.forces || row.law->kind != LawKind::central) return 0.0;
  double sum = 0.0;
  for (ActingConnections& a : world.forces->connections)
    if (const auto k = find(world, a, id)) sum += a.bonds.tension(*k, world.forces->sites, box_of(world));
  return sum;
}

std::vector<double> tensions(const World& world) {
  std::vector<double> list(world.connections.slots(), 0.0);
  for (ConnectionId id : world.connections.ids())
    if (world.connections[id].solve != Solve::explicitly) list[id.slot - 1] = world.connections[id].tension;
  if (!world.forces) return list;
  for (ActingConnections& a : world.forces->connections)
    for (std::size_t k = 0; a.law->kind == LawKind::central && k < a.ids.size(); k++)
      list[a.ids[k].slot - 1] += a.solved ? 0.0 : a.bonds.tension(k, world.forces->sites, box_of(world));
  return list;
}

LawLedger law_ledger(const World& world) {
  LawLedger ledger{world.given_by_laws, {}, world.nonconservative_work};
  if (!acting_now(world)) return ledger;
  law_energy(world);
  each_element(*world.forces, [&](const ActingElement& a) {
    if (a.law->has_energy())
      ledger.given[a.name(world)] += a.at_first - a.energy;
    else
      ledger.without_energy.push_back(a.name(world));
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
  const auto message = [&](const ForceElement& row, const BadForce& bad) {
    std::string between = name(bad.sites[0]);
    for (int i = 1; i < bad.count; i++) between += " and " + name(bad.sites[i]);
    const std::string distance = bad.count == 1 ? "" : text(", at a distance of ", bad.distance, " m");
    const bool met = bad.count > 1 && bad.distance == 0.0, rests = row.law->velocity_dependent && rest(f.sites, bad);
    const bool hopeless = met || rests;  // no step is short enough
    return text(law_in_place(row), ": the force ", bad.count == 1 ? "on " : "between ", between,
                " is not a finite number", distance, rests ? where_at_rest(f.sites, bad) : "", hopeless ? "" : advice);
  };
  std::string found;
  each_element(f, [&](ActingElement& a) {
    const ForceElement* row = found.empty() ? a.row(world) : nullptr;
    if (row == nullptr) return;
    if (const auto bad = a.on().find_bad(f.sites, box_of(world), instant, a.parameters(world)))
      found = message(*row, *bad);
    else if (with_energies && !std::isfinite(a.energy))
      found = text(law_in_place(*row), ": its energy is not a finite number", advice);
  });
  return found;
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
