#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "bindings/lua_support.hpp"
#include "lua/annotations.hpp"
#include "lua/fields.hpp"
#include "support/sources.hpp"

using namespace pantin;
using namespace pantin::lua_tests;

TEST_CASE("scripts/meta/pantin.lua is what the tables of the bindings say") {
  std::ifstream file(sources::folder() + "/scripts/meta/pantin.lua");
  const std::string written{std::istreambuf_iterator<char>(file), {}};
  INFO("write it anew with: pantin meta > scripts/meta/pantin.lua");
  CHECK(written == lua::annotations());
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
      Motor = scene:motor(body, { axis = vec(0, 1, 0), speed = 1 }),
      Limit = scene:limit(body, other, { axis = vec(0, 1, 0), max = 1 }), Group = scene:group "g", Hand = scene:hand(),
      Structure = structure.cube(), Draw = scene.draw, Event = scene:at(1, type), Subscription = scene:on("step", type), Family = scene:family("f") }
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
      if (field.write)
        CHECK_FALSE(failure(things + at + " = coroutine.create(print)").empty());
      else
        CHECK_THAT(failure(things + at + " = 1"), Catch::Contains("can be read, not written"));
    }
    for (const lua::Method& method : type->methods)
      CHECK(failure(things + "assert(type(things." + type->name + "." + method.name + ") == 'function')") == "");
  }
}
