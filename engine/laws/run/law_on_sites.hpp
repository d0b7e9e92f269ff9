#pragma once
// Running a law over what it acts on: pairs of sites, connections or single sites. These say how their sites are found and
// forces are given back; all else is the same for them.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/compensated.hpp"
#include "base/parallel.hpp"
#include "laws/law.hpp"
#include "laws/run/answers.hpp"
#include "laws/run/block.hpp"

namespace pantin {

/// Where a law gave a force that is not finite.
struct BadForce {
  std::uint32_t sites[4] = {};
  int count = 0;          ///< of sites
  double distance = 0.0;  ///< [m] of the first two
};

/// A law made ready to act. Virtual functions are called for tasks and blocks, never for one pair.
class LawOnSites {
 public:
  virtual ~LawOnSites();

  /// Adds the forces to Sites::force, or to Sites::nonconservative_force for a law without energy. `parameters` count where
  /// connections have none of their own.
  void add_forces(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                  Workers& workers);
  /// The same, and gives the energy [J]; 0 for a law without.
  double add_forces_and_energy(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                               Workers& workers);
  /// Gives the forces of a law of velocity with their derivatives, at Sites::v; tells whether they are linear in it. Those
  /// of a law of single sites are added to `on_sites`, others listed in `pairs`.
  bool add_slopes(const Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                  Workers& workers, SiteSlopes& on_sites, std::vector<VelocityPair>& pairs);
  /// What comes first of that whose force is not finite. Slow: for a message.
  std::optional<BadForce> find_bad(const Sites& sites, const Box& box, const Instant& instant,
                                   std::span<const double> parameters) const;

 protected:
  using Blocks = std::vector<std::unique_ptr<Block>>;

  /// What was asked for last.
  struct Asked {
    Instant instant;
    std::vector<double> parameters;
    bool with_energy = false, is_new = false;
  };

  /// Call `make_blocks` then, which throws Error where the law wants an attribute that is not among `names`.
  LawOnSites(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers);
  LawOnSites(const LawOnSites& other);  ///< makes blocks of its own when it runs
  LawOnSites(LawOnSites&&) noexcept;
  LawOnSites& operator=(LawOnSites&&) noexcept;

  const Law& law() const { return *law_; }
  void make_blocks();
  /// They are to be made anew; `own_parameters`: each connection has its own.
  void drop_blocks(bool own_parameters);
  Blocks& blocks(bool with_energy);
  const AlignedVector<Vec3>& force_of(const Sites& sites) const {
    return law_->has_energy() ? sites.force : sites.nonconservative_force;
  }
  /// Gathers, runs and calls each(block), block by block.
  template <class Each>
  void each_block(Block& block, Task task, const Sites& sites, const Box& box, Each each) const {
    while (task.at < task.end || task.exchange) {
      gather(block, task, sites, box);
      if (!block.in_one_pass) block.law.run(block.count, sites);
      each(block);
    }
  }

  /// Tasks of one phase touch no site in common; the phases follow each other.
  virtual std::size_t phases() const { return 1; }
  virtual std::size_t tasks(std::size_t phase) const = 0;
  virtual Task task(std::size_t phase, std::size_t number) const = 0;
  /// All, as slopes are listed.
  virtual std::vector<Task> in_order() const;
  virtual bool is_small() const { return false; }  ///< not worth sharing out
  virtual std::unique_ptr<Block> make_block(LawBlock made) const = 0;
  /// Has blocks that were made for this program go about it another way, where that is faster.
  virtual void speed_up(Blocks& /*blocks*/, const Program& /*program*/) const {}
  /// Fills a block with what comes next.
  virtual void gather(Block& block, Task& task, const Sites& sites, const Box& box) const = 0;
  virtual void scatter(const Block& block, const Sites& sites, Vec3* force) = 0;
  /// By which the first of a block's is found.
  virtual std::size_t number(const Block& /*block*/, std::size_t /*k*/) const { return 0; }

  Asked asked_;

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  double add(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters, Workers& workers,
             bool with_energy);
  void make_sloped();
  CompensatedSum add_task(Block& block, const Task& task, Sites& sites, const Box& box);
  template <class Use>
  void share_out(Blocks& blocks, const Instant& instant, std::span<const double> parameters, Workers& workers, Use use);

  std::shared_ptr<const Law> law_;
  std::vector<std::string> names_;
  std::size_t workers_ = 1;
  Uniform uniform_;
  Blocks plain_, energetic_;              // one for each worker, once it is to run
  Blocks sloped_;                         // of a law of velocity, once its derivatives are asked for
  bool linear_ = false;                   // in velocity
  std::vector<CompensatedSum> energies_;  // of tasks
};

}  // namespace pantin
