#pragma once
#include <string>

namespace pantin::lua {

/// The table `force`, as annotations for language servers: laws of a scene's own, and those of the library from its table.
std::string force_annotations();

}  // namespace pantin::lua
