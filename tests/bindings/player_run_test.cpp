// What a run leaves that an error stops.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/process.hpp"
#include "support/sources.hpp"

namespace sources = pantin::sources;
using namespace pantin::support;
using Catch::Contains;

TEST_CASE("program: what a run had until an error stopped it is kept, and the summary names the error") {
  Folder folder;
  write_file(folder / "nan.lua", R"(
local p = scene:particle {}
scene:probe("x", function() return p.position.x end)
scene:field(scene, force.point { force = function(p, own, t) return vec(where(t > 0.1, 0 / 0, 0), 0, 0) end })
)");
  write_file(folder / "boom.lua", "scene:on('step', function() if scene.time > 0.1 then error('boom') end end)");
  write_file(folder / "late.lua", "scene:at(0.1,\nfunction() error('boom') end)");
  for (const char* scene : {"nan", "boom", "late"}) {
    const Finished result = finish({{sources::program(), "run", std::string(scene) + ".lua", "--until", "1", "--out",
                                     "a.csv", "--summary", "s.json"},
                                    {"PANTIN_HOME=" + sources::folder(), "DISPLAY", "WAYLAND_DISPLAY"},
                                    folder.path,
                                    -1});
    INFO(result.err);
    CHECK(result.code == 1);
    CHECK_THAT(result.err, Contains("what there is by then is kept"));
    const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
    CHECK(summary["steps"] > 20);
    CHECK_THAT(summary["failure"].get<std::string>(), Contains(".lua:"));
    CHECK(!read_file(folder / "a.csv").empty());
  }
}
