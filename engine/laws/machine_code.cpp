#include "laws/machine_code.hpp"

#include <atomic>

#include "laws/in_registers.hpp"

namespace pantin {

namespace {

std::atomic<bool> machine_code_allowed{true}, pages_refused{false};

}  // namespace

void allow_machine_code(bool allowed) { machine_code_allowed = allowed; }
bool machine_code_refused() { return pages_refused; }

#ifdef PANTIN_MACHINE_CODE

bool may_write_code() { return machine_code_allowed && !pages_refused; }
void note_refusal(const Xbyak::Error& error) {
  if (error == Xbyak::ERR_CANT_PROTECT || error == Xbyak::ERR_CANT_ALLOC) pages_refused = true;
}

namespace {

/// Calls that are made of it give whole columns.
class OverColumns final : public CodeWriter {
 public:
  explicit OverColumns(const Program& program) : CodeWriter(InRegisters::most_bytes(program)) {
    const Xbyak::Reg64 &columns = rbx, &at = r12, &end = r13, &column = rax;
    for (const Xbyak::Reg64& each : {rbp, rbx, r12, r13}) push(each);
    mov(rbp, rsp);
    sub(rsp, InRegisters::frame_bytes(program));
    and_(rsp, ~31u);
    mov(columns, rdi);
    mov(end, rsi);
    shl(end, 3);
    xor_(at, at);
    const auto address = [&](std::int32_t slot) {
      mov(column, ptr[columns + 8 * static_cast<std::size_t>(slot)]);
      return yword[column + at];
    };
    Xbyak::Label next, over;
    cmp(at, end);
    jge(over, T_NEAR);
    L(next);
    InRegisters law(*this, program, 16, [&](std::int32_t slot, const Xbyak::Ymm& to) { vmovupd(to, address(slot)); });
    law.write([&](std::size_t output, const Xbyak::Ymm& value) {
      const std::int32_t slot = program.outputs[output];
      if (law.makes(slot)) vmovupd(address(slot), value);
    });
    add(at, 32);
    cmp(at, end);
    jl(next, T_NEAR);
    L(over);
    vzeroupper();
    mov(rsp, rbp);
    for (const Xbyak::Reg64& each : {r13, r12, rbx, rbp}) pop(each);
    ret();
    finish();
  }
};

}  // namespace

MachineCode::MachineCode(const Program& program)
    : pages_(std::make_unique<OverColumns>(program)), splines_(program.splines) {
  run_ = pages_->getCode<void (*)(double* const*, std::int64_t)>();
}

std::shared_ptr<const MachineCode> MachineCode::of(const Program& program) {
  return code_or_null([&] { return std::shared_ptr<const MachineCode>(new MachineCode(program)); });
}

#else

MachineCode::MachineCode(const Program&) {}
std::shared_ptr<const MachineCode> MachineCode::of(const Program&) { return nullptr; }

#endif

MachineCode::~MachineCode() = default;

}  // namespace pantin
