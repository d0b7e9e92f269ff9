#include "view/tools.hpp"

#include <string_view>

namespace pantin {

const std::vector<Tool>& tools() {
  static const std::vector<Tool> table = {
      {ToolKind::drag, "drag", "\u261d", "pull a point; let go in full swing to throw it", {}},
      {ToolKind::cut, "cut", "\u2702", "stroke over hinges, nails, rods, strings and connections", {}},
      {ToolKind::join,
       "join",
       "\u26ad",
       "drag from a thing to a thing: a hinge draws them together, others tie them, also to a place; a chain touches "
       "things",
       {"hinge", "rod", "rope", "spring", "chain", "ball hinge"}},
      {ToolKind::nail, "nail", "\u2299", "click a point to nail it where it is; again to pull the nail out", {}},
      {ToolKind::push, "push", "\u279c", "drag from a thing: the longer, the harder it is pushed that way", {}},
      {ToolKind::spin,
       "spin",
       "\u21bb",
       "drag over a body as you would turn a globe; a motor goes on turning it so, a click takes the motor away",
       {"once", "motor"}},
      {ToolKind::remove, "remove", "\u2715", "click or stroke over what is to go", {}},
      {ToolKind::make,
       "make",
       "\u271a",
       "drag to make a thing of that size; a rod's ends and a wheel's middle are hinged to what is under them; of a "
       "polygon "
       "click the corners, or draw its outline",
       {"rod", "ball", "box", "wheel", "tetrahedron", "octahedron", "dodecahedron", "icosahedron", "polygon"}},
      {ToolKind::heat, "heat", "\u2600", "hold over things to shake them, or to bring them to rest", {"heat", "cool"}},
  };
  return table;
}

bool ToolChoice::is_polygon() const {
  return kind == ToolKind::make && std::string_view(tool().variants[variant]) == "polygon";
}

void ToolChoice::choose(ToolKind wanted) {
  const std::size_t variants = tools()[static_cast<std::size_t>(wanted)].variants.size();
  variant = wanted == kind && variants > 0 ? (variant + 1) % variants : 0;
  kind = wanted;
}

void ToolChoice::move_on(int places) {
  const auto count = static_cast<int>(tools().size());
  kind = static_cast<ToolKind>((static_cast<int>(kind) + places + count) % count);
  variant = 0;
}

}  // namespace pantin
