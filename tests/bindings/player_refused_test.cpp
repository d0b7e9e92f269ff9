// What LAMMPS cannot be given is told by name, with what to do.
#include "player/lammps/refused.hpp"

#include <catch2/catch.hpp>

#include "lua/scene/open.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

std::vector<std::string> refused(const std::string& source, double until = 10.0) {
  const auto scene = lua::open_scene_text(source, "test.lua", ".", {});
  return player::refused_by_lammps(*scene, until);
}

/// The one sentence that there is.
std::string only(const std::string& source, double until = 10.0) {
  const std::vector<std::string> all = refused(source, until);
  REQUIRE(all.size() == 1);
  return all[0];
}

const std::string two = R"(
local p = scene:particle { at = vec(0, 0, 0) }
local q = scene:particle { at = vec(1, 0, 0) }
local dust = scene:family "dust"
)";

}  // namespace

TEST_CASE("refused: nothing, of particles, springs, bodies of points, fields and a thermostat") {
  CHECK(refused(two + R"(
    scene:connect(p, q, force.spring { stiffness = 10 })
    scene:body { at = vec(0, 5, 0), points = { { at = vec(0, 0, 0), mass = 1 }, { at = vec(1, 0, 0), mass = 2 } } }
    scene:interact(dust, dust, force.lennard_jones { epsilon = 1, sigma = 1 })
    scene:field(scene, force.thermostat { rate = 1, temperature = 1 })
    scene:field(dust, force.point { potential = function(p) return p.position.y ^ 2 end })
    scene:probe("x", function() return p.position.x end)
  )")
            .empty());
}

TEST_CASE("refused: each thing once, by its name, with what to do") {
  CHECK_THAT(only("scene:nail(scene:particle { at = vec(0, 0, 0), name = \"bob\" })"),
             Contains("a constraint, nail") && Contains("tie the same points by a stiff"));
  CHECK_THAT(only(R"(
    local a = scene:body { points = { { at = vec(0, 0, 0), mass = 1 }, { at = vec(1, 0, 0), mass = 1 } } }
    local b = scene:body { points = { { at = vec(1, 0, 0), mass = 1 }, { at = vec(2, 0, 0), mass = 1 } } }
    scene:hinge(a.points[2], b.points[1], { name = "elbow" }))"),
             Contains("a hinge (hinge 'elbow')") && Contains("no joints"));
  CHECK_THAT(
      only("for i = 1, 3 do scene:body { at = vec(3 * i, 0, 0), mass = 1, inertia = vec(1, 1, 1), points = { { at = "
           "vec(0, 0, 0), mass = 1 } } } end"),
      Contains("a body with mass beside its points") && Contains("and 2 more") &&
          Contains("give its mass to its points"));
  CHECK_THAT(only("scene:emitter { rate = 1 }"), Contains("an emitter") && Contains("--save-at"));
  CHECK_THAT(only("scene:particle { at = vec(0, 0, 0), lifetime = 3 }"), Contains("a particle whose life ends"));
  CHECK_THAT(only(two + "scene.plane = \"xy\""), Contains("scene.plane") && Contains("stays there"));
  CHECK_THAT(only(two + "scene.plane = \"xy\" scene:field(scene, force.thermostat { rate = 1, temperature = 1 })"),
             Contains("scene.plane") && Contains("what the thermostat pushes out of the plane"));
  CHECK_THAT(only(two + "scene:hand({ path = function(t) return vec(0, t, 0) end }):grab(p)"),
             Contains("a hand that holds something") && Contains("hand:release()"));
  CHECK_THAT(only(two + "scene:family(\"sand\", { solid = true, radius = 0.1 })"),
             Contains("a solid family") && Contains("force.repel"));
}

TEST_CASE("refused: what the script does, and what is set to happen before the end") {
  CHECK_THAT(only(two + "scene:on(\"step\", function() p:kick(vec(0, 1, 0)) end)"),
             Contains("a behaviour") && Contains("test.lua:5") && Contains("LAMMPS runs no Lua"));
  CHECK_THAT(only(two + "scene:at(3, function() end)"),
             Contains("an event (test.lua:5, at 3 s)") && Contains("--until") && Contains("--save-at"));
  CHECK(refused(two + "scene:at(3, function() end)", 2.0).empty());
  CHECK_THAT(only(two + "scene:every(3, function() end)"), Contains("again and again"));
  CHECK_THAT(only(two + "scene:over(1, 2, function() end)"), Contains("an event over a time"));
  CHECK_THAT(only(two + "scene:bonding { families = dust, near = 0.2, below = 5, above = 10, law = "
                        "force.spring { stiffness = 10 } }"),
             Contains("a bonding") && Contains("bonding:cancel()"));
}

TEST_CASE("refused: laws, with their lines") {
  const auto [law, told] = GENERATE(table<std::string, std::string>(
      {{"scene:connect(p, q, force.damper { damping = 1 })", "test.lua:5: damper (a law): it depends on velocities"},
       {"scene:connect(p, q, force.spring { stiffness = 1, damping = 1 })", "leave its damping out"},
       {"scene:field(scene, force.drag { linear = 1 })", "depends on velocities"},
       {"scene:connect(p, q, force.pair { potential = function(r, a, b, own, t) return r * t end })",
        "depends on time"},
       {"scene:interact(dust, dust, force.gravitation {})", "give cutoff"},
       {"scene:interact(dust, dust, force.flock { sight = 1 })", "test.lua:5: flock"},
       {"scene:interact(dust, dust, force.lennard_jones { epsilon = 1, sigma = 1, exclude = 5 })",
        "up to 3 connections"},
       {"local r = scene:particle { at = vec(0, 1, 0) } scene:connect({ p, q, r }, force.angle { stiffness = 1 })",
        "a law of three or four particles"},
       {"scene:connect(p, vec(0, 3, 0), force.spring { stiffness = 1 })", "a connection to a position"},
       {"scene:connect(p, q, force.spring { stiffness = 1 }, { breaks_at = { length = 3 } })",
        "a connection that may break"}}));
  CHECK_THAT(only(two + law), Contains(told));
}
