#include <algorithm>
#include <new>
#include <optional>

#include "laws/kernels.hpp"
#include "laws/machine_code.hpp"
#include "laws/program.hpp"

namespace pantin {

namespace {

// An instruction seen from one of its operands: shape, and the slots of the
// others in b and c.
struct Seen {
  kernels::Shape shape;
  std::int32_t b, c;
};
std::optional<Seen> seen_from(const Instruction& i, std::int32_t slot) {
  if (!kernels::is_arithmetic(i.operation)) return std::nullopt;
  const auto shape = static_cast<kernels::Shape>(i.operation);
  const bool in_a = i.a == slot, in_b = i.b == slot, in_c = i.c == slot;
  if (in_a + in_b + in_c != 1) return std::nullopt;
  if (in_a) return Seen{shape, i.b, i.c};
  switch (i.operation) {
    case Operation::multiply:
    case Operation::add:
    case Operation::multiply_add_number: return Seen{shape, i.a, -1};
    case Operation::multiply_add: return in_b ? Seen{shape, i.a, i.c} : Seen{kernels::Shape::add_product, i.a, i.b};
    case Operation::subtract: return Seen{kernels::Shape::subtract_from, i.a, -1};
    case Operation::multiply_number_add: return Seen{kernels::Shape::add_multiple, i.a, -1};
    default: return std::nullopt;
  }
}

// Instructions to be run together: the second, where there is one, is all that
// reads what the first gives.
struct Stage {
  Instruction first;
  Instruction second{};
  kernels::Two run_both = nullptr;
};

bool reads(const Instruction& i, std::int32_t slot) {
  const bool index_in_c = i.operation == Operation::function && i.function == Function::spline;
  return i.a == slot || i.b == slot || (i.c == slot && !index_in_c);
}

// Whether a slot is read from instruction `from` on, before it is written.
bool is_needed(const std::vector<Instruction>& code, const std::vector<std::int32_t>& outputs, std::size_t from,
               std::int32_t slot) {
  for (std::size_t k = from; k < code.size(); k++) {
    if (reads(code[k], slot)) return true;
    if (code[k].to == slot) return false;
  }
  return std::find(outputs.begin(), outputs.end(), slot) != outputs.end();
}

std::vector<Stage> stages_of(const std::vector<Instruction>& code, const std::vector<std::int32_t>& outputs) {
  std::vector<Stage> made;
  for (std::size_t k = 0; k < code.size(); k++) {
    made.push_back({code[k]});
    if (k + 1 == code.size() || !kernels::is_arithmetic(code[k].operation)) continue;
    const std::int32_t between = code[k].to;
    const auto seen = seen_from(code[k + 1], between);
    if (!seen || (code[k + 1].to != between && is_needed(code, outputs, k + 2, between))) continue;
    Stage& stage = made.back();
    stage.second = code[++k];
    stage.second.b = seen->b;
    stage.second.c = seen->c;
    stage.run_both = kernels::arithmetic(stage.first.operation, seen->shape);
  }
  return made;
}

constexpr auto alignment = std::align_val_t{64};
struct Free {
  void operator()(double* memory) const { ::operator delete[](memory, alignment); }
};

}  // namespace

struct Machine::Memory {
  Program program;
  std::unique_ptr<double[], Free> values;
  std::vector<double*> columns;  // by slot; of a bound input somewhere else, only read
  std::vector<Stage> uniform, code;
  std::shared_ptr<const MachineCode> machine_code;
  int capacity;  // values in a column
  int stride;    // from slot to slot

  Memory(const Program& made, int most) : program(made), capacity(most), stride(most + distance - block) {
    const std::size_t size = static_cast<std::size_t>(program.slots) * static_cast<std::size_t>(stride);
    values.reset(static_cast<double*>(::operator new[](std::max<std::size_t>(size, 1) * sizeof(double), alignment)));
    std::fill_n(values.get(), size, 0.0);
    for (std::int32_t i = 0; i < program.slots; i++) columns.push_back(values.get() + i * stride);
    for (const Instruction& i : program.uniform) uniform.push_back({i});
    code = stages_of(program.code, program.outputs);
  }

  double* at(std::int32_t slot) const { return slot < 0 ? nullptr : columns[static_cast<std::size_t>(slot)]; }

  void run(const std::vector<Stage>& stages, int n) const {
    for (const Stage& stage : stages) {
      const Instruction &i = stage.first, &j = stage.second;
      if (stage.run_both != nullptr) {
        stage.run_both(n, at(j.to), at(i.a), {at(i.b), at(i.c), i.x, i.y}, {at(j.b), at(j.c), j.x, j.y});
      } else {
        run(i, n);
      }
    }
  }

  void run(const Instruction& i, int n) const {
    if (kernels::is_arithmetic(i.operation)) {
      kernels::arithmetic(i.operation)(n, at(i.to), at(i.a), {at(i.b), at(i.c), i.x, i.y});
    } else if (i.operation == Operation::set) {
      kernels::fill(n, at(i.to), i.x);
    } else if (i.operation == Operation::square_root) {
      kernels::square_root(n, at(i.to), at(i.a));
    } else if (i.function == Function::spline) {
      const Spline& spline = *program.splines[static_cast<std::size_t>(i.c)];
      kernels::spline(n, at(i.to), at(i.a), spline, static_cast<int>(i.x));
    } else {
      kernels::function(i.function, n, {at(i.to), at(i.a), at(i.b), at(i.c)});
    }
  }
};

Machine::Machine(const Program& program, int capacity) : memory_(std::make_unique<Memory>(program, capacity)) {}
Machine::~Machine() = default;
Machine::Machine(Machine&&) noexcept = default;
Machine& Machine::operator=(Machine&&) noexcept = default;

int Machine::input(const Input& input) const {
  const auto& inputs = memory_->program.inputs;
  const auto found = std::find(inputs.begin(), inputs.end(), input);
  return found == inputs.end() ? -1 : static_cast<int>(found - inputs.begin());
}

double* Machine::column(int input) {
  double* own = memory_->values.get() + input * memory_->stride;
  memory_->columns[static_cast<std::size_t>(input)] = own;
  return own;
}

void Machine::bind(int input, const double* values) {
  memory_->columns[static_cast<std::size_t>(input)] = const_cast<double*>(values);
}

void Machine::fill(int input, double value) { std::fill_n(column(input), memory_->capacity, value); }

void Machine::run_uniform() {
  memory_->run(memory_->uniform, kernels::padding);
  for (const Stage& stage : memory_->uniform) {
    double* values = memory_->at(stage.first.to);
    std::fill(values + kernels::padding, values + memory_->capacity, *values);
  }
}

void Machine::use(std::shared_ptr<const MachineCode> code) { memory_->machine_code = std::move(code); }

void Machine::run(int n) {
  if (memory_->machine_code) return memory_->machine_code->run(memory_->columns.data(), n);
  memory_->run(memory_->code, (n + kernels::padding - 1) / kernels::padding * kernels::padding);
}

double* const* Machine::columns() const { return memory_->columns.data(); }

const double* Machine::output(int k) const {
  return memory_->at(memory_->program.outputs[static_cast<std::size_t>(k)]);
}

}  // namespace pantin
