#pragma once
// How scripts make constraints: the calls, and what they have in common.
#include "lua/thing/constraint_values.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

/// How scripts make a kind of constraint, and what the annotations and the reference say of that.
struct ConstraintCall {
  Method method;             ///< of the scene
  const char* wanted;        ///< its task in the reference, which several kinds may share
  const char* options = "";  ///< annotations of the options that it is the first to have
  const char* further = "";  ///< entry that its task names beside the call
};
// Of each kind.
#define CONSTRAINT_KIND(name) extern const ConstraintCall name##_call;
#include "model/constraint_kinds.hpp"

/// In the order of the kinds, without the axis, which comes with a hinge.
std::vector<const ConstraintCall*> constraint_calls();

/// The options of a call, what comes last in it: these, and those that all constraints have.
Options tie_options(lua_State* state, int index, std::string what, std::vector<std::string> names);
/// Gives a new constraint what all may have, and returns it to the script.
int finish(const Self& self, ConstraintId id, const Options& options);
/// The option `axis`; in a plane its normal, unless another is given.
Vec3 axis_option(const Self& self, const Options& options);

/// Of one that attracts what is far.
template <class Def>
void read_time_constant(const Options& options, Def& def) {
  def.time_constant = options.number("time_constant", "s").value_or(def.time_constant);
}

}  // namespace pantin::lua
