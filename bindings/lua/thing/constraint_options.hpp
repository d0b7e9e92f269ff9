#pragma once
// What the makers of constraints have in common.
#include "lua/thing/constraint_values.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

/// These options, and those that all constraints have.
std::vector<std::string> with_common(std::vector<std::string> names);
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
