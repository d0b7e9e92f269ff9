// The table `structure`: polyhedra, lattices, mechanisms and structures of a scene's own.
#include <cmath>
#include <span>

#include "lua/thing/scene_file.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/structure_type.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/tostring.hpp"
#include "lua/vm/guard.hpp"
#include "structures/lattice.hpp"
#include "structures/mesh_file.hpp"
#include "structures/molecule.hpp"
#include "structures/polyhedra.hpp"

namespace pantin::lua {
namespace {

constexpr double most_parts = 1e5;  // of a side, a row or the like

int push_made(lua_State* state, Structure structure) {
  push_structure(state, script_of(state), std::move(structure));
  return 1;
}

double length(const Options& o, const char* name) { return o.number(name, "m").value_or(1.0); }

int whole(const Options& o, const char* name, int usual) {
  const double value = o.number(name, "").value_or(usual);
  require(std::trunc(value) == value, o.what(), ": ", name, " must be a whole number, got ", value);
  require(value <= most_parts, o.what(), ": ", name, " must be at most ", static_cast<int>(most_parts), ", got ",
          value);
  return static_cast<int>(std::fmax(value, -most_parts));
}

template <Structure (*shape)(double)>
int make_regular(lua_State* state, const char* name) {
  return push_made(state, shape(length(Options(state, 1, name, {"edge"}), "edge")));
}
int tetrahedron(lua_State* state) { return make_regular<shapes::tetrahedron>(state, "tetrahedron"); }
int cube(lua_State* state) { return make_regular<shapes::cube>(state, "cube"); }
int octahedron(lua_State* state) { return make_regular<shapes::octahedron>(state, "octahedron"); }
int dodecahedron(lua_State* state) { return make_regular<shapes::dodecahedron>(state, "dodecahedron"); }
int icosahedron(lua_State* state) { return make_regular<shapes::icosahedron>(state, "icosahedron"); }

int prism(lua_State* state) {
  const Options o(state, 1, "prism", {"sides", "edge", "height"});
  return push_made(state, shapes::prism(whole(o, "sides", 6), length(o, "edge"), length(o, "height")));
}

int regular_polygon(lua_State* state) {
  const Options o(state, 1, "polygon", {"sides", "edge"});
  return push_made(state, shapes::polygon(whole(o, "sides", 6), length(o, "edge")));
}

int rod(lua_State* state) {
  const Options o(state, 1, "rod", {"length", "pieces"});
  return push_made(state, shapes::rod(length(o, "length"), whole(o, "pieces", 1)));
}

int sheet(lua_State* state) {
  const Options o(state, 1, "sheet", {"columns", "rows", "edge"});
  return push_made(state, shapes::sheet(whole(o, "columns", 1), whole(o, "rows", 1), length(o, "edge")));
}

int ring(lua_State* state) {
  const Options o(state, 1, "ring", {"sides", "radius"});
  return push_made(state, shapes::ring(whole(o, "sides", 12), length(o, "radius")));
}

int geodesic(lua_State* state) {
  const Options o(state, 1, "geodesic", {"divisions", "radius"});
  return push_made(state, shapes::geodesic(whole(o, "divisions", 2), length(o, "radius")));
}

int rotating_squares(lua_State* state) {
  const Options o(state, 1, "rotating_squares", {"columns", "rows", "edge", "angle"});
  return push_made(state, shapes::rotating_squares(whole(o, "columns", 1), whole(o, "rows", 1), length(o, "edge"),
                                                   o.number("angle", "rad").value_or(0.0)));
}

int reentrant(lua_State* state) {
  const Options o(state, 1, "reentrant", {"columns", "rows", "rib", "edge", "angle"});
  const double edge = length(o, "edge");
  return push_made(
      state, shapes::reentrant(whole(o, "columns", 1), whole(o, "rows", 1), o.number("rib", "m").value_or(2.0 * edge),
                               edge, o.number("angle", "rad").value_or(0.5)));
}

/// A number for all ways, or a vec of three.
LatticeCells check_cells(lua_State* state, const Options& o) {
  if (!o.has("cells")) return {};
  const int at = o.push("cells");
  Vec3 cells;
  if (to_vec(state, at)) {
    cells = check_vec(state, at, "lattice", "cells", "");
  } else {
    const double number = check_number(state, at, "lattice", "cells, a number or a vec of three,", "");
    cells = vec(number, number, number);
  }
  lua_pop(state, 1);
  for (int i = 0; i < 3; i++)
    require(std::trunc(cells[i]) == cells[i] && std::fabs(cells[i]) < 1e6,
            "lattice: cells must be whole numbers below 1000000, got ", cells[i]);
  return {static_cast<int>(cells[0]), static_cast<int>(cells[1]), static_cast<int>(cells[2])};
}

int make_lattice(lua_State* state) {
  const Options o(state, 1, "lattice", {"kind", "cells", "edge"});
  return push_made(state, lattice(o.string("kind").value_or("cubic"), check_cells(state, o), length(o, "edge")));
}

/// Calls `read(index on the stack, number)` for each element of a list; none where it is not given.
template <class Read>
void each_element(lua_State* state, const Options& o, const char* name, const Read& read) {
  const int list = o.push(name);
  require(lua_isnil(state, list) || lua_istable(state, list), o.what(), ": ", name, " must be a list, got ",
          kind_of_value(state, list));
  const lua_Unsigned count = lua_isnil(state, list) ? 0 : lua_rawlen(state, list);
  for (lua_Unsigned i = 1; i <= count; i++) {
    lua_rawgeti(state, list, static_cast<lua_Integer>(i));
    read(lua_gettop(state), i);
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
}

StructureFace check_numbers(lua_State* state, int list, const std::string& name) {
  require(lua_istable(state, list), "structure: ", name, " must be a list of numbers of vertices, got ",
          kind_of_value(state, list));
  StructureFace numbers;
  for (lua_Unsigned i = 1; i <= lua_rawlen(state, list); i++) {
    lua_rawgeti(state, list, static_cast<lua_Integer>(i));
    const lua_Integer number = lua_isinteger(state, -1) ? lua_tointeger(state, -1) : 0;
    require(number >= 1 && number <= static_cast<lua_Integer>(most_vertices), "structure: ", name,
            " must have numbers of vertices, from 1, got ", push_text(state, -1));
    numbers.push_back(static_cast<std::uint32_t>(number - 1));
    lua_settop(state, list);
  }
  return numbers;
}

int make_new(lua_State* state) {
  const Options o(state, 1, "structure", {"vertices", "edges", "faces"});
  std::vector<Vec3> vertices;
  std::vector<StructureEdge> edges;
  std::vector<StructureFace> faces;
  each_element(state, o, "vertices", [&](int at, lua_Unsigned i) {
    vertices.push_back(check_vec(state, at, "structure", text("vertex ", i), "m"));
  });
  each_element(state, o, "edges", [&](int at, lua_Unsigned i) {
    const StructureFace ends = check_numbers(state, at, text("edge ", i));
    require(ends.size() == 2, "structure: edge ", i, " must have two vertices, got ", ends.size());
    edges.push_back({ends[0], ends[1]});
  });
  each_element(state, o, "faces",
               [&](int at, lua_Unsigned i) { faces.push_back(check_numbers(state, at, text("face ", i))); });
  return push_made(state, make_structure(std::move(vertices), edges, std::move(faces)));
}

int molecule(lua_State* state) {
  const std::string name = check_text(state, 1, "molecule", "argument 1, the file,");
  const Options o(state, 2, "molecule", {"scale"});
  const double scale = o.number("scale", "m/Å").value_or(1.0);
  require(scale > 0.0, "molecule: scale must be > 0 m/Å, got ", scale);
  const std::string content = read_scene_file(state, "molecule", "molecules", name, largest_file);
  Structure read;
  try {
    read = read_molecule(content, name);
  } catch (const Error& error) { throw Error(text("molecule: ", error.what())); }
  return push_made(state, scaled(std::move(read), vec(scale, scale, scale)));
}

int mesh_from_file(lua_State* state) {
  const std::string name = check_text(state, 1, "mesh", "argument 1, the file,");
  const Options o(state, 2, "mesh", {"scale"});
  return push_made(state, mesh_of_file(state, script_of(state), name, o.number("scale", "").value_or(1.0)));
}

int unknown_structure(lua_State* state) {
  std::vector<std::string> names;
  for (const Method& maker : structure_makers()) names.push_back(maker.name);
  const std::string name(push_text(state, 2));
  throw Error(
      text("structure: unknown structure '", name, "'.", suggestion(name, names), " Known are ", joined(names)));
}

std::vector<Method> make_structure_makers() {
  const char* edge = "options?: EdgeOptions";
  return {
      {"tetrahedron", guard<tetrahedron>, edge, "Structure", "Four triangles.",
       "local t = structure.tetrahedron { edge = 2 }"},
      {"cube", guard<cube>, edge, "Structure", "Six squares.", "local c = structure.cube { edge = 2 }"},
      {"octahedron", guard<octahedron>, edge, "Structure", "Eight triangles.", "local o = structure.octahedron()"},
      {"dodecahedron", guard<dodecahedron>, edge, "Structure", "Twelve pentagons.",
       "local d = structure.dodecahedron()"},
      {"icosahedron", guard<icosahedron>, edge, "Structure", "Twenty triangles.", "local i = structure.icosahedron()"},
      {"prism", guard<prism>, "options?: PrismOptions", "Structure", "Two regular polygons, one above the other.",
       "local p = structure.prism { sides = 8, height = 0.2 }"},
      {"polygon", guard<regular_polygon>, "options?: PolygonOptions", "Structure", "One regular face.",
       "local hexagon = structure.polygon { sides = 6 }"},
      {"rod", guard<rod>, "options?: PiecesOptions", "Structure", "A line along x.",
       "local chain = structure.rod { length = 5, pieces = 20 }"},
      {"sheet", guard<sheet>, "options?: SheetOptions", "Structure", "Squares side by side, in the plane z = 0.",
       "local net = structure.sheet { columns = 10, rows = 5, edge = 0.1 }"},
      {"ring", guard<ring>, "options?: RingOptions", "Structure", "A regular polygon without a face.",
       "local hoop = structure.ring { sides = 24, radius = 0.5 }"},
      {"geodesic", guard<geodesic>, "options?: GeodesicOptions", "Structure",
       "An icosahedron with its triangles divided into four some times, on a sphere.",
       "local globe = structure.geodesic { divisions = 2, radius = 3 }"},
      {"rotating_squares", guard<rotating_squares>, "options?: RotatingSquaresOptions", "Structure",
       "Squares that touch at their corners, turned by plus and minus an angle.",
       "local mesh = structure.rotating_squares { columns = 4, rows = 4, angle = 0.3 }"},
      {"reentrant", guard<reentrant>, "options?: ReentrantOptions", "Structure",
       "A honeycomb of bow ties: upright ribs, and edges that rise inwards by an angle.",
       "local auxetic = structure.reentrant { columns = 4, rows = 3 }"},
      {"lattice", guard<make_lattice>, "options?: LatticeOptions", "Structure",
       "A block of cells with edges between neighbours.",
       "local crystal = structure.lattice { kind = \"diamond\", cells = vec(2, 2, 1), edge = 0.5 }"},
      {"molecule", guard<molecule>, "file: string, options?: MoleculeOptions", "Structure",
       "Atoms, bonds and flat rings of a .xyz, .sdf, .mol, .pdb, .cif or .mmcif file in the scene's folder or "
       "assets/molecules.",
       "local ball = structure.molecule(\"c60.xyz\", { scale = 0.1 })"},
      {"mesh", guard<mesh_from_file>, "file: string, options?: MeshFileOptions", "Structure",
       "Vertices and faces of a Wavefront .obj file in the scene's folder or assets/meshes; a notice tells of holes.",
       "scene:ground { shape = shape.mesh(structure.mesh(\"bowl.obj\", { scale = 0.5 })), at = vec(0, -9, 0) }"},
      {"new", guard<make_new>, "parts: StructureParts", "Structure",
       "A structure of one's own; edges of faces need not be given.",
       "local kite = structure.new { vertices = { vec(0, 0, 0), vec(1, 0, 0), vec(1, 1, 0) }, faces = { { 1, 2, 3 } } "
       "}"},
  };
}

}  // namespace

Structure mesh_of_file(lua_State* state, Script& script, const std::string& name, double scale) {
  require(scale > 0.0, "mesh: scale must be > 0, got ", scale);
  const std::string content = read_scene_file(state, "mesh", "meshes", name, largest_file);
  Structure read;
  try {
    read = read_mesh_file(content, name);
  } catch (const Error& error) { throw Error(text("mesh: ", error.what())); }
  if (const std::size_t open = open_edges(read); open > 0)
    log_line(script.world, "notice",
             text("mesh '", name, "' has holes or a rim: ", open, open == 1 ? " edge is" : " edges are",
                  " not between two faces that go round it in opposite senses"));
  return scaled(std::move(read), vec(scale, scale, scale));
}

const std::vector<Method>& structure_makers() {
  static const std::vector<Method> makers = make_structure_makers();
  return makers;
}

void open_structures(lua_State* state, Script& script) {
  lua_newtable(state);
  for (const Method& maker : structure_makers()) {
    push_maker(state, maker, script);
    lua_setfield(state, -2, maker.name);
  }
  lua_newtable(state);
  lua_pushcfunction(state, guard<unknown_structure>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
  lua_setglobal(state, "structure");
}

}  // namespace pantin::lua
