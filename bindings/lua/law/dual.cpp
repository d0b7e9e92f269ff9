#include "lua/law/dual.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/functions.hpp"
#include "lua/law/algebra.hpp"
#include "lua/law/law_run.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

/// The userdata; the derivatives of each part follow.
struct DualData {
  Tag tag;
  int count;
  double* values() { return reinterpret_cast<double*>(this + 1); }
  const double* values() const { return reinterpret_cast<const double*>(this + 1); }
};

/// f with df / da = slope.
Dual chain(const Dual& a, double value, double slope) {
  Dual result(value);
  result.count = a.count;
  for (int i = 0; i < a.count; i++) result.rate[static_cast<std::size_t>(i)] = slope * a.slope(i);
  return result;
}

/// f with df / da and df / db.
Dual chain(const Dual& a, const Dual& b, double value, double by_a, double by_b) {
  if (b.count == 0) return chain(a, value, by_a);
  if (a.count == 0) return chain(b, value, by_b);
  Dual result(value);
  result.count = std::max(a.count, b.count);
  for (int i = 0; i < result.count; i++)
    result.rate[static_cast<std::size_t>(i)] = by_a * a.slope(i) + by_b * b.slope(i);
  return result;
}

template <std::size_t parts>
void push_data(lua_State* state, Tag tag, const Dual* x) {
  int count = 0;
  for (std::size_t p = 0; p < parts; p++) count = std::max(count, x[p].count);
  const auto stride = static_cast<std::size_t>(1 + count);
  auto* data = static_cast<DualData*>(lua_newuserdatauv(state, sizeof(DualData) + parts * stride * sizeof(double), 0));
  data->tag = tag;
  data->count = count;
  for (std::size_t p = 0; p < parts; p++) {
    data->values()[p * stride] = x[p].value;
    for (int i = 0; i < count; i++) data->values()[p * stride + 1 + static_cast<std::size_t>(i)] = x[p].slope(i);
  }
  set_algebra_metatable(state, tag);
}

Dual read_data(const DualData& data, std::size_t part) {
  const double* values = data.values() + part * static_cast<std::size_t>(1 + data.count);
  Dual x(values[0]);
  x.count = data.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(data.count); i++) x.rate[i] = values[1 + i];
  return x;
}

}  // namespace

Dual Dual::variable(double value, int which, int of) {
  Dual x(value);
  x.count = of;
  for (int i = 0; i < of; i++) x.rate[static_cast<std::size_t>(i)] = i == which ? 1.0 : 0.0;
  return x;
}

std::optional<Dual> DualAlgebra::read(lua_State* state, int index) const {
  const int type = lua_type(state, index);
  if (type == LUA_TNUMBER) return Dual(lua_tonumber(state, index));
  if (type != LUA_TUSERDATA) return {};
  const auto& data = *static_cast<const DualData*>(lua_touserdata(state, index));
  if (data.tag != Tag::dual) return {};
  return read_data(data, 0);
}

std::optional<std::array<Dual, 3>> DualAlgebra::read_vec(lua_State* state, int index) const {
  if (const auto v = to_vec(state, index)) return std::array<Dual, 3>{Dual((*v)[0]), Dual((*v)[1]), Dual((*v)[2])};
  if (tag_of(state, index) != Tag::dual_vec) return {};
  const auto& data = *static_cast<const DualData*>(lua_touserdata(state, index));
  return std::array<Dual, 3>{read_data(data, 0), read_data(data, 1), read_data(data, 2)};
}

void DualAlgebra::push(lua_State* state, const Dual& x) const {
  if (x.count == 0)
    lua_pushnumber(state, x.value);
  else
    push_data<1>(state, Tag::dual, &x);
}

void DualAlgebra::push_vec(lua_State* state, const std::array<Dual, 3>& v) const {
  push_data<3>(state, Tag::dual_vec, v.data());
}

Dual DualAlgebra::add(const Dual& a, const Dual& b) const { return chain(a, b, a.value + b.value, 1.0, 1.0); }
Dual DualAlgebra::subtract(const Dual& a, const Dual& b) const { return chain(a, b, a.value - b.value, 1.0, -1.0); }
Dual DualAlgebra::multiply(const Dual& a, const Dual& b) const {
  return chain(a, b, a.value * b.value, b.value, a.value);
}
Dual DualAlgebra::divide(const Dual& a, const Dual& b) const {
  const double value = a.value / b.value;
  return chain(a, b, value, 1.0 / b.value, -value / b.value);
}

Dual DualAlgebra::modulo(const Dual& a, const Dual& b) const {
  double value = std::fmod(a.value, b.value);
  if (value * b.value < 0.0) value += b.value;
  return chain(a, b, value, 1.0, -std::floor(a.value / b.value));
}

Dual DualAlgebra::power(const Dual& a, const Dual& b) const {
  const double value = functions::pow(a.value, b.value);
  const double by_a = b.value == 0.0   ? 0.0
                      : a.value != 0.0 ? b.value * (value / a.value)
                                       : b.value * functions::pow(a.value, b.value - 1.0);
  if (b.count == 0) return chain(a, value, by_a);
  return chain(a, b, value, by_a, value == 0.0 ? 0.0 : value * functions::log(a.value));
}

Dual DualAlgebra::apply(Function f, const Dual& a) const {
  const double x = a.value;
  switch (f) {
    case Function::exp: return chain(a, functions::exp(x), functions::exp(x));
    case Function::log: return chain(a, functions::log(x), 1.0 / x);
    case Function::sin: return chain(a, functions::sin(x), functions::cos(x));
    case Function::cos: return chain(a, functions::cos(x), -functions::sin(x));
    case Function::tan: return chain(a, functions::tan(x), 1.0 + functions::tan(x) * functions::tan(x));
    case Function::asin: return chain(a, functions::asin(x), 1.0 / std::sqrt(1.0 - x * x));
    case Function::acos: return chain(a, functions::acos(x), -1.0 / std::sqrt(1.0 - x * x));
    case Function::atan: return chain(a, functions::atan(x), 1.0 / (1.0 + x * x));
    case Function::sinh: return chain(a, functions::sinh(x), functions::cosh(x));
    case Function::cosh: return chain(a, functions::cosh(x), functions::sinh(x));
    case Function::tanh: return chain(a, functions::tanh(x), 1.0 - functions::tanh(x) * functions::tanh(x));
    case Function::abs: return chain(a, std::fabs(x), x < 0.0 ? -1.0 : 1.0);
    case Function::floor: return Dual(std::floor(x));
    default: break;
  }
  assume(false);
  return {};
}

Dual DualAlgebra::arc_tangent(const Dual& y, const Dual& x) const {
  const double square = x.value * x.value + y.value * y.value;
  return chain(y, x, functions::atan2(y.value, x.value), x.value / square, -y.value / square);
}

void DualAlgebra::push_floor(lua_State* state, const Dual& a) const {
  const double floor = std::floor(a.value);
  if (std::fabs(floor) < 0x1p53)
    lua_pushinteger(state, static_cast<lua_Integer>(floor));
  else
    lua_pushnumber(state, floor);
}

std::string DualAlgebra::text(const Dual& a) const {
  if (LawRun* law = Runtime::of(running).law)
    law->mistake(
        running,
        "a text has no derivative, and the derivative of a potential is its force; print(…) may show the value, "
        "or give a force in place of the potential");
  return to_text(a.value);
}

}  // namespace pantin::lua
