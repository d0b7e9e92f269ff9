#include "structures/build.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "laws/library.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "structures/lattice.hpp"
#include "structures/polyhedra.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

BuildLaw law_of(const char* name, std::map<std::string, double> numbers) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  auto law = std::make_shared<const Law>(make_library_law(name, arguments)[0]);
  std::vector<double> values;
  for (const Parameter& p : law->parameters)
    values.push_back(arguments.numbers.contains(p.name) ? arguments.numbers[p.name] : p.value);
  return {law, values};
}
BuildLaw spring() { return law_of("spring", {{"stiffness", 100}}); }

BuildDef as(BuildAs form, double mass = 1.0) {
  BuildDef def;
  def.as = form;
  def.mass = mass;
  return def;
}

void check_inertia_of(const Mat3& inertia, double expected) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      CHECK(inertia[i][j] == Approx(i == j ? expected : 0.0).epsilon(1e-12).margin(1e-12 * expected));
}

std::map<std::size_t, int> rings_by_size(const World& world, const Built& built) {
  std::map<std::size_t, int> count;
  for (ParticleId p : built.particles) count[world.particles[p].points.size()]++;
  return count;
}

Structure c60() { return truncated(shapes::icosahedron(3), 1.0 / 3); }

/// Every vertex has its particle in its place.
void check_places(const World& world, const Built& built, const Structure& s, Vec3 at) {
  REQUIRE(built.particles.size() == s.vertices.size());
  for (std::size_t v = 0; v < s.vertices.size(); v++)
    CHECK(norm(position(world, awake(world, built.particles[v])) - s.vertices[v] - at) < 1e-13 * (1 + norm(at)));
}

void check_still_there(const World& world) {
  CHECK(world.bodies.size() == 1);
  CHECK(world.particles.size() == 3);
  CHECK(world.connections.empty());
  CHECK(world.groups.empty());
  CHECK(world.notices.empty());
}

}  // namespace

TEST_CASE("a rigid build has the inertia of points, thin rods, plates or a solid") {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  struct Row {
    Structure s;
    MassIn where;
    double moment;  // of mass 1
  };
  const Row rows[] = {
      {shapes::cube(2), MassIn::points, 2},
      {shapes::cube(2), MassIn::edges, (4 * 2 + 8 * (1 / 3.0 + 1)) / 12},
      {shapes::cube(2), MassIn::faces, (2 * 8 / 12.0 + 4 * (1 / 3.0 + 1)) / 6},
      {shapes::cube(2), MassIn::solid, 4 / 6.0},
      {shapes::tetrahedron(1), MassIn::solid, 1 / 20.0},
      {shapes::octahedron(1), MassIn::solid, 1 / 10.0},
      {shapes::icosahedron(1), MassIn::solid, golden * golden / 10},
      {shapes::dodecahedron(1), MassIn::solid, (39 * golden + 28) / 150},
  };
  for (const Row& row : rows) {
    World world;
    BuildDef def = as(BuildAs::rigid, 3);
    def.mass_in = row.where;
    def.at = vec(10, -4, 2);
    const Built built = build(world, row.s, def);
    REQUIRE(built.bodies.size() == 1);
    check_inertia_of(inertia(world, built.bodies[0]), 3 * row.moment);
    CHECK(world.motion_of(built.bodies[0]).mass == Approx(3).epsilon(1e-15));
    CHECK(norm(world.motion_of(built.bodies[0]).x - def.at) < 1e-13);
    check_places(world, built, row.s, def.at);
  }
}

TEST_CASE("an articulated icosahedron: 30 rods on 12 rings of 5") {
  World world;
  BuildDef def = as(BuildAs::articulated, 30);
  def.velocity = vec(1, 2, 3);
  def.at = vec(0, 5, 0);
  const Structure s = shapes::icosahedron(0.5);
  const Built built = build(world, s, def);
  CHECK(built.bodies.size() == 30);
  CHECK(built.connections.empty());
  CHECK(rings_by_size(world, built) == std::map<std::size_t, int>{{5, 12}});
  check_places(world, built, s, def.at);
  CHECK(accuracy(world).hinge_gap < 1e-14);
  for (std::size_t e = 0; e < s.edges.size(); e++) {
    const Motion& m = world.motion_of(built.bodies[e]);
    CHECK(m.mass == Approx(1).epsilon(1e-14));
    CHECK(m.inertia[1] == Approx(0.25 / 12).epsilon(1e-14));
    CHECK(m.freedom == Freedom::line);
    CHECK(norm(m.x - def.at - (s.vertices[s.edges[e][0]] + s.vertices[s.edges[e][1]]) / 2.0) < 1e-14);
  }
  CHECK(norm(momentum(world, everything(world)) - vec(30, 60, 90)) < 1e-12);
  for (int i = 0; i < 120; i++) step(world);
  CHECK(accuracy(world).hinge_gap < 1e-9);
  CHECK(world.worst.energy < 1e-9);
}

TEST_CASE("C60 in every form") {
  const Structure s = c60();
  for (BuildAs form : {BuildAs::rigid, BuildAs::deformable, BuildAs::articulated, BuildAs::panels}) {
    World world;
    BuildDef def = as(form, 60);
    def.edge = spring();
    const Built built = build(world, s, def);
    check_places(world, built, s, zero3());
    const std::map<BuildAs, std::size_t> bodies = {
        {BuildAs::rigid, 1}, {BuildAs::deformable, 0}, {BuildAs::articulated, 90}, {BuildAs::panels, 32}};
    CHECK(built.bodies.size() == bodies.at(form));
    CHECK(built.connections.size() == (form == BuildAs::deformable ? 90 : 0));
    const std::size_t ring = form == BuildAs::articulated || form == BuildAs::panels ? 3 : 1;
    CHECK(rings_by_size(world, built) == std::map<std::size_t, int>{{ring, 60}});
    CHECK(mass(world, things_of(world, built.group)) == Approx(60).epsilon(1e-13));
    CHECK(world.groups[built.group].members.size() == 60 + built.bodies.size() + built.connections.size());
    for (int i = 0; i < 20; i++) step(world);
    CHECK(accuracy(world).hinge_gap < 1e-9);
  }
}

TEST_CASE("a plate has the inertia of its polygon, however it lies") {
  World world;
  const Structure s = rotated(shapes::cube(2), normalised({1, 0.3, -0.2, 0.5}));
  const Built built = build(world, s, as(BuildAs::panels, 6));
  REQUIRE(built.bodies.size() == 6);
  for (BodyId plate : built.bodies) {
    const Motion& m = world.motion_of(plate);
    CHECK(m.mass == Approx(1).epsilon(1e-14));
    CHECK(m.inertia[0] == Approx(4 / 12.0).epsilon(1e-13));
    CHECK(m.inertia[2] == Approx(8 / 12.0).epsilon(1e-13));
  }
  CHECK(rings_by_size(world, built) == std::map<std::size_t, int>{{3, 8}});
}

TEST_CASE("a deformable build ties edges, angles and torsions at their present values") {
  World world;
  BuildDef def = as(BuildAs::deformable, 6);
  def.edge = spring();
  def.angle = law_of("angle", {{"stiffness", 1}});
  def.torsion = law_of("torsion", {{"stiffness", 1}, {"fold", 1}});
  Structure s = shapes::ring(6, 1);
  for (std::size_t v = 0; v < 6; v += 2) s.vertices[v] += vec(0, 0, 0.3);
  const Built built = build(world, s, def);
  REQUIRE(built.connections.size() == 6 + 6 + 6);
  for (std::size_t e = 0; e < 6; e++) {
    const Connection& c = world.connections[built.connections[e]];
    CHECK(c.particles[0] == built.particles[s.edges[e][0]]);
    CHECK(c.particles[1] == built.particles[s.edges[e][1]]);
  }
  // At rest when nothing pulls.
  set_gravity(world, zero3());
  for (int i = 0; i < 10; i++) step(world);
  for (ParticleId p : built.particles) CHECK(norm(velocity(world, p)) < 1e-12);
  // Three in line have no torsion: of a straight chain there is none, of a cubic lattice only those round corners.
  World straight;
  CHECK(build(straight, shapes::rod(1, 5), def).connections.size() == 5 + 4);
}

TEST_CASE("mixed builds: by vertex, edge and face") {
  const Structure rod = shapes::rod(4, 4);
  {  // Rigid ends, a soft middle.
    World world;
    BuildDef def;
    def.edge = spring();
    def.vertices = [](std::uint32_t v) { return v == 2 ? BuildAs::deformable : BuildAs::rigid; };
    const Built built = build(world, rod, def);
    CHECK(built.bodies.size() == 2);
    CHECK(built.connections.size() == 2);
    CHECK(rings_by_size(world, built) == std::map<std::size_t, int>{{1, 5}});
    CHECK(mass(world, things_of(world, built.group)) == Approx(1).epsilon(1e-14));
  }
  {  // A rod on hinges, a rigid pair, a spring, and a gap.
    World world;
    BuildDef def;
    def.edge = spring();
    def.edges = [](std::uint32_t e) {
      return std::array{BuildAs::articulated, BuildAs::rigid, BuildAs::deformable, BuildAs::nothing}[e];
    };
    const Built built = build(world, rod, def);
    CHECK(built.bodies.size() == 2);
    CHECK(built.connections.size() == 1);
    CHECK(world.particles[built.particles[1]].points.size() == 2);
    check_places(world, built, rod, zero3());
    CHECK(mass(world, things_of(world, built.group)) == Approx(1).epsilon(1e-14));
  }
  {  // A cube with a plate above and below, springs between.
    World world;
    BuildDef def;
    def.edge = spring();
    const Structure cube = shapes::cube(1);
    def.faces = [&](std::uint32_t f) {
      return std::fabs(middle(cube, cube.faces[f])[1]) > 0.1 ? BuildAs::panels : BuildAs::nothing;
    };
    const Built built = build(world, cube, def);
    CHECK(built.bodies.size() == 2);
    CHECK(built.connections.size() == 4);
  }
}

TEST_CASE("what cannot be built leaves the world as it was") {
  World world;
  BodyDef body;
  body.mass = 1;
  body.inertia = identity33();
  body.points = {{}, {}, {}};
  for (int i = 0; i < 3; i++) body.points[static_cast<std::size_t>(i)].at = vec(i, 0, 0);
  add_body(world, body);
  const auto fails = [&](const Structure& s, const BuildDef& def, const std::string& message) {
    CHECK_THROWS_WITH(build(world, s, def), Contains(message));
    check_still_there(world);
  };
  BuildDef solid = as(BuildAs::rigid);
  solid.mass_in = MassIn::solid;
  BuildDef wrong_law = as(BuildAs::deformable);
  wrong_law.angle = spring();
  BuildDef in_box = as(BuildAs::deformable);
  in_box.edge = spring();
  in_box.edge.solve = Solve::at_middle;
  BuildDef no_place = as(BuildAs::rigid);
  no_place.at = vec(0, std::numeric_limits<double>::quiet_NaN(), 0);
  BuildDef wrong_mass_in = as(BuildAs::panels);
  wrong_mass_in.mass_in = MassIn::solid;
  BuildDef wrong_edges = as(BuildAs::deformable);
  wrong_edges.edges = [](std::uint32_t) { return BuildAs::panels; };
  fails({}, as(BuildAs::rigid), "build: the structure is empty");
  fails(shapes::ring(5, 1), as(BuildAs::panels), "\"panels\" makes plates of faces, and the structure has none");
  fails(make_structure({zero3()}, {}, {}), as(BuildAs::articulated), "rods of edges, and the structure has none");
  fails(make_structure({zero3(), zero3()}, {{0, 1}}, {}), as(BuildAs::articulated), "vertices 1 and 2 have an edge");
  fails(make_structure({vec(0, 0, 0), vec(1, 0, 0), vec(2, 0, 0)}, {}, {{0, 1, 2}}), as(BuildAs::panels),
        "a face without area cannot have mass");
  fails(shapes::ring(5, 1), solid, "needs a closed surface");
  fails(shapes::cube(1), as(BuildAs::rigid, 0), "mass must be > 0 kg, got 0");
  fails(shapes::cube(1), no_place, "at must be finite");
  fails(shapes::cube(1), wrong_law, "the law of angles must tie 3 particles, got one that ties 2");
  fails(shapes::cube(1), wrong_mass_in, "mass_in is \"points\"");
  fails(shapes::cube(1), wrong_edges, "an edge may become");
  world.settings.box = vec(10, 10, 10);
  fails(shapes::cube(1), in_box, "implicit = true works in open space");
}

TEST_CASE("vertices that are in no face of panels, and in no edge of rods, have their share of the mass") {
  Structure s = shapes::cube(1);
  s.vertices.push_back(vec(3, 0, 0));
  for (BuildAs form : {BuildAs::panels, BuildAs::articulated}) {
    World world;
    const Built built = build(world, s, as(form, 9.0));
    CHECK(mass(world, things_of(world, built.group)) == Approx(9).epsilon(1e-14));
    CHECK(world.points[world.particles[built.particles[8]].points[0]].mass == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("the law of an edge across the border of a box measures it the short way") {
  World world;
  world.settings.box = vec(10, 10, 10);
  Structure s;
  s.vertices = {vec(9.5, 0, 0), vec(0.5, 0, 0)};
  s.edges = {{0, 1}};
  BuildDef def = as(BuildAs::deformable);
  def.edge = law_of("spring", {{"stiffness", 100}});
  for (std::size_t i = 0; i < def.edge.law->parameters.size(); i++)
    if (def.edge.law->parameters[i].present) def.edge.values[i] = 0.0;
  const Built built = build(world, s, def);
  const Connection& edge = world.connections[built.connections[0]];
  for (std::size_t i = 0; i < edge.parameters.size(); i++)
    if (edge.law->parameters[i].present) CHECK(edge.parameters[i] == Approx(1.0));
}
