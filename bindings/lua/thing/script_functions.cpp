#include "lua/thing/script_functions.hpp"

#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {
namespace {

int push_time(lua_State* state, double time) {
  lua_pushnumber(state, time);
  return 1;
}

int push_target(lua_State* state, Script& script, const AnyId& target) {
  if (std::holds_alternative<std::monostate>(target)) return 0;
  push_thing(state, script, target);
  return 1;
}

template <class Call>
void dropping_stale(Script& script, Call call) {
  try {
    noting_stale(script.runtime, call);
  } catch (const StaleHandle& error) { log_line(script.world, "dropped", error.what()); }
}

}  // namespace

double CalledNumber::operator()(double time) const {
  double value = 0.0;
  function.call([&](lua_State* state) { return push_time(state, time); },
                [&](lua_State* state) {
                  value = check_number(state, -1, what, "its result", "");
                  require(kept.allows(value), what, ": its result must ",
                          kept.range == KeptNumber::Range::positive ? "be > 0 " : "not be 0 ", kept.unit, ", got ",
                          value);
                });
  return value;
}

Quat CalledTurn::operator()(double time) const {
  Quat value;
  function.call([&](lua_State* state) { return push_time(state, time); },
                [&](lua_State* state) { value = check_quat(state, -1, what, "its result"); });
  return value;
}

double CalledRate::operator()(double time) const {
  double rate = 0.0;
  function.call([&](lua_State* state) { return push_time(state, time); },
                [&](lua_State* state) {
                  rate = check_number(state, -1, "emitter", "what rate returns", "1/s");
                  require(rate >= 0.0, "emitter: rate must be >= 0 1/s, got ", rate);
                });
  return rate;
}

void CalledAction::operator()() const {
  dropping_stale(*script, [&] { function.call([&](lua_State* s) { return push_target(s, *script, target); }); });
}

void CalledProgress::operator()(double part) const {
  dropping_stale(*script, [&] {
    function.call([&](lua_State* s) {
      lua_pushnumber(s, part);
      return 1 + push_target(s, *script, target);
    });
  });
}

double CalledCondition::operator()() const {
  bool holds = false;
  noting_stale(function.runtime(),
               [&] { function.call({}, [&](lua_State* s) { holds = lua_toboolean(s, -1) != 0; }); });
  return holds ? 1.0 : 0.0;
}

double CalledProbe::operator()() const { return function.number(text("probe '", name, "'")); }

void CalledOnMet::operator()(ParticleId hinge) const {
  dropping_stale(*script, [&] {
    function.call([&](lua_State* s) {
      push_thing(s, *script, hinge);
      return 1;
    });
  });
}

}  // namespace pantin::lua
