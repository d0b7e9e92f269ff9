#include "structures/molecule.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>

#include "base/check.hpp"
#include "base/interruptible.hpp"
#include "structures/polyhedra.hpp"
#include "structures/rings.hpp"
#include "support/sources.hpp"

using namespace pantin;
using Catch::Contains;
using Catch::StartsWith;

namespace {

Structure from_assets(const std::string& name) {
  std::ifstream file(sources::folder() + "/assets/molecules/" + name);
  return read_molecule(std::string(std::istreambuf_iterator<char>(file), {}), name);
}

std::string failure_of(const std::string& content, const std::string& name) {
  try {
    read_molecule(content, name);
  } catch (const Error& error) { return error.what(); }
  return "";
}

std::map<std::size_t, int> rings_by_sides(const Structure& s) {
  std::map<std::size_t, int> count;
  for (const StructureFace& face : s.faces) count[face.size()]++;
  return count;
}

const std::string water_pdb =
    "HETATM    1  O   HOH A   1       0.000   0.000   0.000  1.00  0.00           O\n"
    "HETATM    2  H1  HOH A   1       0.757   0.586   0.000  1.00  0.00           H\n"
    "HETATM    3  H2  HOH A   1      -0.757   0.586   0.000  1.00  0.00           H\n"
    "END\n";

const std::string water_cif =
    "data_water\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
    "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n_atom_site.B_iso_or_equiv\n"
    "_atom_site.auth_seq_id\n_atom_site.auth_asym_id\n"
    "HETATM 1 O O . HOH A . 0.0 0.0 0.0 1 0 1 A\nHETATM 2 H H1 . HOH A . 0.757 0.586 0.0 1 0 1 A\n"
    "HETATM 3 H H2 . HOH A . -0.757 0.586 0.0 1 0 1 A\n";

const std::string component =
    "data_CO\n_chem_comp.id CO\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n_chem_comp_atom.type_symbol\n"
    "_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\nCO C C 0 0 0\nCO O O 9.0 0 0\n"
    "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\nCO C O\n";

}  // namespace

TEST_CASE("C60: 60 atoms, 90 bonds of two lengths, 12 pentagons, 20 hexagons, as the program makes it") {
  const Structure s = from_assets("c60.xyz");
  CHECK(s.vertices.size() == 60);
  CHECK(s.edges.size() == 90);
  CHECK(rings_by_sides(s) == std::map<std::size_t, int>{{5, 12}, {6, 20}});
  CHECK(euler_characteristic(s) == 2);
  CHECK(is_closed(s));
  std::map<long, int> lengths;  // [mÅ]
  for (const StructureEdge& e : s.edges) lengths[std::lround(1e3 * norm(s.vertices[e[0]] - s.vertices[e[1]]))]++;
  CHECK(lengths == std::map<long, int>{{1401, 30}, {1458, 60}});
  const double edge = 1.401 + 2 * 1.458;
  const Structure made = truncated(shapes::icosahedron(edge), 1.458 / edge);
  for (std::size_t v = 0; v < 60; v++) CHECK(norm(made.vertices[v] - s.vertices[v]) < 1e-7);
  CHECK(volume(s).value() == Approx(volume(made).value()).epsilon(1e-6));
}

TEST_CASE("benzene, water and diamond") {
  const Structure benzene = from_assets("benzene.sdf"), water = from_assets("water.xyz"),
                  diamond = from_assets("diamond.xyz");
  CHECK(benzene.vertices.size() == 12);
  CHECK(benzene.edges.size() == 12);
  CHECK(rings_by_sides(benzene) == std::map<std::size_t, int>{{6, 1}});
  CHECK(std::count(benzene.elements.begin(), benzene.elements.end(), "H") == 6);
  REQUIRE(water.edges == std::vector<StructureEdge>{{0, 1}, {0, 2}});
  const Vec3 a = water.vertices[1], b = water.vertices[2];
  CHECK(norm(a) == Approx(0.9572).epsilon(1e-6));
  CHECK(std::acos(dot(a, b) / (norm(a) * norm(b))) * 180 / std::acos(-1.0) == Approx(104.52).epsilon(1e-6));
  CHECK(atomic_mass("O") == Approx(15.999).epsilon(1e-4));
  std::vector<int> degree(diamond.vertices.size(), 0);
  for (const StructureEdge& e : diamond.edges) {
    degree[e[0]]++;
    degree[e[1]]++;
    CHECK(norm(diamond.vertices[e[0]] - diamond.vertices[e[1]]) == Approx(3.567 * std::sqrt(3.0) / 4).epsilon(1e-6));
  }
  CHECK(*std::max_element(degree.begin(), degree.end()) == 4);
  CHECK(diamond.faces.empty());  // its rings are chairs
}

TEST_CASE("PDB and mmCIF: atoms of the first model, bonds from the file and by distance") {
  for (const auto& [content, name] : {std::pair{water_pdb, "water.pdb"}, {water_cif, "water.mmcif"}}) {
    INFO(name);
    const Structure s = read_molecule(content, name);
    CHECK(s.elements == std::vector<std::string>{"O", "H", "H"});
    CHECK(s.edges == std::vector<StructureEdge>{{0, 1}, {0, 2}});
    CHECK(norm(s.vertices[1] - vec(0.757, 0.586, 0)) < 1e-12);
  }
  // CONECT adds what is not near; an atom that it names needs no other.
  CHECK(read_molecule("CONECT    2    3\n" + water_pdb, "x.pdb").edges.size() == 3);
  CHECK(read_molecule(component, "co.cif").edges == std::vector<StructureEdge>{{0, 1}});
}

TEST_CASE("bad molecule files are told with their line") {
  CHECK(failure_of("", "a.xyz") == "a.xyz:1: the file ends before the number of atoms");
  CHECK(failure_of("3\n\nC 0 0 0\nC 1 0 0\n", "a.xyz") == "a.xyz:5: the file ends before atom 3 of 3");
  CHECK(failure_of("1\n\nC 0 nan 0\n", "a.xyz") == "a.xyz:3: a coordinate must be a finite number [Å], got 'nan'");
  CHECK(failure_of("1\n\nC 0 1e999 0\n", "a.xyz") == "a.xyz:3: a coordinate must be a finite number [Å], got '1e999'");
  CHECK(failure_of("1\n\nQq 0 0 0\n", "a.xyz") == "a.xyz:3: must name a chemical element, got 'Qq'");
  CHECK(failure_of("1\n\nC 0 0\n", "a.xyz") == "a.xyz:3: must be an element and three coordinates [Å]");
  CHECK(failure_of(water_pdb, "a.xyz").starts_with("a.xyz:1: must be the number of atoms, got 'HETATM"));
  CHECK(failure_of("1\n" + std::string(std::size_t{2} << 20, ' ') + "\nC 0 0 0\n", "a.xyz") ==
        "a.xyz:2: the line has 2097152 bytes; at most 1048576 are read");
  CHECK_THAT(failure_of("99999999999\n\n", "a.xyz"), StartsWith("a.xyz:1: at most 4000000 atoms are read"));
  CHECK_THAT(failure_of("2\n\nC 0 0 0\nC 0 0 0\n", "a.xyz"), Contains("atoms 1 and 2 are only 0 Å apart"));
  CHECK_THAT(failure_of("\x89PNG\r\n\x1a\n\0\0", "a.xyz"), StartsWith("a.xyz:1: must be the number of atoms"));
  CHECK_THAT(failure_of("C 0 0 0", "molecule"), Contains("is read from .xyz, .sdf"));
  CHECK(failure_of("\n\n\n", "a.sdf") == "a.sdf:4: the file ends before the counts");
  CHECK_THAT(failure_of("\n\n\n  0  0  0     0  0              0 V3000\n", "a.sdf"), Contains("V3000 is not read"));
  CHECK(failure_of("\n\n\n  2  1\n    0.0000    0.0000    0.0000 C\n    1.2000    0.0000    0.0000 O\n  1  3  1\n",
                   "a.sdf") == "a.sdf:7: must be a bond between two of the 2 atoms, got '  1  3  1'");
  CHECK(failure_of("\n\n\n  1  0\n    0.0000       NaN    0.0000 C\n", "a.sdf") ==
        "a.sdf:5: a coordinate must be a finite number [Å], got 'NaN'");
  CHECK(failure_of("", "a.pdb") == "a.pdb: has no atoms");
  CHECK(failure_of("HETATM    1  O   HOH A   1       0.000   0.0\n", "a.pdb") ==
        "a.pdb:1: the line of an atom ends before its coordinates do");
  CHECK_THAT(failure_of("HETATM    1  O   HOH A   1         NaN   0.000   0.000  1.00  0.00           O\n", "a.pdb"),
             StartsWith("a.pdb:1: a coordinate must be a finite number"));
  CHECK(failure_of("data_x\n", "a.cif") == "a.cif: has no atoms");
  CHECK_THAT(failure_of("not a cif", "a.cif"), StartsWith("a.cif:1:"));
  CHECK_THAT(failure_of("", "a.cif"), StartsWith("a.cif"));
  std::string nan_cif = water_cif;
  nan_cif.replace(nan_cif.find("0.757"), 5, "?");
  CHECK_THAT(failure_of(nan_cif, "a.cif"), Contains("has a coordinate that is no finite number"));
}

TEST_CASE("of alternatives the first counts, where few or all atoms have them") {
  std::string text;
  for (const char* position : {"A", "B"})
    for (int i = 0; i < 9; i++)
      text += "HETATM   1" + std::to_string(i) + "  C" + std::to_string(i) + " " + position + "LIG A   1      " +
              (position[0] == 'A' ? " " : "1") + std::to_string(i) + ".000   0.000   0.000  0.50  0.00           C\n";
  const Structure s = read_molecule(text + "END\n", "alternatives.pdb");
  REQUIRE(s.vertices.size() == 9);
  for (std::size_t i = 0; i < 9; i++) CHECK(norm(s.vertices[i] - vec(static_cast<double>(i), 0, 0)) < 1e-12);
}

TEST_CASE("a search for rings that nobody waits for any more ends") {
  const Structure crowd = [] {
    std::vector<Vec3> positions;
    for (int i = 0; i < 1000; i++) positions.push_back(vec(i % 10, i / 10 % 10, i / 100));
    std::vector<StructureEdge> edges;
    for (std::uint32_t i = 0; i < 1000; i++)
      for (std::uint32_t step : {1u, 2u, 10u, 20u, 100u, 200u})
        if (i + step < 1000) edges.push_back({i, i + step});
    return make_structure(positions, edges, {});
  }();
  const std::atomic<bool> gone = true;
  given_up = &gone;
  CHECK_THROWS_AS(flat_rings(crowd, 8, 0.1), GivenUp);
  given_up = nullptr;
}
