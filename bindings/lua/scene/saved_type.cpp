// `scene.saved`: what lasts from one play of a scene to the next.
#include "lua/scene/saved_type.hpp"

#include "lua/law/law_run.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {
namespace {

constexpr std::size_t most_values = 1000, longest_name = 100, longest_value = 10000;  // of names and strings [bytes]

SavedValues& values_of(Script& script) { return *script.options.saved; }

bool read_saved(const Self& self, const char* name) {
  if (LawRun* law = Runtime::of(self.state).law) law->mistake(self.state, "a law cannot read scene.saved");
  const SavedValues& values = values_of(self.script);
  const auto found = values.find(name);
  lua_Integer whole = 0;
  const double* number = found == values.end() ? nullptr : std::get_if<double>(&found->second);
  if (found == values.end())
    lua_pushnil(self.state);
  else if (number && lua_numbertointeger(*number, &whole) && static_cast<double>(whole) == *number)
    lua_pushinteger(self.state, whole);
  else
    push_value(self.state, found->second);
  return true;
}

SceneValue check_saved(lua_State* state, const char* name, int index) {
  switch (lua_type(state, index)) {
    case LUA_TNUMBER: return check_number(state, index, "saved", name, "");
    case LUA_TBOOLEAN: return lua_toboolean(state, index) != 0;
    case LUA_TSTRING: break;
    default:
      throw Error(
          text("saved: ", name, " must be a number, a boolean, a string or nil, got ", kind_of_value(state, index)));
  }
  std::string value = check_text(state, index, "saved", name);
  require(value.size() <= longest_value, "saved: ", name, " may have at most ", longest_value, " bytes, got ",
          value.size());
  return value;
}

void save(lua_State* state, SavedValues& values, const char* name, int index) {
  const std::string key = name;
  SceneValue value = check_saved(state, name, index);
  require(key.size() <= longest_name, "saved: a name may have at most ", longest_name, " bytes, got ", key.size());
  require(values.contains(key) || values.size() < most_values, "saved: there are ", most_values, " values already");
  values.insert_or_assign(key, std::move(value));
}

bool write_saved(const Self& self, const char* name, int index) {
  SavedValues& values = values_of(self.script);
  if (lua_isnil(self.state, index))
    values.erase(name);
  else
    save(self.state, values, name, index);
  return true;
}

}  // namespace

void give_saved(lua_State* state, int index, const char* call, SceneOptions& options) {
  if (lua_isnoneornil(state, index)) return;
  const Ref* other = to_ref(state, index);
  if (other && other->kind == Kind::saved) {
    options.saved = other->script->options.saved;
    return;
  }
  options.saved = std::make_shared<SavedValues>();
  each_given(state, index, call, "argument 3, what is saved,",
             [&](const std::string& name) { save(state, *options.saved, name.c_str(), lua_gettop(state)); });
}

const Type& saved_type() {
  static const Type type = [] {
    Type made{
        "Saved",
        "saved",
        "What lasts from one play of a scene to the next: `scene.saved.best = 12`. Numbers, booleans and strings, "
        "by names; nil takes one away, and what is not there is nil; a whole number is an integer again. The window "
        "keeps them in a file for each "
        "scene, in `pantin/saved` of `XDG_DATA_HOME` (or `~/.local/share`). Without a window they begin empty and "
        "end with the run. Restore, reset, rewind and undo leave them.",
        {},
        {}};
    made.more = read_saved;
    made.write_more = write_saved;
    made.more_doc = "number|boolean|string|nil [its own] a value of yours";
    return made;
  }();
  return type;
}

}  // namespace pantin::lua
