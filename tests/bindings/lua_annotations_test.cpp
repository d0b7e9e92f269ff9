#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "bindings/lua_support.hpp"
#include "lua/meta/annotations.hpp"
#include "lua/meta/reference.hpp"
#include "lua/thing/fields.hpp"
#include "support/sources.hpp"
#include "view/keys.hpp"

using namespace pantin;
using namespace pantin::lua_tests;

namespace {

/// The fields of each class of the annotations, with those of the classes that it is also.
std::map<std::string, std::set<std::string>> documented_fields() {
  std::map<std::string, std::set<std::string>> classes;
  std::istringstream lines(lua::annotations());
  std::string open;
  std::map<std::string, std::vector<std::string>> bases;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, name;
    words >> word >> name;
    if (word == "---@class") {
      const bool derived = name.ends_with(':');
      open = derived ? name.substr(0, name.size() - 1) : name;
      classes[open];
      for (bool more = derived; more && words >> name;) {
        more = name.ends_with(',');
        bases[open].push_back(more ? name.substr(0, name.size() - 1) : name);
      }
    }
    if (word == "---@field" && !name.starts_with('['))
      classes[open].insert(name.ends_with('?') ? name.substr(0, name.size() - 1) : name);
  }
  for (int depth = 0; depth < 4; depth++)
    for (const auto& [name, from] : bases)
      for (const std::string& base : from) classes[name].insert(classes[base].begin(), classes[base].end());
  return classes;
}

}  // namespace

TEST_CASE("scripts/meta/pantin.lua is what the tables of the bindings say") {
  std::ifstream file(sources::folder() + "/scripts/meta/pantin.lua");
  const std::string written{std::istreambuf_iterator<char>(file), {}};
  INFO("write it anew with: pantin meta > scripts/meta/pantin.lua");
  CHECK(written == lua::annotations());
}

TEST_CASE("assets/pages/reference.md is what the annotations and the table of keys say") {
  std::ifstream file(sources::folder() + "/assets/pages/reference.md");
  const std::string written{std::istreambuf_iterator<char>(file), {}};
  INFO("write it anew with: pantin meta reference > assets/pages/reference.md");
  CHECK(written == lua::reference() + key_reference());
}

TEST_CASE("the reference has every class, field, function and parameter of the annotations") {
  const std::string pages = lua::reference();
  std::istringstream lines(lua::annotations());
  std::string word, name;
  std::size_t seen = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> word >> name;
    if (word == "---@class" && name.ends_with(':')) name.pop_back();
    CAPTURE(line);
    if (word == "---@class") CHECK(pages.find("\n## " + name + "\n") != std::string::npos);
    if (word == "---@field" && !name.starts_with('[')) CHECK(pages.find("\n| `" + name + "`") != std::string::npos);
    if (word == "---@param") CHECK(pages.find("- `" + name + "`: ") != std::string::npos);
    seen += word.starts_with("---@");
  }
  CHECK(seen > 1000);
}

TEST_CASE("the options that annotations list are those that the bindings know") {
  const std::string things = R"(
    local p = scene:particle() local b = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { head = vec(0, 0, 0) } }
    local c = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { head = vec(0, 0, 0) } }
    local x, o, wrong = vec(1, 0, 0), vec(0, 0, 0), { wrong = 1 }
  )";
  const std::vector<std::pair<std::string, std::string>> calls = {
      {"ParticleOptions", "scene:particle(wrong)"},
      {"BodyOptions", "scene:body(wrong)"},
      {"BallOptions", "scene:ball(wrong)"},
      {"BoxOptions", "scene:box(wrong)"},
      {"CapsuleOptions", "scene:capsule(wrong)"},
      {"CylinderOptions", "scene:cylinder(wrong)"},
      {"FloorOptions", "scene:floor(wrong)"},
      {"GroundOptions", "scene:ground(wrong)"},
      {"PairOptions", "scene:collide('a', 'b', wrong)"},
      {"RayOptions", "scene:ray(wrong)"},
      {"HitFilter", "scene:inside(o, wrong)"},
      {"BallShapeOptions", "shape.ball(wrong)"},
      {"BoxShapeOptions", "shape.box(wrong)"},
      {"CapsuleShapeOptions", "shape.capsule(wrong)"},
      {"CylinderShapeOptions", "shape.cylinder(wrong)"},
      {"HullShapeOptions", "shape.hull(wrong)"},
      {"PolygonShapeOptions", "shape.polygon(wrong)"},
      {"PlaneShapeOptions", "shape.plane(wrong)"},
      {"MeshShapeOptions", "shape.mesh(wrong)"},
      {"HeightsShapeOptions", "shape.heights(wrong)"},
      {"PointOptions", "scene:body { points = { wrong } }"},
      {"FamilyOptions", "scene:family('f', wrong)"},
      {"EmitterOptions", "scene:emitter(wrong)"},
      {"HingeOptions", "scene:hinge(b.head, c.head, wrong)"},
      {"TieOptions", "scene:nail(p, o, wrong)"},
      {"FollowOptions", "scene:follow(p, o, wrong)"},
      {"MotorOptions", "scene:motor(b, wrong)"},
      {"StringOptions", "scene:string({ p, o }, wrong)"},
      {"PathOptions", "scene:on_path(p, { o, x }, wrong)"},
      {"PlaneOptions", "scene:on_plane(p, wrong)"},
      {"OrientOptions", "scene:orient(b, nil, wrong)"},
      {"AlignOptions", "scene:align(b, x, x, wrong)"},
      {"JoinOptions", "scene:join(p, b.head, wrong)"},
      {"GearOptions", "scene:gear(b, c, wrong)"},
      {"RackOptions", "scene:rack(b, p, wrong)"},
      {"PulleyOptions", "scene:pulley(p, o, x, b.head, wrong)"},
      {"ScrewOptions", "scene:screw(b.head, c.head, wrong)"},
      {"SliderOptions", "scene:slider(p, b, wrong)"},
      {"BuildOptions", "scene:build(structure.cube(), wrong)"},
      {"BondingOptions", "scene:bonding(wrong)"},
      {"Condition", "scene:when(wrong, print)"},
      {"WhenOptions", "scene:when(print, print, wrong)"},
      {"ParamOptions", "scene:param('x', 1, wrong)"},
      {"Camera", "scene.camera = wrong"},
      {"SoundOptions", "scene:sound('blip', wrong)"},
      {"SpringOptions", "force.spring(wrong)"},
      {"OwnPairLawOptions", "force.pair(wrong)"},
      {"OwnPointLawOptions", "force.point(wrong)"},
      {"OwnManyLawOptions", "force.many(wrong)"},
  };
  const auto documented = documented_fields();
  for (const auto& [name, call] : calls) {
    CAPTURE(name);
    const std::string message = failure(things + call);
    const std::string begins = " Known are ";
    CHECK_THAT(message, Catch::Contains("unknown field 'wrong'"));
    CAPTURE(message);
    const std::size_t known = message.find(begins);
    REQUIRE(known != std::string::npos);
    std::set<std::string> accepted;
    std::istringstream list(message.substr(known + begins.size()));
    for (std::string field; std::getline(list, field, ',');) {
      accepted.insert(field.substr(field.find_first_not_of(' ')));
    }
    CHECK(documented.at(name) == accepted);
  }
}

TEST_CASE("every field that is listed can be read, and every method is there") {
  const std::string things = R"(
    local body = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { head = vec(0, 0, 0) } }
    local other = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { head = vec(0, 0, 0) } }
    local things = { Scene = scene, Body = body, Point = body.head, Particle = scene:hinge(body.head, other.head),
      Nail = scene:nail(body.head), Follow = scene:follow(scene:particle(), vec(0, 0, 0), { max_force = 1 }),
      Rod = scene:rod(scene:particle(), vec(0, 1, 0)), Weld = scene:weld(body, other), Orient = scene:orient(body),
      Align = scene:align(body, vec(1, 0, 0), vec(0, 1, 0)), OnPlane = scene:on_plane(scene:particle()),
      String = scene:string({ scene:particle(), vec(0, 1, 0) }),
      Join = scene:join(scene:particle { at = vec(9, 9, 9) }, scene:particle()),
      OnPath = scene:on_path(scene:particle(), { vec(0, 0, 0), vec(1, 0, 0) }),
      Gear = scene:gear(body, other, { ratio = 2, axis = vec(0, 1, 0) }),
      Rack = scene:rack(body, scene:particle(), { radius = 2, axis = vec(0, 1, 0), along = vec(1, 0, 0) }),
      Pulley = scene:pulley(scene:particle(), vec(0, 1, 0), vec(1, 1, 0), scene:particle()),
      Screw = scene:screw(body.head, other.head, { lead = 1, axis = vec(0, 1, 0) }),
      Slider = scene:slider(scene:particle(), other, { axis = vec(0, 1, 0) }),
      Motor = scene:motor(body, { axis = vec(0, 1, 0), speed = 1 }),
      Limit = scene:limit(body, other, { axis = vec(0, 1, 0), max = 1 }), Group = scene:group "g", Hand = scene:hand(),
      Snapshot = scene:snapshot(), Structure = structure.cube(), Shape = shape.ball(1), Collider = scene:floor(),
      Draw = scene.draw, HeldKeys = scene.keys, Gamepad = scene.pad, Mouse = scene.mouse, Camera = scene.camera, Saved = scene.saved, Event = scene:at(1, type), Subscription = scene:on("step", type), Family = scene:family("f") }
    local spring, drag = force.spring { stiffness = 1 }, force.drag { linear = 1 }
    things.Connection = scene:connect(scene:particle(), vec(0, 1, 0), spring)
    things.Interaction = scene:interact(things.Family, things.Family, force.gravitation {})
    things.Field = scene:field(scene, drag)
    things.Emitter = scene:emitter { at = vec(0, 0, 0), rate = 1 }
    things.Group:add(body)
  )";
  for (const lua::Type* type : lua::all_types()) {
    if (std::string(type->name) == "OpenedScene") continue;
    CAPTURE(type->name);
    for (const lua::Field& field : type->fields) {
      CAPTURE(field.name);
      const std::string at = "things." + std::string(type->name) + "." + field.name;
      CHECK(failure(things + "local x = " + at) == "");
      if (lua::writable(field))
        CHECK_FALSE(failure(things + at + " = coroutine.create(print)").empty());
      else
        CHECK_THAT(failure(things + at + " = 1"), Catch::Contains("can be read, not written"));
    }
    for (const lua::Method& method : type->methods) {
      const std::string_view name = method.name;
      if (name == "box") continue;  // scene.box reads as the field, see shape_test.lua
      CHECK(failure(things + "assert(type(things." + type->name + "." + method.name + ") == 'function')") == "");
    }
  }
}
