#include "laws/check_read.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"

namespace pantin {

namespace {

void sound_law(bool good) { require(good, "a law in it contradicts itself"); }

std::size_t arguments_of(Function f) {
  switch (f) {
    case Function::atan2:
    case Function::power:
    case Function::minimum:
    case Function::maximum:
    case Function::less:
    case Function::less_or_equal: return 2;
    case Function::select: return 3;
    default: return 1;
  }
}

void check_input(const Input& input, int particles) {
  sound_law(input.who < particles && (input.component < 3 || input.role == Role::noise));
}

/// A node leads to nodes before it alone.
void check_node(const Law& law, Expr e) {
  using Kind = Expressions::Kind;
  const Expressions& graph = law.graph;
  const Expressions::Node& node = graph[e];
  sound_law(std::all_of(node.terms.begin(), node.terms.end(), [&](auto& t) { return t.first >= 0 && t.first < e; }));
  if (node.kind == Kind::product)
    sound_law(std::all_of(node.terms.begin(), node.terms.end(),
                          [](auto& t) { return std::isfinite(t.second) && t.second != 0.0; }));
  if (node.kind == Kind::input) sound_law(node.index < graph.inputs().size());
  if (node.kind != Kind::function) return sound_law(node.terms.empty() || node.kind >= Kind::sum);
  sound_law(node.terms.size() == arguments_of(node.function));
  if (node.function != Function::spline) return;
  sound_law(node.index < graph.splines().size() && graph.splines()[node.index] && node.value >= -1.0 &&
            node.value <= 3.0 && node.value == static_cast<int>(node.value));
}

/// How many numbers an operation reads, of a, b and c.
std::size_t operands_of(const Instruction& i) {
  switch (i.operation) {
    case Operation::multiply:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply_number_add:
    case Operation::multiply_add_number:
    case Operation::divide: return 2;
    case Operation::multiply_add: return 3;
    case Operation::set: return 0;
    case Operation::function: return arguments_of(i.function);
    default: return 1;
  }
}

}  // namespace

void check_read(const Law& law) {
  const bool pair = law.kind == LawKind::central || law.kind == LawKind::pair;
  sound_law(law.count >= 1 && law.count <= 4 && (!pair || law.count == 2) &&
            (law.kind != LawKind::point || law.count == 1));
  const auto size = static_cast<Expr>(law.graph.size());
  for (Expr e = 0; e < size; e++) check_node(law, e);
  for (const std::vector<Input>* list : {&law.graph.inputs(), &law.inputs_wanted})
    for (const Input& input : *list) {
      check_input(input, law.count);
      sound_law(input.role != Role::parameter || std::any_of(law.parameters.begin(), law.parameters.end(),
                                                             [&](auto& p) { return p.name == input.name; }));
    }
  const auto is_node = [&](Expr e) { return e >= 0 && e < size; };
  const std::size_t forces = law.kind == LawKind::central ? 1
                             : law.kind == LawKind::many  ? 3 * std::size_t(law.count)
                                                          : 3;
  sound_law(law.called || (law.force.size() == forces && std::all_of(law.force.begin(), law.force.end(), is_node)));
  for (const Expr e : {law.energy, law.stiffness}) sound_law(e == no_expression || is_node(e));
  sound_law(law.exclude >= 0 && law.cutoff > 0.0);
  sound_law(!law.also || (law.also->kind == law.kind && law.also->count == law.count &&
                          law.also->parameters.size() == law.parameters.size()));
}

void check_read(const Program& program) {
  const std::int32_t slots = program.slots, inputs = static_cast<std::int32_t>(program.inputs.size());
  sound_law(inputs <= slots &&
            static_cast<std::size_t>(slots) <= program.inputs.size() + program.uniform.size() + program.code.size());
  const auto is_slot = [&](std::int32_t slot) { return slot >= 0 && slot < slots; };
  for (const Input& input : program.inputs) check_input(input, 4);
  for (const std::vector<Instruction>* list : {&program.uniform, &program.code})
    for (const Instruction& i : *list) {
      const std::array<std::int32_t, 3> read = {i.a, i.b, i.c};
      sound_law(is_slot(i.to) && i.to >= inputs && std::all_of(read.begin(), read.begin() + operands_of(i), is_slot));
      if (i.operation == Operation::function && i.function == Function::spline)
        sound_law(i.c >= 0 && static_cast<std::size_t>(i.c) < program.splines.size() &&
                  program.splines[static_cast<std::size_t>(i.c)] && i.x >= -1.0 && i.x <= 3.0);
    }
  sound_law(std::all_of(program.outputs.begin(), program.outputs.end(), is_slot));
}

}  // namespace pantin
