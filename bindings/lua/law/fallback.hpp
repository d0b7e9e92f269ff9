#pragma once
// A law that cannot be traced: its function is called for every pair or particle, with plain numbers; only a potential
// gets numbers that carry derivatives, so that its force is exact.
#include <optional>
#include <string>
#include <vector>

#include "lua/law/law_run.hpp"

namespace pantin::lua {

class CalledLaw final : public Called {
 public:
  explicit CalledLaw(LawFunction law) : law_(std::move(law)) {}

  /// Outputs are the forces and, where there is one column more, the energy of a potential. Errors of the function, and
  /// results that are no finite numbers, throw Error with the law's line and what was seen.
  void run(const Block& block) override;
  /// Tries each by itself. Outputs may be anything; where the function failed the message is given, else "".
  std::vector<std::string> try_each(const Block& block);

  /// Columns that a block must have: all that the law may see.
  std::vector<Input> inputs_wanted() const;
  /// Columns of outputs without the energy.
  std::size_t forces() const;

  const LawFunction& law() const { return law_; }
  int noises = 16;          ///< columns of noise that are wanted
  bool reads_time = false;  ///< of the scene
  std::string reads;        ///< a field of a thing, "position"; empty where it has read none yet

 private:
  class Calls;
  LawFunction law_;
};

}  // namespace pantin::lua
