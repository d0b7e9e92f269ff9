#include "lua/law/curve_options.hpp"

#include "lua/law/trace.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {

std::shared_ptr<const Curve> curve_of(lua_State* state, int index, const std::string& what, const std::string& name) {
  LawFunction function{Callback(state, index),
                       name == "color" ? LawForm::color_curve : LawForm::number_curve,
                       0,
                       {},
                       {KnownNames{}},
                       true};
  function.def.name = name;
  const Traced traced = trace(Runtime::of(state), function);
  require(traced.refusal.empty(), what, ": ", name,
          " as a function of age and lifetime cannot be traced: ", traced.refusal);
  return make_curve(name, traced.graph, traced.outputs);
}

}  // namespace pantin::lua
