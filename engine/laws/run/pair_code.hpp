#pragma once
// The law and both scatters of a block of pairs in one pass, as code of the processor.
#include <memory>

#include "laws/law.hpp"
#include "laws/machine_code.hpp"
#include "laws/run/pair_block.hpp"

namespace pantin {

class PairCode {
 public:
  /// Of a program that gives a law's force, or force and energy. Null where the law goes another way: it is not a traced
  /// central one that acts on both, sees more than distance, attributes, parameters and time, or calls functions; and where
  /// there is no such code.
  static std::shared_ptr<const PairCode> of(const Law& law, const Program& program);
  ~PairCode();

  /// Adds the forces of a block of pairs that were taken, and fills the column of energies where the program gives them.
  /// Attributes are read at the sites themselves.
  void run(const PairBlock& block, const Sites& sites, Vec3* force) const;

 private:
  struct Call;
  class Writer;
  explicit PairCode(const Program& program);

  std::unique_ptr<CodeWriter> pages_;
  void (*run_)(const Call& call) = nullptr;
};

}  // namespace pantin
