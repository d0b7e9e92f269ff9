#include "lua/thing/shape_options.hpp"

#include <cmath>

#include "lua/thing/picture_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/structure_type.hpp"
#include "lua/value/tostring.hpp"
#include "lua/value/values.hpp"
#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"

namespace pantin::lua {
namespace {

constexpr double most_heights = 1e7;
const Vec3 up = vec(0, 1, 0);

/// Says which option is wrong in what the engine refuses.
template <class Make>
auto checked(const Options& o, const char* name, const Make& make) {
  try {
    return make();
  } catch (const Error& error) { throw Error(text(o.what(), ": ", name, ": ", error.what())); }
}

double needed(const Options& o, const char* name) {
  const auto given = o.number(name, "m");
  require(given.has_value(), o.what(), ": needs ", name, " [m]");
  require(*given > 0.0, o.what(), ": ", name, " must be > 0 m, got ", *given);
  return *given;
}

Vec3 axis_of(const Options& o, const char* name) {
  const Vec3 given = o.vector(name, "").value_or(up);
  require(norm(given) > 0.0, o.what(), ": ", name, " must have a length > 0");
  return direction(given);
}

void read_ball(Script&, const Options& o, ShapeDef& def) { def.geometry = BallShape{needed(o, "radius")}; }

void read_box(Script&, const Options& o, ShapeDef& def) {
  Vec3 size = zero3();
  if (o.has("size")) {
    require(!o.has("x") && !o.has("y") && !o.has("z"), o.what(), ": takes size, or x, y and z, not both");
    const int at = o.push("size");
    if (lua_type(o.state(), at) == LUA_TNUMBER)
      size = vec(1, 1, 1) * check_number(o.state(), at, o.what(), "size", "m");
    else
      size = check_vec(o.state(), at, o.what(), "size", "m");
    lua_pop(o.state(), 1);
    for (int i = 0; i < 3; i++)
      require(size[i] > 0.0, o.what(), ": size must be > 0 m along each axis, got (", size[0], ", ", size[1], ", ",
              size[2], ")");
  } else {
    require(o.has("x") || o.has("y") || o.has("z"), o.what(), ": needs size, a vec [m], or x, y and z [m]");
    size = vec(needed(o, "x"), needed(o, "y"), needed(o, "z"));
  }
  def.geometry = BoxShape{size * 0.5};
}

void read_capsule(Script&, const Options& o, ShapeDef& def) {
  const double radius = needed(o, "radius");
  if (!o.has("from") && !o.has("to")) {
    def.geometry = CapsuleShape{radius, 0.5 * needed(o, "length")};
    def.orientation = turn_to(up);
    return;
  }
  require(o.has("from") && o.has("to") && !o.has("length"), o.what(), ": takes from and to, or length");
  const Vec3 from = *o.vector("from", "m"), way = *o.vector("to", "m") - from;
  require(norm(way) > 0.0, o.what(), ": from and to must be apart; a ball has one centre");
  def.geometry = CapsuleShape{radius, 0.5 * norm(way)};
  def.at = from + way * 0.5;
  def.orientation = turn_to(direction(way));
}

void read_cylinder(Script&, const Options& o, ShapeDef& def) {
  def.geometry = CylinderShape{needed(o, "radius"), 0.5 * needed(o, "length")};
  def.orientation = turn_to(axis_of(o, "axis"));
}

/// Calls `read(index on the stack, number)` for each element of the list at `at`.
template <class Read>
void each_element(lua_State* state, int at, const Read& read) {
  for (lua_Unsigned i = 1; i <= lua_rawlen(state, at); i++) {
    lua_rawgeti(state, at, static_cast<lua_Integer>(i));
    read(lua_gettop(state), i);
    lua_pop(state, 1);
  }
}

/// A list of vecs, or the vertices of a structure.
std::vector<Vec3> positions(const Options& o, const char* name, const char* one) {
  lua_State* state = o.state();
  const int at = o.push(name);
  require(!lua_isnil(state, at), o.what(), ": needs ", name, ", a list of vecs [m] or a structure");
  std::vector<Vec3> list;
  if (const Ref* ref = to_ref(state, at); ref && ref->kind == Kind::structure) {
    list = check_structure(state, at, o.what().c_str(), name).vertices;
  } else {
    require(lua_istable(state, at), o.what(), ": ", name, " must be a list of vecs [m] or a structure, got ",
            kind_of_value(state, at));
    each_element(state, at, [&](int element, lua_Unsigned i) {
      list.push_back(check_vec(state, element, o.what(), text(one, " ", i), "m"));
    });
  }
  lua_pop(state, 1);
  return list;
}

void read_hull(Script&, const Options& o, ShapeDef& def) {
  const std::vector<Vec3> points = positions(o, "points", "point");
  def.geometry = checked(o, "points", [&] { return make_hull(points); });
}

/// Which axis polygons and lines have no part of: that across the scene's plane, else z.
int flat_axis(const Script& script) { return script.world.plane.flat() ? script.world.plane.normal : 2; }

/// Positions in the scene's plane, else in that of x and y.
std::vector<Vec3> flat_positions(const Script& script, const Options& o) {
  const std::vector<Vec3> list = positions(o, "points", "point");
  const int axis = flat_axis(script);
  for (std::size_t i = 0; i < list.size(); i++)
    require(list[i][axis] == 0.0, o.what(), ": point ", i + 1, " must lie in the plane of ", axis == 0 ? "y" : "x",
            " and ", axis == 2 ? "y" : "z", ", got ",
            axis == 0   ? "x"
            : axis == 1 ? "y"
                        : "z",
            " = ", list[i][axis], " m");
  return list;
}

void read_polygon(Script& script, const Options& o, ShapeDef& def) {
  const std::vector<Vec3> outline = flat_positions(script, o);
  const double thickness = o.has("thickness") ? needed(o, "thickness") : 1.0;
  require(outline.size() >= 3, o.what(), ": points must be 3 or more, got ", outline.size());
  Vec3 side = zero3();
  side[flat_axis(script)] = 0.5 * thickness;
  std::vector<Vec3> corners;
  for (const Vec3 at : outline) corners.insert(corners.end(), {at - side, at + side});
  def.geometry = checked(o, "points", [&] { return make_hull(corners); });
}

void read_line(Script& script, const Options& o, ShapeDef& def) {
  const std::vector<Vec3> points = flat_positions(script, o);
  const double thickness = o.has("thickness") ? needed(o, "thickness") : 2.0;
  const bool closed = o.boolean("closed").value_or(false);
  const std::size_t least = closed ? 3 : 2;
  require(points.size() >= least, o.what(), ": points must be ", least, " or more, got ", points.size());
  const int axis = flat_axis(script);
  Vec3 side = zero3();
  side[axis] = 0.5 * thickness;
  if (axis == 1) side = -side;  // x, z and y are left-handed
  std::vector<Vec3> corners;
  for (const Vec3 at : points) corners.insert(corners.end(), {at - side, at + side});
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto count = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i + (closed ? 0 : 1) < count; i++) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % count);
    require(norm(points[(i + 1) % count] - points[i]) > 0.0, o.what(), ": points ", i + 1, " and ", (i + 1) % count + 1,
            " are at one position");
    triangles.insert(triangles.end(), {{a, a + 1, b}, {a + 1, b + 1, b}});
  }
  def.geometry = checked(o, "points", [&] { return make_mesh(std::move(corners), triangles); });
}

void read_plane(Script&, const Options& o, ShapeDef& def) {
  const Vec3 normal = axis_of(o, "normal");
  def.geometry = HalfSpaceShape{};
  def.at = normal * o.number("height", "m").value_or(0.0);
  def.orientation = turn_to(normal);
}

using Triangle = std::array<std::uint32_t, 3>;

/// Triangles side by side from the first corner.
void cut_face(const std::vector<std::uint32_t>& face, std::vector<Triangle>& triangles) {
  for (std::size_t i = 2; i < face.size(); i++) triangles.push_back({face[0], face[i - 1], face[i]});
}

std::vector<std::uint32_t> check_face(const Options& o, int at, lua_Unsigned number, std::size_t vertices) {
  lua_State* state = o.state();
  require(lua_istable(state, at) && lua_rawlen(state, at) >= 3, o.what(), ": face ", number,
          " must be a list of three or more numbers of vertices");
  std::vector<std::uint32_t> face;
  each_element(state, at, [&](int element, lua_Unsigned) {
    const lua_Integer corner = lua_isinteger(state, element) ? lua_tointeger(state, element) : 0;
    require(corner >= 1 && static_cast<std::size_t>(corner) <= vertices, o.what(), ": face ", number,
            " must have numbers of vertices, from 1 to ", vertices, ", got ", push_text(state, element));
    face.push_back(static_cast<std::uint32_t>(corner - 1));
  });
  return face;
}

/// Of the structure that the vertices were given as, or of the option.
std::vector<Triangle> read_faces(const Options& o, std::size_t vertices) {
  lua_State* state = o.state();
  std::vector<Triangle> triangles;
  const int given = o.push("vertices"), at = o.push("faces");
  if (const Ref* ref = to_ref(state, given); ref && lua_isnil(state, at)) {
    for (const auto& face : check_structure(state, given, o.what().c_str(), "vertices").faces)
      cut_face({face.begin(), face.end()}, triangles);
  } else {
    require(lua_istable(state, at), o.what(), ": faces must be a list of lists of numbers of vertices, got ",
            kind_of_value(state, at));
    each_element(state, at, [&](int face, lua_Unsigned i) { cut_face(check_face(o, face, i, vertices), triangles); });
  }
  lua_pop(state, 2);
  return triangles;
}

void read_mesh(Script& script, const Options& o, ShapeDef& def) {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  if (o.has("file")) {
    require(!o.has("vertices") && !o.has("faces"), o.what(), ": takes file, or vertices and faces, not both");
    Structure read = mesh_of_file(o.state(), script, *o.string("file"), o.number("scale", "").value_or(1.0));
    vertices = std::move(read.vertices);
    for (const StructureFace& face : read.faces) cut_face(face, triangles);
  } else {
    require(!o.has("scale"), o.what(), ": scale is of a file");
    vertices = positions(o, "vertices", "vertex");
    triangles = read_faces(o, vertices.size());
  }
  def.geometry = checked(o, "faces", [&] { return make_mesh(std::move(vertices), triangles); });
}

std::uint32_t count_of(const Options& o, const char* name) {
  const double count = o.number(name, "").value_or(0.0);
  require(count >= 2.0 && count <= most_heights && std::trunc(count) == count, o.what(), ": ", name,
          " must be a whole number from 2 to ", most_heights, ", got ",
          o.has(name) ? to_text(count) : std::string("nil"));
  return static_cast<std::uint32_t>(count);
}

/// Heights [m] of a list, row by row, or of a function of the places.
std::vector<double> read_height(const Options& o, std::uint32_t columns, std::uint32_t rows, double spacing) {
  lua_State* state = o.state();
  const int at = o.push("height");
  std::vector<double> heights;
  if (lua_isfunction(state, at)) {
    for (std::uint32_t row = 0; row < rows; row++)
      for (std::uint32_t column = 0; column < columns; column++) {
        lua_pushvalue(state, at);
        const double x = (column - 0.5 * (columns - 1)) * spacing, z = (row - 0.5 * (rows - 1)) * spacing;
        lua_pushnumber(state, x);
        lua_pushnumber(state, z);
        lua_call(state, 2, 1);
        heights.push_back(check_number(state, -1, o.what(), text("height at x = ", x, " m, z = ", z, " m"), "m"));
        lua_pop(state, 1);
      }
  } else {
    require(lua_istable(state, at), o.what(), ": height must be a function of x and z, or a list of numbers [m], got ",
            kind_of_value(state, at));
    each_element(state, at, [&](int element, lua_Unsigned i) {
      heights.push_back(check_number(state, element, o.what(), text("height ", i), "m"));
    });
    require(heights.size() == std::size_t{columns} * rows, o.what(),
            ": height must have columns x rows = ", std::size_t{columns} * rows, " numbers, got ", heights.size());
  }
  lua_pop(state, 1);
  return heights;
}

void read_heights(Script&, const Options& o, ShapeDef& def) {
  const std::uint32_t columns = count_of(o, "columns"), rows = count_of(o, "rows");
  require(static_cast<double>(columns) * rows <= most_heights, o.what(), ": columns x rows must be at most ",
          most_heights, ", got ", static_cast<double>(columns) * rows);
  const double spacing = o.has("spacing") ? needed(o, "spacing") : 1.0;
  std::vector<double> heights = read_height(o, columns, rows, spacing);
  def.geometry = checked(o, "height", [&] { return make_height_field(columns, rows, spacing, std::move(heights)); });
}

}  // namespace

const std::vector<ShapeKind>& shape_kinds() {
  static const std::vector<ShapeKind> all = {
      {"ball", {"radius"}, {"radius"}, read_ball},
      {"box", {"size", "x", "y", "z"}, {"x", "y", "z"}, read_box},
      {"capsule", {"radius", "length", "from", "to"}, {"radius", "length"}, read_capsule},
      {"cylinder", {"radius", "length", "axis"}, {"radius", "length"}, read_cylinder},
      {"hull", {"points"}, {"points"}, read_hull},
      {"polygon", {"points", "thickness"}, {"points", "thickness"}, read_polygon},
      {"line", {"points", "closed", "thickness"}, {"points"}, read_line},
      {"plane", {"normal", "height"}, {}, read_plane},
      {"mesh", {"vertices", "faces", "file", "scale"}, {"vertices", "faces"}, read_mesh},
      {"heights", {"columns", "rows", "spacing", "height"}, {}, read_heights},
  };
  return all;
}

const ShapeKind& shape_kind(std::string_view name) {
  for (const ShapeKind& kind : shape_kinds())
    if (name == kind.name) return kind;
  throw Error(text("shape: there is no kind '", name, "'"));
}

const std::vector<std::string>& material_options() {
  static const std::vector<std::string> names = {"density",  "friction",         "restitution", "rolling",
                                                 "spinning", "surface_velocity", "layer",       "sensor"};
  return names;
}

Material material_of(const Options& o) {
  Material m;
  m.density = o.number("density", "kg/m³").value_or(m.density);
  require(m.density > 0.0, o.what(), ": density must be > 0 kg/m³, got ", m.density);
  m.friction = o.number("friction", "").value_or(m.friction);
  require(m.friction >= 0.0, o.what(), ": friction must be >= 0, got ", m.friction);
  m.restitution = o.number("restitution", "").value_or(m.restitution);
  require(m.restitution >= 0.0 && m.restitution <= 1.0, o.what(), ": restitution must be from 0 to 1, got ",
          m.restitution);
  m.rolling = o.number("rolling", "m").value_or(m.rolling);
  require(m.rolling >= 0.0, o.what(), ": rolling must be >= 0 m, got ", m.rolling);
  m.spinning = o.number("spinning", "m").value_or(m.spinning);
  require(m.spinning >= 0.0, o.what(), ": spinning must be >= 0 m, got ", m.spinning);
  m.surface_velocity = o.vector("surface_velocity", "m/s").value_or(m.surface_velocity);
  return m;
}

std::string layer_option(const Options& o) {
  const auto layer = o.string("layer");
  require(!layer || !layer->empty(), o.what(), ": layer must not be empty");
  return layer.value_or("");
}

ShapeValue shape_of_sizes(Script& script, const ShapeKind& kind, const Options& o) {
  ShapeValue value{kind.name, {}, {}, o.has("density")};
  kind.read(script, o, value.def);
  value.def.material = material_of(o);
  value.def.layer = layer_option(o);
  value.def.sensor = o.boolean("sensor").value_or(false);
  try {
    check_shape(value.def.geometry);
  } catch (const Error& error) { throw Error(text(o.what(), ": ", error.what())); }
  return value;
}

ShapeValue shape_at(Script& script, const ShapeKind& kind, lua_State* state, int index) {
  std::vector<std::string> known = with_names(kind.sizes, {"at", "orientation"});
  known = with_names(with_names(std::move(known), material_options()), {"color", "picture", "name"});
  const Options o(state, index, kind.name, std::move(known));
  ShapeValue value = shape_of_sizes(script, kind, o);
  const Quat turn = normalised(o.quat("orientation").value_or(Quat{}));
  value.def.at = o.vector("at", "m").value_or(zero3()) + rotate(turn, value.def.at);
  value.def.orientation = normalised(turn * value.def.orientation);
  value.def.name = o.string("name").value_or("");
  value.color = o.color("color");
  if (value.color) value.def.color = *value.color;
  value.def.cover = spread(picture_option(script, o), value.def.geometry);
  return value;
}

std::vector<std::string> with_names(std::vector<std::string> list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

}  // namespace pantin::lua
