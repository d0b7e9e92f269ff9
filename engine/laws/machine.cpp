#include <sleef.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "base/check.hpp"
#include "laws/program.hpp"

// The same bits whatever the width: SLEEF's variants without contraction differ in nothing else (machine_test).
#if defined(__AVX512F__)
#define PANTIN_LANES 8
#define PANTIN_SLEEF(name, kind) Sleef_cinz_##name##d8_##kind##avx512fnofma
#define PANTIN_SQUARE_ROOT Sleef_sqrtd8_avx512fnofma
#elif defined(__AVX__)
#define PANTIN_LANES 4
#define PANTIN_SLEEF(name, kind) Sleef_cinz_##name##d4_##kind##avx
#define PANTIN_SQUARE_ROOT Sleef_sqrtd4_avx
#else
#define PANTIN_LANES 2
#define PANTIN_SLEEF(name, kind) Sleef_cinz_##name##d2_##kind##sse2
#define PANTIN_SQUARE_ROOT Sleef_sqrtd2_sse2
#endif

namespace pantin {

namespace {

constexpr int lanes = PANTIN_LANES;
constexpr int stride = 2 * lanes;  // two vectors at a time
constexpr int padding = 16;

using Vector = double __attribute__((vector_size(lanes * sizeof(double))));
using Unaligned = double __attribute__((vector_size(lanes * sizeof(double)), aligned(alignof(double)), may_alias));
using Bits = std::int64_t __attribute__((vector_size(lanes * sizeof(double))));

Vector load(const double* from) { return *reinterpret_cast<const Unaligned*>(from); }
void store(double* to, Vector v) { *reinterpret_cast<Unaligned*>(to) = v; }
Vector all(double x) { return Vector{} + x; }

struct Columns {
  double* to;
  const double *a, *b, *c;
};

// to[k] = f(k) for k in steps of a vector
template <class F>
void each(int n, double* to, F f) {
  for (int k = 0; k < n; k += stride) {
    const Vector first = f(k), second = f(k + lanes);
    store(to + k, first);
    store(to + k + lanes, second);
  }
}

template <class F>
void unary(int n, const Columns& at, F f) {
  each(n, at.to, [&, a = at.a](int k) { return f(load(a + k)); });
}
template <class F>
void binary(int n, const Columns& at, F f) {
  each(n, at.to, [&, a = at.a, b = at.b](int k) { return f(load(a + k), load(b + k)); });
}

Vector absolute(Vector v) {
  Bits bits;
  std::memcpy(&bits, &v, sizeof bits);
  bits &= std::int64_t{0x7fffffffffffffff};
  std::memcpy(&v, &bits, sizeof v);
  return v;
}

void run_spline(int n, const Columns& at, const Spline& spline, int order) {
  for (int k = 0; k < n; k++) at.to[k] = spline.evaluate(at.a[k], order);
}

void run_choice(Function f, int n, const Columns& at) {
  const Vector zero{}, one = all(1.0);
  switch (f) {
    case Function::minimum: return binary(n, at, [](Vector a, Vector b) { return b < a ? b : a; });
    case Function::maximum: return binary(n, at, [](Vector a, Vector b) { return b > a ? b : a; });
    case Function::less: return binary(n, at, [&](Vector a, Vector b) { return a < b ? one : zero; });
    case Function::less_or_equal: return binary(n, at, [&](Vector a, Vector b) { return a <= b ? one : zero; });
    case Function::select:
      return each(n, at.to, [&](int k) { return load(at.a + k) != zero ? load(at.b + k) : load(at.c + k); });
    default: assume(false);
  }
}

void run_function(Function f, int n, const Columns& at) {
  switch (f) {
    case Function::exp: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(exp, u10)(a); });
    case Function::log: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(log, u10)(a); });
    case Function::sin: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(sin, u10)(a); });
    case Function::cos: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(cos, u10)(a); });
    case Function::tan: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(tan, u10)(a); });
    case Function::asin: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(asin, u10)(a); });
    case Function::acos: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(acos, u10)(a); });
    case Function::atan: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(atan, u10)(a); });
    case Function::atan2: return binary(n, at, [](Vector a, Vector b) { return PANTIN_SLEEF(atan2, u10)(a, b); });
    case Function::sinh: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(sinh, u10)(a); });
    case Function::cosh: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(cosh, u10)(a); });
    case Function::tanh: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(tanh, u10)(a); });
    case Function::power: return binary(n, at, [](Vector a, Vector b) { return PANTIN_SLEEF(pow, u10)(a, b); });
    case Function::floor: return unary(n, at, [](Vector a) { return PANTIN_SLEEF(floor, )(a); });
    case Function::abs: return unary(n, at, absolute);
    default: run_choice(f, n, at);
  }
}

void run_operation(const Instruction& i, int n, const Columns& at) {
  const Vector x = all(i.x), y = all(i.y);
  const auto *a = at.a, *b = at.b, *c = at.c;
  switch (i.operation) {
    case Operation::multiply: return each(n, at.to, [=](int k) { return load(a + k) * load(b + k); });
    case Operation::multiply_number: return each(n, at.to, [=](int k) { return load(a + k) * x; });
    case Operation::add: return each(n, at.to, [=](int k) { return load(a + k) + load(b + k); });
    case Operation::add_number: return each(n, at.to, [=](int k) { return load(a + k) + x; });
    case Operation::subtract: return each(n, at.to, [=](int k) { return load(a + k) - load(b + k); });
    case Operation::multiply_add: return each(n, at.to, [=](int k) { return load(a + k) * load(b + k) + load(c + k); });
    case Operation::multiply_number_add: return each(n, at.to, [=](int k) { return load(a + k) * x + load(b + k); });
    case Operation::multiply_add_number: return each(n, at.to, [=](int k) { return load(a + k) * load(b + k) + x; });
    case Operation::multiply_number_add_number: return each(n, at.to, [=](int k) { return load(a + k) * x + y; });
    case Operation::reciprocal: return each(n, at.to, [=](int k) { return all(1.0) / load(a + k); });
    case Operation::square: return each(n, at.to, [=](int k) { return load(a + k) * load(a + k); });
    case Operation::divide: return each(n, at.to, [=](int k) { return load(a + k) / load(b + k); });
    case Operation::set: return each(n, at.to, [=](int) { return x; });
    case Operation::square_root: return unary(n, at, [](Vector v) { return PANTIN_SQUARE_ROOT(v); });
    case Operation::function: return run_function(i.function, n, at);
  }
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

  explicit Memory(const Program& made) : program(made) {
    const std::size_t size = static_cast<std::size_t>(program.slots) * block;
    values.reset(static_cast<double*>(::operator new[](std::max<std::size_t>(size, 1) * sizeof(double), alignment)));
    std::fill_n(values.get(), size, 0.0);
    for (std::int32_t i = 0; i < program.slots; i++) columns.push_back(values.get() + i * block);
  }

  double* at(std::int32_t slot) const { return slot < 0 ? nullptr : columns[static_cast<std::size_t>(slot)]; }

  void run(const std::vector<Instruction>& code, int n) const {
    for (const Instruction& i : code) {
      if (i.operation == Operation::function && i.function == Function::spline) {
        const Spline& spline = *program.splines[static_cast<std::size_t>(i.c)];
        run_spline(n, {at(i.to), at(i.a), nullptr, nullptr}, spline, static_cast<int>(i.x));
      } else {
        run_operation(i, n, {at(i.to), at(i.a), at(i.b), at(i.c)});
      }
    }
  }
};

Machine::Machine(const Program& program) : memory_(std::make_unique<Memory>(program)) {}
Machine::~Machine() = default;
Machine::Machine(Machine&&) noexcept = default;
Machine& Machine::operator=(Machine&&) noexcept = default;

int Machine::input(const Input& input) const {
  const auto& inputs = memory_->program.inputs;
  const auto found = std::find(inputs.begin(), inputs.end(), input);
  return found == inputs.end() ? -1 : static_cast<int>(found - inputs.begin());
}

double* Machine::column(int input) {
  double* own = memory_->values.get() + input * block;
  memory_->columns[static_cast<std::size_t>(input)] = own;
  return own;
}

void Machine::bind(int input, const double* values) {
  memory_->columns[static_cast<std::size_t>(input)] = const_cast<double*>(values);
}

void Machine::fill(int input, double value) { std::fill_n(column(input), block, value); }

void Machine::run_uniform() { memory_->run(memory_->program.uniform, block); }

void Machine::run(int n) { memory_->run(memory_->program.code, (n + padding - 1) / padding * padding); }

const double* Machine::output(int k) const {
  return memory_->at(memory_->program.outputs[static_cast<std::size_t>(k)]);
}

}  // namespace pantin
