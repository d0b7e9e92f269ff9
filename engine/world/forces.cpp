#include "world/forces.hpp"

#include <algorithm>

#include "articulates/articulate.hpp"
#include "world/courses.hpp"
#include "world/editing.hpp"
#include "world/forces_build.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t none = Forces::none;
/// Laws over no more pairs than this tell their energy in every step, others in every sixteenth.
constexpr std::size_t few_pairs = 4096;

Box box_of(const World& world) { return {world.settings.box.value_or(zero3())}; }

/// State of a mover: after a drift as the articulate that holds it has it, before as the model has it.
struct Pose {
  Vec3 x, v, spin;
  Quat q;
};

Pose pose_of(const World& world, const Mover& m, bool drifted) {
  if (drifted && m.articulate >= 0) {
    const Node& n = world.articulates[static_cast<std::size_t>(m.articulate)]->nodes[m.node];
    return {n.x0, n.p0 * n.inverse_mass, rotate(n.q0, n.O0), n.q0};
  }
  if (!m.is_body) return {world.free_motion[m.slot].x, world.free_motion[m.slot].v, zero3(), {}};
  const Motion& motion = world.motion[m.slot];
  return {motion.x, motion.p / motion.mass, angular_velocity(motion), motion.q};
}

void read_velocities(const World& world, Forces& f, bool drifted) {
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != none) f.sites.v[i] = world.free_motion[f.point[i]].v;
  for (Attached& a : f.attached) {
    const Pose pose = pose_of(world, f.movers[a.mover], drifted);
    f.sites.v[a.site] = pose.v + cross(pose.spin, a.r);
  }
}

void read_places(const World& world, Forces& f, bool drifted) {
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != none) f.sites.x[i] = world.free_motion[f.point[i]].x - f.image[i];
  for (Attached& a : f.attached) {
    const Pose pose = pose_of(world, f.movers[a.mover], drifted);
    a.r = rotate(pose.q, a.arm);
    f.sites.x[a.site] = pose.x + a.r - f.image[a.site];
  }
}

template <class Array>
void permute(Array& array, std::span<const std::uint32_t> order) {
  const Array old = array;
  for (std::size_t k = 0; k < order.size(); k++) array[k] = old[order[k]];
}

/// The same pairs, where site i is now the site now[i].
Exclusions put_in_order(const Exclusions& old, std::span<const std::uint32_t> now) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i + 1 < old.begin.size(); i++)
    for (std::uint32_t j : old.of(i)) pairs.push_back({now[i], now[j]});
  return exclusions(now.size(), std::move(pairs));
}

/// Puts the sites into a new order: element k of it is the site to be put at k.
void put_in_order(const World& world, Forces& f, std::span<const std::uint32_t> order) {
  Sites& s = f.sites;
  std::vector<std::uint32_t> now(order.size());
  for (std::uint32_t k = 0; k < order.size(); k++) now[order[k]] = k;
  permute(s.x, order);
  permute(s.v, order);
  permute(s.particle, order);
  permute(s.serial, order);
  permute(s.family, order);
  permute(s.kin, order);
  for (auto& column : s.attributes) permute(column, order);
  permute(f.point, order);
  permute(f.inverse_mass, order);
  permute(f.image, order);
  for (Attached& a : f.attached) a.site = now[a.site];
  for (std::uint32_t& site : f.site_of)
    if (site != none) site = now[site];
  s.excluded = put_in_order(s.excluded, now);
  for (ActingInteraction& a : f.interactions) a.bonded = put_in_order(a.bonded, now);
  for (ActingConnections& c : f.connections) {
    for (std::uint32_t& site : c.ties.sites) site = now[site];
    c.bonds.arrange(c.ties, s);
  }
  arrange_fields(world, f);
}

double largest_radius(const Sites& sites, std::uint32_t family) {
  const auto column = std::find(sites.names.begin(), sites.names.end(), "radius") - sites.names.begin();
  double most = 0.0;
  for (std::size_t i = 0; i < sites.n; i++)
    if (sites.family[i] == family) most = std::fmax(most, sites.attributes[static_cast<std::size_t>(column)][i]);
  return most;
}

/// Beyond it a law of an interaction gives nothing, [m].
double reach_of(const World& world, const Forces& f, const ActingInteraction& a) {
  if (!a.law->touching) return a.law->cutoff;
  const Interaction& row = world.interactions[a.id];
  const double touch = largest_radius(f.sites, row.a.slot - 1) + largest_radius(f.sites, row.b.slot - 1);
  return std::fmin(a.law->cutoff, std::fmax(touch, std::numeric_limits<double>::min()));
}

/// Sorts the sites by cells and builds the rows anew.
void build_rows(const World& world, Forces& f, bool drifted) {
  const Box box = box_of(world);
  double reach = 0.0;
  for (const ActingInteraction& a : f.interactions)
    if (const double cutoff = reach_of(world, f, a); std::isfinite(cutoff)) reach = std::max(reach, cutoff);
  for (std::size_t i = 0; box.periodic() && i < f.sites.n; i++) {
    const Vec3 wrapped = box.wrapped(f.sites.x[i]);
    f.image[i] += f.sites.x[i] - wrapped;
    f.sites.x[i] = wrapped;
  }
  double skin = 0.0;
  if (reach > 0.0) {
    read_velocities(world, f, drifted);
    skin = best_skin(f.sites, world.settings.step, reach);
    put_in_order(world, f, cell_order({f.sites.x.data(), f.sites.n}, box, 0.5 * (reach + skin)));
  }
  for (ActingInteraction& a : f.interactions) {
    const Interaction& row = world.interactions[a.id];
    const std::uint32_t of_a[] = {row.a.slot - 1}, of_b[] = {row.b.slot - 1};
    try {
      a.rows.build(f.sites, box, of_a, of_b, reach_of(world, f, a), skin, *world.workers, a.bonded);
    } catch (const Error& error) { throw Error(text(a.law->name, ": ", error.what())); }
  }
  f.skin.restart(f.sites, skin);
  f.rows = reach > 0.0;
}

/// Values of a law's parameters; "step" is the length of the step [s], "boltzmann" k_B [J/K].
std::vector<double> present_parameters(const World& world, const Law& law, const std::vector<double>& given) {
  std::vector<double> values = given;
  for (std::size_t i = 0; i < values.size(); i++) {
    if (!editing::given_by_world(law.parameters[i].name)) continue;
    values[i] = law.parameters[i].name == "step" ? world.settings.step : world.settings.boltzmann;
  }
  return values;
}

struct Which {
  bool moving, still;
};

/// Adds the forces of the laws; gives the energy of those that have one where it is asked for.
double run_laws(const World& world, Forces& f, const Instant& instant, Which which, bool with_energy) {
  const Box box = box_of(world);
  double energy = 0.0;
  const auto runs = [&](const Law& law) { return law.moving ? which.moving : which.still; };
  for (ActingInteraction& a : f.interactions) {
    if (!runs(*a.law)) continue;
    const auto parameters = present_parameters(world, *a.law, world.interactions[a.id].parameters);
    if (with_energy)
      energy += a.energy = a.pairs.add_forces_and_energy(f.sites, a.rows, instant, parameters, *world.workers);
    else
      a.pairs.add_forces(f.sites, a.rows, instant, parameters, *world.workers);
  }
  for (ActingConnections& a : f.connections) {
    if (!runs(*a.law)) continue;
    if (with_energy)
      energy += a.energy = a.bonds.add_forces_and_energy(f.sites, box, instant, {}, *world.workers);
    else
      a.bonds.add_forces(f.sites, box, instant, {}, *world.workers);
  }
  for (ActingField& a : f.fields) {
    if (!runs(*a.law)) continue;
    const auto parameters = present_parameters(world, *a.law, world.fields[a.id].parameters);
    if (with_energy)
      energy += a.energy = a.fields.add_forces_and_energy(f.sites, box, instant, parameters, *world.workers);
    else
      a.fields.add_forces(f.sites, box, instant, parameters, *world.workers);
  }
  return energy;
}

void collect(Forces& f) {
  for (Mover& m : f.movers) m.force = m.torque = m.open_force = m.open_torque = zero3();
  for (const Attached& a : f.attached) {
    Mover& m = f.movers[a.mover];
    m.force += f.sites.force[a.site];
    m.torque += cross(a.r, f.sites.force[a.site]);
    m.open_force += f.sites.open_force[a.site];
    m.open_torque += cross(a.r, f.sites.open_force[a.site]);
  }
}

/// Ages, and what follows them, at a time [s].
void refresh_ages(const World& world, Forces& f, double time) {
  Sites& s = f.sites;
  for (std::size_t c = 0; c < s.names.size(); c++) {
    if (s.names[c] == "age")
      for (std::size_t i = 0; i < s.n; i++)
        if (s.particle[i] != none)
          s.attributes[c][i] = std::fmax(0.0, time - world.particles.at_slot(s.particle[i]).born);
    double* const column = s.attributes[c].data();
    if (f.followed[c]) follow_courses(world, s.names[c], time, s.particle, {&column, 1});
  }
}

bool follows(const Forces& f) {
  return std::any_of(f.followed.begin(), f.followed.end(), [](char c) { return c != 0; });
}

/// Forces at the places and velocities that the sites now have; the energy where it is asked for.
double evaluate(const World& world, Forces& f, const Instant& instant, bool with_energy) {
  refresh_ages(world, f, instant.time);
  f.sites.clear_forces();
  double energy = run_laws(world, f, instant, {false, true}, with_energy);
  if (f.moving) {
    f.still.assign(f.sites.open_force.begin(), f.sites.open_force.end());
    run_laws(world, f, instant, {true, false}, false);
  }
  collect(f);
  return energy;
}

Instant instant_of(const World& world, double time, std::uint64_t number) {
  return {time, number, world.settings.seed};
}

/// Reads the present state into laws that were just built.
void start(const World& world, Forces& f) {
  read_places(world, f, false);
  build_rows(world, f, false);
  if (!f.rows) {
    for (ActingConnections& c : f.connections) c.bonds.arrange(c.ties, f.sites);
    arrange_fields(world, f);
  }
  read_velocities(world, f, false);
}

/// Calls `use(name, law, what acts)` for all laws at work.
template <class Use>
void each_law(const World& world, Forces& f, Use use) {
  const auto name = [](const auto& row, const Law& law) { return row.name.empty() ? law.name : row.name; };
  for (ActingInteraction& a : f.interactions) use(name(world.interactions[a.id], *a.law), *a.law, a);
  for (ActingConnections& a : f.connections) use(a.law->name, *a.law, a);
  for (ActingField& a : f.fields) use(name(world.fields[a.id], *a.law), *a.law, a);
}

bool tells_energy(const World& world, const Forces& f) {
  std::size_t pairs = 0;
  for (const ActingInteraction& a : f.interactions) pairs += a.rows.pairs();
  for (const ActingConnections& a : f.connections) pairs += a.ties.size();
  return pairs <= few_pairs || (world.steps + 1) % 16 == 0;
}

}  // namespace

void editing::disturb_forces(World& world) {
  if (world.influences_changed) return;
  if (world.forces) {
    post(world, -law_energy(world));
    each_law(world, *world.forces, [&](const std::string& name, const Law& law, auto& acting) {
      if (law.has_energy()) world.given_by_laws[name] += acting.at_first - acting.energy;
    });
  }
  world.influences_changed = true;
}

namespace {

/// Energy of the laws at the present places, with ages of another time [s]; forces stay, ages do not.
double energy_at_ages(const World& world, Forces& f, double time) {
  const auto force = f.sites.force, open = f.sites.open_force;
  refresh_ages(world, f, time);
  const double energy = run_laws(world, f, instant_of(world, time, world.steps), {false, true}, true);
  f.sites.force = force;
  f.sites.open_force = open;
  return energy;
}

void make_forces(World& world) {
  world.forces = build_forces(world);
  world.influences_changed = false;
  for (const auto& articulate : world.articulates) articulate->pulled = false;
  if (!world.forces) return;
  Forces& f = *world.forces;
  for (const Mover& m : f.movers)
    if (m.articulate >= 0) world.articulates[static_cast<std::size_t>(m.articulate)]->pulled = true;
  start(world, f);
  f.energy = evaluate(world, f, instant_of(world, world.time, world.steps), true);
  each_law(world, f, [](const std::string&, const Law&, auto& acting) { acting.at_first = acting.energy; });
  (world.steps == 0 ? world.start_energy : world.work) += f.energy;
}

}  // namespace

void refresh_forces(World& world) {
  if (world.influences_changed) make_forces(world);
  if (!world.forces || !follows(*world.forces)) return;
  // What changes with age alone is work from outside: half of it at the places before the drift, half at those after.
  Forces& f = *world.forces;
  const double energy = f.energy;
  editing::post(world, 0.5 * (energy_at_ages(world, f, next_time(world)) - energy));
}

void find_pairs(World& world) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  read_places(world, f, true);
  if (f.rows && f.skin.spent(f.sites)) build_rows(world, f, true);
}

void apply_forces(World& world) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  if (f.moving) read_velocities(world, f, true);
  f.told = tells_energy(world, f) || follows(f);
  const double before = follows(f) ? energy_at_ages(world, f, world.time) : 0.0;
  f.energy = evaluate(world, f, instant_of(world, next_time(world), world.steps + 1), f.told);
  if (follows(f)) editing::post(world, 0.5 * (f.energy - before));
}

void run_moving_laws(World& world, Forces& f) {
  read_velocities(world, f, true);
  std::copy(f.still.begin(), f.still.end(), f.sites.open_force.begin());
  run_laws(world, f, instant_of(world, next_time(world), world.steps + 1), {true, false}, false);
  collect(f);
}

namespace {

/// Calls `read` with the laws of the present state at work, which it may run; what they were is put back.
template <class Read>
auto with_present_laws(const World& world, Read read) -> decltype(read(*world.forces)) {
  if (world.influences_changed) {
    const std::unique_ptr<Forces> fresh = build_forces(world);
    if (!fresh) return {};
    start(world, *fresh);
    refresh_ages(world, *fresh, world.time);
    return read(*fresh);
  }
  if (!world.forces) return {};
  Forces& f = *world.forces;
  const auto force = f.sites.force, open = f.sites.open_force;
  auto result = read(f);
  f.sites.force = force;
  f.sites.open_force = open;
  return result;
}

Instant present(const World& world) { return instant_of(world, world.time, world.steps); }

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
  return with_present_laws(world, [&](Forces& f) { return run_laws(world, f, present(world), {false, true}, true); });
}

std::optional<double> law_energy(const World& world, InteractionId id) {
  const Interaction& row = world.interactions[id];
  if (!row.law->has_energy()) return {};
  return with_present_laws(world, [&](Forces& f) -> std::optional<double> {
    for (ActingInteraction& a : f.interactions)
      if (a.id == id && a.law == row.law)
        return a.pairs.add_forces_and_energy(f.sites, a.rows, present(world),
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
  const auto count = static_cast<std::ptrdiff_t>(acting.ties.count), at = static_cast<std::ptrdiff_t>(k) * count;
  Ties one{acting.ties.count, {acting.ties.sites.begin() + at, acting.ties.sites.begin() + at + count}, {}};
  for (const auto& column : acting.ties.parameters) one.parameters.push_back({column[k]});
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
  if (!world.forces || row.law->kind != LawKind::central) return 0.0;
  double sum = 0.0;
  for (const ActingConnections& a : world.forces->connections)
    if (const auto k = find(world, a, id)) sum += a.bonds.tension(*k, world.forces->sites, box_of(world));
  return sum;
}

std::vector<double> tensions(const World& world) {
  std::vector<double> list(world.connections.slots(), 0.0);
  if (!world.forces) return list;
  for (const ActingConnections& a : world.forces->connections)
    for (std::size_t k = 0; a.law->kind == LawKind::central && k < a.ids.size(); k++)
      list[a.ids[k].slot - 1] += a.bonds.tension(k, world.forces->sites, box_of(world));
  return list;
}

LawLedger law_ledger(const World& world) {
  LawLedger ledger{world.given_by_laws, {}, world.open_work};
  if (!world.forces || world.influences_changed) return ledger;
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

std::string bad_force(const World& world) {
  if (!world.forces) return {};
  Forces& f = *world.forces;
  const Instant instant = instant_of(world, next_time(world), world.steps + 1);
  const auto name = [&](std::uint32_t site) {
    return f.sites.particle[site] == none ? std::string("a place")
                                          : describe(world, world.particles.id_at(f.sites.particle[site]));
  };
  const auto message = [&](const Law& law, const BadForce& bad) {
    std::string between = name(bad.sites[0]);
    for (int i = 1; i < bad.count; i++) between += " and " + name(bad.sites[i]);
    return bad.count == 1 ? text(law.name, ": the force on ", between, " is not a finite number")
                          : text(law.name, ": the force between ", between,
                                 " is not a finite number, at a distance of ", bad.distance, " m");
  };
  for (ActingInteraction& a : f.interactions) {
    const Interaction& row = world.interactions[a.id];
    if (const auto bad = a.pairs.find_bad(f.sites, a.rows, instant, present_parameters(world, *a.law, row.parameters)))
      return message(*a.law, *bad);
  }
  for (ActingConnections& a : f.connections)
    if (const auto bad = a.bonds.find_bad(f.sites, box_of(world), instant, {})) return message(*a.law, *bad);
  for (ActingField& a : f.fields) {
    const pantin::Field& row = world.fields[a.id];
    if (const auto bad =
            a.fields.find_bad(f.sites, box_of(world), instant, present_parameters(world, *a.law, row.parameters)))
      return message(*a.law, *bad);
  }
  return {};
}

}  // namespace pantin
