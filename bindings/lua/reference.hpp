#pragma once
#include <string>

namespace pantin::lua {

/// The reference of the scene's functions and fields as Markdown, made from the annotations, so that the two say the
/// same: assets/pages/reference.md.
std::string reference();

}  // namespace pantin::lua
