#include "bindings/lua_support.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "scene/errors.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("settings are checked and reach the world") {
  const auto scene = open(R"(
    scene.title, scene.duration, scene.pace = "Test", 3, 0.5
    scene.camera = { at = vec(0, 1, 5), look_at = vec(0, 1, 0), follow = scene:particle() }
    scene.gravity, scene.step, scene.integrator = vec(0, -1, 0), 1 / 60, "euler"
    scene.energy_return, scene.tolerance, scene.seed, scene.boltzmann = false, 1e-5, 7, 1.38e-23
    scene.store = { n = 1 } scene.store.n = scene.store.n + 1
    assert(scene.store.n == 2 and scene.title == "Test" and scene.step == 1 / 60 and scene.camera.at == vec(0, 1, 5)))");
  const Settings& s = scene->world().settings;
  CHECK(scene->title() == "Test");
  CHECK(scene->duration() == 3.0);
  CHECK(scene->pace() == 0.5);
  CHECK(same(*scene->camera().at, vec(0, 1, 5)));
  CHECK(std::holds_alternative<ParticleId>(scene->camera().follow));
  CHECK(s.gravity[1] == -1.0);
  CHECK(s.step == 1.0 / 60);
  CHECK(s.integrator == Integrator::euler);
  CHECK_FALSE(s.energy_return);
  CHECK(s.tolerance == 1e-5);
  CHECK(s.seed == 7);
  CHECK(s.boltzmann == 1.38e-23);
}

TEST_CASE("wrong settings are errors at their line") {
  CHECK_THAT(
      failure("scene.gravty = vec(0, 0, 0)"),
      StartsWith(
          "scene.lua:1: scene: cannot write unknown field 'gravty'. Did you mean 'gravity'? Fields: title, duration"));
  CHECK(failure("scene.gravity = 3") == "scene.lua:1: scene: gravity must be a vec [m/s²], got a number");
  CHECK(failure("scene.step = 0") == "scene.lua:1: scene: step must be > 0 s, got 0");
  CHECK(failure("scene.step = 0/0") == "scene.lua:1: scene: step must be a finite number [s], got NaN");
  CHECK(failure("scene.step = 5e-324").find("step must be at least 1e-18 s") != std::string::npos);
  CHECK_THAT(failure("scene.integrator = 'rk5'"), Contains("must be \"verlet\"") && Contains("got \"rk5\""));
  CHECK(failure("scene.accuracy = 0") == "scene.lua:1: scene: accuracy must be > 0 1/s, got 0");
  CHECK(failure("scene.accuracy = -1e-3") == "scene.lua:1: scene: accuracy must be > 0 1/s, got -0.001");
  CHECK(failure("scene.accuracy = 0/0") == "scene.lua:1: scene: accuracy must be a finite number [1/s], got NaN");
  CHECK_THAT(failure("scene.accuracy = 'high'"), StartsWith("scene.lua:1: scene: accuracy must be a number [1/s]"));
  CHECK_THAT(failure("scene.accuracy = 1e-4 scene.integrator = 'suzuki4'"),
             StartsWith("scene.lua:1: ") && Contains("\"suzuki4\" has fixed steps"));
  CHECK_THAT(failure("scene:nail(scene:body{ mass = 1, inertia = vec(1, 1, 1), points = { p = vec(1, 0, 0) } "
                     "}.p)\nscene.integrator = 'rk4'"),
             StartsWith("scene.lua:2: ") && Contains("moves only what no constraint ties: there is "));
  CHECK_THAT(failure("scene:field(scene, force.drag{ linear = 1 })\nscene.integrator = 'suzuki4'"),
             StartsWith("scene.lua:2: ") && Contains("drag") && Contains("depends on velocities"));
  CHECK_THAT(failure("scene.energy_return = 1"), Contains("must be true or false, got a number"));
  CHECK_THAT(failure("scene.seed = 1.5"), Contains("a whole number"));
  CHECK_THAT(failure("scene.camera = { from = vec(0, 0, 0) }"), Contains("scene: camera: unknown field 'from'"));
  CHECK_THAT(failure("scene.time = 3"), Contains("time can be read, not written"));
}

TEST_CASE("--set scene.FIELD wins over the file") {
  const auto scene = open(
      "scene.step = 1 / 240 scene.gravity = vec(0, -9, 0) scene.title = 'mine' scene.energy_return = true",
      {{"scene.step", "1/60"}, {"scene.gravity", "1,-2.5,0"}, {"scene.title", "42"}, {"scene.energy_return", "false"}});
  CHECK(scene->world().settings.step == 1.0 / 60);
  CHECK(same(scene->world().settings.gravity, vec(1, -2.5, 0)));
  CHECK(scene->title() == "42");
  CHECK_FALSE(scene->world().settings.energy_return);
  CHECK(open("", {{"scene.integrator", "\"suzuki4\""}})->world().settings.integrator == Integrator::suzuki4);
  CHECK(open("scene.accuracy = 1e-2", {{"scene.accuracy", "1e-4"}})->world().settings.accuracy == 1e-4);
  CHECK_FALSE(open("scene.accuracy = 1e-2", {{"scene.accuracy", "nil"}})->world().settings.accuracy);
  CHECK_THROWS_WITH(open("", {{"scene.accuracy", "0"}}),
                    Contains("--set scene.accuracy=0: ") && Contains("must be > 0"));
  CHECK_THROWS_AS(open("", {{"scene.stp", "1"}}), UsageError);
  CHECK_THROWS_WITH(open("", {{"scene.stp", "1"}}), Contains("no setting 'stp'. Did you mean 'step'?"));
  CHECK_THROWS_WITH(open("", {{"scene.step", "-1"}}), Contains("--set scene.step=-1: ") && Contains("must be > 0 s"));
  CHECK_THROWS_AS(open("", {{"scene.step", "abc"}}), UsageError);
  CHECK_THROWS_AS(open("", {{"scene.time", "1"}}), UsageError);
}

TEST_CASE("parameters come from the command line, checked") {
  const std::string source = R"(
    local links = scene:param("links", 20, { min = 1, max = 100, step = 1, help = "number of links" })
    local kind = scene:param("kind", "rope", { choices = { "rope", "chain" } })
    local on = scene:param("on", false)
    scene:result("x", links .. " " .. kind .. " " .. tostring(on)))";
  CHECK(word(source) == "20 rope false");
  const auto scene = open(source, {{"links", "30"}, {"kind", "chain"}, {"on", "true"}});
  CHECK(std::get<std::string>(scene->results().at("x")) == "30 chain true");
  REQUIRE(scene->parameters().size() == 3);
  CHECK(scene->parameters()[0].max == 100.0);
  CHECK(scene->parameters()[0].help == "number of links");
  CHECK(scene->parameters()[1].choices.size() == 2);
  CHECK_FALSE(scene->set_parameter("links", 40.0));
  const auto usage = [&](std::map<std::string, std::string> set, const char* message) {
    CHECK_THROWS_AS(open(source, set), UsageError);
    CHECK_THROWS_WITH(open(source, set), Contains(message));
  };
  usage({{"link", "3"}}, "the scene has no parameter 'link'. Did you mean 'links'? It has links, kind, on");
  usage({{"links", "0"}}, "links must be at least 1, got 0");
  usage({{"links", "101"}}, "links must be at most 100, got 101");
  usage({{"links", "many"}}, "links must be a number, got 'many'");
  usage({{"links", "nan"}}, "links must be a finite number");
  usage({{"kind", "rod"}}, "kind must be one of rope, chain, got rod");
  usage({{"on", "1"}}, "on must be true or false");
  CHECK_THAT(failure("scene:param('a', 1) scene:param('a', 2)"), Contains("declared twice"));
  CHECK_THAT(failure("scene:param('a', 1, { min = 2, max = 0 })"),
             Contains("param: min of 'a' must not be above max, got 2 and 0"));
  CHECK_THAT(failure("scene:param('a', 1, { minimum = 2 })"), Contains("unknown field 'minimum'"));
  CHECK_THAT(failure("scene:param('a', {})"), Contains("must be a number, true or false, or a string, got a table"));
  CHECK_THAT(failure("scene:param('a', 5, { max = 2 })"), Contains("a must be at most 2, got 5"));
}

TEST_CASE("a parameter with a step takes no value between two steps") {
  const std::string links = "local n = scene:param('links', 20, { min = 1, step = 1 }) scene:result('x', n)";
  CHECK(std::get<double>(open(links, {{"links", "7"}})->results().at("x")) == 7);
  CHECK(failure(links, {{"links", "2.5"}}) ==
        "--set links=2.5: links goes in steps of 1 from 1, so it must be 2 or 3, got 2.5");
  CHECK_THROWS_WITH(open(links)->set_parameter("links", 2.5), Contains("must be 2 or 3, got 2.5"));
  CHECK_THAT(failure("scene:param('a', 0.25, { min = 0, step = 0.1 })"),
             StartsWith("scene.lua:1: a goes in steps of 0.1 from 0"));
  const std::string tenths = "scene:param('a', 0.5, { step = 0.1 })";  // counted from the default where there is no min
  for (const char* value : {"0.3", "0.7", "-12.9", "1234567.1"}) CHECK(failure(tenths, {{"a", value}}) == "");
  CHECK_THAT(failure(tenths, {{"a", "0.35"}}), Contains("in steps of 0.1 from 0.5"));
}

TEST_CASE("a parameter with on_change is applied live") {
  const auto scene =
      open("scene:param('g', 9.81, { min = 0, on_change = function(v) scene.gravity = vec(0, -v, 0) end })");
  CHECK(scene->set_parameter("g", 3.0));
  CHECK(scene->world().settings.gravity[1] == -3.0);
  CHECK(std::get<double>(scene->parameters()[0].value) == 3.0);
  CHECK_THROWS_WITH(scene->set_parameter("g", -3.0), Contains("at least 0"));
  CHECK_THROWS_AS(scene->set_parameter("h", 1.0), UsageError);
}

TEST_CASE("files that are no scenes are told") {
  CHECK_THROWS_AS(lua::open_scene("/nowhere/scene.lua", options()), UsageError);
  CHECK_THROWS_WITH(lua::open_scene("/nowhere/scene.lua", options()), "/nowhere/scene.lua: there is no such file");
  CHECK_THROWS_AS(lua::open_scene("/tmp", options()), UsageError);
  CHECK_THAT(failure("local x =\nfor"), StartsWith("scene.lua:2: unexpected symbol near"));
}

TEST_CASE("results, finish, probes and warnings come out") {
  const auto scene = open(R"(
    scene:result("n", 3) scene:result("word", "yes") scene:result("flag", true)
    scene:probe("height", function() return 1 + scene.time end)
    scene:at(scene.step, function() scene:finish() end))");
  CHECK(std::get<double>(scene->results().at("n")) == 3.0);
  CHECK(std::get<bool>(scene->results().at("flag")));
  scene->step();
  CHECK_FALSE(scene->finished());
  scene->step();
  CHECK(scene->finished());
  REQUIRE(scene->world().probes.size() == 1);
  CHECK(scene->world().probes[0].values.size() == 2);
  CHECK(scene->world().probes[0].values[1] == 1 + scene->world().time);
  CHECK_THAT(failure("scene:probe('a', function()\nreturn 'x' end)"),
             Contains("probe 'a': what the function returns must be a number, got a string"));
  CHECK_THAT(failure("scene:result('a', {})"), Contains("must be a number, true or false, or a string, got a table"));
}

TEST_CASE("measures can be read") {
  CHECK(failure(R"(
    local p = scene:particle { at = vec(0, 2, 0), velocity = vec(3, 0, 0), mass = 2 }
    scene:particle { at = vec(0, 0, 0), mass = 1 }
    local e = scene.energy
    assert(e.kinetic == 9 and math.abs(e.potential - 2 * 9.81 * 2) < 1e-12 and e.total == e.kinetic + e.potential)
    assert(scene.momentum == vec(6, 0, 0) and scene.angular_momentum == vec(0, 0, -12))
    assert(scene.temperature > 0 and #scene.particles == 2 and #scene:near(vec(0, 2, 0), 1) == 1 and scene:near(vec(0, 2, 0), 1)[1] == p)
    assert(scene.error.hinge_gap == 0 and scene.error.worst_energy >= 0 and scene.stats.newton_iterations == 0)
    assert(type(scene.stats.ns.drift) == "number" and #scene.log == 0 and scene.time == 0))") == "");
}
