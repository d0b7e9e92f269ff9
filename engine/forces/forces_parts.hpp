#pragma once
// Not for use outside world/.
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "forces/forces.hpp"

namespace pantin {

/// Makes the laws of the model ready to act; null where there are none. Places are not yet read.
std::unique_ptr<Forces> build_forces(const World& world);
/// Gives connections and fields their sites; after every change of their order.
void arrange(const World& world, Forces& forces);
/// Reads what the laws at work read by name of some sites, in rising order, but for what follows the age of particles.
void fill_attributes(const World& world, Forces& forces, std::span<const std::uint32_t> some);
/// Throws Error where laws act on one of these sites, in rising order, that has not what they read.
void check_attributes(const World& world, const Forces& forces, std::span<const std::uint32_t> some);
std::vector<Input> inputs_of(const Law& law);
/// Whether laws act on every free particle of a family, or of none where it is null.
inline bool acts_on_all(const Forces& forces, FamilyId family) {
  return forces.everybody || (family && family.slot <= forces.families.size() && forces.families[family.slot - 1]);
}
/// Which laws want a site of a particle.
enum class Wanted : std::uint8_t { not_at_all, by_solved, by_others };
/// What families and connections want of one that is awake; not of fields on groups.
Wanted wanted(const World& world, const Forces& forces, ParticleId particle);
/// Makes a site that of a particle, on what moves it: a loose point, a body or a tied point.
void bind_site(const World& world, Forces& forces, std::uint32_t site, ParticleId particle, Wanted how);
void unbind_site(Forces& forces, std::uint32_t site);
/// Finds which of `attached` each site is, after their numbers changed.
void number_attached(Forces& forces);
/// Finds where in articulates the receivers are, and which laws pull; without those to which nothing is bound any more.
void find_receivers(World& world, Forces& forces);

/// The sites of a connection's ends.
using BondEnds = std::array<std::uint32_t, 4>;
/// Adds a connection to those of its law, unless a hinge has joined two of its ends.
void add_bond(const World& world, ActingConnections& acting, ConnectionId connection, const BondEnds& ends);
/// Takes out connections that are gone, and lists those anew whose ends may have changed.
void change_bonds(const World& world, Forces& forces, const std::vector<ConnectionId>& changed);

/// Whether `change_members` can do what edits ask for; otherwise all is to be built anew.
bool can_change_members(const World& world, const Forces& forces);
/// Looks at the particles anew that edits say may have changed: takes sites away, gives new ones, and binds others anew.
/// Gives these in rising order. Places are not yet read.
std::vector<std::uint32_t> change_members(const World& world, Forces& forces);
/// Whether only free particles were born or have gone, and what laws do to one of them has to do with no other, and comes of
/// its state alone.
bool are_apart(const World& world, const Forces& forces);
/// The same where they are apart, and the forces on them at the present positions; others stay. Gives the change of energy
/// [J], told before of the present state.
double change_members_apart(const World& world, Forces& forces);
/// The particles of a point, body, particle or group, as they were made: some may sleep in hinges.
std::vector<ParticleId> particles_of(const World& world, const AnyId& thing);
/// Pairs of sites with no more than `steps` connections between them.
Exclusions bonded(const Forces& forces, int steps);
/// The same pairs of n sites, by the number that each has `now`; without those that have none.
Exclusions renumbered(const Exclusions& old, std::span<const std::uint32_t> now, std::size_t n);
/// From pairs of n sites, each in both orders.
Exclusions exclusions(std::size_t n, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs);

/// A law as messages name it: "scene.lua:12", or where one of the library was put to use, "scene.lua:3: lennard_jones".
std::string law_in_place(const ForceElement& row);
/// The same of one at work.
std::string law_at_work(const World& world, const ActingElement& acting);
/// The periodic box, or open space.
Box box_of(const World& world);
/// State of the sites: of what articulates hold after a drift as they have it, before as the model has it.
void read_positions(const World& world, Forces& forces, bool drifted);
void read_velocities(const World& world, Forces& forces, bool drifted);
/// Sorts the sites by cells and builds the rows anew.
void build_neighbours(const World& world, Forces& forces, bool drifted);
/// The same after an edit, with the sites in the order that they are in.
void build_neighbours_in_order(const World& world, Forces& forces);
/// Calls use(i, j) for all pairs of sites that are listed.
template <class Use>
void each_pair(const NeighbourList& neighbours, const Sites& sites, Use use) {
  for (const auto& phase : neighbours.phases())
    for (const Slab& slab : phase)
      for (const NeighbourRow& row : slab.rows)
        for (std::uint32_t j : std::span(slab.list + row.begin, row.count))
          if (j < sites.n) use(row.site, j);
}
/// Reads the present state into laws that were just built.
void start(const World& world, Forces& forces);
/// Ages, and what follows them, at a time [s].
void refresh_ages(const World& world, Forces& forces, double time);

Instant instant_of(const World& world, double time, std::uint64_t number);
/// Values of a law's parameters; "step" is the length of the step [s], "boltzmann" k_B [J/K].
std::vector<double> present_parameters(const World& world, const Law& law, const std::vector<double>& given);

/// Keeps the forces on sites through what asks laws for others: they are put back at its end.
class KeptForces {
 public:
  explicit KeptForces(Sites& sites) : sites_(sites), force_(sites.force), open_(sites.nonconservative_force) {}
  ~KeptForces() {
    sites_.force = std::move(force_);
    sites_.nonconservative_force = std::move(open_);
  }
  KeptForces(const KeptForces&) = delete;
  KeptForces& operator=(const KeptForces&) = delete;

 private:
  Sites& sites_;
  AlignedVector<Vec3> force_, open_;
};

/// Takes what forces have across a plane away.
void keep_in_plane(const Plane& plane, Sites& sites);
/// Adds the forces of one law at the present positions and velocities, at an instant; gives its energy [J] where it has one
/// and that is asked for, else 0.
double run_law(const World& world, Forces& forces, ActingElement& acting, const Instant& instant,
               bool with_energy = false);
/// Adds the forces of the laws that do not depend on velocities; gives the energy [J] of those that have one where it is
/// asked for.
double run_laws(const World& world, Forces& forces, const Instant& instant, bool with_energy);

/// The forces of those that do not depend on velocities, at the present positions.
double run_still_laws(const World& world, Forces& forces, const Instant& instant, bool with_energy);
/// Sums what sites feel over the receivers that they are bound to.
void collect(const World& world, Forces& forces);
}  // namespace pantin
