#pragma once
// Laws of short scenes, made ready, and what they give.
#include <cmath>
#include <map>

#include "bindings/lua_support.hpp"
#include "laws/program.hpp"
#include "lua/law/force.hpp"
#include "lua/scene/script_scene.hpp"
#include "lua/thing/script.hpp"

namespace pantin::lua_tests {

/// The law that a scene's global `law` holds, between particles of families with a charge.
struct LawScene {
  std::unique_ptr<Scene> scene;
  lua::ResolvedLaw resolved;
  std::shared_ptr<const Law> by_calls;
  const Law& law() const { return *resolved.laws[0]; }
  /// The same law, not traced.
  const Law& called() const { return *by_calls; }
};

inline LawScene resolve(const std::string& source, bool exchangeable = false) {
  LawScene result;
  result.scene = open(source);
  lua::Script& script = lua::script_of(*result.scene);
  script.runtime.run([&](lua_State* state) {
    lua_getglobal(state, "law");
    const lua::LawSpec* spec = lua::to_law(state, -1);
    require(spec, "the scene has no law");
    const std::vector<lua::KnownNames> known(static_cast<std::size_t>(spec->count), {"family 'ion'", {"charge"}});
    result.resolved = lua::resolve_law(state, -1, script.world, known, exchangeable);
    if (result.resolved.function) result.by_calls = lua::called_law(result.resolved.function);
  });
  return result;
}

/// The message of a law that must be refused, or "".
inline std::string refusal(const std::string& source, bool exchangeable = false) {
  try {
    resolve(source, exchangeable);
  } catch (const Error& error) { return error.what(); }
  return "";
}

/// Values of what a law sees; what is not given is 0.
using Seen = std::map<Input, double>;

inline Input input(Role role, int who = 0, int component = 0, std::string name = "") {
  return {role, static_cast<std::uint8_t>(who), static_cast<std::uint8_t>(component), std::move(name)};
}
inline Seen pair(double r, double charge_a = 0.0, double charge_b = 0.0) {
  return {{input(Role::distance2), r * r},
          {input(Role::attribute, 0, 0, "charge"), charge_a},
          {input(Role::attribute, 1, 0, "charge"), charge_b}};
}

/// Forces, then the energy, of expressions or of a function that is called.
inline std::vector<double> outputs_of(const Law& law, const Seen& seen) {
  const auto value = [&](const Input& i) {
    const auto found = seen.find(i);
    if (found != seen.end()) return found->second;
    for (const Parameter& p : law.parameters)
      if (i.role == Role::parameter && i.name == p.name) return p.value;
    return 0.0;
  };
  const std::size_t count = law.force.size() + (law.has_energy() ? 1 : 0);
  if (!law.called) {
    std::vector<Expr> outputs = law.force;
    if (law.has_energy()) outputs.push_back(law.energy);
    const Program program = lower(law.graph, outputs);
    Machine machine(program);
    for (std::size_t i = 0; i < program.inputs.size(); i++) machine.fill(static_cast<int>(i), value(program.inputs[i]));
    machine.run_uniform();
    machine.run(1);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; i++) values.push_back(machine.output(static_cast<int>(i))[0]);
    return values;
  }
  const std::size_t forces = law.kind == LawKind::central ? 1
                             : law.kind == LawKind::many  ? 3 * static_cast<std::size_t>(law.count)
                                                          : 3;
  std::vector<double> given, parameters, values(forces + (law.called_energy ? 1 : 0));
  for (const Input& i : law.inputs_wanted) given.push_back(value(i));
  for (const Parameter& p : law.parameters) parameters.push_back(value(input(Role::parameter, 0, 0, p.name)));
  std::vector<const double*> inputs;
  std::vector<double*> outputs;
  for (double& x : given) inputs.push_back(&x);
  for (double& x : values) outputs.push_back(&x);
  Called::Block block;
  block.n = 1;
  block.inputs = inputs;
  block.outputs = outputs;
  block.parameters = parameters;
  const auto time = seen.find(input(Role::time));
  block.time = time == seen.end() ? 0.0 : time->second;
  law.called->run(block);
  return values;
}

}  // namespace pantin::lua_tests
