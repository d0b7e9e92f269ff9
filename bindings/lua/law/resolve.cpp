// From what a scene wrote to a law that can be run: traced where it can be, else called.
#include <algorithm>
#include <cmath>

#include "lua/law/captured.hpp"
#include "lua/law/force.hpp"
#include "lua/law/law_check.hpp"
#include "lua/law/trace.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

constexpr double sample_times[] = {0.0, 0.7, 13.0, 1000.0};  // [s]

Law traced_law(const LawFunction& f, const Traced& traced) {
  const Expr first = traced.outputs[0];
  switch (f.form) {
    case LawForm::pair_potential: return central_potential(f.def, traced.graph, first);
    case LawForm::pair_tension: return central_tension(f.def, traced.graph, first);
    case LawForm::pair_force: return pair_force(f.def, traced.graph, traced.outputs);
    case LawForm::point_potential: return point_potential(f.def, traced.graph, first);
    case LawForm::point_force: return point_force(f.def, traced.graph, traced.outputs);
    case LawForm::many_potential:
    case LawForm::number_curve:
    case LawForm::color_curve: break;
  }
  return many_potential(f.def, f.count, traced.graph, first);
}

/// Runs the function on samples; throws its error where it came through on none of them.
void check_runs(CalledLaw& called) {
  Samples samples(called, sample_times[0]);
  const Outcome tried = outcome(called, nullptr, samples.block());
  if (std::any_of(tried.failures.begin(), tried.failures.end(), [](const std::string& f) { return f.empty(); })) return;
  throw ScriptError(tried.failures[0]);
}

/// The expressions of a law that does on all samples what its function does, or nothing and the reason.
std::shared_ptr<const Law> try_trace(CalledLaw& called, std::string& reason) {
  Traced traced = trace(called.law().function.runtime(), called.law());
  reason = traced.refusal;
  if (!reason.empty()) return {};
  const auto law = std::make_shared<const Law>(traced_law(called.law(), traced));
  for (double time : sample_times) {
    Samples samples(called, time);
    const std::string difference = disagreement(called, *law, samples.block());
    if (difference.empty()) continue;
    reason = text(called.law().function.place(), ": ", difference);
    return {};
  }
  return law;
}

void warn(World& world, LawSpec& spec, const LawFunction& f, const std::string& reason) {
  if (spec.warned) return;
  spec.warned = true;
  const char* each = is_pair(f.form) ? "pair" : f.form == LawForm::many_potential ? "connection" : "particle";
  // Measured with Lennard-Jones as a tension and as a potential, whose function works with derivatives too.
  const char* cost = is_potential(f.form) ? "some 300 times slower than traced (a force or tension: 50)"
                                          : "some 50 times slower than traced";
  log_line(world, "warning",
           text(f.function.place(), ": this law is called in Lua for every ", each, ", ", cost,
                " and on one core; it cannot be traced: ", reason));
}

/// Attributes that a law of the library reads must be there.
void check_attributes(const LawSpec& spec, std::span<const KnownNames> known) {
  for (const std::shared_ptr<const Law>& law : spec.library->laws)
    for (const Input& input : law->graph.inputs_of(law->force)) {
      if (input.role != Role::attribute) continue;
      const KnownNames& names = known[input.who];
      const std::vector<std::string> all = names.all();
      const bool has = std::find(all.begin(), all.end(), input.name) != all.end();
      require(has || !names.place, spec.word, ": reads the attribute '", input.name, "', which ", names.whose,
              " has not; tie it to a particle");
      require(has, spec.word, ": reads the attribute '", input.name, "', which ", names.whose,
              " has not; give it attributes = { ", input.name, " = … }");
    }
}

LawFunction function_of(lua_State* state, int index, const LawSpec& spec, std::span<const KnownNames> known) {
  lua_getiuservalue(state, index, 1);
  LawFunction f{Callback(state, lua_gettop(state)), spec.form, spec.count, spec.def,
                {known.begin(), known.end()},       spec.exact};
  lua_pop(state, 1);
  if (f.def.name.empty()) f.def.name = f.function.place();
  return f;
}

/// Whether the function takes the time.
bool takes_time(const LawFunction& f) {
  bool takes = false;
  f.function.runtime().run([&](lua_State* state) {
    lua_Debug function;
    f.function.push(state);
    lua_getinfo(state, ">u", &function);
    const int last = is_pair(f.form) ? (f.form == LawForm::pair_potential ? 5 : 6) : 3;
    takes = function.isvararg || function.nparams >= last;
  });
  return takes;
}

LawKind kind_of(LawForm form) {
  if (form == LawForm::pair_force) return LawKind::pair;
  if (is_pair(form)) return LawKind::central;
  return form == LawForm::many_potential ? LawKind::many : LawKind::point;
}

/// Remembers what the function of a law that was traced just now reads.
void note_read(ResolvedLaw& law) {
  const LawFunction& f = law.function->law();
  law.traced = std::make_shared<const Traced>(trace(f.function.runtime(), f));
  law.captured = captured_values(f.function);
}

bool same_nodes(const Expressions& g, const Expressions& h) {
  if (g.size() != h.size() || g.inputs() != h.inputs() || g.splines() != h.splines()) return false;
  for (std::size_t i = 0; i < g.size(); i++) {
    const Expressions::Node &m = g[static_cast<Expr>(i)], &n = h[static_cast<Expr>(i)];
    const bool same = m.kind == n.kind && m.function == n.function && m.value == n.value && m.index == n.index;
    if (!same || m.terms != n.terms) return false;
  }
  return true;
}

/// Whether a law would be traced to what it was.
bool reads_the_same(const ResolvedLaw& law) {
  if (!law.traced) return false;
  const LawFunction& f = law.function->law();
  const Traced now = trace(f.function.runtime(), f), &then = *law.traced;
  return now.refusal.empty() && now.outputs == then.outputs && same_nodes(now.graph, then.graph);
}

ResolvedLaw make_ready(LawSpec& spec, const LawFunction& f, World& world, bool exchangeable) {
  const auto called = std::make_shared<CalledLaw>(f);
  check_runs(*called);
  std::string reason;
  const std::shared_ptr<const Law> law = try_trace(*called, reason);
  if (exchangeable && is_pair(f.form) && !f.def.one_sided) {
    const std::string difference = asymmetry(*called, law.get(), sample_times[1]);
    require(difference.empty(), f.function.place(), ": ", difference);
  }
  std::vector<double> values;
  for (const pantin::Parameter& p : f.def.parameters) values.push_back(p.value);
  if (law) {
    ResolvedLaw ready{{law}, values, called, spec.solve, {}, {}};
    note_read(ready);
    return ready;
  }
  require(!spec.strict, spec.word, ": strict = true, and the law cannot be traced: ", reason);
  require(spec.solve == Solve::explicitly, spec.word,
          ": implicit needs a law that can be traced, and this one cannot: ", reason);
  warn(world, spec, f, reason);
  return {{called_law(called)}, values, nullptr, Solve::explicitly, 0, {}};
}

}  // namespace

std::shared_ptr<const Law> called_law(const std::shared_ptr<CalledLaw>& function) {
  const LawFunction& f = function->law();
  Law law;
  law.name = f.def.name;
  law.kind = kind_of(f.form);
  law.count = f.count;
  law.cutoff = f.def.cutoff;
  law.one_sided = f.def.one_sided;
  law.exclude = f.def.exclude;
  law.parameters = f.def.parameters;
  law.called = function;
  law.inputs_wanted = function->inputs_wanted();
  law.velocity_dependent = !is_potential(f.form);
  law.timed =
      function->noises > 0 || ((takes_time(f) || function->reads_time) && depends_on_time(*function, sample_times));
  law.called_energy = is_potential(f.form) && !law.timed && !law.one_sided;
  return std::make_shared<const Law>(std::move(law));
}

ResolvedLaw resolve_law(lua_State* state, int index, World& world, std::span<const KnownNames> known,
                        bool exchangeable) {
  LawSpec* spec = to_law(state, index);
  require(spec, "a law is needed, as force.spring{ … } makes one, got ", kind_of_value(state, index),
          lua_isfunction(state, index) ? "; write force.pair{ potential = function … }" : "");
  require(static_cast<std::size_t>(spec->count) == known.size(), spec->word, " is a law of ", spec->count,
          spec->count == 1 ? " particle" : " particles", ", and ", known.size(), known.size() == 1 ? " is" : " are",
          " to have it");
  if (spec->library) {
    check_attributes(*spec, known);
    return *spec->library;
  }
  std::erase_if(spec->ready, [](const LawSpec::Ready& ready) { return has_changed(ready.law); });
  for (const LawSpec::Ready& ready : spec->ready)
    if (ready.exchangeable == exchangeable && std::equal(known.begin(), known.end(), ready.known.begin()))
      return ready.law;
  const LawFunction f = function_of(state, lua_absindex(state, index), *spec, known);
  spec->ready.push_back({{known.begin(), known.end()}, exchangeable, make_ready(*spec, f, world, exchangeable)});
  return spec->ready.back().law;
}

bool has_changed(const ResolvedLaw& law) {
  if (!law.function) return false;
  return law.captured ? captured_values(law.function->law().function) != law.captured : !reads_the_same(law);
}

namespace {

bool same_expressions(const Law& a, const Law& b) {
  return a.force == b.force && a.energy == b.energy && a.stiffness == b.stiffness && same_nodes(a.graph, b.graph);
}

}  // namespace

bool trace_again(ResolvedLaw& law) {
  if (reads_the_same(law)) {
    law.captured = captured_values(law.function->law().function);
    return true;
  }
  std::string reason;
  const std::shared_ptr<const Law> traced = try_trace(*law.function, reason);
  if (!traced) return false;
  if (!same_expressions(*traced, *law.laws.front())) law.laws = {traced};
  note_read(law);
  return true;
}

std::string recheck_law(const ResolvedLaw& law, const Called::Block& block) {
  return law.function ? disagreement(*law.function, *law.laws[0], block) : "";
}

}  // namespace pantin::lua
