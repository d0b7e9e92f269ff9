#pragma once
// Pictures of the scene's folder, on shapes and as sprites.
#include <lua.hpp>
#include <memory>
#include <string>

#include "lua/value/arguments.hpp"
#include "model/cover.hpp"
#include "shapes/shape.hpp"

namespace pantin::lua {

struct Script;

/// `picture`: a file, or `{ file, width, low, high }`, spread over no shape yet; null where it is not given.
std::shared_ptr<const Cover> picture_option(Script& script, const Options& options);
/// The same on a shape; null stays null.
std::shared_ptr<const Cover> spread(const std::shared_ptr<const Cover>& cover, const Geometry& geometry);
/// `sprite`: `{ file, width }`; null where it is not given.
std::shared_ptr<const Cover> sprite_option(Script& script, const Options& options);

/// What is written to a field; nil: null.
std::shared_ptr<const Cover> check_picture(Script& script, lua_State* state, int index, const std::string& what);
std::shared_ptr<const Cover> check_sprite(Script& script, lua_State* state, int index, const std::string& what);
/// The file, or `{ file, width, low, high }`, the box where it is not that of the shape; nil of null.
void push_cover(lua_State* state, const Cover* cover, const Geometry* shape = nullptr);

/// White, where a picture is not to be tinted by what is usual.
inline constexpr Color untinted = {1.0f, 1.0f, 1.0f, 1.0f};

}  // namespace pantin::lua
