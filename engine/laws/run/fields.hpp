#pragma once
// Running a law over single sites.
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

/// A law of single particles made ready for some sites.
class Fields {
 public:
  /// Throws Error where the law wants an attribute that is not among `names`.
  Fields(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers);
  ~Fields();
  Fields(const Fields&);
  Fields(Fields&&) noexcept;
  Fields& operator=(Fields&&) noexcept;

  /// Takes the sites to act on: after every edit and whenever sites were put in another order.
  void arrange(std::span<const std::uint32_t> members);

  /// Adds the forces to Sites::force, or to Sites::nonconservative_force for a law without energy.
  void add_forces(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                  Workers& workers);
  double add_forces_and_energy(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                               Workers& workers);
  /// Adds the forces of a law of velocity and their derivatives, at Sites::v; tells whether they are linear in it.
  bool add_slopes(const Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                  Workers& workers, SiteSlopes& to);
  /// The first site whose force is not finite. Slow: for a message.
  std::optional<BadForce> find_bad(const Sites& sites, const Box& box, const Instant& instant,
                                   std::span<const double> parameters);

 private:
  struct Kernel;
  std::unique_ptr<Kernel> kernel_;
};

}  // namespace pantin
