// A traced law is compared with its function while the scene runs.
#include <catch2/catch.hpp>

#include "laws/law.hpp"
#include "lua/scene/open.hpp"
#include "step/step.hpp"
#include "world/world.hpp"

using namespace pantin;

TEST_CASE(
    "a traced law that disagrees with its function, which reads too much to be watched, is called, with one warning") {
  const auto scene = lua::open_scene_text(R"(
    scene.gravity = vec(0, 0, 0)
    local ions, k = scene:family "ions", {}
    for i = 1, 5000 do k[i] = 1 end
    for i = 1, 5 do scene:particle { family = ions, at = vec(2 * i, 0, 0) } end
    scene:interact(ions, ions, force.pair { potential = function(r) return k[5000] / r end })
    scene:at(0.01, function() k[5000] = 2 end)
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
