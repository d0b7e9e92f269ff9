#include "lua/law/symbol.hpp"

#include "lua/law/algebra.hpp"
#include "lua/law/trace.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

/// The userdata, one expression or three.
struct SymbolData {
  Tag tag;
  std::uint64_t trace;  ///< serial of the trace that made it
  Expr parts[3];
};

Trace& tracing(lua_State* state) {
  auto* trace = dynamic_cast<Trace*>(Runtime::of(state).law);
  require(trace, "this value was kept from inside of a law; it means nothing outside");
  return *trace;
}

const SymbolData* to_data(const Trace& trace, lua_State* state, int index, Tag tag) {
  if (tag_of(state, index) != tag) return nullptr;
  const auto* data = static_cast<const SymbolData*>(lua_touserdata(state, index));
  require(data->trace == trace.serial(), "this value was kept from another run of a law; it means nothing here");
  return data;
}

}  // namespace

SymbolAlgebra::SymbolAlgebra(lua_State* of) : state(of), trace(tracing(of)), graph(trace.graph) {}

std::optional<Expr> SymbolAlgebra::read(lua_State* from, int index) const {
  if (lua_type(from, index) == LUA_TNUMBER) return graph.constant(lua_tonumber(from, index));
  const SymbolData* data = to_data(trace, from, index, Tag::symbol);
  if (!data) return {};
  return data->parts[0];
}

std::optional<std::array<Expr, 3>> SymbolAlgebra::read_vec(lua_State* from, int index) const {
  if (const auto v = to_vec(from, index))
    return std::array<Expr, 3>{graph.constant((*v)[0]), graph.constant((*v)[1]), graph.constant((*v)[2])};
  const SymbolData* data = to_data(trace, from, index, Tag::symbol_vec);
  if (!data) return {};
  return std::array<Expr, 3>{data->parts[0], data->parts[1], data->parts[2]};
}

namespace {
/// Derivatives of more would take seconds.
constexpr std::size_t most_operations = 600;
std::string text_of_limit() { return pantin::text("more than ", most_operations, " operations (a long loop?)"); }
}  // namespace

void SymbolAlgebra::push(lua_State* to, Expr e) const {
  if (graph.is_constant(e)) return lua_pushnumber(to, graph[e].value);
  if (graph.size() > most_operations) trace.refuse(state, text_of_limit());
  *static_cast<SymbolData*>(lua_newuserdatauv(to, sizeof(SymbolData), 0)) = {Tag::symbol, trace.serial(), {e, e, e}};
  set_algebra_metatable(to, Tag::symbol);
}

void SymbolAlgebra::push_vec(lua_State* to, const std::array<Expr, 3>& v) const {
  *static_cast<SymbolData*>(lua_newuserdatauv(to, sizeof(SymbolData), 0)) = {
      Tag::symbol_vec, trace.serial(), {v[0], v[1], v[2]}};
  set_algebra_metatable(to, Tag::symbol_vec);
}

bool SymbolAlgebra::less(Expr a, Expr b) const { return trace.decide(state, graph.apply(Function::less, a, b)); }
bool SymbolAlgebra::less_or_equal(Expr a, Expr b) const { return !less(b, a); }

bool SymbolAlgebra::equal(Expr, Expr) const {
  if (trace.law.exact) trace.refuse(state, "an equality test of two values that differ from pair to pair");
  return false;
}

std::string SymbolAlgebra::text(Expr) const {
  trace.refuse(state, "a text is made of a value that differs from pair to pair");
}

double SymbolAlgebra::plain(Expr, const char* what) const {
  trace.refuse(state, pantin::text(what, " of a value that differs from pair to pair"));
}

}  // namespace pantin::lua
