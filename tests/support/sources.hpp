#pragma once
#include <initializer_list>
#include <map>
#include <string>

namespace pantin::sources {

using Files = std::map<std::string, std::string>;  ///< path in the repository, text

std::string folder();   ///< of the repository
std::string program();  ///< path of the pantin that was built with the tests
/// A library of tests/preload; empty where sanitizers want to be the first that is loaded.
std::string preload(const std::string& name);

/// Every .cpp and .hpp file in some folders of the repository.
Files read(std::initializer_list<const char*> folders);

}  // namespace pantin::sources
