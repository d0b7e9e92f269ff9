#include "laws/in_registers.hpp"

#ifdef PANTIN_MACHINE_CODE

#include <immintrin.h>
#include <sleef.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/check.hpp"

namespace pantin {

namespace {

using Four = __m256d;

/// What is called for a function, of four values or of two times four; or null.
const void* called(Function f) {
  const auto at = [](auto* function) { return reinterpret_cast<const void*>(function); };
  switch (f) {
    case Function::exp: return at(Sleef_cinz_expd4_u10avx);
    case Function::log: return at(Sleef_cinz_logd4_u10avx);
    case Function::sin: return at(Sleef_cinz_sind4_u10avx);
    case Function::cos: return at(Sleef_cinz_cosd4_u10avx);
    case Function::tan: return at(Sleef_cinz_tand4_u10avx);
    case Function::asin: return at(Sleef_cinz_asind4_u10avx);
    case Function::acos: return at(Sleef_cinz_acosd4_u10avx);
    case Function::atan: return at(Sleef_cinz_atand4_u10avx);
    case Function::atan2: return at(Sleef_cinz_atan2d4_u10avx);
    case Function::sinh: return at(Sleef_cinz_sinhd4_u10avx);
    case Function::cosh: return at(Sleef_cinz_coshd4_u10avx);
    case Function::tanh: return at(Sleef_cinz_tanhd4_u10avx);
    case Function::power: return at(Sleef_cinz_powd4_u10avx);
    default: return nullptr;
  }
}

Four spline_of_four(Four x, const Spline* spline, int order) {
  for (int k = 0; k < 4; k++) x[k] = spline->evaluate(x[k], order);
  return x;
}

bool is_call(const Instruction& i) {
  return i.operation == Operation::function && (i.function == Function::spline || called(i.function) != nullptr);
}

/// The slots that an instruction reads, -1 where there is none.
std::array<std::int32_t, 3> operands(const Instruction& i) {
  const bool index_in_c = i.operation == Operation::function && i.function == Function::spline;
  return {i.a, i.b, index_in_c ? -1 : i.c};
}

}  // namespace

Xbyak::Address CodeWriter::number(double x) { return yword[rip + numbers_[std::bit_cast<std::uint64_t>(x)]]; }

void CodeWriter::finish() {
  align(32);
  for (auto& [bits, label] : numbers_) {
    L(label);
    for (int k = 0; k < 4; k++) dq(bits);
  }
  setProtectModeRE();
}

InRegisters::InRegisters(CodeWriter& to, const Program& program, int registers, Load load)
    : to_(to),
      program_(program),
      load_(std::move(load)),
      values_(static_cast<std::size_t>(program.slots)),
      registers_(static_cast<std::size_t>(registers), -1),
      locked_(registers_.size(), false),
      next_(program.code.size()) {
  for (std::size_t slot = 0; slot < program.inputs.size(); slot++) values_[slot].is_loaded = true;
  for (const Instruction& i : program.uniform) value(i.to).is_loaded = true;
  find_next();
}

bool InRegisters::has_calls(const Program& program) {
  return std::any_of(program.code.begin(), program.code.end(), is_call);
}

void InRegisters::find_next() {
  for (const std::int32_t slot : program_.outputs) value(slot).next = program_.code.size();
  for (std::size_t k = program_.code.size(); k-- > 0;) {
    const Instruction& i = program_.code[k];
    next_[k].result = value(i.to).next;
    value(i.to).next = never;
    const std::array<std::int32_t, 3> reads = operands(i);
    for (std::size_t o = 0; o < 3; o++)
      if (reads[o] >= 0) next_[k].operands[o] = value(reads[o]).next;
    for (const std::int32_t slot : reads)
      if (slot >= 0) value(slot).next = k;
  }
}

void InRegisters::let_go(std::int32_t slot) {
  if (value(slot).in >= 0) registers_[static_cast<std::size_t>(value(slot).in)] = -1;
  value(slot).in = -1;
}

/// Puts it into the frame, unless it can be had again.
void InRegisters::keep(std::int32_t slot) {
  Value& v = value(slot);
  if (v.is_loaded || v.in_frame) return;
  to_.vmovapd(frame(slot), Register(v.in));
  v.in_frame = true;
}

InRegisters::Register InRegisters::free_register() {
  std::size_t best = registers_.size(), latest = 0;
  for (std::size_t r = 0; r < registers_.size(); r++) {
    if (locked_[r]) continue;
    const std::size_t next = registers_[r] < 0 ? never : value(registers_[r]).next;
    if (best < registers_.size() && next <= latest) continue;
    best = r;
    latest = next;
  }
  assume(best < registers_.size());
  if (const std::int32_t slot = registers_[best]; slot >= 0) {
    keep(slot);
    let_go(slot);
  }
  locked_[best] = true;
  return Register(static_cast<int>(best));
}

InRegisters::Register InRegisters::in_register(std::int32_t slot) {
  Value& v = value(slot);
  if (v.in < 0) {
    const Register to = free_register();
    if (v.is_loaded)
      load_(slot, to);
    else
      to_.vmovapd(to, frame(slot));
    v.in = to.getIdx();
    registers_[static_cast<std::size_t>(v.in)] = slot;
  }
  locked_[static_cast<std::size_t>(v.in)] = true;
  return Register(v.in);
}

void InRegisters::write_arithmetic(const Instruction& i, const Register& to) {
  const auto a = [&] { return in_register(i.a); };
  const auto b = [&] { return in_register(i.b); };
  const auto c = [&] { return in_register(i.c); };
  const auto x = [&] { return to_.number(i.x); };
  switch (i.operation) {
    case Operation::multiply: return to_.vmulpd(to, a(), b());
    case Operation::multiply_number: return to_.vmulpd(to, a(), x());
    case Operation::add: return to_.vaddpd(to, a(), b());
    case Operation::add_number: return to_.vaddpd(to, a(), x());
    case Operation::subtract: return to_.vsubpd(to, a(), b());
    case Operation::multiply_add: to_.vmulpd(to, a(), b()); return to_.vaddpd(to, to, c());
    case Operation::multiply_number_add: to_.vmulpd(to, a(), x()); return to_.vaddpd(to, to, b());
    case Operation::multiply_add_number: to_.vmulpd(to, a(), b()); return to_.vaddpd(to, to, x());
    case Operation::multiply_number_add_number: to_.vmulpd(to, a(), x()); return to_.vaddpd(to, to, to_.number(i.y));
    case Operation::reciprocal: to_.vmovapd(to, to_.number(1.0)); return to_.vdivpd(to, to, a());
    case Operation::square: return to_.vmulpd(to, a(), a());
    case Operation::divide: return to_.vdivpd(to, a(), b());
    case Operation::set: return to_.vmovapd(to, x());
    case Operation::square_root: return to_.vsqrtpd(to, a());
    case Operation::function: assume(false);
  }
}

/// Functions that are an instruction or two.
void InRegisters::write_choice(const Instruction& i, const Register& to) {
  constexpr std::uint8_t less = 17, less_or_equal = 18, not_equal = 4;  // of vcmppd; these are quiet
  constexpr std::uint8_t down = 9;                                      // of vroundpd
  const auto a = [&] { return in_register(i.a); };
  const auto b = [&] { return in_register(i.b); };
  switch (i.function) {
    case Function::minimum: return to_.vminpd(to, b(), a());
    case Function::maximum: return to_.vmaxpd(to, b(), a());
    case Function::less:
    case Function::less_or_equal:
      to_.vcmppd(to, a(), b(), i.function == Function::less ? less : less_or_equal);
      return to_.vandpd(to, to, to_.number(1.0));
    case Function::select:
      to_.vcmppd(to, a(), to_.number(0.0), not_equal);
      return to_.vblendvpd(to, in_register(i.c), b(), to);
    case Function::abs: return to_.vandpd(to, a(), to_.number(std::bit_cast<double>(0x7fffffffffffffff)));
    case Function::floor: return to_.vroundpd(to, a(), down);
    default: assume(false);
  }
}

void InRegisters::write_call(const Instruction& i) {
  const Register first(0), second(1);
  const Register a = in_register(i.a), b = i.b < 0 ? a : in_register(i.b);
  for (const std::int32_t slot : registers_)
    if (slot >= 0 && value(slot).next != never) keep(slot);
  if (i.b >= 0 && a.getIdx() == 1) {
    const Register spare(b.getIdx() == 2 ? 3 : 2);
    to_.vmovapd(spare, a);
    if (b.getIdx() != 1) to_.vmovapd(second, b);
    to_.vmovapd(first, spare);
  } else {
    if (i.b >= 0 && b.getIdx() != 1) to_.vmovapd(second, b);
    if (a.getIdx() != 0) to_.vmovapd(first, a);
  }
  if (i.function == Function::spline) {
    to_.mov(to_.rdi, reinterpret_cast<std::size_t>(program_.splines[static_cast<std::size_t>(i.c)].get()));
    to_.mov(to_.esi, static_cast<std::uint32_t>(static_cast<std::int32_t>(i.x)));
    to_.mov(to_.rax, reinterpret_cast<std::size_t>(&spline_of_four));
  } else {
    to_.mov(to_.rax, reinterpret_cast<std::size_t>(called(i.function)));
  }
  to_.call(to_.rax);
  for (Value& v : values_) v.in = -1;
  std::fill(registers_.begin(), registers_.end(), -1);
}

void InRegisters::write(const Instruction& i, const Next& next) {
  std::fill(locked_.begin(), locked_.end(), false);
  const std::array<std::int32_t, 3> reads = operands(i);
  for (const std::int32_t slot : reads)
    if (slot >= 0) in_register(slot);
  for (std::size_t o = 0; o < 3; o++)
    if (reads[o] >= 0) value(reads[o]).next = reads[o] == i.to ? never : next.operands[o];
  int result = 0;
  if (is_call(i)) {
    write_call(i);
  } else {
    const Register to = free_register();
    result = to.getIdx();
    if (i.operation == Operation::function)
      write_choice(i, to);
    else
      write_arithmetic(i, to);
    for (const std::int32_t slot : reads)
      if (slot >= 0 && value(slot).next == never) let_go(slot);
  }
  value(i.to) = {result, false, false, next.result};
  registers_[static_cast<std::size_t>(result)] = i.to;
}

void InRegisters::write(const std::function<void(std::size_t output, const Register& value)>& each) {
  for (std::size_t k = 0; k < program_.code.size(); k++) write(program_.code[k], next_[k]);
  for (std::size_t output = 0; output < program_.outputs.size(); output++) {
    std::fill(locked_.begin(), locked_.end(), false);
    each(output, in_register(program_.outputs[output]));
  }
}

}  // namespace pantin

#endif
