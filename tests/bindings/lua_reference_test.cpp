#include <catch2/catch.hpp>
#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "bindings/lua_support.hpp"
#include "lua/meta/annotations.hpp"
#include "lua/meta/reference.hpp"
#include "lua/scene/open.hpp"
#include "lua/test/tests.hpp"
#include "lua/thing/fields.hpp"
#include "support/process.hpp"
#include "view/keys.hpp"

using namespace pantin;
using namespace pantin::lua_tests;

namespace {

/// A field or parameter of the annotations.
struct Line {
  std::string whole, owner, name, type, rest;
  bool is_field;
};

std::vector<Line> lines_of_annotations() {
  const std::regex pattern(
      R"re(---@(field|param) (\[string\]|\S+) ((?:fun\([^)]*\)(?:: \S+)?|\{[^}]*\}|\S)+) ?(.*))re");
  std::vector<Line> found;
  std::istringstream in(lua::annotations());
  std::string owner;
  for (std::string line; std::getline(in, line);) {
    std::smatch m;
    if (line.starts_with("---@class ")) owner = line.substr(10, line.find_first_of(": ", 10) - 10);
    if (std::regex_match(line, m, pattern)) found.push_back({line, owner, m[2], m[3], m[4], m[1] == "field"});
  }
  return found;
}

/// What stands between the backticks of "(default `…`)"; empty where there are none.
std::string default_of(const std::string& text) {
  const std::string begin = "(default `";
  const std::size_t from = text.find(begin);
  if (from == text.npos) return "";
  return text.substr(from + begin.size(), text.find('`', from + begin.size()) - from - begin.size());
}

std::string failure_of_scene(const std::string& lines, const support::Folder& folder) {
  support::write_file(folder.path / "track.csv", "x,y\n1,2\n3,4\n");
  try {
    const auto scene = lua::open_scene_text(lua::example_scene + lines, "scene.lua", folder.path, options());
    for (int i = 0; i < 10; i++) scene->step();
  } catch (const Error& error) { return error.what(); }
  return "";
}

/// A file of its own for each: `test` and what stands outside of tests are tried, too.
std::string failure_of_test(const std::string& lines, const support::Folder& folder) {
  const std::string path = folder.path / "example_test.lua";
  support::write_file(path, lua::example_test + lines + "test(\"it runs\", function() end)\n");
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::tmpfile(), std::fclose);
  const int failed = lua::run_tests({path}, options(), out.get()).failed;
  std::rewind(out.get());
  std::string told;
  for (int c = std::fgetc(out.get()); c != EOF; c = std::fgetc(out.get())) told += static_cast<char>(c);
  return failed == 0 ? "" : told;
}

}  // namespace

TEST_CASE("the reference has an example of every call, of one to three lines that run") {
  const std::vector<lua::Example> examples = lua::reference_examples();
  CHECK(examples.size() > 130);
  const support::Folder folder;
  for (const lua::Example& example : examples) {
    CAPTURE(example.call, example.lines);
    const auto lines = std::count(example.lines.begin(), example.lines.end(), '\n');
    CHECK(lines >= 1);
    CHECK(lines <= 3);
    const std::string name = example.call.substr(example.call.find_first_of(":.") + 1);
    CHECK(example.lines.find(name) != std::string::npos);
    CHECK((example.of_test ? failure_of_test(example.lines, folder) : failure_of_scene(example.lines, folder)) == "");
  }
}

TEST_CASE("every link of the reference leads to an entry, and every call on the scene belongs to a task") {
  const std::string pages = lua::reference() + key_reference();
  const std::regex link(R"re(\]\(#([^)]+)\))re");
  std::size_t links = 0;
  for (std::sregex_iterator at(pages.begin(), pages.end(), link), end; at != end; ++at, links++) {
    const std::string id = "<a id=\"" + (*at)[1].str() + "\"></a>";
    CAPTURE(id);
    CHECK(pages.find(id) != std::string::npos);
    CHECK(pages.find(id, pages.find(id) + 1) == std::string::npos);
  }
  CHECK(links > 300);
  const std::string tasks = pages.substr(0, pages.find("## What the examples have"));
  CHECK(pages.find("## By task") < 400);
  for (const lua::Method& method : lua::scene_type().methods) {
    CAPTURE(method.name);
    CHECK(std::regex_search(tasks, std::regex(text("#(Any)?Scene:", method.name, "\\)"))));
  }
}

TEST_CASE("in the reference every number and vec has a unit, and every option a default") {
  const std::regex of_number(R"re(\b(number|vec)\b)re");
  std::size_t options = 0;
  for (const Line& line : lines_of_annotations()) {
    CAPTURE(line.whole);
    // What a function is given and gives is told by its meaning.
    if (std::regex_search(line.type, of_number) && line.type.find("fun(") == std::string::npos && line.type != "color")
      CHECK(line.rest.starts_with("["));
    const bool of_result = line.owner == "Ledger" || line.owner == "TimelineEntry" || line.owner == "Contact" ||
                           line.owner == "Touch" || line.owner == "ContactHeat" || line.owner == "Hit";
    if (!line.is_field || !line.name.ends_with('?') || of_result) continue;
    CHECK(line.rest.find("(default ") != std::string::npos);
    options++;
  }
  CHECK(options > 120);
}

TEST_CASE("the defaults that the reference names are those of the scene") {
  std::size_t settings = 0;
  for (const lua::Field& field : lua::scene_type().fields) {
    const std::string usual = default_of(field.doc);
    if (usual.empty() || std::string_view(field.name) == "store") continue;
    CAPTURE(field.name, usual);
    CHECK(failure(text("assert(scene.", field.name, " == ", usual, ")")) == "");
    settings++;
  }
  CHECK(settings >= 8);
  for (const char* name : {"duration", "accuracy", "box", "plane"})
    CHECK(failure(text("assert(scene.", name, " == nil)")) == "");
}

TEST_CASE("the defaults that the reference names of options are those of what is made without them") {
  const std::string bodies =
      R"(local b = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { head = vec(0, 0, 0) } }
    local p = scene:particle {} local made = )";
  const std::map<std::string, std::string> makers = {
      {"LookOptions", "scene:particle {}"},
      {"ParticleOptions", "scene:particle {}"},
      {"EmitterOptions", "scene:emitter { rate = 1 }"},
      {"PointOptions", "b.head"},
      {"AnyBodyOptions",
       "scene:body { points = { { mass = 1, at = vec(1, 0, 0) }, { mass = 1, at = vec(-1, 0, 0) } } }"},
      {"FollowOptions", "scene:follow(p, vec(0, 0, 0))"},
      {"MotorOptions", "scene:motor(b, { axis = vec(0, 1, 0), speed = 1 })"},
      {"LimitOptions", "scene:limit(b, { axis = vec(0, 1, 0), max = 2 })"},
      {"PlaneOptions", "scene:on_plane(p)"},
      {"JoinOptions", "scene:join(p, b.head)"},
      {"MaterialOptions", "shape.ball(1)"},
  };
  // Of those the thing tells more than what was given: its points' part too, or the length.
  const std::set<std::string> other = {"AnyBodyOptions.mass", "AnyBodyOptions.inertia", "AnyBodyOptions.points",
                                       "PointOptions.at",     "LimitOptions.max",       "JoinOptions.at"};
  std::size_t compared = 0;
  for (const Line& line : lines_of_annotations()) {
    const auto maker = makers.find(line.owner);
    const std::string usual = default_of(line.rest), name = line.name.substr(0, line.name.find('?'));
    if (maker == makers.end() || usual.empty() || other.contains(line.owner + "." + name)) continue;
    CAPTURE(line.whole);
    if (name == "time_constant") continue;  // no field tells it
    const std::string at = name == "at" && line.owner == "ParticleOptions"  ? "position"
                           : name == "at" && line.owner == "AnyBodyOptions" ? "origin"
                                                                            : name;
    const std::string is = "tostring(made." + at + ") == tostring(" + usual + ")";
    CHECK(failure(bodies + maker->second + " assert(made." + at + " == " + usual + " or " + is + ")") == "");
    compared++;
  }
  CHECK(compared >= 20);
}

TEST_CASE("what the annotations call a thing is what calls accept as one") {
  const std::string annotations = lua::annotations();
  const std::size_t from = annotations.find("---@alias Thing ") + 16;
  std::istringstream names(annotations.substr(from, annotations.find('\n', from) - from));
  std::set<std::string> things;
  for (std::string name; std::getline(names, name, '|');) things.insert(name);
  std::set<std::string> accepted;
  const std::string made = std::string(lua::example_scene) + R"(
    local things = { Point = arm.head, Particle = p, Body = arm, Nail = scene:nail(arm.head), Follow = scene:follow(p, vec(0, 0, 0)),
      Rod = scene:rod(p, q), Weld = scene:weld(arm, block), Orient = scene:orient(block),
      Align = scene:align(arm, vec(1, 0, 0), vec(0, 1, 0)), Motor = scene:motor(block, { axis = vec(0, 1, 0), speed = 1 }),
      Limit = scene:limit(p, q, { length = 9 }), OnPlane = scene:on_plane(q), String = scene:string({ p, q }),
      OnPath = scene:on_path(q, { vec(0, 0, 0), vec(1, 0, 0) }), Join = scene:join(p, arm.tail),
      Gear = scene:gear(arm, block, { ratio = 2, axis = vec(0, 1, 0) }),
      Rack = scene:rack(block, p, { radius = 2, axis = vec(0, 1, 0), along = vec(1, 0, 0) }),
      Pulley = scene:pulley(p, vec(0, 1, 0), vec(1, 1, 0), q),
      Screw = scene:screw(block.points[1], arm.head, { lead = 1, axis = vec(0, 1, 0) }),
      Slider = scene:slider(p, arm, { axis = vec(0, 1, 0) }), Group = group, Family = ions,
      Connection = scene:connect(p, q, spring), Interaction = scene:interact(ions, ions, force.coulomb {}),
      Field = scene:field(scene, force.drag { linear = 1 }), Emitter = scene:emitter { rate = 1 },
      Event = scene:at(1, type), Hand = scene:hand(), Subscription = scene:on("step", type), Structure = structure.cube(),
      Shape = shape.ball(1), Collider = scene:floor(), Draw = scene.draw, HeldKeys = scene.keys,
      Gamepad = scene.pad, Mouse = scene.mouse, Camera = scene.camera, Saved = scene.saved, Snapshot = scene:snapshot(), Scene = scene }
    local thing = things.)";
  for (const lua::Type* type : lua::all_types()) {
    const std::string name = type->name;
    if (name == "OpenedScene") continue;
    CAPTURE(name);
    std::set<bool> answers;
    for (const char* call : {"scene:at(0, thing, type)", "scene:group('g'):add(thing)",
                             "scene.camera = { follow = thing }", "scene:play(thing, function(wait) wait() end)"}) {
      CAPTURE(call);
      const std::string message = failure(made + name + " " + call);
      if (!message.empty()) CHECK_THAT(message, Catch::Contains("must be a thing of the scene"));
      answers.insert(message.empty());
    }
    CHECK(answers.size() == 1);
    if (answers.contains(true)) accepted.insert(name);
  }
  CHECK(things == accepted);
}
