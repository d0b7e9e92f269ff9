#pragma once
// Functions of a script as the engine calls them. Each says by its type what it is for, so that a state in a file can name
// it (lua/scene/state_file.cpp).
#include <string>

#include "constraints/kind.hpp"
#include "lua/law/recheck.hpp"
#include "lua/value/callback.hpp"
#include "lua/vm/runtime.hpp"
#include "scene/errors.hpp"

namespace pantin::lua {

struct Script;

/// Of a follow, a hand [m].
struct CalledPosition {
  Callback function;
  std::string what;
  Vec3 operator()(double time) const { return function.vector(time, what); }
};
/// What a constraint keeps.
struct CalledNumber {
  Callback function;
  std::string what;
  KeptNumber kept;
  double operator()(double time) const;
};
/// Of an orient.
struct CalledTurn {
  Callback function;
  std::string what;
  Quat operator()(double time) const;
};
/// Of an emitter [1/s].
struct CalledRate {
  Callback function;
  double operator()(double time) const;
};
/// Runs what an event calls; what a removed thing ended there is noted.
template <class Call>
auto noting_stale(Runtime& runtime, Call call) {
  try {
    return call();
  } catch (const StaleHandle& error) {
    if (runtime.broken_off.empty()) runtime.broken_off = error.what();
    throw;
  }
}

/// Of an event; a removed thing that is used ends this one call only.
struct CalledAction {
  Callback function;
  Script* script;
  AnyId target;
  void operator()() const;
};
struct CalledProgress {
  Callback function;
  Script* script;
  AnyId target;
  void operator()(double part) const;
};
/// Of a when: 1 where it holds, else 0.
struct CalledCondition {
  Callback function;
  double operator()() const;
};
struct CalledProbe {
  Callback function;
  std::string name;
  double operator()() const;
};
/// Of a join.
struct CalledOnMet {
  Callback function;
  Script* script;
  void operator()(ParticleId hinge) const;
};
/// Of a bonding.
struct WatchedBond {
  LawsAtWork* laws;
  ResolvedLaw law;
  void operator()(ConnectionId connection) const { watch_law(*laws, connection, law); }
};

}  // namespace pantin::lua
