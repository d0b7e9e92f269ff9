#pragma once
#include <limits>
#include <lua.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lua/law/force.hpp"

namespace pantin::lua {

class Options;

/// What laws of pairs have in common.
struct PairOptions {
  double cutoff = std::numeric_limits<double>::infinity();  ///< [m]
  std::optional<bool> shift;
  bool one_sided = false;
  int exclude = 0;  ///< connections
  Solve solve = Solve::explicitly;
};
PairOptions read_pair_options(const Options& options);
/// `implicit`: true, "dissipative" or false.
Solve read_implicit(const Options& options);

/// Pushes a law as a value. Its function, where it has one, is to be set as user value 1.
void push_law(lua_State* state, LawSpec spec);

/// Laws of the library that a script has made so far, by what they do not share with others of their name.
using KnownLaws = std::map<std::string, std::vector<std::shared_ptr<const Law>>>;
KnownLaws& known_laws(lua_State* state);

/// Adds `spring`, `lennard_jones` and the others of the engine's library to the table at the top.
void add_library_laws(lua_State* state);

}  // namespace pantin::lua
