#pragma once
// Running a law over given pairs, triples and quadruples of sites.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "laws/law.hpp"
#include "laws/run/answers.hpp"
#include "laws/run/pairs.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Connections of one law, in the order they were made.
struct BondList {
  int count = 2;                                ///< sites of each
  std::vector<std::uint32_t> sites;             ///< (count × connections) one connection after the other
  std::vector<std::vector<double>> parameters;  ///< (parameters of the law × connections), or empty: the same for all
  std::size_t size() const { return sites.size() / static_cast<std::size_t>(count); }
};

/// A law (central, pair, or of many) made ready for connections.
class Bonds {
 public:
  /// Throws Error where the law wants an attribute that is not among `names`.
  Bonds(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers);
  ~Bonds();
  Bonds(const Bonds&);
  Bonds(Bonds&&) noexcept;
  Bonds& operator=(Bonds&&) noexcept;

  /// Takes the connections over, sorted by their first sites: after every edit and whenever sites were put in another
  /// order.
  void arrange(const BondList& ties, const Sites& sites);
  std::size_t size() const;
  /// The number in BondList of the kth connection in the order in which they are gone through.
  std::size_t number(std::size_t k) const;

  /// Adds the forces to Sites::force, or to Sites::nonconservative_force for a law without energy; in a box along the shortest
  /// vectors. `parameters` count where connections have none of their own.
  void add_forces(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                  Workers& workers);
  double add_forces_and_energy(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                               Workers& workers);
  /// Lists the forces of a law of velocity with their derivatives, at Sites::v; tells whether they are linear in it.
  bool list_slopes(const Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                   std::vector<VelocityPair>& to) const;
  /// Tension [N] of a connection (its number in BondList) of a central law at the last evaluation, for sites where they
  /// were then; positive: it pulls. The first call after an evaluation works them out for all.
  double tension(std::size_t connection, const Sites& sites, const Box& box) const;
  /// The same over the distance, which may be 0, [N/m].
  double pull(std::size_t connection, const Sites& sites, const Box& box) const;
  /// The first connection whose force is not finite. Slow: for a message.
  std::optional<BadForce> find_bad(const Sites& sites, const Box& box, const Instant& instant,
                                   std::span<const double> parameters);

 private:
  struct Kernel;
  std::unique_ptr<Kernel> kernel_;
};

}  // namespace pantin
