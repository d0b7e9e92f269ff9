#pragma once
// Programs as code of the processor, whose values stay in its registers. The bits are those of the kernels.
#include <memory>

#include "laws/program.hpp"

namespace pantin {

/// Whether programs become code of the processor from now on, where it can run such code; true at the start. For tests.
void allow_machine_code(bool allowed);
/// Whether the system refused pages that are run: programs then go on without.
bool machine_code_refused();

/// Owns pages of code.
class CodeWriter;

class MachineCode {
 public:
  /// Null where there is none: of another processor, refused, or not allowed.
  static std::shared_ptr<const MachineCode> of(const Program& program);
  ~MachineCode();

  /// Does what Program::code does to the first n values, and up to the next multiple of 4: reads the columns of inputs and
  /// uniform results, and writes those of outputs alone. `columns`: by slot.
  void run(double* const* columns, int n) const { run_(columns, n); }

 private:
  explicit MachineCode(const Program& program);

  std::unique_ptr<CodeWriter> pages_;
  std::vector<std::shared_ptr<const Spline>> splines_;
  void (*run_)(double* const* columns, std::int64_t n) = nullptr;
};

}  // namespace pantin
