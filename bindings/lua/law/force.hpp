#pragma once
// Laws as values of Lua: what `force.pair{ … }`, `force.spring{ … }` and the others return.
#include <cstdint>
#include <lua.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lua/law/fallback.hpp"
#include "lua/law/law_run.hpp"
#include "world/world.hpp"

namespace pantin::lua {

struct Traced;

/// A law made ready for particles of known families.
struct ResolvedLaw {
  /// All act, with the same parameters: a law of the library that also dissipates has a second part without energy. The
  /// same objects for laws that differ in the values of their parameters alone.
  std::vector<std::shared_ptr<const Law>> laws;
  std::vector<double> values;  ///< (parameters of the law); where one is `present` it is to be measured
  std::shared_ptr<CalledLaw>
      function;                     ///< of a traced law of a scene: to be compared with now and then (`recheck_law`)
  Solve solve = Solve::explicitly;  ///< of its connections
  std::optional<std::uint64_t> captured = 0;  ///< of such a function, when it was traced: see `captured_values`
  std::shared_ptr<const Traced> traced;       ///< what it was traced to; may be null
};

/// A law as a scene wrote it.
struct LawSpec {
  std::string word;  ///< "force.pair": begins messages
  LawKind kind = LawKind::central;
  int count = 2;                       ///< particles
  std::optional<ResolvedLaw> library;  ///< of the library; else the scene's own function
  LawForm form = LawForm::pair_potential;
  LawDef def;
  bool strict = false;              ///< not to be traced is an error
  bool exact = true;                ///< an equality test is not traced
  Solve solve = Solve::explicitly;  ///< of its connections
  bool warned = false;              ///< that it is called in Lua

  /// What was made ready so far, and for whom.
  struct Ready {
    std::vector<KnownNames> known;
    bool exchangeable;
    ResolvedLaw law;
  };
  std::vector<Ready> ready;
};

/// The law at `index`, or null.
LawSpec* to_law(lua_State* state, int index);

/// Makes the law at `index` ready: traces a scene's own, checks it on samples, and falls back to calling it with a warning
/// in the log of the world. `known`: what it may read of each of its particles; `exchangeable`: a and b are of one
/// family, so the law must be the same with them exchanged. Throws Error where it is no law, or is wrong.
ResolvedLaw resolve_law(lua_State* state, int index, World& world, std::span<const KnownNames> known,
                        bool exchangeable);

/// Whether a traced law reads what the script has changed since.
bool has_changed(const ResolvedLaw& law);
/// Traces such a law with what it reads now; false where that cannot be done any more.
bool trace_again(ResolvedLaw& law);
/// Compares a traced law with its function on real pairs, given as for a called law (columns of
/// `function->inputs_wanted()`; no outputs). "" or a sentence, after which `called_law` should take its place.
std::string recheck_law(const ResolvedLaw& law, const Called::Block& block);
/// The law that calls the function.
std::shared_ptr<const Law> called_law(const std::shared_ptr<CalledLaw>& function);

/// Puts the table `force` into the globals.
void open_force(lua_State* state);

}  // namespace pantin::lua
