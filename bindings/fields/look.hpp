#pragma once
#include <string>
#include <string_view>

#include "model/family.hpp"

namespace pantin::fields {

const char* name_of(Look look);
/// Throws Error, which begins with `what`, where there is none of this name.
Look look_of_name(std::string_view name, std::string_view what);

}  // namespace pantin::fields
