#pragma once
// Running a law over pairs of sites.
#include "laws/run/law_on_sites.hpp"
#include "laws/run/neighbours.hpp"

namespace pantin {

/// Of neighbours. A one-sided law within one set acts both ways, with the roles exchanged.
class Pairs final : public LawOnSites {
 public:
  /// Throws Error where the law wants an attribute that is not among `names`.
  Pairs(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers);

  NeighbourList neighbours;

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  std::size_t phases() const override { return neighbours.phases().size(); }
  std::size_t tasks(std::size_t phase) const override { return neighbours.phases()[phase].size(); }
  Task task(std::size_t phase, std::size_t number) const override;
  bool is_small() const override;
  std::unique_ptr<Block> make_block(LawBlock made) const override;
  void speed_up(Blocks& blocks, const Program& program) const override;
  void gather(Block& block, Task& task, const Sites& sites, const Box& box) const override;
  void scatter(const Block& block, const Sites& sites, Vec3* force) override;

  std::size_t radius_ = 0;  // column of a touching law
};

}  // namespace pantin
