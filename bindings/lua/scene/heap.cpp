#include "lua/scene/heap.hpp"

#include <algorithm>

#include "lua/law/force_library.hpp"
#include "lua/scene/events.hpp"
#include "lua/thing/law_parameters.hpp"
#include "lua/thing/shape_options.hpp"
#include "lua/thing/shape_type.hpp"
#include "lua/thing/structure_type.hpp"
#include "lua/vm/prototypes.hpp"
#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"

namespace pantin::lua {
namespace {

const char permanents_key = 0;  // of the registry: names of what the sandbox begins with

enum class Mark : std::uint8_t {
  nil,
  no,
  yes,
  integer,
  number,
  string,
  permanent,
  known,
  table,
  closure,
  built_in,
  vec,
  quat,
  thing,
  event,
  structure,
  shape,
  law
};

constexpr const char* behaviour_name = "behaviour";
constexpr const char* loaded_modules = "_G.require#1";

bool is_object(lua_State* state, int index) {
  const int type = lua_type(state, index);
  return type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TUSERDATA || type == LUA_TTHREAD;
}

/// Keys that are strings, sorted: Lua's own order differs from run to run.
std::vector<std::string> string_keys(lua_State* state, int table) {
  std::vector<std::string> keys;
  lua_pushnil(state);
  while (lua_next(state, table)) {
    lua_pop(state, 1);
    if (lua_type(state, -1) == LUA_TSTRING) keys.emplace_back(lua_tostring(state, -1));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Names the object at the top, and what it leads to; pops it. `names`: stack index.
void name_permanents(lua_State* state, int names, const std::string& name) {
  luaL_checkstack(state, 8, nullptr);
  const int object = lua_gettop(state);
  lua_pushvalue(state, object);
  const bool is_new = is_object(state, object) && lua_rawget(state, names) == LUA_TNIL;
  lua_settop(state, object);
  if (!is_new) return lua_settop(state, object - 1);
  lua_pushvalue(state, object);
  lua_pushstring(state, name.c_str());
  lua_rawset(state, names);
  if (lua_istable(state, object))
    for (const std::string& key : string_keys(state, object)) {
      lua_pushstring(state, key.c_str());
      lua_rawget(state, object);
      name_permanents(state, names, name + "." + key);
    }
  if (lua_isfunction(state, object))
    for (int i = 1; lua_getupvalue(state, object, i); i++) name_permanents(state, names, text(name, "#", i));
  if (!to_ref(state, object) && lua_getmetatable(state, object)) name_permanents(state, names, name + "!");
  lua_settop(state, object - 1);
}

bool is_library_table(const std::string& name) {
  return name == loaded_modules || name.find_first_of("!#") == std::string::npos;
}

bool has_pointers(lua_State* state, int table) {
  bool any = false;
  lua_pushnil(state);
  while (lua_next(state, table)) {
    any = any || lua_islightuserdata(state, -1);
    lua_pop(state, 1);
  }
  return any;
}

std::string key_text(lua_State* state, int index) {
  if (lua_type(state, index) == LUA_TSTRING) return text(".", lua_tostring(state, index));
  if (lua_isinteger(state, index)) return text("[", lua_tointeger(state, index), "]");
  return "[…]";
}

struct RefData {
  std::uint32_t kind;  ///< a Kind
  std::uint32_t slot, generation;
  std::uint64_t serial;
  AnyId thing;
};

struct ShapeData {
  std::string kind;
  ShapeDef def;
  std::optional<Color> color;
  bool density_given;
};

}  // namespace

void note_permanents(lua_State* state) {
  lua_newtable(state);
  const int names = lua_gettop(state);
  lua_pushglobaltable(state);
  name_permanents(state, names, "_G");
  push_law_parameters_type(state);
  name_permanents(state, names, "parameters!");
  lua_rawsetp(state, LUA_REGISTRYINDEX, &permanents_key);
}

HeapWriter::HeapWriter(lua_State* state, Script& script, Writer& to)
    : state_(state), script_(script), to_(to), base_(lua_gettop(state)) {
  luaL_checkstack(state, 32, nullptr);
  lua_newtable(state);
  lua_newtable(state);
  lua_rawgetp(state, LUA_REGISTRYINDEX, &permanents_key);
  std::tie(seen_, list_, permanents_) = std::tuple(base_ + 1, base_ + 2, base_ + 3);
  const std::vector<SourceText>& chunks = script.runtime.chunks;
  for (std::uint32_t c = 0; c < chunks.size(); c++) {
    const std::vector<std::string> list = prototypes(state, chunks[c]);
    for (std::uint32_t i = 0; i < list.size(); i++) prototypes_.try_emplace(list[i], c, i);
  }
  built_in_[reinterpret_cast<const void*>(behaviour_part())] = behaviour_name;
  lua_pushnil(state);
  while (lua_next(state, permanents_)) {
    if (lua_CFunction called = lua_tocfunction(state, -2)) {
      std::string& known = built_in_[reinterpret_cast<const void*>(called)];
      const std::string name = lua_tostring(state, -1);
      if (known.empty() || name < known) known = name;
    }
    lua_pop(state, 1);
  }
}

bool HeapWriter::has(int index) {
  lua_pushvalue(state_, index);
  const bool met = lua_rawget(state_, seen_) == LUA_TNUMBER;
  lua_pop(state_, 1);
  return met;
}

void HeapWriter::function(const Callback& callback) {
  callback.push(state_);
  value(lua_gettop(state_), callback.place());
  lua_pop(state_, 1);
}

void HeapWriter::value(int index, const std::string& what) {
  const auto plain = [&](Mark mark, auto held) {
    visit(to_, mark);
    visit(to_, held);
  };
  switch (lua_type(state_, index)) {
    case LUA_TNIL: return plain(Mark::nil, std::monostate{});
    case LUA_TBOOLEAN: return plain(lua_toboolean(state_, index) ? Mark::yes : Mark::no, std::monostate{});
    case LUA_TNUMBER:
      if (lua_isinteger(state_, index)) return plain(Mark::integer, lua_tointeger(state_, index));
      return plain(Mark::number, lua_tonumber(state_, index));
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* data = lua_tolstring(state_, index, &size);
      return plain(Mark::string, std::string(data, size));
    }
    default: return object(index, what);
  }
}

void HeapWriter::object(int index, const std::string& what) {
  luaL_checkstack(state_, 16, nullptr);
  lua_pushvalue(state_, index);
  if (lua_rawget(state_, permanents_) == LUA_TSTRING) {
    Mark mark = Mark::permanent;
    std::string name = lua_tostring(state_, -1);
    lua_pop(state_, 1);
    visit(to_, mark);
    return visit(to_, name);
  }
  lua_pop(state_, 1);
  lua_pushvalue(state_, index);
  if (lua_rawget(state_, seen_) == LUA_TNUMBER) {
    Mark mark = Mark::known;
    visit(to_, mark);
    number(static_cast<std::uint64_t>(lua_tointeger(state_, -1)));
    return lua_pop(state_, 1);
  }
  lua_pop(state_, 1);
  lua_pushvalue(state_, index);
  lua_pushinteger(state_, ++count_);
  lua_rawset(state_, seen_);
  lua_pushvalue(state_, index);
  lua_rawseti(state_, list_, count_);
  names_.push_back(what);
  described(index, what);
}

void HeapWriter::described(int index, const std::string& what) {
  Mark mark = Mark::table;
  switch (lua_type(state_, index)) {
    case LUA_TTABLE: visit(to_, mark); return number(lua_rawlen(state_, index));
    case LUA_TFUNCTION: return closure(index, what);
    case LUA_TUSERDATA: return userdata(index, what);
    default: break;
  }
  throw Error(text(what, " is a ", lua_typename(state_, lua_type(state_, index)), ", which cannot be kept in a file"));
}

void HeapWriter::closure(int index, const std::string& what) {
  if (lua_CFunction called = lua_tocfunction(state_, index)) {
    const auto known = built_in_.find(reinterpret_cast<const void*>(called));
    require(known != built_in_.end(), what,
            " is a function that Pantin made while the scene ran, which cannot be kept in a file");
    Mark mark = Mark::built_in;
    std::uint64_t count = 0;
    while (lua_getupvalue(state_, index, static_cast<int>(count + 1))) lua_pop(state_, 1), count++;
    visit(to_, mark);
    visit(to_, known->second);
    return number(count);
  }
  lua_pushvalue(state_, index);
  const auto found = prototypes_.find(dumped(state_));
  lua_Debug info;
  lua_getinfo(state_, ">S", &info);
  const std::string place = text(info.short_src, ":", info.linedefined);
  require(found != prototypes_.end(), what, " is the function at ", place, ", whose text is not known");
  names_.back() = text("the function at ", place);
  Mark mark = Mark::closure;
  visit(to_, mark);
  visit(to_, found->second);
}

void HeapWriter::userdata(int index, const std::string& what) {
  const auto put = [&](Mark mark, auto held) {
    visit(to_, mark);
    visit(to_, held);
  };
  const std::optional<Tag> tag = tag_of(state_, index);
  if (const auto v = to_vec(state_, index)) return put(Mark::vec, *v);
  if (const auto q = to_quat(state_, index)) return put(Mark::quat, *q);
  if (tag == Tag::ref) return ref(index, what);
  require(tag == Tag::law, what, " is ", kind_of_value(state_, index), ", which cannot be kept in a file");
  Mark mark = Mark::law;
  visit(to_, mark);
  visit_spec(*this, to_, *to_law(state_, index));
}

void HeapWriter::ref(int index, const std::string& what) {
  const Ref& ref = *to_ref(state_, index);
  require(ref.script == &script_ && ref.kind != Kind::snapshot, what, " is ",
          ref.kind == Kind::snapshot ? "a snapshot" : "of another scene", ", which cannot be kept in a file");
  const auto put = [&](Mark mark, auto held) {
    visit(to_, mark);
    visit(to_, held);
  };
  if (ref.kind == Kind::structure) return put(Mark::structure, check_structure(state_, index, "save", what));
  if (ref.kind == Kind::shape) {
    const ShapeValue& shape = check_shape_value(state_, index, "save", what);
    return put(Mark::shape, ShapeData{shape.kind, shape.def, shape.color, shape.density_given});
  }
  const RefData data{static_cast<std::uint32_t>(ref.kind), ref.slot, ref.generation, ref.serial, ref.thing};
  if (ref.kind != Kind::event) return put(Mark::thing, data);
  put(Mark::event, data);
  std::shared_ptr<EventState> shared = shared_state_of_event(ref);
  visit(to_, shared);
}

void HeapWriter::contents() {
  permanent_tables();
  for (lua_Integer i = 1; i <= count_; i++) {
    lua_rawgeti(state_, list_, i);
    const int object = lua_gettop(state_);
    const std::string what = names_[static_cast<std::size_t>(i - 1)];
    if (lua_istable(state_, object)) table(object, what);
    if (lua_isfunction(state_, object)) upvalues(object, what, !lua_iscfunction(state_, object));
    if (tag_of(state_, object) == Tag::law) {
      lua_getiuservalue(state_, object, 1);
      value(lua_gettop(state_), what);
    }
    lua_settop(state_, object - 1);
  }
}

void HeapWriter::permanent_tables() {
  std::vector<std::string> names;
  lua_pushnil(state_);
  while (lua_next(state_, permanents_)) {
    const int object = lua_gettop(state_) - 1;
    const std::string name = lua_tostring(state_, -1);
    if (lua_istable(state_, object) && is_library_table(name) && !has_pointers(state_, object)) {
      visit(to_, const_cast<std::string&>(name));
      table(object, name == "_G" ? "the global" : name);
    }
    lua_pop(state_, 1);
  }
  std::string end;
  visit(to_, end);
}

void HeapWriter::table(int index, const std::string& what) {
  if (lua_getmetatable(state_, index) == 0) lua_pushnil(state_);
  value(lua_gettop(state_), what);
  lua_pop(state_, 1);
  lua_pushnil(state_);
  while (lua_next(state_, index)) {
    const int entry = lua_gettop(state_);
    const std::string name = is_object(state_, entry) ? what + key_text(state_, entry - 1) : std::string();
    value(entry - 1, what);
    value(entry, name);
    lua_pop(state_, 1);
  }
  lua_pushnil(state_);
  value(lua_gettop(state_), what);
  lua_pop(state_, 1);
}

void HeapWriter::upvalues(int index, const std::string& what, bool shared) {
  lua_pushvalue(state_, index);
  lua_rawget(state_, seen_);
  const lua_Integer own = lua_tointeger(state_, -1);
  lua_pop(state_, 1);
  for (int i = 1; const char* name = lua_getupvalue(state_, index, i); i++) {
    const void* id = shared ? lua_upvalueid(state_, index, i) : nullptr;
    const auto known = upvalues_.find(id);
    if (shared) number(known == upvalues_.end() ? 0 : static_cast<std::uint64_t>(known->second.first));
    if (shared && known != upvalues_.end()) {
      number(static_cast<std::uint64_t>(known->second.second));
    } else {
      if (shared) upvalues_[id] = {own, i};
      value(lua_gettop(state_), text("'", name, "' in ", what));
    }
    lua_pop(state_, 1);
  }
}

HeapReader::HeapReader(lua_State* state, Script& script, Reader& from)
    : state_(state), script_(script), from_(from), base_(lua_gettop(state)) {
  luaL_checkstack(state, 32, nullptr);
  lua_newtable(state);
  lua_newtable(state);
  std::tie(list_, permanents_) = std::tuple(base_ + 1, base_ + 2);
  lua_rawgetp(state, LUA_REGISTRYINDEX, &permanents_key);
  lua_pushnil(state);
  while (lua_next(state, -2)) {
    lua_pushvalue(state, -1);
    lua_pushvalue(state, -3);
    lua_rawset(state, permanents_);
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
  lua_pushcfunction(state, behaviour_part());
  lua_setfield(state, permanents_, behaviour_name);
  for (const SourceText& chunk : script.runtime.chunks) prototypes_.push_back(prototypes(state, chunk));
}

std::uint64_t HeapReader::number() {
  std::uint64_t n = 0;
  visit(from_, n);
  return n;
}

std::string HeapReader::text() {
  std::string s;
  visit(from_, s);
  return s;
}

Callback HeapReader::function() {
  value();
  require(lua_isfunction(state_, -1), "it has something else where a function should be");
  Callback callback(state_, lua_gettop(state_));
  lua_pop(state_, 1);
  return callback;
}

/// The object at the top.
void HeapReader::remember() {
  lua_pushvalue(state_, -1);
  lua_rawseti(state_, list_, ++count_);
}

void HeapReader::value() {
  const Reader::Within within(from_);
  luaL_checkstack(state_, 16, nullptr);
  Mark mark = Mark::nil;
  visit(from_, mark);
  switch (mark) {
    case Mark::nil: return lua_pushnil(state_);
    case Mark::no: return lua_pushboolean(state_, 0);
    case Mark::yes: return lua_pushboolean(state_, 1);
    case Mark::integer: return lua_pushinteger(state_, static_cast<lua_Integer>(number()));
    case Mark::number: {
      double x = 0.0;
      visit(from_, x);
      return lua_pushnumber(state_, x);
    }
    case Mark::string: {
      const std::string s = text();
      lua_pushlstring(state_, s.data(), s.size());
      return;
    }
    case Mark::permanent: {
      const std::string name = text();
      require(lua_getfield(state_, permanents_, name.c_str()) != LUA_TNIL, "there is no ", name, " any more");
      return;
    }
    case Mark::known:
      require(lua_rawgeti(state_, list_, static_cast<lua_Integer>(number())) != LUA_TNIL, "a value in it is missing");
      return;
    case Mark::table:
      lua_createtable(state_, static_cast<int>(std::min<std::uint64_t>(number(), from_.rest.size())), 0);
      return remember();
    case Mark::closure: return closure();
    case Mark::built_in: {
      const std::string name = text();
      const std::uint64_t count = number();
      lua_getfield(state_, permanents_, name.c_str());
      lua_CFunction called = lua_tocfunction(state_, -1);
      const bool has_own = lua_getupvalue(state_, -1, 1) != nullptr;  // which it trusts
      require(called && !has_own && count < 256, "there is no ", name, " any more");
      lua_pop(state_, 1);
      luaL_checkstack(state_, static_cast<int>(count) + 1, nullptr);
      for (std::uint64_t i = 0; i < count; i++) lua_pushnil(state_);
      lua_pushcclosure(state_, called, static_cast<int>(count));
      return remember();
    }
    default: return userdata(static_cast<std::uint8_t>(mark));
  }
}

void HeapReader::closure() {
  std::pair<std::uint32_t, std::uint32_t> at;
  visit(from_, at);
  require(at.first < prototypes_.size() && at.second < prototypes_[at.first].size(), "a function in it is missing");
  const std::string& code = prototypes_[at.first][at.second];
  if (luaL_loadbufferx(state_, code.data(), code.size(), "=?", "b") != LUA_OK) lua_error(state_);
  remember();
}

void HeapReader::userdata(std::uint8_t mark) {
  switch (static_cast<Mark>(mark)) {
    case Mark::vec: {
      Vec3 v = zero3();
      visit(from_, v);
      push(state_, v);
      break;
    }
    case Mark::quat: {
      Quat q;
      visit(from_, q);
      push(state_, q);
      break;
    }
    case Mark::thing:
    case Mark::event: {
      RefData data{};
      visit(from_, data);
      const auto kind = static_cast<Kind>(data.kind);
      const bool has_more = kind == Kind::structure || kind == Kind::shape || kind == Kind::snapshot;
      require(data.kind < kind_count && !has_more && (kind == Kind::event) == (static_cast<Mark>(mark) == Mark::event),
              "it names a kind that there is not");
      Ref ref = make_ref(script_, kind, data.slot, data.generation, data.serial);
      ref.thing = data.thing;
      if (kind != Kind::event) {
        push_ref(state_, ref);
        break;
      }
      std::shared_ptr<EventState> shared;
      visit(from_, shared);
      require(shared != nullptr, "an event in it has no state");
      push_event_ref(state_, ref, shared);
      break;
    }
    case Mark::structure: {
      Structure structure;
      visit(from_, structure);
      Structure checked = make_structure(structure.vertices, structure.edges, structure.faces);
      require(checked.edges.size() == structure.edges.size() &&
                  (structure.elements.empty() || structure.elements.size() == structure.vertices.size()),
              "a structure in it contradicts itself");
      push_structure(state_, script_, std::move(structure));
      break;
    }
    case Mark::shape: {
      ShapeData data;
      visit(from_, data);
      check_shape(data.def.geometry);
      push_shape(state_, script_, {shape_kind(data.kind).name, data.def, data.color, data.density_given});
      break;
    }
    case Mark::law: {
      push_law(state_, {});
      remember();
      return visit_spec(*this, from_, *to_law(state_, lua_gettop(state_)));
    }
    default: throw Error("it has a value of a kind that there is not");
  }
  remember();
}

void HeapReader::contents() {
  permanent_tables();
  for (lua_Integer i = 1; i <= count_; i++) {
    lua_rawgeti(state_, list_, i);
    const int object = lua_gettop(state_);
    if (lua_istable(state_, object)) table(object);
    if (lua_isfunction(state_, object)) upvalues(object, !lua_iscfunction(state_, object));
    if (tag_of(state_, object) == Tag::law) {
      value();
      lua_setiuservalue(state_, object, 1);
    }
    lua_settop(state_, object - 1);
  }
}

void HeapReader::permanent_tables() {
  for (std::string name = text(); !name.empty(); name = text()) {
    require(lua_getfield(state_, permanents_, name.c_str()) == LUA_TTABLE && is_library_table(name) &&
                !has_pointers(state_, lua_gettop(state_)),
            "there is no ", name, " any more");
    const int object = lua_gettop(state_);
    lua_pushnil(state_);
    while (lua_next(state_, object)) {
      lua_pop(state_, 1);
      lua_pushvalue(state_, -1);
      lua_pushnil(state_);
      lua_rawset(state_, object);
    }
    table(object);
    lua_settop(state_, object - 1);
  }
}

void HeapReader::table(int index) {
  value();
  require(lua_istable(state_, -1) || lua_isnil(state_, -1), "a metatable in it is none");
  if (lua_istable(state_, -1)) {
    for (const char* name : {"__gc", "__mode"}) {
      lua_pushstring(state_, name);
      require(lua_rawget(state_, -2) == LUA_TNIL, "a metatable in it has ", name);
      lua_pop(state_, 1);
    }
  }
  lua_setmetatable(state_, index);
  for (;;) {
    value();
    if (lua_isnil(state_, -1)) break;
    value();
    lua_rawset(state_, index);
  }
  lua_pop(state_, 1);
}

void HeapReader::upvalues(int index, bool shared) {
  for (int i = 1; lua_getupvalue(state_, index, i); i++) {
    lua_pop(state_, 1);
    const std::uint64_t of = shared ? number() : 0;
    if (of == 0) {
      value();
      lua_setupvalue(state_, index, i);
      continue;
    }
    const std::uint64_t which = number();
    lua_rawgeti(state_, list_, static_cast<lua_Integer>(of));
    require(lua_isfunction(state_, -1) && !lua_iscfunction(state_, -1) && which < 256 &&
                lua_upvalueid(state_, -1, static_cast<int>(which)),
            "a local in it is missing");
    lua_upvaluejoin(state_, index, i, lua_gettop(state_), static_cast<int>(which));
    lua_pop(state_, 1);
  }
}

}  // namespace pantin::lua
