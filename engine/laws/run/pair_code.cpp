#include "laws/run/pair_code.hpp"

#include <algorithm>
#include <cstddef>

#include "laws/in_registers.hpp"

namespace pantin {

struct PairCode::Call {
  const PairBlock::Part *part, *end;
  const std::uint32_t* neighbour;
  const Vec3* x;
  Vec3* force;
  double* const* columns;  // by slot; those of attributes hold all sites
};

#ifdef PANTIN_MACHINE_CODE

namespace {

bool is_of_one_pass(const Law& law, const Program& program) {
  if (law.kind != LawKind::central || law.called || law.one_sided || InRegisters::has_calls(program)) return false;
  const auto is_given = [&](std::int32_t slot) { return static_cast<std::size_t>(slot) < program.inputs.size(); };
  const auto is_known = [](const Input& input) {
    return input.role == Role::distance2 || input.role == Role::attribute || input.role == Role::parameter ||
           input.role == Role::time;
  };
  return std::none_of(program.outputs.begin(), program.outputs.end(), is_given) &&
         std::all_of(program.inputs.begin(), program.inputs.end(), is_known);
}

}  // namespace

class PairCode::Writer final : public CodeWriter {
 public:
  explicit Writer(const Program& program) : CodeWriter(2 * InRegisters::most_bytes(program)), program_(program) {
    const Xbyak::Reg64 saved[] = {rbp, rbx, r12, r13, r14, r15};
    for (const Xbyak::Reg64& each : saved) push(each);
    mov(rbp, rsp);
    sub(rsp, InRegisters::frame_bytes(program) + 32 * static_cast<std::uint32_t>(program.inputs.size()));
    and_(rsp, ~31u);
    mov(part_, field(offsetof(Call, part)));
    mov(neighbour_, field(offsetof(Call, neighbour)));
    mov(x_, field(offsetof(Call, x)));
    mov(force_, field(offsetof(Call, force)));
    mov(columns_, field(offsetof(Call, columns)));
    xor_(at_, at_);
    Xbyak::Label next, over;
    L(next);
    cmp(part_, field(offsetof(Call, end)));
    jae(over, T_NEAR);
    write_part();
    add(part_, sizeof(PairBlock::Part));
    jmp(next, T_NEAR);
    L(over);
    vzeroupper();
    mov(rsp, rbp);
    for (std::size_t k = std::size(saved); k-- > 0;) pop(saved[k]);
    ret();
    write_lanes();
    finish();
  }

 private:
  static constexpr int registers = 11;  // of the law

  Xbyak::Address field(std::size_t offset) const { return ptr[rdi + offset]; }
  Xbyak::Address of_part(std::size_t offset) const { return ptr[part_ + offset]; }
  /// Where an attribute of the part's site is.
  Xbyak::Address of_site(std::size_t slot) const { return yword[rsp + InRegisters::frame_bytes(program_) + 32 * slot]; }

  /// Four pairs after the other: the law of the next is worked out before the forces of these are added, so that nothing
  /// waits for it. Which of the last four are of the part takes no branch: nobody could guess it.
  void write_part() {
    Xbyak::Label next, last, over;
    vmovapd(from_, of_part(offsetof(PairBlock::Part, from)));
    vxorpd(sums_[0], sums_[0], sums_[0]);
    vxorpd(sums_[1], sums_[1], sums_[1]);
    write_attributes_of_site();
    mov(ecx, of_part(offsetof(PairBlock::Part, count)));
    sub(ecx, 1);
    jl(over, T_NEAR);
    mov(edx, ecx);
    and_(edx, 3);
    vmovapd(pull_, write_law(0));
    shr(ecx, 2);
    jz(last, T_NEAR);
    L(next);
    add(at_, 32);
    const Xbyak::Ymm next_pull = write_law(16);
    scatter(next_pull.getIdx());
    vmovapd(pull_, next_pull);
    add(neighbour_, 16);
    dec(ecx);
    jnz(next, T_NEAR);
    L(last);
    lea(rax, ptr[rip + lanes_]);
    shl(edx, 5);
    vandpd(pull_, pull_, ptr[rax + rdx]);
    scatter(registers);
    shr(edx, 3);
    lea(neighbour_, ptr[neighbour_ + rdx + 4]);
    lea(at_, ptr[at_ + rdx * 2 + 8]);
    L(over);
    vaddpd(ymm0, sums_[0], sums_[1]);
    mov(eax, of_part(offsetof(PairBlock::Part, site)));
    shl(rax, 5);
    vmovapd(ymm1, ptr[force_ + rax]);
    vsubpd(ymm1, ymm1, ymm0);
    vmovapd(ptr[force_ + rax], ymm1);
  }

  void write_attributes_of_site() {
    mov(eax, of_part(offsetof(PairBlock::Part, site)));
    for (std::size_t slot = 0; slot < program_.inputs.size(); slot++) {
      if (program_.inputs[slot].role != Role::attribute || program_.inputs[slot].who != 0) continue;
      mov(rdx, ptr[columns_ + 8 * slot]);
      vbroadcastsd(ymm0, ptr[rdx + rax * 8]);
      vmovapd(of_site(slot), ymm0);
    }
  }

  /// The first lane alone, the first two, three, all.
  void write_lanes() {
    align(32);
    L(lanes_);
    for (int last = 0; last < 4; last++)
      for (int lane = 0; lane < 4; lane++) dq(lane <= last ? ~std::uint64_t{0} : 0);
  }

  /// Works out force over distance of four pairs, those that are so many bytes of neighbours ahead; says where it is then.
  Xbyak::Ymm write_law(std::size_t ahead) {
    Xbyak::Ymm pull = ymm0;
    const auto is_of_neighbour = [](const Input& input) { return input.role == Role::attribute && input.who != 0; };
    if (std::any_of(program_.inputs.begin(), program_.inputs.end(), is_of_neighbour)) find_others(ahead);
    InRegisters law(*this, program_, registers, [&](std::int32_t slot, const Xbyak::Ymm& to) { load(slot, to); });
    law.write([&](std::size_t output, const Xbyak::Ymm& value) {
      if (output == 0) pull = value;
      if (output == 0 || !law.makes(program_.outputs[output])) return;
      mov(rax, ptr[columns_ + 8 * static_cast<std::size_t>(program_.outputs[output])]);
      vmovupd(ptr[rax + at_], value);
    });
    return pull;
  }

  void find_others(std::size_t ahead) {
    for (std::size_t lane = 0; lane < 4; lane++) mov(others_[lane].cvt32(), ptr[neighbour_ + ahead + 4 * lane]);
  }

  void load(std::int32_t slot, const Xbyak::Ymm& to) {
    const auto number = static_cast<std::size_t>(slot);
    const Input* input = number < program_.inputs.size() ? &program_.inputs[number] : nullptr;
    if (input != nullptr && input->role == Role::attribute && input->who == 0) return vmovapd(to, of_site(number));
    mov(rax, ptr[columns_ + 8 * number]);
    if (input == nullptr || input->role == Role::parameter || input->role == Role::time) return vmovupd(to, ptr[rax]);
    if (input->role == Role::distance2) return vmovupd(to, ptr[rax + at_]);
    const Xbyak::Xmm low(to.getIdx());
    vmovsd(high_, ptr[rax + others_[2] * 8]);
    vmovhpd(high_, high_, ptr[rax + others_[3] * 8]);
    vmovsd(low, ptr[rax + others_[0] * 8]);
    vmovhpd(low, low, ptr[rax + others_[1] * 8]);
    vinsertf128(to, to, high_, 1);
  }

  /// Adds the forces of four pairs to both sites. Leaves one register of the law as it is.
  void scatter(int but) {
    find_others(0);
    const Xbyak::Ymm pull(but < 2 ? 2 : 0), force(but < 2 ? 3 : 1);
    for (int lane = 0; lane < 4; lane++) {
      const Xbyak::Reg64& other = others_[static_cast<std::size_t>(lane)];
      shl(other, 5);
      if (lane == 0)
        vbroadcastsd(pull, Xbyak::Xmm(pull_.getIdx()));
      else
        vpermpd(pull, pull_, static_cast<std::uint8_t>(0x55 * lane));
      vsubpd(force, from_, ptr[x_ + other]);
      vmulpd(force, force, pull);
      const Xbyak::Ymm& sum = sums_[static_cast<std::size_t>(lane % 2)];
      vaddpd(sum, sum, force);
      vaddpd(force, force, ptr[force_ + other]);
      vmovapd(ptr[force_ + other], force);
    }
  }

  const Program& program_;
  const Xbyak::Reg64 part_ = rbx, neighbour_ = r12, at_ = r13, x_ = r14, force_ = r15, columns_ = rsi;
  const std::array<Xbyak::Reg64, 4> others_{r8, r9, r10, r11};
  const Xbyak::Ymm from_ = ymm15;
  const std::array<Xbyak::Ymm, 2> sums_{ymm13, ymm14};
  const Xbyak::Xmm high_ = xmm11;
  const Xbyak::Ymm pull_ = ymm12;
  Xbyak::Label lanes_;
};

PairCode::PairCode(const Program& program) : pages_(std::make_unique<Writer>(program)) {
  run_ = pages_->getCode<void (*)(const Call&)>();
}

std::shared_ptr<const PairCode> PairCode::of(const Law& law, const Program& program) {
  if (!is_of_one_pass(law, program)) return nullptr;
  return code_or_null([&] { return std::shared_ptr<const PairCode>(new PairCode(program)); });
}

#else

PairCode::PairCode(const Program&) {}
std::shared_ptr<const PairCode> PairCode::of(const Law&, const Program&) { return nullptr; }

#endif

PairCode::~PairCode() = default;

void PairCode::run(const PairBlock& block, const Sites& sites, Vec3* force) const {
  const PairBlock::Part* const parts = block.parts.data();
  run_({parts, parts + block.part_count, block.neighbours.data(), sites.x.data(), force, block.law.columns()});
}

}  // namespace pantin
