#include "laws/curve.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace pantin {

namespace {

bool comes_before(const std::shared_ptr<const Curve>& curve, std::string_view name) { return curve->name < name; }

}  // namespace

const Curve* Curves::find(std::string_view name) const {
  const auto found = std::lower_bound(list.begin(), list.end(), name, comes_before);
  return found != list.end() && (*found)->name == name ? found->get() : nullptr;
}

std::shared_ptr<const Curve> make_curve(std::string name, const Expressions& graph, std::span<const Expr> outputs) {
  assume(outputs.size() == (name == "color" ? 4u : 1u));
  for (const Input& input : graph.inputs_of(outputs))
    require(input == curve_age || input == curve_lifetime, name, ": it may depend on age and lifetime alone");
  return std::make_shared<const Curve>(Curve{std::move(name), lower(graph, outputs)});
}

std::shared_ptr<const Curves> with(const Curves* curves, std::shared_ptr<const Curve> curve) {
  auto result = curves ? std::make_shared<Curves>(*curves) : std::make_shared<Curves>();
  std::erase_if(result->list, [&](const auto& other) { return other->name == curve->name; });
  const auto at = std::lower_bound(result->list.begin(), result->list.end(), curve->name, comes_before);
  result->list.insert(at, std::move(curve));
  return result;
}

std::shared_ptr<const Curves> without(const std::shared_ptr<const Curves>& curves, std::string_view name) {
  if (!curves || !curves->find(name)) return curves;
  if (curves->list.size() == 1) return nullptr;
  auto result = std::make_shared<Curves>(*curves);
  std::erase_if(result->list, [&](const auto& other) { return other->name == name; });
  return result;
}

}  // namespace pantin
