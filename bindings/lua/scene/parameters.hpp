#pragma once
#include <functional>
#include <lua.hpp>
#include <map>
#include <string>

#include "lua/thing/script.hpp"

namespace pantin::lua {

/// Applies `--set scene.FIELD=…`; throws UsageError.
void apply_settings(Script& script);
/// Throws UsageError where `--set` names a parameter that the script did not declare.
void check_parameters_known(const Script& script);
/// Calls the parameter's `on_change` with a new value; false where it has none.
bool change_parameter(Script& script, const std::string& name, const SceneValue& value);
/// Calls with each name of a table, whose value is on the stack's top. Without a table with none.
void each_given(lua_State* state, int index, const char* call, const char* what,
                const std::function<void(const std::string& name)>& take);
/// The parameters that a scene is opened with, as messages call their table.
extern const char* const given_what;
std::map<std::string, SceneValue> given_parameters(lua_State* state, int index, const char* call);
void push_value(lua_State* state, const SceneValue& value);

/// scene:param(name, default, { min, max, step, help, choices, on_change })
int scene_param(lua_State* state);

}  // namespace pantin::lua
