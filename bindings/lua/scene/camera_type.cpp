// `scene.camera`: where the scene is seen from.
#include "lua/scene/scene_settings.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {
namespace {

constexpr double largest_zoom = 1e6, longest_ease = 60.0;

void push_place(const Self& s, const std::optional<Vec3>& place) {
  if (place)
    push(s.state, *place);
  else
    lua_pushnil(s.state);
}

std::optional<Vec3> check_place(const Self& s, int index, const char* name) {
  if (lua_isnil(s.state, index)) return {};
  return check_vec(s.state, index, "scene: camera", name, "m");
}

AnyId check_followed(const Self& s, int index) {
  if (lua_isnil(s.state, index)) return {};
  return check_thing(s.state, index, "scene: camera", "follow").thing;
}

double check_zoom(double zoom) {
  require(zoom >= 1.0 / largest_zoom && zoom <= largest_zoom, "scene: camera: zoom must be > 0 and at most ",
          largest_zoom, ", got ", zoom);
  return zoom;
}

double check_ease(double ease) {
  require(ease >= 0.0 && ease <= longest_ease, "scene: camera: ease must be from 0 to ", longest_ease, " s, got ",
          ease);
  return ease;
}

}  // namespace

void write_camera(const Self& s, int index) {
  require(lua_istable(s.state, index), "scene: camera must be a table { at, look_at, follow, zoom, ease }, got ",
          kind_of_value(s.state, index));
  const Options o(s.state, index, "scene: camera", {"at", "look_at", "follow", "zoom", "ease"});
  CameraWish wish;
  wish.at = o.vector("at", "m");
  wish.look_at = o.vector("look_at", "m");
  require(!wish.at || !wish.look_at || norm(*wish.at - *wish.look_at) > 0.0,
          "scene: camera: at and look_at must not be the same place");
  wish.zoom = check_zoom(o.number("zoom", "").value_or(1.0));
  wish.ease = check_ease(o.number("ease", "s").value_or(0.0));
  if (o.has("follow")) {
    wish.follow = check_followed(s, o.push("follow"));
    lua_pop(s.state, 1);
  }
  s.script.camera = wish;
}

const Type& camera_type() {
  static const Type type = {
      "Camera",
      "camera",
      "Where the scene is seen from. A script may give it all at once, `scene.camera = { at = …, look_at = … }`, or "
      "change one of these at any time: the camera then goes where they say, in the time of `ease`, and between such "
      "changes it is whoever watches who moves it.",
      {{"at", "vec?", "m", "where it is (default from where all is seen, as where it would be at `look_at`)",
        [](const Self& s) { push_place(s, s.script.camera.at); },
        [](const Self& s, int i) { s.script.camera.at = check_place(s, i, "at"); }},
       {"look_at", "vec?", "m", "what is in the middle (default the middle of all)",
        [](const Self& s) { push_place(s, s.script.camera.look_at); },
        [](const Self& s, int i) { s.script.camera.look_at = check_place(s, i, "look_at"); }},
       {"follow", "Thing?", "", "what it goes along with (default none); with `ease` it has it in the middle",
        [](const Self& s) { push_thing(s.state, s.script, s.script.camera.follow); },
        [](const Self& s, int i) { s.script.camera.follow = check_followed(s, i); }},
       {"zoom", "number?", "1", "how many times larger all is seen than from there (default `1`)",
        [](const Self& s) { lua_pushnumber(s.state, s.script.camera.zoom); },
        [](const Self& s, int i) {
          s.script.camera.zoom = check_zoom(check_number(s.state, i, "scene: camera", "zoom", ""));
        }},
       {"ease", "number?", "s", "in which it comes nearer by a factor of e to where it is to be (default `0`: at once)",
        [](const Self& s) { lua_pushnumber(s.state, s.script.camera.ease); },
        [](const Self& s, int i) {
          s.script.camera.ease = check_ease(check_number(s.state, i, "scene: camera", "ease", "s"));
        }}},
      {}};
  return type;
}

}  // namespace pantin::lua
