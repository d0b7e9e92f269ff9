#include "laws/kernels.hpp"

#include <sleef.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/check.hpp"

// The same bits whatever the width: SLEEF's variants without contraction differ
// in nothing else.
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

namespace pantin::kernels {

namespace {

constexpr int lanes = PANTIN_LANES;
constexpr int stride = 2 * lanes;  // two vectors at a time

using Vector = double __attribute__((vector_size(lanes * sizeof(double))));
using Unaligned = double __attribute__((vector_size(lanes * sizeof(double)), aligned(alignof(double)), may_alias));
using Bits = std::int64_t __attribute__((vector_size(lanes * sizeof(double))));

Vector load(const double* from) { return *reinterpret_cast<const Unaligned*>(from); }
void store(double* to, Vector v) { *reinterpret_cast<Unaligned*>(to) = v; }
Vector all(double x) { return Vector{} + x; }

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

template <Shape shape>
Vector combine(Vector a, const Operands& with, int k) {
  const auto b = [&] { return load(with.b + k); };
  const auto c = [&] { return load(with.c + k); };
  if constexpr (shape == Shape::multiply) return a * b();
  if constexpr (shape == Shape::multiply_number) return a * with.x;
  if constexpr (shape == Shape::add) return a + b();
  if constexpr (shape == Shape::add_number) return a + with.x;
  if constexpr (shape == Shape::subtract) return a - b();
  if constexpr (shape == Shape::multiply_add) return a * b() + c();
  if constexpr (shape == Shape::multiply_number_add) return a * with.x + b();
  if constexpr (shape == Shape::multiply_add_number) return a * b() + with.x;
  if constexpr (shape == Shape::multiply_number_add_number) return a * with.x + with.y;
  if constexpr (shape == Shape::reciprocal) return 1.0 / a;
  if constexpr (shape == Shape::square) return a * a;
  if constexpr (shape == Shape::divide) return a / b();
  if constexpr (shape == Shape::subtract_from) return b() - a;
  if constexpr (shape == Shape::add_product) return b() * c() + a;
  if constexpr (shape == Shape::add_multiple) return b() * with.x + a;
}

template <Shape shape>
void run_one(int n, double* to, const double* a, const Operands& with) {
  each(n, to, [a, with](int k) { return combine<shape>(load(a + k), with, k); });
}
// What is between the two operations stays in a register.
template <Shape first, Shape second>
void run_two(int n, double* to, const double* a, const Operands& with_first, const Operands& with_second) {
  each(n, to, [a, with_first, with_second](int k) {
    return combine<second>(combine<first>(load(a + k), with_first, k), with_second, k);
  });
}

template <std::size_t... i>
constexpr std::array<One, operations> table_of_one(std::index_sequence<i...>) {
  return {run_one<static_cast<Shape>(i)>...};
}
template <std::size_t... i>
constexpr std::array<Two, operations * shapes> table_of_two(std::index_sequence<i...>) {
  return {run_two<static_cast<Shape>(i / shapes), static_cast<Shape>(i % shapes)>...};
}
constexpr auto ones = table_of_one(std::make_index_sequence<operations>());
constexpr auto twos = table_of_two(std::make_index_sequence<operations * shapes>());

}  // namespace

One arithmetic(Operation operation) { return ones[static_cast<std::size_t>(operation)]; }

Two arithmetic(Operation first, Shape second) {
  return twos[static_cast<std::size_t>(first) * shapes + static_cast<std::size_t>(second)];
}

void fill(int n, double* to, double x) { std::fill_n(to, n, x); }

void square_root(int n, double* to, const double* a) {
  each(n, to, [a](int k) { return PANTIN_SQUARE_ROOT(load(a + k)); });
}

void spline(int n, double* to, const double* a, const Spline& spline, int order) {
  for (int k = 0; k < n; k++) to[k] = spline.evaluate(a[k], order);
}

void function(Function f, int n, const Columns& at) {
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

}  // namespace pantin::kernels
