#include "laws/program.hpp"

#include <algorithm>

#include "laws/lowering.hpp"

namespace pantin {

namespace {

std::vector<Slot*> operands(Instruction& instruction) {
  const bool index_in_c = instruction.operation == Operation::function && instruction.function == Function::spline;
  std::vector<Slot*> found;
  for (Slot* slot : {&instruction.a, &instruction.b, &instruction.c}) {
    if (*slot >= 0 && !(index_in_c && slot == &instruction.c)) found.push_back(slot);
  }
  return found;
}

// Puts the instructions in order, the uniform ones first, without those that nothing depends on.
void keep_live(const Lowering& lowering, Program& program) {
  std::vector<bool> live(lowering.slots(), false);
  for (Slot slot : lowering.outputs()) live[static_cast<std::size_t>(slot)] = true;
  std::vector<Instruction> kept;
  for (std::size_t i = lowering.code().size(); i-- > 0;) {
    Instruction instruction = lowering.code()[i];
    if (!live[static_cast<std::size_t>(instruction.to)]) continue;
    for (const Slot* slot : operands(instruction)) live[static_cast<std::size_t>(*slot)] = true;
    kept.push_back(instruction);
  }
  for (std::size_t i = kept.size(); i-- > 0;) {
    (lowering.is_uniform(kept[i].to) ? program.uniform : program.code).push_back(kept[i]);
  }
}

// Gives slots that are no longer read to later results. Inputs, outputs and uniform results keep theirs.
void reuse_slots(const Lowering& lowering, Program& program) {
  const auto inputs = lowering.inputs().size();
  std::vector<std::size_t> last(lowering.slots(), 0);
  for (std::size_t i = 0; i < program.code.size(); i++) {
    for (const Slot* slot : operands(program.code[i])) last[static_cast<std::size_t>(*slot)] = i;
  }
  for (Slot slot : lowering.outputs()) last[static_cast<std::size_t>(slot)] = program.code.size();
  std::vector<Slot> position(lowering.slots(), -1), free;
  auto next = static_cast<Slot>(inputs);
  for (std::size_t i = 0; i < inputs; i++) position[i] = static_cast<Slot>(i);
  const auto put = [&](Instruction& instruction, Slot to) {
    position[static_cast<std::size_t>(instruction.to)] = to;
    instruction.to = to;
  };
  for (Instruction& instruction : program.uniform) {
    for (Slot* slot : operands(instruction)) *slot = position[static_cast<std::size_t>(*slot)];
    put(instruction, next++);
  }
  for (std::size_t i = 0; i < program.code.size(); i++) {
    for (Slot* slot : operands(program.code[i])) {
      const auto old = static_cast<std::size_t>(*slot);
      *slot = position[old];
      if (last[old] != i || old < inputs || lowering.is_uniform(static_cast<Slot>(old))) continue;
      if (std::find(free.begin(), free.end(), *slot) == free.end()) free.push_back(*slot);
    }
    const Slot to = free.empty() ? next++ : free.back();
    if (!free.empty()) free.pop_back();
    put(program.code[i], to);
  }
  for (Slot slot : lowering.outputs()) program.outputs.push_back(position[static_cast<std::size_t>(slot)]);
  program.slots = next;
}

}  // namespace

Program lower(const Expressions& graph, std::span<const Expr> outputs, Uniform uniform) {
  const Lowering lowering(graph, outputs, uniform);
  Program program;
  program.inputs = lowering.inputs();
  program.splines = graph.splines();
  keep_live(lowering, program);
  reuse_slots(lowering, program);
  return program;
}

}  // namespace pantin
