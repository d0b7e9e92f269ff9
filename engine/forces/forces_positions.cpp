// Where the particles are that laws act on, as the hot loops read it, and which of them are near to each other.
#include <algorithm>

#include "articulates/articulate.hpp"
#include "forces/forces_parts.hpp"
#include "world/share_blocks.hpp"

namespace pantin {

namespace {

/// State of a receiver: after a drift as the articulate that holds it has it, before as the model has it.
struct ReceiverState {
  Vec3 x, v, spin;
  Quat q;
};

ReceiverState state_of(const World& world, const Receiver& m, bool drifted) {
  if (drifted && m.articulate >= 0) {
    const Node& n = world.articulates[static_cast<std::size_t>(m.articulate)]->nodes[m.node];
    const Vec3 before = m.is_body ? world.motion[m.slot].x : world.free_motion[m.slot].x;
    return {world.plane.beside(n.x0, before), n.p0 * n.inverse_mass, rotate(n.q0, n.spin0), n.q0};
  }
  if (!m.is_body) return {world.free_motion[m.slot].x, world.free_motion[m.slot].v, zero3(), {}};
  const Motion& motion = world.motion[m.slot];
  return {motion.x, motion.p / motion.mass, angular_velocity(motion), motion.q};
}

}  // namespace

Box box_of(const World& world) { return {world.settings.box.value_or(zero3())}; }

void read_velocities(const World& world, Forces& f, bool drifted) {
  share_each(world, f.sites.n, [&](std::size_t i) {
    if (f.point[i] != Forces::none) f.sites.v[i] = world.free_motion[f.point[i]].v;
  });
  for (Attached& a : f.attached) {
    const ReceiverState state = state_of(world, f.receivers[a.receiver], drifted);
    f.sites.v[a.site] = state.v + cross(state.spin, a.r);
  }
}

void read_positions(const World& world, Forces& f, bool drifted) {
  share_each(world, f.sites.n, [&](std::size_t i) {
    if (f.point[i] != Forces::none) f.sites.x[i] = world.free_motion[f.point[i]].x - f.image[i];
  });
  for (Attached& a : f.attached) {
    const ReceiverState state = state_of(world, f.receivers[a.receiver], drifted);
    a.r = rotate(state.q, a.arm);
    f.sites.x[a.site] = state.x + a.r - f.image[a.site];
  }
}

namespace {

template <class Array>
void permute(Array& array, std::span<const std::uint32_t> order) {
  const Array old = array;
  for (std::size_t k = 0; k < order.size(); k++) array[k] = old[order[k]];
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
  number_attached(f);
  for (std::uint32_t& site : f.site_of)
    if (site != Forces::none) site = now[site];
  for (ActingInteraction& a : f.interactions) a.bonded = renumbered(a.bonded, now, s.n);
  for (ActingConnections& c : f.connections)
    for (std::uint32_t& site : c.bond_list.sites) site = now[site];
  arrange(world, f);
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

}  // namespace

namespace {

/// Beyond it no law of an interaction gives anything, [m]; of those without a cutoff nothing is asked.
double longest_reach(const World& world, const Forces& f) {
  double reach = 0.0;
  for (const ActingInteraction& a : f.interactions)
    if (const double cutoff = reach_of(world, f, a); std::isfinite(cutoff)) reach = std::max(reach, cutoff);
  return reach;
}

void wrap(const World& world, Forces& f) {
  const Box box = box_of(world);
  for (std::size_t i = 0; box.periodic() && i < f.sites.n; i++) {
    const Vec3 wrapped = box.wrapped(f.sites.x[i]);
    f.image[i] += f.sites.x[i] - wrapped;
    f.sites.x[i] = wrapped;
  }
}

/// Finds the pairs of the sites in their order.
void list_pairs(const World& world, Forces& f, double skin) {
  for (ActingInteraction& a : f.interactions) {
    const Interaction& row = world.interactions[a.id];
    const std::uint32_t of_a[] = {row.a.slot - 1}, of_b[] = {row.b.slot - 1};
    try {
      a.pairs.neighbours.build(f.sites, box_of(world), of_a, of_b, reach_of(world, f, a), skin, *world.workers,
                               a.bonded);
    } catch (const Error& error) { throw Error(text(law_in_place(row), ": ", error.what())); }
  }
  f.skin.restart(f.sites, skin);
}

}  // namespace

void build_neighbours(const World& world, Forces& f, bool drifted) {
  const double reach = longest_reach(world, f);
  wrap(world, f);
  double skin = 0.0;
  if (reach > 0.0) {
    read_velocities(world, f, drifted);
    skin = best_skin(f.sites, world.stage.full, reach);
    put_in_order(world, f, cell_order({f.sites.x.data(), f.sites.n}, box_of(world), 0.5 * (reach + skin)));
  }
  list_pairs(world, f, skin);
  f.rows = reach > 0.0;
}

void build_neighbours_in_order(const World& world, Forces& f) {
  if (!f.rows) return build_neighbours(world, f, false);
  wrap(world, f);
  list_pairs(world, f, f.skin.width());
}

}  // namespace pantin
