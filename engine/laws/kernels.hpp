#pragma once
// What is done to the columns of a block, for machine.cpp alone.
#include <cstdint>

#include "laws/program.hpp"

namespace pantin::kernels {

/// Columns are worked on in whole multiples of this.
inline constexpr int padding = 16;

/// Arithmetic seen from one operand, a: the first twelve are Operations, the others do the same with a elsewhere.
enum class Shape : std::uint8_t {
  multiply,
  multiply_number,
  add,
  add_number,
  subtract,
  multiply_add,
  multiply_number_add,
  multiply_add_number,
  multiply_number_add_number,
  reciprocal,
  square,
  divide,
  subtract_from,  // b - a
  add_product,    // b c + a
  add_multiple,   // b x + a
};
inline constexpr std::size_t operations = 12, shapes = 15;
static_assert(static_cast<int>(Shape::divide) == static_cast<int>(Operation::divide));

inline bool is_arithmetic(Operation operation) { return static_cast<std::size_t>(operation) < operations; }

/// The other operands: columns and numbers.
struct Operands {
  const double *b, *c;
  double x, y;
};

struct Columns {
  double* to;
  const double *a, *b, *c;
};

using One = void (*)(int n, double* to, const double* a, const Operands& with);
using Two = void (*)(int n, double* to, const double* a, const Operands& first, const Operands& second);

One arithmetic(Operation operation);
/// Both, one after the other: a of the second is what the first gives, and stays in a register.
Two arithmetic(Operation first, Shape second);

void fill(int n, double* to, double x);
void square_root(int n, double* to, const double* a);
void spline(int n, double* to, const double* a, const Spline& spline, int order);
/// Any function but `spline`.
void function(Function f, int n, const Columns& at);

}  // namespace pantin::kernels
