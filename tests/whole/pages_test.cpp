// Pages say what is so: their examples run, and what they name is there.
#include <catch2/catch.hpp>
#include <regex>
#include <string>

#include "bindings/program_support.hpp"

using namespace pantin::support;
using Catch::Contains;
namespace sources = pantin::sources;

namespace {

std::string page(const std::string& name) { return read_file(sources::folder() + "/assets/pages/" + name); }

/// The energy error that the end of a run tells, the worst.
double energy_error(const Folder& folder, std::vector<std::string> arguments) {
  const Finished run = use(folder, std::move(arguments));
  INFO(run.out << run.err);
  std::smatch found;
  const std::regex told(R"(energy error \S+ \(worst ([^)]+)\))");
  REQUIRE(std::regex_search(run.out, found, told));
  return std::stod(found[1]);
}

/// The error of the first scene of a page.
double error_of_first(const std::string& text, const std::string& until) {
  std::smatch scene;
  REQUIRE(std::regex_search(text, scene, std::regex("```lua\n([^`]*)```")));
  const Folder folder;
  write_file(folder / "scene.lua", scene[1]);
  return energy_error(folder, {"run", "scene.lua", "--until", until});
}

}  // namespace

TEST_CASE("pages: the library's examples are those that are built from outside") {
  for (const char* file : {"hang.cpp", "open.cpp", "CMakeLists.txt"}) {
    const std::string text = read_file(sources::folder() + "/examples/library/" + file);
    CHECK(text.size() > 100);
    CHECK_THAT(page("library.md"), Contains("\n" + text + "```"));
  }
}

TEST_CASE("pages: each word of ours for who comes from elsewhere stands in the reference") {
  const std::string coming = page("coming.md"), reference = page("reference.md");
  const std::regex word(R"(`(scene|body)([:.])(\w+))");
  int count = 0;
  for (std::sregex_iterator at(coming.begin(), coming.end(), word), end; at != end; ++at, count++) {
    const std::string type = (*at)[1] == "scene" ? "Scene" : "Body", rest = (*at)[2].str() + (*at)[3].str();
    const std::string field = "| `" + (*at)[3].str() + "`";
    INFO(type << rest);
    CHECK((reference.find(type + rest) != std::string::npos || reference.find(field) != std::string::npos));
  }
  CHECK(count > 50);
  CHECK(error_of_first(coming, "2") < 1e-9);
}

TEST_CASE("pages: the first scene that a reader sees runs") {
  CHECK(error_of_first(read_file(sources::folder() + "/README.md"), "11") < 1e-3);
}

TEST_CASE("pages: what shakes does, and does not as the page sets it") {
  const Folder folder;
  const std::string shakes = page("shakes.md");
  const std::regex scene(R"(`(\w+\.lua)`:\n\n```lua\n([^`]*)```)");
  for (std::sregex_iterator at(shakes.begin(), shakes.end(), scene), end; at != end; ++at)
    write_file(folder / (*at)[1].str(), (*at)[2]);
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "--until", "2"});
    return energy_error(folder, more);
  };
  CHECK(run({"steep.lua"}) > 0.1);
  CHECK(run({"steep.lua", "--set", "scene.accuracy=1e-3"}) < 1e-3);
  CHECK(run({"steep.lua", "--set", "scene.integrator=suzuki4", "--set", "scene.step=1/480"}) < 1e-3);
  CHECK(run({"wheel.lua", "--set", "scene.step=1/60"}) > 1e-3);
  CHECK(run({"wheel.lua", "--set", "strength=20", "--set", "scene.step=1/60"}) < 1e-5);
  CHECK(run({"rotor.lua"}) < 1e-9);
  CHECK_THAT(use(folder, {"run", "overlap.lua", "--until", "2"}).out,
             Contains("shapes overlapped by up to 0.0475 m, 9.5 % of the thinner"));
}
