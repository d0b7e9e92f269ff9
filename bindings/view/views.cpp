#include "view/views.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/check.hpp"

namespace pantin {

namespace {

constexpr std::array<NamedView, 17> table = {{
    {View::bodies, "bodies", "bodies, particles and hinges"},
    {View::loads, "loads", "ties and hinges coloured by load: red pulls, blue pushes"},
    {View::shadows, "shadows", "shadows"},
    {View::rings, "rings", "rings of hinges: each member, its body, and the next member"},
    {View::forces, "forces", "forces of hinges and constraints as arrows"},
    {View::velocities, "velocities", "velocities as arrows: the way of 0.1 s at the scene's pace"},
    {View::trails, "trails", "where things have been"},
    {View::families, "families", "a colour for each family"},
    {View::articulates, "articulates", "a colour for each articulate: what is solved together"},
    {View::islands, "islands", "a colour for each island: what touches, and what ties that"},
    {View::temperature, "temperature", "temperature of each thing: blue cold, red hot"},
    {View::errors, "errors", "gaps of hinges and what the solver left open: blue small, red large"},
    {View::cells, "cells", "cells of the search for neighbours"},
    {View::contacts, "contacts", "contacts with their normals, joined in manifolds; grey: not touching yet"},
    {View::contact_forces, "contact_forces", "forces of contacts as arrows, on one of the two"},
    {View::asleep, "asleep", "what sleeps looks dim"},
    {View::dark, "dark", "a dark background"},
}};

constexpr bool colours(View view) {
  return view == View::families || view == View::articulates || view == View::islands || view == View::temperature ||
         view == View::errors;
}

}  // namespace

std::span<const NamedView> view_table() { return table; }

void Views::set(View view, bool wanted) {
  if (wanted && colours(view))
    for (const NamedView& other : table)
      if (colours(other.view)) set(other.view, false);
  const std::uint32_t bit = 1u << static_cast<unsigned>(view);
  bits_ = wanted ? bits_ | bit : bits_ & ~bit;
}

Views read_views(const std::string& list) {
  Views views;
  std::string known;
  for (const NamedView& named : table) known += (known.empty() ? "" : ", ") + std::string(named.name);
  std::string_view rest = list;
  while (true) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    std::string_view name = rest.substr(0, comma);
    const bool off = name.starts_with('-');
    if (off) name.remove_prefix(1);
    const auto found = std::ranges::find_if(table, [&](const NamedView& named) { return named.name == name; });
    require(found != table.end(), "there is no view '", name, "'; there are: ", known);
    views.set(found->view, !off);
    if (comma == rest.size()) return views;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace pantin
