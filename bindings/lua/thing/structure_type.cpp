#include "lua/thing/structure_type.hpp"

#include "lua/thing/body_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

struct StructureRef : Ref {
  std::shared_ptr<const Structure> value;
};

int drop_structure(lua_State* state) {
  static_cast<StructureRef*>(lua_touserdata(state, 1))->value.reset();
  return 0;
}

const Structure& structure_of(const Self& self) { return *static_cast<const StructureRef&>(self.ref).value; }

/// Lists of numbers of vertices, from 1.
template <class Parts>
void push_numbers(lua_State* state, const Parts& parts) {
  lua_createtable(state, static_cast<int>(parts.size()), 0);
  lua_Integer i = 0;
  for (std::uint32_t part : parts) {
    lua_pushinteger(state, static_cast<lua_Integer>(part) + 1);
    lua_rawseti(state, -2, ++i);
  }
}

template <class Parts>
void push_parts(lua_State* state, const Parts& parts) {
  lua_createtable(state, static_cast<int>(parts.size()), 0);
  lua_Integer i = 0;
  for (const auto& part : parts) {
    push_numbers(state, part);
    lua_rawseti(state, -2, ++i);
  }
}

void read_vertices(const Self& self) {
  const auto& vertices = structure_of(self).vertices;
  lua_createtable(self.state, static_cast<int>(vertices.size()), 0);
  for (std::size_t i = 0; i < vertices.size(); i++) {
    push(self.state, vertices[i]);
    lua_rawseti(self.state, -2, static_cast<lua_Integer>(i + 1));
  }
}

void read_elements(const Self& self) {
  const auto& elements = structure_of(self).elements;
  lua_createtable(self.state, static_cast<int>(elements.size()), 0);
  for (std::size_t i = 0; i < elements.size(); i++) {
    lua_pushlstring(self.state, elements[i].data(), elements[i].size());
    lua_rawseti(self.state, -2, static_cast<lua_Integer>(i + 1));
  }
}

void push_optional(lua_State* state, const std::optional<double>& value) {
  if (value)
    lua_pushnumber(state, *value);
  else
    lua_pushnil(state);
}

int push_made(const Self& self, Structure structure) {
  push_structure(self.state, self.script, std::move(structure));
  return 1;
}

int scale(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "scale");
  Vec3 factors;
  if (to_vec(state, 2)) {
    factors = check_vec(state, 2, "scale", "argument 1", "");
  } else {
    const double factor = check_number(state, 2, "scale", "argument 1, the factor,", "");
    factors = vec(factor, factor, factor);
  }
  return push_made(self, scaled(structure_of(self), factors));
}

int turn(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "rotate");
  return push_made(self, rotated(structure_of(self), check_quat(state, 2, "rotate", argument(1))));
}

int shift(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "move");
  return push_made(self, moved(structure_of(self), check_vec(state, 2, "move", argument(1), "m")));
}

int join(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "join");
  const Structure& other = check_structure(state, 2, "join", argument(1));
  const double tolerance =
      lua_isnoneornil(state, 3) ? 1e-6 : check_number(state, 3, "join", "argument 2, the tolerance,", "m");
  return push_made(self, joined(structure_of(self), other, tolerance));
}

int subdivide(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "subdivide");
  return push_made(self, subdivided(structure_of(self)));
}

int make_dual(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "dual");
  return push_made(self, dual(structure_of(self)));
}

int truncate(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "truncate");
  return push_made(self,
                   truncated(structure_of(self), check_number(state, 2, "truncate", "argument 1, the fraction,", "")));
}

int mirror(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "mirror");
  const Vec3 normal = check_vec(state, 2, "mirror", "argument 1, the normal,", "");
  const Vec3 through = lua_isnoneornil(state, 3) ? zero3() : check_vec(state, 3, "mirror", argument(2), "m");
  return push_made(self, mirrored(structure_of(self), normal, through));
}

Part check_part(lua_State* state, int index) {
  const std::string name = check_text(state, index, "select", argument(1));
  if (name == "vertices") return Part::vertices;
  if (name == "edges") return Part::edges;
  require(name == "faces", "select: argument 1 must be \"vertices\", \"edges\" or \"faces\", got \"", name, "\"");
  return Part::faces;
}

int select(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "select");
  const Structure& s = structure_of(self);
  const Part part = check_part(state, 2);
  require(lua_isfunction(state, 3), "select: argument 2 must be a function, got ", kind_of_value(state, 3));
  Selection selection = selected(s, part, [&](std::uint32_t number) {
    lua_pushvalue(state, 3);
    lua_call(state, push_part(state, s, part, number), 1);
    const bool keep = lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    return keep;
  });
  push_structure(state, self.script, std::move(selection.structure));
  push_numbers(state, selection.parts);
  return 2;
}

int inertia(lua_State* state) {
  const Self self = check_self(state, Kind::structure, "inertia");
  const MassIn where = lua_isnoneornil(state, 2) ? MassIn::points : check_mass_in(state, 2, "inertia", argument(1));
  const MassDistribution spread = distribution(structure_of(self), where, 1.0);
  push_inertia(state, spread.inertia);
  push(state, spread.centre);
  return 2;
}

std::vector<Field> value_fields() {
  return {
      {"vertices", "vec[]", "m", "positions", read_vertices, nullptr},
      {"edges", "integer[][]", "", "pairs of numbers of vertices",
       [](const Self& s) { push_parts(s.state, structure_of(s).edges); }, nullptr},
      {"faces", "integer[][]", "", "lists of numbers of vertices, counter-clockwise seen from outside",
       [](const Self& s) { push_parts(s.state, structure_of(s).faces); }, nullptr},
      {"elements", "string[]", "", "chemical element of each vertex of a molecule; else empty", read_elements, nullptr},
      {"euler", "integer", "", "vertices - edges + faces",
       [](const Self& s) { lua_pushinteger(s.state, euler_characteristic(structure_of(s))); }, nullptr},
      {"area", "number?", "m²", "of all faces; nil without any",
       [](const Self& s) { push_optional(s.state, area(structure_of(s))); }, nullptr},
      {"volume", "number?", "m³", "inside of a closed surface; nil of another",
       [](const Self& s) { push_optional(s.state, volume(structure_of(s))); }, nullptr},
  };
}

Type make_structure_type() {
  Type type{"Structure", "structure", "Vertices, edges and faces: a value, which does not change.", {}, {}};
  type.fields = value_fields();
  type.methods = {
      {"scale", guard<scale>, "factor: number|vec [1]", "Structure", "Times larger, alike or along each axis.",
       "local slab = structure.cube():scale(vec(4, 0.2, 1))"},
      {"rotate", guard<turn>, "turn: quat", "Structure", "Turned about the origin.",
       "local tip = structure.cube():rotate(quat(vec(1, 0, 0), math.pi / 4))"},
      {"move", guard<shift>, "by: vec [m]", "Structure", "Moved.", "local above = structure.cube():move(vec(0, 2, 0))"},
      {"mirror", guard<mirror>, "normal: vec [1], through?: vec [m]", "Structure",
       "Mirror image in a plane, through the origin unless given.",
       "local left = structure.prism { sides = 3 }:mirror(vec(1, 0, 0))"},
      {"join", guard<join>, "other: Structure, tolerance?: number [m]", "Structure",
       "Both as one: vertices of the other within the tolerance (1e-6) of one of this become that one.",
       "local tower = structure.cube():join(structure.cube():move(vec(0, 1, 0)))"},
      {"subdivide", guard<subdivide>, "", "Structure",
       "Each edge halved: triangles become four, other faces quadrilaterals.",
       "local finer = structure.octahedron():subdivide()"},
      {"dual", guard<make_dual>, "", "Structure", "A vertex for each face, a face for each inner vertex.",
       "local cube = structure.octahedron():dual()"},
      {"truncate", guard<truncate>, "fraction: number [1]", "Structure",
       "Each vertex of a closed surface cut off at a fraction of its edges.",
       "local football = structure.icosahedron():truncate(1 / 3)"},
      {"select", guard<select>, "part: \"vertices\"|\"edges\"|\"faces\", keep: function", "Structure, integer[]",
       "What is made of the parts for which keep is true, and their numbers; keep is given the vertex' position, both "
       "ends "
       "of the edge or the middle of the face [m], then the number.",
       "local upper, numbers = structure.geodesic():select(\"vertices\", function(at, number) return at.y > 0 end)"},
      {"inertia", guard<inertia>, "mass_in?: \"points\"|\"edges\"|\"faces\"|\"solid\"", "vec|Inertia, vec",
       "Inertia [kg m²] of 1 kg, in its points unless given, about its centre of mass, and that centre [m].",
       "local inertia, centre = structure.cube():inertia(\"solid\")"},
  };
  return type;
}

}  // namespace

void push_structure(lua_State* state, Script& script, Structure structure) {
  auto value = std::make_shared<const Structure>(std::move(structure));
  const Ref ref = make_ref(script, Kind::structure, 1, 1, 0);
  new (lua_newuserdatauv(state, sizeof(StructureRef), 0)) StructureRef{ref, std::move(value)};
  push_metatable(state, Kind::structure);
  lua_pushcfunction(state, drop_structure);
  lua_setfield(state, -2, "__gc");
  lua_setmetatable(state, -2);
}

const Structure& check_structure(lua_State* state, int index, const char* call, const std::string& name) {
  const Ref* ref = to_ref(state, index);
  require(ref && ref->kind == Kind::structure, call, ": ", name, " must be a structure, got ",
          kind_of_value(state, index));
  return *static_cast<const StructureRef*>(ref)->value;
}

int push_part(lua_State* state, const Structure& s, Part part, std::uint32_t number) {
  int count = 1;
  if (part == Part::vertices) {
    push(state, s.vertices[number]);
  } else if (part == Part::edges) {
    push(state, s.vertices[s.edges[number][0]]);
    push(state, s.vertices[s.edges[number][1]]);
    count = 2;
  } else {
    push(state, middle(s, s.faces[number]));
  }
  lua_pushinteger(state, static_cast<lua_Integer>(number) + 1);
  return count + 1;
}

MassIn check_mass_in(lua_State* state, int index, const std::string& what, const std::string& name) {
  const std::string given = check_text(state, index, what, name);
  const char* const known[] = {"points", "edges", "faces", "solid"};
  for (std::size_t i = 0; i < 4; i++)
    if (given == known[i]) return static_cast<MassIn>(i);
  throw Error(text(what, ": ", name, " must be \"points\", \"edges\", \"faces\" or \"solid\", got \"", given, "\""));
}

const Type& structure_type() {
  static const Type type = make_structure_type();
  return type;
}

}  // namespace pantin::lua
