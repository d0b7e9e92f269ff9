#include "bindings/lua_support.hpp"
#include "lua/scene/open.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("structures are values with parts, measures and acts") {
  CHECK(failure(R"(
    local cube = structure.cube { edge = 2 }
    assert(#cube.vertices == 8 and #cube.edges == 12 and #cube.faces == 6 and #cube.elements == 0)
    assert(cube.euler == 2 and math.abs(cube.volume - 8) < 1e-12 and math.abs(cube.area - 24) < 1e-12)
    assert(structure.ring().area == nil and structure.ring().volume == nil)
    local edge = cube.edges[1]
    assert(math.abs((cube.vertices[edge[1]] - cube.vertices[edge[2]]):length() - 2) < 1e-14)
    local moved = cube:scale(0.5):rotate(quat(vec(0, 1, 0), 1)):move(vec(0, 3, 0)):mirror(vec(1, 0, 0))
    assert(math.abs(moved.volume - 1) < 1e-12 and #cube:subdivide().faces == 24 and #cube:dual().vertices == 6)
    assert(#cube:join(cube:move(vec(2, 0, 0))).vertices == 12 and #cube:truncate(0.3).vertices == 24)
    assert(math.abs(cube:scale(vec(1, 2, 3)).volume - 48) < 1e-12)
    local top, numbers = cube:select("vertices", function(p, i) return p.y > 0 and i > 0 end)
    assert(#top.vertices == 4 and #numbers == 4 and cube.vertices[numbers[1]].y > 0)
    assert(#cube:select("faces", function(middle) return middle.y > 0.5 end).faces == 1)
    assert(#cube:select("edges", function(a, b, i) return (a - b).y ~= 0 end).edges == 4)
    local inertia, centre = cube:move(vec(1, 0, 0)):inertia "solid"
    assert((inertia - vec(1, 1, 1) * (4 / 6)):length() < 1e-13 and (centre - vec(1, 0, 0)):length() < 1e-13)
    local own = structure.new { vertices = { vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0) }, faces = { { 1, 2, 3 } } }
    assert(#own.edges == 3 and own.area == 0.5 and tostring(own) == "structure")
    assert(#structure.lattice { kind = "fcc", cells = vec(1, 1, 1) }.vertices == 14)
    assert(#structure.lattice { kind = "square", cells = 3 }.faces == 9)
    for _, name in ipairs { "tetrahedron", "octahedron", "dodecahedron", "icosahedron", "prism", "geodesic" } do
      assert(structure[name]().euler == 2 and structure[name]().volume > 0)
    end
    for _, name in ipairs { "polygon", "rod", "sheet", "rotating_squares", "reentrant" } do
      assert(structure[name]().euler == 1)
    end)") == "");
}

TEST_CASE("scene:build gives a group in the structure's order") {
  CHECK(failure(R"(
    local ball = structure.icosahedron()
    local g = scene:build(ball, { as = "articulated", mass = 30, at = vec(0, 2, 0), name = "ball" })
    assert(#g.bodies == 30 and #g.particles == 12 and #g.hinges == 12 and #g.connections == 0 and g.name == "ball")
    assert(math.abs(g.mass - 30) < 1e-12 and #g.hinges[1].points == 5)
    for i, p in ipairs(g.particles) do
      assert((p.position - ball.vertices[i] - vec(0, 2, 0)):length() < 1e-13)
    end
    local soft = scene:build(structure.lattice { cells = 2 }, { as = "deformable", law = force.spring { stiffness = 10 } })
    assert(#soft.particles == 27 and #soft.connections == 54 and #soft.bodies == 0)
    assert(#scene:build(structure.ring { sides = 6 }, { as = "deformable", laws = { edge = force.spring { stiffness = 1 },
      angle = force.angle { stiffness = 1 }, torsion = force.torsion { stiffness = 1, fold = 1 } } }).connections == 18)
    local family = scene:family("f", { attributes = { charge = 2 } })
    local own = scene:build(structure.rod(), { as = "deformable", family = family, law = force.pair {
      potential = function(r, a, b) return a.charge * r end } })
    assert(own.particles[1].charge == 2 and #own.connections == 1)
    local halves = scene:build(structure.rod { pieces = 3 }, { as = function(p) return p.x < 0 and "rigid" or "deformable" end })
    assert(#halves.bodies == 1 and #halves.particles == 4)
    local mixed = scene:build(structure.cube(), { as = { faces = function(m) return m.y > 0.1 and "panels" end },
      law = force.spring { stiffness = 1 } })
    assert(#mixed.bodies == 1 and #mixed.connections == 8)
    local first = g.particles[1]
    first:cut()
    assert(#g.particles == 12 and g.particles[2].alive and not g.particles[1].alive))") == "");
}

TEST_CASE("a moved cube's inertia is a vec, round-off left out") {
  CHECK(failure("local i = structure.cube():rotate(quat(vec(1, 2, 3), 0.7)):move(vec(0.1, 0.2, 0.3)):inertia 'points'\n"
                "assert((i - vec(i.x, i.y, i.z)):length() == 0)") == "");
}

TEST_CASE("a build tells of particles that no law ties, and of a law that nothing obeys") {
  const auto log = [](const char* source) { return open(source)->world().log; };
  const auto loose = log("scene:build(structure.cube(), { as = 'deformable', name = 'loose' })");
  REQUIRE(loose.size() == 1);
  CHECK(loose[0].text == "build 'loose': nothing ties the particles along the edges: no law was given");
  const auto stiff = log("scene:build(structure.cube(), { as = 'rigid', law = force.spring { stiffness = 1 } })");
  REQUIRE(stiff.size() == 1);
  CHECK(stiff[0].text == "build: a rigid body has no use for the law that was given");
  CHECK(log("scene:build(structure.cube(), { as = 'deformable', law = force.spring { stiffness = 1 } })").empty());
}

TEST_CASE("bad structures and builds are told with their line") {
  CHECK_THAT(failure("structure.cube { edge = -1 }"), StartsWith("scene.lua:1: cube: edge must be > 0 m, got -1"));
  CHECK_THAT(failure("structure.cube { side = 1 }"), Contains("cube: unknown field 'side'. Known are edge"));
  CHECK_THAT(failure("structure.cubes()"), Contains("unknown structure 'cubes'. Did you mean 'cube'?"));
  CHECK_THAT(failure("structure.prism { sides = 2.5 }"), Contains("sides must be a whole number, got 2.5"));
  CHECK_THAT(failure("structure.sheet { columns = 1e9 }"), Contains("columns must be at most 100000, got 1e+09"));
  CHECK_THAT(failure("structure.ring { sides = -1e300 }"), Contains("sides must be a whole number from 3"));
  CHECK_THAT(failure("structure.lattice { kind = 'fcd' }"), Contains("unknown kind 'fcd'"));
  CHECK_THAT(failure("structure.lattice { cells = vec(1, 0.5, 1) }"), Contains("cells must be whole numbers"));
  CHECK_THAT(failure("structure.lattice { cells = 900000 }"), Contains("at most 4000000 vertices"));
  CHECK_THAT(failure("structure.new { vertices = { vec(0, 0, 0) }, edges = { { 1, 2 } } }"),
             Contains("edge 1 has a vertex 2, but there are 1"));
  CHECK_THAT(failure("structure.new { vertices = { 7 } }"), Contains("vertex 1 must be a vec [m], got a number"));
  CHECK_THAT(failure("structure.new { vertices = {}, faces = { { 0 } } }"),
             Contains("numbers of vertices, from 1, got 0"));
  CHECK_THAT(failure("structure.cube().edges = {}"), Contains("structure: edges can be read, not written"));
  CHECK_THAT(failure("structure.cube():select('corners', print)"),
             Contains("must be \"vertices\", \"edges\" or \"faces\""));
  CHECK_THAT(failure("structure.cube():select('vertices', function() error 'no' end)"), Contains("scene.lua:1: no"));
  CHECK_THAT(failure("structure.cube():inertia 'volume'"), Contains("\"solid\", got \"volume\""));
  CHECK_THAT(failure("scene:build(7)"), Contains("build: argument 1 must be a structure, got a number"));
  CHECK_THAT(failure("scene:build(structure.cube(), {})"), Contains("needs as ="));
  CHECK_THAT(failure("\nscene:build(structure.ring(), { as = 'panels' })"),
             StartsWith("scene.lua:2: build: \"panels\" makes plates of faces, and the structure has none"));
  CHECK_THAT(failure("scene:build(structure.cube(), { as = 'soft' })"), Contains("as must be \"deformable\""));
  CHECK_THAT(failure("scene:build(structure.cube(), { as = function() return 'panels' end })"),
             Contains("a vertex may become \"deformable\" or \"rigid\""));
  CHECK_THAT(failure("scene:build(structure.cube(), { as = 'deformable', law = force.angle { stiffness = 1 } })"),
             Contains("build: law must tie 2 particles; force.angle ties 3"));
  CHECK_THAT(failure("scene:build(structure.cube(), { as = 'deformable', law = 3 })"), Contains("law must be a law"));
  CHECK_THAT(failure("scene:build(structure.cube(), { as = 'rigid', mass = 0/0 })"), Contains("mass must be a finite"));
}

TEST_CASE("molecule files of the scene's folder come first; bad ones are told with both lines") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / text("pantin-molecules-", getpid());
  fs::create_directories(folder);
  std::ofstream(folder / "water.xyz") << "1\n\nO 0 0 0\n";
  std::ofstream(folder / "bad.xyz") << "2\n\nO 0 0 0\nH nan 0 0\n";
  std::ofstream(folder / "empty.pdb") << "";
  std::ofstream(folder / "huge.xyz") << "";
  fs::resize_file(folder / "huge.xyz", std::uintmax_t{257} << 20);
  SceneOptions roomy = options();
  roomy.memory_limit = std::size_t{2} << 30;
  const auto read = [&](const std::string& name) {
    try {
      const auto scene = lua::open_scene_text(
          "local m = structure.molecule '" + name + "'\nscene:result('x', #m.vertices)", "scene.lua", folder, roomy);
      return to_text(std::get<double>(scene->results().at("x")));
    } catch (const Error& error) { return std::string(error.what()); }
  };
  CHECK(read("water.xyz") == "1");
  CHECK(read("bad.xyz") == "scene.lua:1: molecule: bad.xyz:4: a coordinate must be a finite number [Å], got 'nan'");
  CHECK(read("empty.pdb") == "scene.lua:1: molecule: empty.pdb: has no atoms");
  CHECK_THAT(read("huge.xyz"), Contains("huge.xyz' has 257 MiB; at most 256 are read"));
  CHECK_THAT(read("."), StartsWith("scene.lua:1: molecule: there is no file"));
  fs::remove_all(folder);
}

TEST_CASE("molecules are read from the program's own and from nowhere else") {
  CHECK(failure(R"(
    local c60 = structure.molecule "c60.xyz"
    assert(#c60.vertices == 60 and #c60.edges == 90 and #c60.faces == 32 and c60.elements[1] == "C")
    assert(math.abs(structure.molecule("c60.xyz", { scale = 2 }).volume / c60.volume - 8) < 1e-12)
    local water = scene:build(structure.molecule "water.xyz", { as = "rigid", mass = 18.015 })
    assert(math.abs(water.bodies[1].points[1].mass - 15.999) < 1e-3))") == "");
  CHECK_THAT(failure("structure.molecule '/etc/passwd'"), Contains("must be a file below the scene's folder"));
  CHECK_THAT(failure("structure.molecule '../c60.xyz'"), Contains("must be a file below the scene's folder"));
  CHECK_THAT(failure("\nstructure.molecule 'c61.xyz'"),
             StartsWith("scene.lua:2: molecule: there is no file 'c61.xyz'"));
  CHECK_THAT(failure("structure.molecule('c60.xyz', { scale = 0 })"), Contains("scale must be > 0"));
  CHECK_THAT(failure("structure.molecule(3)"), Contains("the file, must be a string"));
}
