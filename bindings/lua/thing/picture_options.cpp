#include "lua/thing/picture_options.hpp"

#include <utility>

#include "lua/thing/scene_file.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/tostring.hpp"
#include "scene/picture_file.hpp"

namespace pantin::lua {
namespace {

constexpr double plane_width = 1.0;  // [m] of a picture on what has no end

std::shared_ptr<const Picture> read_picture(Script& script, lua_State* state, const std::string& what,
                                            const std::string& file) {
  std::shared_ptr<const Picture>& known = script.pictures[file];
  if (known) return known;
  std::string content = read_scene_file(state, what, "pictures", file, largest_picture_file);
  PictureSize size;
  try {
    size = size_of_picture(content);
  } catch (const Error& wrong) { throw Error(text(what, ": '", file, "' ", wrong.what())); }
  require(size.columns > 0 && size.rows > 0 && size.columns <= largest_picture && size.rows <= largest_picture, what,
          ": '", file, "' has ", size.columns, " x ", size.rows, " pixels; at most ", largest_picture, " x ",
          largest_picture, " are read");
  try {
    check_pixels(content);
  } catch (const Error& wrong) { throw Error(text(what, ": '", file, "' ", wrong.what())); }
  return known = std::make_shared<const Picture>(Picture{file, std::move(content), size.columns, size.rows});
}

/// A box to lie over: both of its corners, or neither.
void take_box(const Options& o, const std::string& what, Cover& cover) {
  const std::optional<Vec3> low = o.vector("low", "m"), high = o.vector("high", "m");
  if (!low && !high) return;
  require(low && high, what, ": takes low and high, both corners of the box that it lies over, or neither");
  for (int k = 0; k < 3; k++) require((*low)[k] < (*high)[k], what, ": low must be below high in x, y and z");
  cover.low = *low;
  cover.high = *high;
}

/// A file, or a table with that and others.
std::shared_ptr<const Cover> check_cover(Script& script, lua_State* state, int index, const std::string& what,
                                         const std::vector<std::string>& others) {
  if (lua_isnil(state, index)) return nullptr;
  Cover cover;
  if (lua_type(state, index) == LUA_TSTRING) {
    cover.picture = read_picture(script, state, what, check_text(state, index, what, "the file"));
    return std::make_shared<const Cover>(std::move(cover));
  }
  require(lua_istable(state, index), what, " must be a file, \"crate.png\", or a table { file, width }, got ",
          kind_of_value(state, index));
  std::vector<std::string> known = {"file"};
  known.insert(known.end(), others.begin(), others.end());
  const Options o(state, index, what, known);
  take_box(o, what, cover);
  if (const auto width = o.number("width", "m")) {
    require(*width >= 1e-12 && *width <= 1e12, what, ": width must be from 1e-12 m to 1e12 m, got ", *width);
    cover.width = *width;
  }
  require(o.has("file"), what, ": needs a file, { file = \"crate.png\" }");
  cover.picture = read_picture(script, state, what, *o.string("file"));
  return std::make_shared<const Cover>(std::move(cover));
}

using Check = std::shared_ptr<const Cover>(Script&, lua_State*, int, const std::string&);

std::shared_ptr<const Cover> cover_option(Script& script, const Options& o, const char* name, Check* check) {
  if (!o.has(name)) return nullptr;
  auto cover = check(script, o.state(), o.push(name), text(o.what(), ": ", name));
  lua_pop(o.state(), 1);
  return cover;
}

}  // namespace

std::shared_ptr<const Cover> check_picture(Script& script, lua_State* state, int index, const std::string& what) {
  return check_cover(script, state, index, what, {"width", "low", "high"});
}

std::shared_ptr<const Cover> check_sprite(Script& script, lua_State* state, int index, const std::string& what) {
  auto cover = check_cover(script, state, index, what, {"width"});
  require(!cover || cover->width > 0.0, what, ": needs a width [m], { file = \"bird.png\", width = 0.4 }");
  return cover;
}

std::shared_ptr<const Cover> picture_option(Script& script, const Options& o) {
  return cover_option(script, o, "picture", check_picture);
}

std::shared_ptr<const Cover> sprite_option(Script& script, const Options& o) {
  return cover_option(script, o, "sprite", check_sprite);
}

std::shared_ptr<const Cover> spread(const std::shared_ptr<const Cover>& cover, const Geometry& geometry) {
  if (!cover) return nullptr;
  Cover made = *cover;
  if (std::holds_alternative<HalfSpaceShape>(geometry)) {
    require(same(made.low, made.high), "picture: low and high are for shapes that end; a plane has none");
    if (made.width == 0.0) made.width = plane_width;
  } else if (same(made.low, made.high)) {
    const Bounds box = bounds_of(geometry, {});
    made.low = box.low;
    made.high = box.high;
  }
  return std::make_shared<const Cover>(std::move(made));
}

void push_cover(lua_State* state, const Cover* cover, const Geometry* shape) {
  if (!cover) return lua_pushnil(state);
  const std::string& file = cover->picture->file;
  const bool own_box = !shape || is_over_own_box(*cover, *shape);
  if (cover->width == 0.0 && own_box) return static_cast<void>(lua_pushlstring(state, file.data(), file.size()));
  lua_createtable(state, 0, 4);
  lua_pushlstring(state, file.data(), file.size());
  lua_setfield(state, -2, "file");
  if (cover->width > 0.0) {
    lua_pushnumber(state, cover->width);
    lua_setfield(state, -2, "width");
  }
  if (own_box) return;
  push(state, cover->low);
  lua_setfield(state, -2, "low");
  push(state, cover->high);
  lua_setfield(state, -2, "high");
}

}  // namespace pantin::lua
