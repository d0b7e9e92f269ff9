#pragma once
// How particles look and what of them follows their age: options that families, particles and emitters share.
#include <lua.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edit/edit.hpp"
#include "laws/curve.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

/// `color`, `radius`, `look` and attributes; the first two and the last may be functions of (age, life) [s].
struct Looks {
  std::optional<Color> color;
  std::optional<double> radius;  ///< [m]
  std::optional<Look> look;
  std::vector<AttributeDef> attributes;
  std::shared_ptr<const Curves> curves;  ///< null: none
};
Looks look_options(const Options& options, const std::vector<std::string>& attributes);

/// Puts them into the definition of a particle or an emitter.
template <class Def>
void take_looks(Def& def, const Options& options, const std::vector<std::string>& attributes) {
  Looks looks = look_options(options, attributes);
  def.radius = looks.radius;
  def.color = looks.color;
  def.look = looks.look;
  def.attributes = std::move(looks.attributes);
  def.curves = std::move(looks.curves);
}

}  // namespace pantin::lua
