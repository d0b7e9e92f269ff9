#pragma once
// Running a law over single sites.
#include "laws/run/law_on_sites.hpp"

namespace pantin {

class Fields final : public LawOnSites {
 public:
  /// Throws Error where the law wants an attribute that is not among `names`.
  Fields(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers);

  /// Takes the sites to act on: after every edit and whenever sites were put in another order.
  void arrange(std::span<const std::uint32_t> members);

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  std::size_t tasks(std::size_t phase) const override;
  Task task(std::size_t phase, std::size_t number) const override;
  std::unique_ptr<Block> make_block(LawBlock made) const override;
  void gather(Block& block, Task& task, const Sites& sites, const Box& box) const override;
  void scatter(const Block& block, const Sites& sites, Vec3* force) override;

  std::vector<std::uint32_t> members_;
};

}  // namespace pantin
