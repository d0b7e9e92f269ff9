#include "player/lua_of_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>

#include "base/shortened.hpp"
#include "edit/edit.hpp"
#include "fields/color.hpp"
#include "fields/property.hpp"
#include "measure/measure.hpp"
#include "shapes/hull.hpp"
#include "shapes/mass.hpp"

namespace pantin::player {
namespace {

std::string lua_of_turn(const Quat& q) {
  const Vec3 axis = vec(q.x, q.y, q.z);
  const double sine = norm(axis);
  if (sine == 0.0) return "quat(vec(0, 0, 1), 0)";
  return text("quat(", lua_of(axis / sine), ", ", lua_of(2.0 * std::atan2(sine, q.w)), ")");
}

std::string lua_of_cover(const Cover& cover) {
  const std::string file = quoted(cover.picture->file);
  return cover.width > 0.0 ? text("{ file = ", file, ", width = ", lua_of(cover.width), " }") : file;
}

/// A piece has its part of the picture of the whole.
std::string lua_of_picture(const Shape& shape) {
  const Cover& cover = *shape.cover;
  if (is_over_own_box(cover, shape.geometry)) return lua_of_cover(cover);
  const std::string width = cover.width > 0.0 ? text("width = ", lua_of(cover.width), ", ") : "";
  return text("{ file = ", quoted(cover.picture->file), ", ", width, "low = ", lua_of(cover.low),
              ", high = ", lua_of(cover.high), " }");
}

/// Whether one text says it of both.
bool is_pictured_alike(const Shape& a, const Shape& b) {
  if (!a.cover || !b.cover) return !a.cover && !b.cover;
  if (a.cover->picture != b.cover->picture || a.cover->width != b.cover->width) return false;
  const bool own = is_over_own_box(*a.cover, a.geometry);
  if (own || is_over_own_box(*b.cover, b.geometry)) return own && is_over_own_box(*b.cover, b.geometry);
  return same(a.cover->low, b.cover->low) && same(a.cover->high, b.cover->high);
}

/// As a script would write it; nothing where it has no text.
std::optional<std::string> lua_of_value(const fields::Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return lua_of(*number);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* words = std::get_if<std::string>(&value)) return quoted(*words);
  if (const auto* vector = std::get_if<Vec3>(&value)) return lua_of(*vector);
  if (const auto* turn = std::get_if<Quat>(&value)) return lua_of_turn(*turn);
  if (const auto* color = std::get_if<Color>(&value)) return quoted(fields::text_of(*color));
  return {};
}

constexpr double round_off = 1e-15;  // relative, of what adding points does to centre and axes

/// Where the frame's origin was given, so that the centre comes to lie where it is.
Vec3 given_origin(Vec3 centre, Vec3 arm) {
  const double size = std::fmax(largest(centre), largest(arm));
  const Vec3 full = centre - arm, plain = shortened(full, size);
  if (same(plain + arm, centre)) return plain;
  return same(full + arm, centre) || norm(plain + arm - centre) > round_off * size ? full : plain;
}

/// The body's frame as it was given; nothing: as the world's.
std::optional<Quat> given_frame(const World& world, BodyId id) {
  const Quat frame = orientation(world, id);
  if (frame.w > 0.0 && norm(vec(frame.x, frame.y, frame.z)) <= round_off) return {};
  return frame;
}

struct Form {
  std::string call, word;
  std::vector<std::string> options;
};

/// The ends of a capsule as they were given: the body's two points, where those make it, to the bit.
std::array<Vec3, 2> ends_of(const World& world, const Shape& shape, const CapsuleShape& rod) {
  const std::vector<PointId>& points = world.bodies[shape.body].points;
  if (points.size() >= 2) {
    const Vec3 from = world.points[points[0]].position, way = world.points[points[1]].position - from;
    if (0.5 * norm(way) == rod.half && same(from + way * 0.5, shape.at)) return {from, from + way};
  }
  const Vec3 half = rotate(shape.orientation, vec(0, 0, 1)) * rod.half;
  const double size = rod.half + largest(shape.at);
  return {shortened(shape.at - half, size), shortened(shape.at + half, size)};
}

std::string lua_of_list(std::span<const Vec3> places) {
  std::string list;
  for (const Vec3 at : places) list += text(list.empty() ? "" : ", ", lua_of(at));
  return list;
}

/// The axis that polygons of a script have no part of.
int flat_axis(const World& world) { return world.plane.flat() ? world.plane.normal : 2; }

/// A prism as `shape.polygon` makes it, corner by corner; nothing: it is none.
std::optional<std::string> lua_of_prism(const World& world, const Hull& hull, const std::string& at) {
  const int axis = flat_axis(world);
  const double half = hull.vertices[1][axis];
  std::vector<Vec3> outline;
  for (std::size_t i = 0; i + 1 < hull.vertices.size(); i += 2) {
    Vec3 low = hull.vertices[i], high = hull.vertices[i + 1];
    if (low[axis] != -half || high[axis] != half) return {};
    low[axis] = high[axis] = 0.0;
    if (!same(low, high)) return {};
    outline.push_back(low);
  }
  if (hull.vertices.size() % 2 != 0 || !(half > 0.0)) return {};
  return text("shape.polygon { points = { ", lua_of_list(outline), " }, thickness = ", lua_of(2.0 * half), at, " }");
}

std::optional<std::string> lua_of_hull(const World& world, const Shape& shape) {
  const auto* hull = std::get_if<std::shared_ptr<const Hull>>(&shape.geometry);
  if (!hull || shape.orientation.w != 1.0) return {};
  const std::string at = same(shape.at, zero3()) ? "" : ", at = " + lua_of(shape.at);
  if (auto prism = lua_of_prism(world, **hull, at)) return prism;
  return text("shape.hull { ", lua_of_list((*hull)->vertices), at, " }");
}

/// Several hulls of one material, as those of a polygon that is not convex.
std::optional<Form> form_of_hulls(const World& world, const Body& body) {
  const Material& first = world.shapes[body.shapes[0]].material;
  std::string list;
  for (const ShapeId id : body.shapes) {
    const Shape& shape = world.shapes[id];
    const std::optional<std::string> hull = lua_of_hull(world, shape);
    const Material& m = shape.material;
    const bool alike = m.density == first.density && m.friction == first.friction &&
                       m.restitution == first.restitution && !shape.sensor &&
                       is_pictured_alike(shape, world.shapes[body.shapes[0]]);
    if (!hull || !alike) return {};
    list += text(list.empty() ? "" : ", ", *hull);
  }
  return Form{"scene:body", "polygon", {text("shapes = { ", list, " }")}};
}

std::optional<Form> form_of(const World& world, const Shape& shape) {
  const Vec3 axis = shortened(rotate(shape.orientation, vec(0, 0, 1)), 1.0);
  const bool centred = same(shape.at, zero3());
  const Quat& q = shape.orientation;
  if (const auto* ball = std::get_if<BallShape>(&shape.geometry); ball && centred)
    return Form{"scene:ball", "ball", {"radius = " + lua_of(ball->radius)}};
  if (const auto* box = std::get_if<BoxShape>(&shape.geometry); box && centred && q.w == 1.0) {
    const Vec3 size = 2.0 * box->half;
    const bool cube = size[0] == size[1] && size[1] == size[2];
    return Form{"scene:box", "box", {"size = " + (cube ? lua_of(static_cast<double>(size[0])) : lua_of(size))}};
  }
  if (const auto* rod = std::get_if<CapsuleShape>(&shape.geometry)) {
    const auto [from, to] = ends_of(world, shape, *rod);
    return Form{
        "scene:capsule", "rod", {"radius = " + lua_of(rod->radius), "from = " + lua_of(from), "to = " + lua_of(to)}};
  }
  if (const auto* wheel = std::get_if<CylinderShape>(&shape.geometry); wheel && centred)
    return Form{
        "scene:cylinder",
        "wheel",
        {"radius = " + lua_of(wheel->radius), "length = " + lua_of(2.0 * wheel->half), "axis = " + lua_of(axis)}};
  if (const auto hull = lua_of_hull(world, shape))
    return Form{"scene:body", hull->starts_with("shape.polygon") ? "polygon" : "hull", {"shape = " + *hull}};
  return {};
}

void add_points(const World& world, BodyId id, std::vector<std::string>& options) {
  std::string points;
  for (const PointId point : world.bodies[id].points) {
    if (!is_made_with(world, point)) continue;
    const Point& row = world.points[point];
    const std::string made = lua_of_point(row);
    points += points.empty() ? "" : ", ";
    points += made[0] == '(' ? made.substr(1, made.size() - 2) : made.substr(1);
  }
  if (!points.empty()) options.push_back(text("points = { ", points, " }"));
}

void add_material(const World& world, const Body& body, std::vector<std::string>& options) {
  const Shape& shape = world.shapes[body.shapes[0]];
  const Material usual;
  double filled = 0.0;
  for (const ShapeId id : body.shapes) filled += usual.density * solid_mass(world.shapes[id].geometry).volume;
  if (shape.material.density != usual.density || std::fabs(body.own_mass - filled) > 1e-9 * filled)
    options.push_back("mass = " + lua_of(body.own_mass));
  if (shape.material.friction != usual.friction) options.push_back("friction = " + lua_of(shape.material.friction));
  if (shape.material.restitution != usual.restitution)
    options.push_back("restitution = " + lua_of(shape.material.restitution));
}

void add_motion(const World& world, BodyId id, std::vector<std::string>& options) {
  const Motion& m = world.motion_of(id);
  if (norm2(m.p) > 0.0) options.push_back("velocity = " + lua_of(m.p / m.mass));
  if (norm2(m.angular) > 0.0) options.push_back("spin = " + lua_of(angular_velocity(m)));
}

}  // namespace

std::string lua_of(double value) {
  if (std::isinf(value)) return value > 0.0 ? "math.huge" : "-math.huge";
  return value == 0.0 ? "0" : to_text(value);
}

std::string lua_of(Vec3 v) {
  return text("vec(", lua_of(static_cast<double>(v[0])), ", ", lua_of(static_cast<double>(v[1])), ", ",
              lua_of(static_cast<double>(v[2])), ")");
}

std::string quoted(const std::string& value) {
  std::string out = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    char code[8];
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20) {
      std::snprintf(code, sizeof code, "\\%03d", byte);
      out += code;
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string LuaOfBody::with(const std::string& position, const std::string& its_color) const {
  std::string all;
  for (const std::string& option : options) all += option + ", ";
  return text(call, " { ", all, "at = ", position, ", color = ", its_color, " }");
}

LuaOfBody lua_of_body(const World& world, BodyId id) {
  const Body& body = world.bodies[id];
  LuaOfBody lua;
  if (body.shapes.empty()) {
    lua.call = "scene:body";
    lua.word = body.points.size() == 2 ? "rod" : "body";
    if (body.own_mass > 0.0) lua.options.push_back("mass = " + lua_of(body.own_mass));
    const std::optional<Vec3> moments = fields::diagonal_of(body.own_inertia);
    if (moments && norm2(*moments) > 0.0) lua.options.push_back("inertia = " + lua_of(*moments));
    lua.color = fields::text_of(body.points.empty() ? BodyDef{}.color : world.points[body.points[0]].color);
  } else {
    const Shape& shape = world.shapes[body.shapes[0]];
    const std::optional<Form> form = body.shapes.size() > 1 ? form_of_hulls(world, body) : form_of(world, shape);
    if (!form || shape.sensor)
      return lua.why_not = body.shapes.size() > 1 ? "has several shapes" : "has a shape that no hand makes", lua;
    lua.call = form->call;
    lua.word = form->word;
    lua.options = form->options;
    lua.color = fields::text_of(shape.color);
    add_material(world, body, lua.options);
    if (shape.cover) lua.options.push_back("picture = " + lua_of_picture(shape));
  }
  if (body.sprite) lua.options.push_back("sprite = " + lua_of_cover(*body.sprite));
  if (!body.name.empty()) lua.options.push_back("name = " + quoted(body.name));
  add_points(world, id, lua.options);
  const std::optional<Quat> frame = given_frame(world, id);
  if (frame) lua.options.push_back("orientation = " + lua_of_turn(*frame));
  add_motion(world, id, lua.options);
  lua.arm = rotate(frame.value_or(Quat{}), body.centre);
  lua.centre = world.motion_of(id).x;
  lua.at = given_origin(lua.centre, lua.arm);
  return lua;
}

LuaOfBody lua_of_particle(const World& world, PointId id) {
  const Point& point = world.points[id];
  const FreeMotion& m = world.motion_of(id);
  LuaOfBody lua;
  lua.call = "scene:particle";
  lua.word = "particle";
  lua.options = {"mass = " + lua_of(point.mass), "radius = " + lua_of(point.radius)};
  if (norm2(m.v) > 0.0) lua.options.push_back("velocity = " + lua_of(m.v));
  lua.color = fields::text_of(point.color);
  lua.at = lua.centre = m.x;
  return lua;
}

std::string lua_of_point(const Point& point) {
  if (point.mass == 0.0 && point.radius == 0.0 && point.name.empty()) return text("(", lua_of(point.position), ")");
  std::string options = "at = " + lua_of(point.position);
  if (point.mass > 0.0) options += ", mass = " + lua_of(point.mass);
  if (point.radius > 0.0) options += ", radius = " + lua_of(point.radius);
  if (!point.name.empty()) options += ", name = " + quoted(point.name);
  return " { " + options + " }";
}

/// A body takes a serial, then each of its points two, one with its particle's.
bool is_made_with(const World& world, PointId id) {
  const Body& body = world.bodies[world.points[id].body];
  std::uint64_t serial = body.serial + 1;
  for (const PointId point : body.points) {
    if (world.points[point].serial != serial) return false;
    if (point == id) return true;
    serial += 2;
  }
  return false;
}

std::vector<std::string> changes_of_body(const World& now, const World& before, BodyId body) {
  std::vector<std::string> changes;
  for (const fields::Property* property : fields::properties(fields::body_type())) {
    if (property->write == nullptr || std::string_view(property->name) == "origin") continue;
    const auto value = lua_of_value(property->read(now, body)), was = lua_of_value(property->read(before, body));
    if (value && value != was) changes.push_back(text(property->name, " = ", *value));
  }
  return changes;
}

}  // namespace pantin::player
