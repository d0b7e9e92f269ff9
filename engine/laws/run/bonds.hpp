#pragma once
// Running a law over given pairs, triples and quadruples of sites.
#include "laws/run/arranged.hpp"
#include "laws/run/law_on_sites.hpp"

namespace pantin {

/// A law (central, pair, or of many) made ready for connections; in a box it acts along the shortest vectors.
class Bonds final : public LawOnSites {
 public:
  /// Throws Error where the law wants an attribute that is not among `names`.
  Bonds(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers);

  /// Takes the connections over, sorted by their first sites: after every edit and whenever sites were put in another
  /// order.
  void arrange(const BondList& ties, const Sites& sites);
  std::size_t size() const { return bonds_.n; }
  /// The number in BondList of the kth connection in the order in which slopes are listed.
  std::size_t number(std::size_t k) const { return bonds_.connection[k]; }

  /// Tension [N] of a connection (its number in BondList) of a central law at the last evaluation, for sites where they
  /// were then; positive: it pulls. The first call after an evaluation works them out for all.
  double tension(std::size_t connection, const Sites& sites, const Box& box);
  /// The same over the distance, which may be 0, [N/m].
  double pull(std::size_t connection, const Sites& sites, const Box& box);

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  std::size_t phases() const override { return bonds_.phases.size(); }
  std::size_t tasks(std::size_t phase) const override { return bonds_.phases[phase].size(); }
  Task task(std::size_t phase, std::size_t number) const override;
  std::vector<Task> in_order() const override { return {{.at = 0, .end = bonds_.n}}; }
  bool is_small() const override { return bonds_.phases.size() < 2; }
  std::unique_ptr<Block> make_block(LawBlock made) const override;
  void gather(Block& block, Task& task, const Sites& sites, const Box& box) const override;
  void scatter(const Block& block, const Sites& sites, Vec3* force) override;
  std::size_t number(const Block& block, std::size_t k) const override { return number(block.first + k); }
  void keep_pulls(const Block& block);

  bool own_parameters_ = false;
  Arranged bonds_;
  AlignedVector<double> pull_;  // tension / distance at the last evaluation, by position
  double least2_ = 0.0;         // [m²]
};

}  // namespace pantin
