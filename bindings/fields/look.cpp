#include "fields/look.hpp"

#include <algorithm>
#include <iterator>

#include "base/check.hpp"

namespace pantin::fields {
namespace {

const char* const names[] = {"ball", "glow", "streak"};

}  // namespace

const char* name_of(Look look) { return names[static_cast<std::size_t>(look)]; }

Look look_of_name(std::string_view name, std::string_view what) {
  const auto found = std::find(std::begin(names), std::end(names), name);
  require(found != std::end(names), what, ": look must be \"ball\", \"glow\" or \"streak\", got \"", name, "\"");
  return static_cast<Look>(found - std::begin(names));
}

}  // namespace pantin::fields
