#pragma once
// Running a law over pairs of sites.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "laws/law.hpp"
#include "laws/run/answers.hpp"
#include "laws/run/neighbours.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Where a law gave a force that is not finite.
struct BadForce {
  std::uint32_t sites[4] = {};
  int count = 0;          ///< of sites
  double distance = 0.0;  ///< [m] of the first two
};

/// A law made ready for rows.
class Pairs {
 public:
  /// Throws Error where the law wants an attribute that is not among `names`.
  Pairs(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers);
  ~Pairs();
  Pairs(const Pairs&);
  Pairs(Pairs&&) noexcept;
  Pairs& operator=(Pairs&&) noexcept;

  /// Adds the forces to Sites::force, or to Sites::nonconservative_force for a law without energy. A one-sided law within one set
  /// acts both ways, with the roles exchanged.
  void add_forces(Sites& sites, const NeighbourList& rows, const Instant& instant, std::span<const double> parameters,
                  Workers& workers);
  /// The same, and gives the energy [J]; 0 for a law without.
  double add_forces_and_energy(Sites& sites, const NeighbourList& rows, const Instant& instant,
                               std::span<const double> parameters, Workers& workers);
  /// Lists the forces of a law of velocity with their derivatives, at Sites::v; tells whether they are linear in it.
  bool list_slopes(const Sites& sites, const NeighbourList& rows, const Instant& instant,
                   std::span<const double> parameters, std::vector<VelocityPair>& to);
  /// The first pair whose force is not finite. Slow: for a message.
  std::optional<BadForce> find_bad(const Sites& sites, const NeighbourList& rows, const Instant& instant,
                                   std::span<const double> parameters);

 private:
  struct Kernel;
  std::unique_ptr<Kernel> kernel_;
};

}  // namespace pantin
