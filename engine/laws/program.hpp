#pragma once
// A law made ready to run over blocks of pairs, bonds or particles: a flat list of operations on slots, each slot a
// column of one value per pair. Same bits for any lane width: every operation is element by element.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "laws/expression.hpp"

namespace pantin {

/// a, b, c are slots; x, y are numbers.
enum class Operation : std::uint8_t {
  multiply,                    ///< a b
  multiply_number,             ///< a x
  add,                         ///< a + b
  add_number,                  ///< a + x
  subtract,                    ///< a - b
  multiply_add,                ///< a b + c
  multiply_number_add,         ///< a x + b
  multiply_add_number,         ///< a b + x
  multiply_number_add_number,  ///< a x + y
  reciprocal,                  ///< 1 / a
  square,                      ///< a a
  divide,                      ///< a / b
  set,                         ///< x
  square_root,
  function,  ///< `function` of a, b, c; of a spline: x is the order of the derivative, c its index
};

struct Instruction {
  Operation operation = Operation::set;
  Function function{};
  std::int32_t to = -1, a = -1, b = -1, c = -1;
  double x = 0.0, y = 0.0;
};

struct Program {
  std::vector<Input> inputs;         ///< slot i holds inputs[i]
  std::vector<Instruction> uniform;  ///< depends on uniform inputs only: run once for all blocks
  std::vector<Instruction> code;
  std::vector<std::int32_t> outputs;  ///< slots
  std::int32_t slots = 0;
  std::vector<std::shared_ptr<const Spline>> splines;

  std::size_t operations() const { return code.size(); }
};

/// Whether an input is the same for everything that one run goes over: time always; parameters where `parameters` says.
struct Uniform {
  bool parameters = true;
};

/// Makes a program for some expressions of a graph.
Program lower(const Expressions& graph, std::span<const Expr> outputs, Uniform uniform = {});

class MachineCode;

/// The memory to run a program in; one for each thread.
class Machine {
 public:
  static constexpr int block = 512;  ///< values in a slot
  /// From slot to slot: with a power of 2 they would be in each other's way in the cache.
  static constexpr int distance = block + 16;

  /// `capacity`: the most values that it will run on, a multiple of 16.
  explicit Machine(const Program& program, int capacity = block);
  ~Machine();
  Machine(Machine&&) noexcept;
  Machine& operator=(Machine&&) noexcept;

  /// Runs by this, made of the same program, from now on; by itself where it is null.
  void use(std::shared_ptr<const MachineCode> code);

  /// Index of an input in the program, or -1 where it does not depend on it.
  int input(const Input& input) const;
  /// The column of an input, to be filled (64-byte aligned).
  double* column(int input);
  /// Reads an input in place instead: `values` must be readable up to the next multiple of 16 values.
  void bind(int input, const double* values);
  /// Sets a whole column to one value: how uniform inputs are given.
  void fill(int input, double value);
  /// Runs what depends on uniform inputs only; call after they were filled, and once where there are none.
  void run_uniform();
  /// Runs on the first n values of every column, n <= capacity; values up to the next multiple of 16 may be touched.
  void run(int n);
  /// n values; may be the column of an input.
  const double* output(int k) const;
  double* const* columns() const;  ///< by slot

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace pantin
