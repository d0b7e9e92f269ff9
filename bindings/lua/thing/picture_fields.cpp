#include "lua/thing/picture_fields.hpp"

#include "lua/thing/fields.hpp"
#include "lua/thing/picture_options.hpp"
#include "lua/thing/script.hpp"

namespace pantin::lua {
namespace {

Body& pictured_body(const Self& s) { return s.world.bodies[s.ref.id<BodyId>()]; }
Shape& pictured_shape(const Self& s) { return s.world.shapes[std::get<ShapeId>(s.ref.thing)]; }
Family& pictured_family(const Self& s) { return s.world.families[s.ref.id<FamilyId>()]; }

void push_picture(const Self& s, const char* word, const char* name, const Cover* cover,
                  const Geometry* shape = nullptr) {
  push_cover(s.state, cover, shape);
  if (lua_istable(s.state, -1)) lock_copy(s.state, word, name, true);
}

void read_picture_of_body(const Self& s) {
  const Body& body = pictured_body(s);
  if (body.shapes.empty()) return lua_pushnil(s.state);
  const Shape& shape = s.world.shapes[body.shapes[0]];
  push_picture(s, "body", "picture", shape.cover.get(), &shape.geometry);
}

void write_picture_of_body(const Self& s, int index) {
  const auto cover = check_picture(s.script, s.state, index, "body: picture");
  for (const ShapeId id : pictured_body(s).shapes)
    s.world.shapes[id].cover = spread(cover, s.world.shapes[id].geometry);
}

void write_picture_of_collider(const Self& s, int index) {
  Shape& shape = pictured_shape(s);
  shape.cover = spread(check_picture(s.script, s.state, index, "collider: picture"), shape.geometry);
}

}  // namespace

Field picture_of_body() {
  return {"picture",
          "Picture?",
          "",
          "of its first shape; writing gives it to all",
          read_picture_of_body,
          write_picture_of_body};
}

Field picture_of_collider() {
  return {"picture",
          "Picture?",
          "",
          "that is drawn on it, times its color; nil: the color alone",
          [](const Self& s) {
            push_picture(s, "collider", "picture", pictured_shape(s).cover.get(), &pictured_shape(s).geometry);
          },
          write_picture_of_collider};
}

Field sprite_of_body() {
  return {"sprite",
          "Sprite?",
          "",
          "drawn instead of its shapes and points; nil: those",
          [](const Self& s) { push_picture(s, "body", "sprite", pictured_body(s).sprite.get()); },
          [](const Self& s, int index) {
            pictured_body(s).sprite = check_sprite(s.script, s.state, index, "body: sprite");
          }};
}

Field sprite_of_family() {
  return {"sprite",
          "Sprite?",
          "",
          "drawn instead of its free particles; nil: as their look says",
          [](const Self& s) { push_picture(s, "family", "sprite", pictured_family(s).sprite.get()); },
          [](const Self& s, int index) {
            pictured_family(s).sprite = check_sprite(s.script, s.state, index, "family: sprite");
          }};
}

}  // namespace pantin::lua
