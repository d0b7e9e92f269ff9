#pragma once
// What of a particle follows its age: "radius", "color" or an attribute as a function of age and lifetime.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "laws/program.hpp"

namespace pantin {

/// The inputs of a curve: age and lifetime [s] of the particle; an endless lifetime is infinite.
inline const Input curve_age{Role::attribute, 0, 0, "age"}, curve_lifetime{Role::attribute, 0, 0, "lifetime"};

struct Curve {
  std::string name;  ///< "radius", "color", or an attribute
  Program program;   ///< outputs: the value [m, of a radius]; red, green, blue and opacity of a color
};

/// The curves of a particle, which all particles of a kind share.
struct Curves {
  std::vector<std::shared_ptr<const Curve>> list;  ///< sorted by name
  const Curve* find(std::string_view name) const;
};

/// `outputs`, of age and lifetime, as a curve; one for a number, four for a color. Throws Error where they depend on
/// anything else.
std::shared_ptr<const Curve> make_curve(std::string name, const Expressions& graph, std::span<const Expr> outputs);
/// The curves with one put in or replaced, or with one taken out; null where none is left.
std::shared_ptr<const Curves> with(const Curves* curves, std::shared_ptr<const Curve> curve);
std::shared_ptr<const Curves> without(const std::shared_ptr<const Curves>& curves, std::string_view name);

}  // namespace pantin
