#include "lua/law/trace.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "lua/law/equality.hpp"
#include "lua/law/key_guards.hpp"
#include "lua/law/symbol.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

constexpr std::size_t most_decisions = 12, most_paths = 64;

using Path = std::vector<std::pair<Expr, bool>>;

/// What one way through the branches gave.
struct Leaf {
  Path path;
  std::vector<Expr> outputs;
};

Input component(Role role, int who, int i) {
  return {role, static_cast<std::uint8_t>(who), static_cast<std::uint8_t>(i), ""};
}

/// Leaves lo … hi - 1 agree in their first `depth` decisions; they come in depth-first order, the taken side first.
Expr merged(Expressions& graph, const std::vector<Leaf>& leaves, std::size_t output, std::size_t lo, std::size_t hi,
            std::size_t depth) {
  if (hi - lo == 1) return leaves[lo].outputs[output];
  std::size_t middle = lo;
  while (middle < hi && leaves[middle].path[depth].second) middle++;
  return graph.select(leaves[lo].path[depth].first, merged(graph, leaves, output, lo, middle, depth + 1),
                      merged(graph, leaves, output, middle, hi, depth + 1));
}

/// Looks at every function of Lua that runs while the law is traced.
class Watched {
 public:
  Watched(lua_State* state, Runtime& runtime, Trace& trace)
      : state_(state), runtime_(runtime), trace_(trace), guards_(state) {
    trace.guards = &guards_;
    lua_sethook(state, on_call, LUA_MASKCALL, 0);
    runtime.watch().switch_to(state);  // the time may have been up just then
  }
  ~Watched() {
    trace_.guards = nullptr;
    lua_sethook(state_, nullptr, 0, 0);
    runtime_.watch().switch_to(state_);
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

 private:
  static void on_call(lua_State* state, lua_Debug* frame) {
    auto* trace = dynamic_cast<Trace*>(Runtime::of(state).law);
    lua_getinfo(state, "Sf", frame);
    if (trace && std::string_view(frame->what) != "C") {
      const Silent found = silent_of(state, -1);
      if (!found.equality.empty()) {
        if (trace->refusal.empty()) trace->refusal = found.equality;
        lua_pushlstring(state, found.equality.data(), found.equality.size());
        lua_error(state);
      }
      if (found.indexes && trace->guards) trace->guards->guard_seen_by_function(state);
    }
    lua_pop(state, 1);
  }

  lua_State* state_;
  Runtime& runtime_;
  Trace& trace_;
  KeyGuards guards_;
};

/// Red, green, blue and opacity of the color at the top, some of them traced; empty where it is none.
std::vector<Expr> channels_of(lua_State* state, Expressions& graph) {
  if (const auto color = to_color(state, -1)) {
    std::vector<Expr> channels;
    for (const float channel : {color->r, color->g, color->b, color->a})
      channels.push_back(graph.constant(static_cast<double>(channel)));
    return channels;
  }
  if (!lua_istable(state, -1)) return {};
  const SymbolAlgebra algebra(state);
  std::vector<Expr> channels;
  const auto count = static_cast<lua_Integer>(lua_rawlen(state, -1));
  for (lua_Integer i = 1; i <= count; i++) {
    lua_rawgeti(state, -1, i);
    if (const auto channel = algebra.read(state, -1)) channels.push_back(*channel);
    lua_pop(state, 1);
  }
  if (channels.size() == 3) channels.push_back(graph.constant(1.0));
  if (channels.size() != 4 || count > 4) channels.clear();
  return channels;
}

/// Reads what the function returned.
std::vector<Expr> outputs_of(lua_State* state, Trace& trace) {
  const SymbolAlgebra algebra(state);
  const LawFunction& law = trace.law;
  if (law.form == LawForm::color_curve) {
    if (auto channels = channels_of(state, trace.graph); !channels.empty()) return channels;
  } else if (gives_vec(law.form)) {
    if (const auto v = algebra.read_vec(state, -1)) return {v->begin(), v->end()};
  } else if (const auto x = algebra.read(state, -1)) {
    return {*x};
  }
  trace.refusal = text(law.function.place(), ": it returns ", kind_of_value(state, -1), " on one of its branches");
  throw ScriptError(trace.refusal);
}

/// Runs one way through the branches; false: the law cannot be traced.
bool run_path(Runtime& runtime, Trace& trace, std::vector<Leaf>& leaves) {
  trace.begin_path();
  try {
    runtime.run([&](lua_State* state) {
      LawCall call(state, trace);
      {
        std::unique_ptr<Watched> watched;
        if (trace.law.exact) watched = std::make_unique<Watched>(state, runtime, trace);
        call.call();
      }
      if (trace.mistook.empty() && trace.refusal.empty()) leaves.push_back({trace.path(), outputs_of(state, trace)});
    });
  } catch (const Error& error) {
    if (runtime.watch().over) throw;
    if (trace.refusal.empty()) trace.refusal = error.what();
  }
  if (!trace.mistook.empty()) throw ScriptError(trace.mistook);
  return trace.refusal.empty();
}

}  // namespace

Trace::Trace(lua_State* state, const LawFunction& function) : LawRun(function), serial_(++Runtime::of(state).traces) {}

void Trace::push(lua_State* state, Seen what, int who) {
  const SymbolAlgebra algebra(state);
  const auto push_three = [&](Role role) {
    std::array<Expr, 3> v;
    for (int i = 0; i < 3; i++) v[static_cast<std::size_t>(i)] = graph.input(component(role, who, i));
    algebra.push_vec(state, v);
  };
  const auto distance = [&] { return graph.square_root(graph.input(component(Role::distance2, 0, 0))); };
  switch (what) {
    case Seen::distance: return algebra.push(state, distance());
    case Seen::rate: return algebra.push(state, graph.divide(graph.input(component(Role::approach, 0, 0)), distance()));
    case Seen::displacement: return push_three(Role::displacement);
    case Seen::relative_velocity: return push_three(Role::relative_velocity);
    case Seen::place: return push_three(Role::position);
    case Seen::velocity: return push_three(Role::velocity);
    case Seen::time: return algebra.push(state, graph.input(component(Role::time, 0, 0)));
  }
}

void Trace::push_attribute(lua_State* state, int who, std::size_t index) {
  const std::string name = law.known[static_cast<std::size_t>(who)].all()[index];
  SymbolAlgebra(state).push(state, graph.input({Role::attribute, static_cast<std::uint8_t>(who), 0, name}));
}

void Trace::push_parameter(lua_State* state, std::size_t index) {
  SymbolAlgebra(state).push(state, graph.input({Role::parameter, 0, 0, law.def.parameters[index].name}));
}

void Trace::push_noise(lua_State* state, int index) {
  SymbolAlgebra(state).push(state, graph.input(component(Role::noise, 0, index)));
}

bool Trace::on_thing(lua_State* state, std::string_view field, bool of_scene) {
  if (of_scene && field == "time" && !is_curve(law.form)) {
    push(state, Seen::time, 0);
    return true;
  }
  refuse(state, text("it reads ", field,
                     " of a thing, which may change while the law goes on; read it outside of the "
                     "function, or make it one of the law's parameters"));
}

bool Trace::decide(lua_State* state, Expr condition) {
  if (graph.is_constant(condition)) return !graph.is_constant(condition, 0.0);
  for (std::size_t i = 0; i < made_; i++)
    if (decisions_[i].condition == condition) return decisions_[i].taken;
  if (made_ == decisions_.size()) {
    if (made_ == most_decisions)
      refuse(state, text("more than ", most_decisions,
                         " branches on values that differ from pair to pair (a loop on such a value?)"));
    decisions_.push_back({condition, true});
  }
  return decisions_[made_++].taken;
}

void Trace::refuse(lua_State* state, const std::string& reason) {
  if (refusal.empty()) refusal = text(where(state), ": ", reason);
  throw ScriptError(refusal);
}

void Trace::begin_path() { made_ = 0; }

bool Trace::next_path() {
  decisions_.resize(made_);
  while (!decisions_.empty() && !decisions_.back().taken) decisions_.pop_back();
  if (decisions_.empty()) return false;
  decisions_.back().taken = false;
  return true;
}

std::vector<std::pair<Expr, bool>> Trace::path() const {
  std::vector<std::pair<Expr, bool>> path;
  for (std::size_t i = 0; i < made_; i++) path.emplace_back(decisions_[i].condition, decisions_[i].taken);
  return path;
}

Traced trace(Runtime& runtime, const LawFunction& law) {
  Trace run(runtime.active(), law);
  const InLaw inside(runtime, run);
  std::vector<Leaf> leaves;
  do {
    if (leaves.size() == most_paths)
      run.refusal = text(law.function.place(), ": more than ", most_paths, " ways through its branches");
    if (!run.refusal.empty() || !run_path(runtime, run, leaves)) return {{}, {}, run.refusal};
  } while (run.next_path());
  std::vector<Expr> outputs;
  for (std::size_t i = 0; i < leaves[0].outputs.size(); i++)
    outputs.push_back(merged(run.graph, leaves, i, 0, leaves.size(), 0));
  return {std::move(run.graph), std::move(outputs), ""};
}

}  // namespace pantin::lua
