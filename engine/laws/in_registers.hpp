#pragma once
// From a program's instructions to code of the processor (x86-64 with AVX2), four values at a time. For what makes such
// code alone.
#if defined(__x86_64__) && defined(__AVX2__)
#define PANTIN_MACHINE_CODE 1

#include <xbyak/xbyak.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "laws/program.hpp"

namespace pantin {

/// Where code is written to, and run from once `finish` was called: pages are never both.
class CodeWriter : public Xbyak::CodeGenerator {
 public:
  /// `size`: the most bytes.
  explicit CodeWriter(std::size_t size) : CodeGenerator(size, Xbyak::DontSetProtectRWE) {}

  /// Four times a number, in memory.
  Xbyak::Address number(double x);
  /// Writes the numbers; then the code can run. Throws Xbyak::Error where the system refuses.
  void finish();

 private:
  std::map<std::uint64_t, Xbyak::Label> numbers_;  // by their bits
};

/// Whether such code may be made, and what went wrong when it was.
bool may_write_code();
void note_refusal(const Xbyak::Error& error);

/// make(), or null where code is not to be made or was refused.
template <class Make>
auto code_or_null(Make make) -> decltype(make()) {
  if (!may_write_code()) return nullptr;
  try {
    return make();
  } catch (const Xbyak::Error& error) {
    note_refusal(error);
    return nullptr;
  }
}

/// One run of a program for four values, in registers. Those that do not fit wait in the frame: 32 bytes at rsp for each
/// slot. A call leaves none of the registers of values as they were; rax is used, too.
class InRegisters {
 public:
  using Register = Xbyak::Ymm;
  /// Writes code that loads an input or a uniform value.
  using Load = std::function<void(std::int32_t slot, const Register& to)>;

  static std::size_t most_bytes(const Program& program) { return 4096 + 320 * program.code.size(); }
  static std::uint32_t frame_bytes(const Program& program) { return 32 * static_cast<std::uint32_t>(program.slots); }
  static bool has_calls(const Program& program);
  /// Whether a slot's value is made by the code, not given to it: one of an input or a uniform value is.
  bool makes(std::int32_t slot) const { return !values_[static_cast<std::size_t>(slot)].is_loaded; }

  /// `registers`: it may use those from 0 on.
  InRegisters(CodeWriter& to, const Program& program, int registers, Load load);

  /// Calls each(number of the output, its register) at the end, one after the other.
  void write(const std::function<void(std::size_t output, const Register& value)>& each);

 private:
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  struct Value {
    int in = -1;             // register
    bool is_loaded = false;  // an input or a uniform value: may be loaded again
    bool in_frame = false;
    std::size_t next = never;  // instruction that reads it
  };
  /// Instructions that read the operands and the result of one next.
  struct Next {
    std::array<std::size_t, 3> operands{never, never, never};
    std::size_t result = never;
  };

  void find_next();
  Value& value(std::int32_t slot) { return values_[static_cast<std::size_t>(slot)]; }
  Xbyak::Address frame(std::int32_t slot) const { return to_.yword[to_.rsp + 32 * static_cast<std::size_t>(slot)]; }
  Register in_register(std::int32_t slot);
  Register free_register();
  void let_go(std::int32_t slot);
  void keep(std::int32_t slot);
  void write(const Instruction& i, const Next& next);
  void write_arithmetic(const Instruction& i, const Register& to);
  void write_choice(const Instruction& i, const Register& to);
  void write_call(const Instruction& i);

  CodeWriter& to_;
  const Program& program_;
  Load load_;
  std::vector<Value> values_;            // by slot
  std::vector<std::int32_t> registers_;  // slot in each, or -1
  std::vector<bool> locked_;             // registers of the present instruction
  std::vector<Next> next_;               // by instruction
};

}  // namespace pantin

#else

namespace pantin {

class CodeWriter {};

}  // namespace pantin

#endif
