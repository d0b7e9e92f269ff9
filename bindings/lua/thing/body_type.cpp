#include "edit/edit.hpp"
#include "lua/thing/body_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

BodyId id_of(const Self& self) { return self.ref.id<BodyId>(); }
Body& row(const Self& self) { return self.world.bodies[id_of(self)]; }

double mass_of_points(const Self& self) {
  double sum = 0.0;
  for (PointId p : row(self).points) sum += self.world.points[p].mass;
  return sum;
}

/// About the frame's origin, in the frame's axes, of its masses in their places, [kg m²].
Mat3 inertia_of_points(const Self& self) {
  Mat3 sum = zero33();
  const auto add = [&](Vec3 at, double mass) { sum += (identity33() * norm2(at) - outer(at, at)) * mass; };
  for (PointId p : row(self).points) add(self.world.points[p].position, self.world.points[p].mass);
  add(row(self).own_position, row(self).own_mass);
  return sum;
}

void write_mass(const Self& self, int index) {
  const double mass = check_number(self.state, index, "body", "mass", "kg");
  require(mass > 0, "body: mass must be > 0 kg, got ", mass);
  const double points = mass_of_points(self);
  require(mass >= points, "body: mass must be at least that of its points, ", points, " kg, got ", mass);
  set_own_mass(self.world, id_of(self), mass - points);
}

void write_inertia(const Self& self, int index) {
  const Mat3 wanted = check_inertia(self.state, index, "body");
  set_own_inertia(self.world, id_of(self), wanted - inertia_of_points(self));
}

std::optional<Vec3> place(lua_State* state, const char* call) {
  if (lua_isnoneornil(state, 3)) return {};
  return check_vec(state, 3, call, "at", "m");
}

int push_force(lua_State* state) {
  const Self self = check_self(state, Kind::body, "push");
  push(self.world, id_of(self), check_vec(state, 2, "push", "force", "N"), place(state, "push"));
  return 0;
}

int kick_body(lua_State* state) {
  const Self self = check_self(state, Kind::body, "kick");
  kick(self.world, id_of(self), check_vec(state, 2, "kick", "impulse", "N s"), place(state, "kick"));
  return 0;
}

int twist_body(lua_State* state) {
  const Self self = check_self(state, Kind::body, "twist");
  twist(self.world, id_of(self), check_vec(state, 2, "twist", "torque", "N m"));
  return 0;
}

int add_point_to(lua_State* state) {
  const Self self = check_self(state, Kind::body, "add_point");
  push_thing(state, self.script,
             add_point(self.world, id_of(self), point_def(state, 2, "add_point", "argument 1", true)));
  return 1;
}

int remove_point_of(lua_State* state) {
  const Self self = check_self(state, Kind::body, "remove_point");
  const PointId point = check_kind(state, 2, Kind::point, "remove_point", argument(1)).id<PointId>();
  require(self.world.points[point].body == id_of(self), "remove_point: ", describe(self.world, point),
          " is no point of ", describe(self.ref));
  remove_point(self.world, point);
  return 0;
}

/// Its points by their names.
bool named_point(const Self& self, const char* name) {
  for (PointId p : row(self).points)
    if (self.world.points[p].name == name && *name) return push_thing(self.state, self.script, p), true;
  return false;
}

std::vector<Field> motion_fields() {
  return {
      {"position", "vec", "m", "position of the centre of mass",
       [](const Self& s) { push(s.state, s.world.motion_of(id_of(s)).x); },
       [](const Self& s, int i) { set_position(s.world, id_of(s), check_vec(s.state, i, "body", "position", "m")); }},
      {"velocity", "vec", "m/s", "velocity of the centre of mass",
       [](const Self& s) {
         const Motion& m = s.world.motion_of(id_of(s));
         push(s.state, m.p / m.mass);
       },
       [](const Self& s, int i) { set_velocity(s.world, id_of(s), check_vec(s.state, i, "body", "velocity", "m/s")); }},
      {"origin", "vec", "m", "position of its frame's origin",
       [](const Self& s) { push(s.state, origin(s.world, id_of(s))); },
       [](const Self& s, int i) { set_origin(s.world, id_of(s), check_vec(s.state, i, "body", "origin", "m")); }},
      {"orientation", "quat", "", "turns its frame to the world",
       [](const Self& s) { push(s.state, orientation(s.world, id_of(s))); },
       [](const Self& s, int i) { set_orientation(s.world, id_of(s), check_quat(s.state, i, "body", "orientation")); }},
      {"spin", "vec", "rad/s", "angular velocity, world axes",
       [](const Self& s) { push(s.state, angular_velocity(s.world.motion_of(id_of(s)))); },
       [](const Self& s, int i) { set_spin(s.world, id_of(s), check_vec(s.state, i, "body", "spin", "rad/s")); }},
      {"momentum", "vec", "kg m/s", "mass times velocity",
       [](const Self& s) { push(s.state, s.world.motion_of(id_of(s)).p); }, nullptr},
      {"angular_momentum", "vec", "kg m²/s", "about its centre of mass, world axes",
       [](const Self& s) { push(s.state, angular_momentum(s.world, id_of(s))); }, nullptr},
  };
}

std::vector<Field> build_fields() {
  return {
      {"mass", "number", "kg", "its points' and its own",
       [](const Self& s) { lua_pushnumber(s.state, s.world.motion_of(id_of(s)).mass); }, write_mass},
      {"inertia", "vec|Inertia", "kg m²",
       "its points' and its own about the frame's origin, in the frame's axes: vec of the diagonal, "
       "or a table. Tied, a body moves with no principal moment below 1e-4 of the largest, and a warning says so",
       [](const Self& s) { push_inertia(s.state, row(s).own_inertia + inertia_of_points(s)); }, write_inertia},
      {"points", "Point[]", "", "its points, in the order of making",
       [](const Self& s) { push_list(s.state, s.script, row(s).points); }, nullptr},
      {"hinges", "Particle[]", "", "the hinges that its points are in",
       [](const Self& s) { push_list(s.state, s.script, hinges_of(s.world, id_of(s))); }, nullptr},
      {"color", "color", "", "color of its first point; writing gives it to all",
       [](const Self& s) {
         if (row(s).points.empty())
           lua_pushnil(s.state);
         else
           push(s.state, s.world.points[row(s).points[0]].color);
       },
       [](const Self& s, int i) {
         const Color color = check_color(s.state, i, "body", "color");
         for (PointId p : row(s).points) s.world.points[p].color = color;
       }},
  };
}

Type make() {
  Type type{
      "Body", "body", "Points at fixed relative positions: rigid. Its named points are fields: link.head.", {}, {}};
  type.fields = motion_fields();
  for (Field& field : build_fields()) type.fields.push_back(field);
  type.methods = {
      {"push", guard<push_force>, "force: vec [N], at?: vec [m]", "",
       "Pulls for the coming step, at its centre of mass or at a position of the world.",
       "scene:on(\"step\", function() block:push(vec(0, 20, 0), block.points[1].position) end)"},
      {"kick", guard<kick_body>, "impulse: vec [N s], at?: vec [m]", "",
       "Changes the velocity at once, at its centre of mass or at a position of the world.",
       "block:kick(vec(0, 2, 0))"},
      {"twist", guard<twist_body>, "torque: vec [N m]", "", "Turns for the coming step.",
       "scene:on(\"step\", function() block:twist(vec(0, 0, 0.5)) end)"},
      {"add_point", guard<add_point_to>, "point: vec|AddPointOptions [m]", "Point",
       "Adds a point at a position in its frame.",
       "local handle = block:add_point { at = vec(0, 1, 0), mass = 0.2, name = \"handle\" }"},
      {"remove_point", guard<remove_point_of>, "point: Point", "", "Takes a point off.",
       "block:remove_point(block.points[8])"},
  };
  add_base(type, any_thing_type());
  add_common_remove(type);
  type.more = named_point;
  type.more_doc = "Point its named points";
  return type;
}

}  // namespace

const Type& body_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
