#include "forces/encounters.hpp"

#include <algorithm>
#include <cmath>

#include "articulates/articulate.hpp"
#include "forces/forces_parts.hpp"

namespace pantin {

namespace {

constexpr double slow_part = 0.1;  // of the reach of a law: who moves less in a stage passes nobody in it
constexpr double nearer = 0.7;     // than at both ends: an encounter

/// How a pair passed, if it did.
struct Passing {
  std::uint32_t a = 0, b = 0;
  Vec3 d = zero3();             // [m] from a to b where they were nearest
  Vec3 displacement = zero3();  // [m] by which that changed over the stage
  std::size_t tie = 0;          // number of the connection
};

class Finder {
 public:
  Finder(const World& world, Forces& f, double fastest, double nearest)
      : world_(world), f_(f), box_(box_of(world)), fastest_(fastest), nearest_(nearest) {}

  std::vector<Encounter> find() {
    for (ActingConnections& c : f_.connections) of_connections(c);
    for (ActingInteraction& a : f_.interactions) of_interaction(a);
    return std::move(found_);
  }

 private:
  Vec3 start(std::uint32_t site) const {
    const std::uint32_t slot = f_.sites.particle[site];
    return slot == Forces::none ? f_.sites.x[site] : f_.notes.position[slot] - f_.image[site];
  }
  void consider(std::uint32_t a, std::uint32_t b, std::size_t tie) {
    const Vec3 d0 = box_.nearest(start(b) - start(a)), d1 = box_.nearest(f_.sites.x[b] - f_.sites.x[a]);
    const Vec3 displacement = d1 - d0;
    const double squared = norm2(displacement), at = squared > 0.0 ? -dot(d0, displacement) / squared : 0.0;
    if (!(at > 0.0 && at < 1.0)) return;
    Vec3 d = d0 + displacement * at;
    if (const double least = 1e-3 * std::sqrt(squared); norm(d) < least)
      d = direction(d1) * least;  // a law needs a direction
    if (norm(d) < nearer * std::min(norm(d0), norm(d1))) passed_.push_back({a, b, d, displacement, tie});
  }

  void of_connections(const ActingConnections& c) {
    if (c.solved || c.bond_list.count != 2) return;
    passed_.clear();
    for (std::size_t k = 0; k < c.ids.size(); k++) consider(c.bond_list.sites[2 * k], c.bond_list.sites[2 * k + 1], k);
    if (passed_.empty()) return;
    BondList ties;
    for (const std::vector<double>& column : c.bond_list.parameters) {
      ties.parameters.emplace_back();
      for (const Passing& p : passed_) ties.parameters.back().push_back(column[p.tie]);
    }
    ask(c.law, std::move(ties), {});
  }

  void of_interaction(ActingInteraction& a) {
    const Interaction& row = world_.interactions[a.id];
    const double cutoff = a.pairs.neighbours.cutoff();
    if (2.0 * fastest_ < slow_part * std::min(cutoff, nearest_)) return;
    passed_.clear();
    const std::uint32_t of_a[] = {row.a.slot - 1}, of_b[] = {row.b.slot - 1};
    const double farthest = 2.0 * fastest_ / std::sqrt(1.0 - nearer * nearer);  // at the end, of two that passed
    NeighbourList near;
    near.build(f_.sites, box_, of_a, of_b, std::min(cutoff + 2.0 * fastest_, farthest), 0.0, *world_.workers, a.bonded);
    each_pair(near, f_.sites, [&](std::uint32_t i, std::uint32_t j) { consider(i, j, 0); });
    if (!passed_.empty()) ask(a.law, {}, a.parameters(world_));
  }

  /// Asks the law of the pairs that passed each other, put on sites of their own where they were nearest.
  void ask(const std::shared_ptr<const Law>& law, BondList ties, const std::vector<double>& parameters) {
    Sites sites;
    sites.names = f_.sites.names;
    sites.resize(2 * passed_.size());
    sites.clear_forces();
    for (std::uint32_t k = 0; k < sites.n; k++) {
      const std::uint32_t from = k % 2 == 0 ? passed_[k / 2].a : passed_[k / 2].b;
      sites.x[k] = k % 2 == 0 ? zero3() : passed_[k / 2].d;
      sites.v[k] = f_.sites.v[from];
      sites.particle[k] = f_.sites.particle[from];
      sites.serial[k] = f_.sites.serial[from];
      sites.family[k] = f_.sites.family[from];
      sites.kin[k] = {};
      for (std::size_t c = 0; c < sites.attributes.size(); c++) sites.attributes[c][k] = f_.sites.attributes[c][from];
      ties.sites.push_back(k);
    }
    Bonds bonds(law, sites.names, *world_.workers);
    bonds.arrange(ties, sites);
    bonds.add_forces(sites, {}, instant_of(world_, world_.time, world_.instant), parameters, *world_.workers);
    for (std::uint32_t k = 0; k < sites.n; k++) {
      const Passing& p = passed_[k / 2];
      const std::uint32_t site = k % 2 == 0 ? p.a : p.b;
      const bool reached = norm(p.d) < (law->touching ? touching_distance(p) : law->cutoff);
      const double force = reached ? norm(sites.force[k] + sites.nonconservative_force[k]) : 0.0;
      found_.push_back({site, force * mobility(site), norm(p.d), norm(p.displacement)});
    }
  }

  double touching_distance(const Passing& p) const {
    const auto& names = f_.sites.names;
    const auto radius = static_cast<std::size_t>(std::find(names.begin(), names.end(), "radius") - names.begin());
    return f_.sites.attributes[radius][p.a] + f_.sites.attributes[radius][p.b];
  }

  double mobility(std::uint32_t site) const {
    if (f_.point[site] != Forces::none) return f_.inverse_mass[site];
    const std::uint32_t at = f_.attached_of[site];
    if (at == Forces::none) return 0.0;
    const Receiver& m = f_.receivers[f_.attached[at].receiver];
    return 1.0 / (m.is_body ? world_.motion[m.slot].mass : world_.points.at_slot(m.slot).mass);
  }

  const World& world_;
  Forces& f_;
  Box box_;
  double fastest_, nearest_;  // [m]
  std::vector<Passing> passed_;
  std::vector<Encounter> found_;
};

}  // namespace

std::vector<Encounter> find_encounters(const World& world, Forces& f, double fastest, double nearest) {
  if (f.interactions.empty() && f.connections.empty()) return {};
  return Finder(world, f, fastest, nearest).find();
}

}  // namespace pantin
