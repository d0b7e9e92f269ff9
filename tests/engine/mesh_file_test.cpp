#include "structures/mesh_file.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "base/check.hpp"
#include "base/random.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string tetrahedron = corners + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

std::string message(const std::string& text) {
  try {
    read_mesh_file(text, "x.obj");
  } catch (const Error& error) { return error.what(); }
  return "none";
}

}  // namespace

TEST_CASE("mesh file: a tetrahedron has its corners, edges, faces and volume, whatever else is in the file") {
  const std::string noise =
      "# a comment\nmtllib none.mtl\no thing\nvn 0 0 1\nvt 0 0\nv 7 7 7\ng part\nusemtl red\ns off\n";
  for (const std::string& text : {tetrahedron, tetrahedron + noise}) {
    const Structure s = read_mesh_file(text, "x.obj");
    CHECK(s.vertices.size() == 4);
    CHECK(s.edges.size() == 6);
    CHECK(s.faces.size() == 4);
    CHECK(volume(s).value() == Approx(1.0 / 6));
    CHECK(open_edges(s) == 0);
  }
  const Structure relative = read_mesh_file(corners + "f -4//1 -2//1 -3//1\nvn 0 0 1\n", "x.obj");
  CHECK(relative.faces.size() == 1);
  CHECK(open_edges(relative) == 3);
}

TEST_CASE("mesh file: coordinates are those of the text, to the last bit") {
  const Structure s = read_mesh_file("v 0.1 1e-300 -2.5\nv 3 0 0\nv 0 3 1\nf 1 2 3\n", "x.obj");
  CHECK(s.vertices[0][0] == 0.1);
  CHECK(s.vertices[0][1] == 1e-300);
  CHECK(s.vertices[0][2] == -2.5);
}

TEST_CASE("mesh file: edges of a hole, and of faces turned inside out, are counted") {
  CHECK(open_edges(read_mesh_file(corners + "f 1 3 2\nf 1 2 4\nf 2 3 4\n", "x.obj")) == 3);
  CHECK(open_edges(read_mesh_file(corners + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n", "x.obj")) == 3);
}

TEST_CASE("mesh file: what is no surface is told with the file's name") {
  CHECK_THAT(message(""), Contains("x.obj: has no faces"));
  CHECK_THAT(message(corners), Contains("x.obj: has no faces"));
  CHECK_THAT(message(corners + "l 1 2\n"), Contains("x.obj: has no faces"));
  CHECK_THAT(message("solid ascii\nfacet normal 0 0 1\n"), Contains("x.obj: has no faces"));
  CHECK_THAT(message(corners + "f 1 2 9\n"), Contains("x.obj: "));
  CHECK_THAT(message(corners + "f 1 2 0\n"), Contains("x.obj:5: a face must have numbers of vertices, got '0'"));
  CHECK_THAT(message(corners + "f 1 2 -9\n"), Contains("x.obj: "));
  CHECK_THAT(message(corners + "f 1 2 99999999999999999999\n"), Contains("x.obj:5: a face must have numbers"));
  CHECK_THAT(message(corners + "f 1 2 2\n"), Contains("x.obj: "));
  for (const std::string bad : {"nan", "inf", "1e999", "abc", "1,5", "0x1"})
    CHECK_THAT(message("v 1 0 0\nv " + bad + " 0 0\nv 0 1 0\nf 1 2 3\n"),
               Contains("x.obj:2: a vertex must have three finite numbers [m], got '" + bad + "'"));
  CHECK_THAT(message("v 1 0\n"), Contains("x.obj:1: a vertex must have three finite numbers [m], got 2"));
}

TEST_CASE("mesh file: garbled files are read or refused, and nothing worse") {
  Random random{5, 0};
  for (int i = 0; i < 3000; i++) {
    std::string text = tetrahedron;
    for (int k = 0; k < 4; k++)
      text[static_cast<std::size_t>(random.uniform() * static_cast<double>(text.size()))] =
          "0123456789-/.ef v\nx\0"[static_cast<std::size_t>(random.uniform() * 20)];
    message(text);
  }
  SUCCEED();
}
