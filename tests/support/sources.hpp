#pragma once
#include <initializer_list>
#include <map>
#include <string>

namespace pantin::sources {

using Files = std::map<std::string, std::string>;  ///< path in the repository, text

/// Every .cpp and .hpp file in some folders of the repository.
Files read(std::initializer_list<const char*> folders);

}  // namespace pantin::sources
