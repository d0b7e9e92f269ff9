// A traced law is compared with its function while the scene runs.
#include <catch2/catch.hpp>
#include <string>
#include <variant>

#include "forces/forces.hpp"
#include "laws/law.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "world/world.hpp"

using namespace pantin;

TEST_CASE(
    "a traced law that disagrees with its function, which reads what cannot be watched, is called, with one warning") {
  const auto scene = lua::open_scene_text(R"(
    scene.gravity = vec(0, 0, 0)
    local ions, seen = scene:family "ions", 0
    local read = coroutine.wrap(function() while true do seen = seen + 1 coroutine.yield(seen < 2000 and 1 or 2) end end)
    for i = 1, 5 do scene:particle { family = ions, at = vec(2 * i, 0, 0) } end
    scene:interact(ions, ions, force.pair { potential = function(r) return read() / r end })
    scene:at(0.01, function() for _ = 1, 2000 do read() end end)
  )",
                                          "scene.lua", ".", {});
  advance(scene->world(), 0.5);
  int warnings = 0;
  for (const LogLine& line : scene->world().log)
    if (line.kind == "warning") warnings++;
  CHECK(warnings == 1);
  CHECK(scene->world().interactions.at_slot(0).law->called);
}

TEST_CASE("a traced law that agrees with its function stays traced") {
  const auto scene = lua::open_scene_text(R"(
    scene.gravity = vec(0, 0, 0)
    local ions = scene:family("ions", { attributes = { charge = 2 } })
    for i = 1, 5 do scene:particle { family = ions, at = vec(2 * i, 0, 0) } end
    scene:interact(ions, ions, force.pair { cutoff = 3, parameters = { k = 2 },
      tension = function(r, rate, a, b, own, t) return own.k * a.charge * b.charge * (r - 2) + 0.1 * rate + t end })
    scene:field(ions, force.point { force = function(p) return -0.1 * p.velocity end })
  )",
                                          "scene.lua", ".", {});
  advance(scene->world(), 0.5);
  CHECK(scene->world().failure == "");
  CHECK(scene->world().log.empty());
  CHECK_FALSE(scene->world().interactions.at_slot(0).law->called);
}

namespace {

/// A pair law, a field and a connection that read what is set after them.
const char* const filled_in_later = R"(
  scene.gravity, scene.box = vec(0, 0, 0), vec(12, 12, 12)
  local constants, f = { k = 1 }, scene:family "f"
  local a, b = scene:particle { family = f, at = vec(5, 5, 5) }, scene:particle { family = f, at = vec(7, 5, 5) }
  local pairs = scene:interact(f, f, force.pair { cutoff = 3, potential = function(r) return constants.k * (3 - r) ^ 3 end })
  local bond = scene:connect(a, b, force.pair { potential = function(r) return constants.k * (r - 1) ^ 2 end })
  local field = scene:field(f, force.point { potential = function(p) return constants.k * p.position.x end })
  constants.k = 3
)";

}  // namespace

TEST_CASE("a law reads what the file sets after it, before the first step and in a state that is kept of then") {
  const auto opened = lua::open_scene_text(filled_in_later, "scene.lua", ".", {});
  CHECK(energy(opened->world()).potential == Approx(3.0 * (1.0 + 1.0 + 12.0)));
  CHECK(present_forces(opened->world()).on[0][0] == Approx(-3.0 * (3.0 - 2.0 + 1.0)));
  const auto kept = lua::open_state(opened->state(), "state", {});
  CHECK(energy(kept->world()).potential == Approx(42.0));
  kept->step();
  opened->step();
  CHECK(energy(opened->world()).potential == Approx(42.0).epsilon(1e-3));
  CHECK(energy(opened->world()).potential == energy(kept->world()).potential);
}

TEST_CASE("energies that a script reads are of laws with what it has set so far") {
  const auto scene = lua::open_scene_text(std::string(filled_in_later) + R"(
    scene:result("all", scene.energy.potential)
    scene:result("family", f.energy.potential)
    scene:result("pairs", pairs.energy)
    constants.k = 1
    scene:result("bond", bond.energy)
    scene:result("field", field.energy)
    scene:at(0, function()
      constants.k = 2
      scene:result("later", scene.energy.potential)
      constants.k = 4
    end)
  )",
                                          "scene.lua", ".", {});
  const auto told = [&](const char* name) { return std::get<double>(scene->results().at(name)); };
  CHECK(told("all") == Approx(42.0));
  CHECK(told("pairs") == Approx(3.0));
  CHECK(told("bond") == Approx(1.0));
  CHECK(told("field") == Approx(12.0));
  scene->step();
  CHECK(told("later") == Approx(28.0));
  CHECK(energy(scene->world()).potential == Approx(56.0).epsilon(1e-2));
  CHECK(scene->world().log.empty());
}

TEST_CASE("a law that several have follows what changes once the first of them is gone") {
  const auto scene = lua::open_scene_text(R"(
    scene.gravity = vec(0, 0, 0)
    local k, p = 1, {}
    for i = 1, 4 do p[i] = scene:particle { at = vec(2 * i, 0, 0) } end
    local law = force.pair { potential = function(r) return k * (r - 1) ^ 2 end }
    local first, second = scene:connect(p[1], p[2], law), scene:connect(p[3], p[4], law)
    first:remove()
    scene:at(0.1, function() k = 3 scene:result("energy", second.energy / (p[4].position.x - p[3].position.x - 1) ^ 2) end)
  )",
                                          "scene.lua", ".", {});
  advance(scene->world(), 0.2);
  CHECK(std::get<double>(scene->results().at("energy")) == Approx(3.0));
}
