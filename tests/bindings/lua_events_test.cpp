#include "bindings/lua_support.hpp"
#include "choreography/hands.hpp"
#include "lua/scene/script_scene.hpp"
#include "lua/thing/script.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

namespace {

std::string text_of(const Scene& scene) { return std::get<std::string>(scene.results().at("x")); }

}  // namespace

TEST_CASE("events fire at the beginning of the step at their time, in the order of adding") {
  const auto scene = open(R"(
    scene.step = 0.25
    local s = ""
    local function say(word) return function() s = s .. word .. scene.time .. " " scene:result("x", s) end end
    scene:at(0.5, say "b") scene:at(0.5, say "c") scene:at(0, say "a") scene:every(0.75, say "e") scene:after(1, say "f"))");
  for (int i = 0; i < 7; i++) scene->step();
  CHECK(text_of(*scene) == "a0.0 b0.5 c0.5 e0.75 f1.0 e1.5 ");
}

TEST_CASE("an event knows its state and can be cancelled") {
  CHECK(failure(R"(
    local p = scene:particle()
    local gone = scene:at(0.02, p, function() error "must not run" end)
    local cancelled = scene:at(0.01, function() error "must not run" end)
    local fired = scene:at(0.01, p, function(target) assert(target == p) p:remove() end)
    assert(fired.state == "waiting") cancelled:cancel() assert(cancelled.state == "cancelled")
    scene:at(0.03, function()
      assert(gone.state == "dropped" and fired.state == "fired")
      fired:cancel() assert(fired.state == "fired")
      assert(scene.log[1].kind == "dropped" and scene.log[1].text:find "scene.lua:3" and scene.log[1].text:find "removed at")
    end))") == "");
}

TEST_CASE("using a removed thing in an event ends that action only") {
  const auto scene = open(
      "local p = scene:particle { name = 'p' } p:remove()\nlocal n = 0\nscene:every(scene.step, function()\n"
      "n = n + 1 scene:result('x', n)\np.mass = 3\nerror 'not reached' end)");
  for (int i = 0; i < 3; i++) scene->step();
  CHECK(std::get<double>(scene->results().at("x")) == 2.0);
  REQUIRE(scene->world().log.size() == 2);
  CHECK(scene->world().log[0].kind == "dropped");
  CHECK(scene->world().log[0].text == "scene.lua:5: particle 'p' was removed at 0 s by scene.lua:1");
  REQUIRE(scene->warnings().size() == 1);
  CHECK(scene->warnings()[0].starts_with("2 events were dropped, the first: scene.lua:5: particle 'p'"));
}

TEST_CASE("an error in a callback leaves the step with its line") {
  CHECK(failure("scene:at(0.01, function()\nlocal x = nil\nx.y = 1 end)") ==
        "scene.lua:3: attempt to index a nil value (local 'x')");
  CHECK(failure("scene:on('step', function()\nscene:body { mass = -1, points = { vec(0, 0, 0) } } end)") ==
        "scene.lua:2: body: mass must be > 0 kg, got -1");
  CHECK(failure("local p = scene:particle { name = 'p' } p:remove()\nscene:on('step', function()\np.mass = 1 end)") ==
        "scene.lua:3: particle 'p' was removed at 0 s by scene.lua:1");
  CHECK_THAT(failure("scene:probe('x', function()\nerror('no') end)"), StartsWith("scene.lua:2: no"));
  CHECK_THAT(failure("scene:probe('x', function()\nscene:particle() return 1 end)"),
             Contains("cannot be edited while it steps"));
  CHECK_THAT(failure("scene:probe('x', function()\nscene:probe('y', function() return 1 end) return 1 end)"),
             StartsWith("scene.lua:2: probe: probes cannot be added while the world steps"));
}

TEST_CASE("an error is told with a line, whatever was raised and wherever") {
  CHECK(failure("\nerror()") == "scene.lua:2: error without a message");
  CHECK(failure("\nerror({})") == "scene.lua:2: error: {}");
  CHECK(failure("error { code = 3, reason = 'full', vec(1, 2, 3), { 1 } }") ==
        "scene.lua:1: error: { [1] = a vec, [2] = a table, code = 3, reason = \"full\" }");
  CHECK(failure("error(setmetatable({}, { __tostring = function() return 'mine' end }))") ==
        "scene.lua:1: error: mine");
  CHECK(failure("\nerror('no place', 0)") == "scene.lua:2: no place");
  CHECK(failure("\nassert(false)") == "scene.lua:2: assertion failed!");
  CHECK(failure("scene:on('step', function()\nerror(3 == 4) end)") == "scene.lua:2: error: false");
  CHECK(failure("\ncoroutine.wrap(function() error {} end)()") == "scene.lua:2: error: {}");
  CHECK_THAT(failure("\nsetmetatable(scene, {})"), StartsWith("scene.lua:2: bad argument #1 to 'setmetatable'"));
  CHECK_THAT(failure("\nsetmetatable(setmetatable({}, { __metatable = 1 }), {})"),
             StartsWith("scene.lua:2: cannot change a protected metatable"));
}

TEST_CASE("a state that goes wrong is told with who acted last") {
  const auto scene =
      open("local p = scene:particle { name = 'comet' }\nscene:at(0.1, function()\np:kick(vec(1e308, 0, 0)) end)");
  for (int i = 0; i < 3000 && scene->world().failure.empty(); i++) scene->step();
  CHECK_THAT(scene->world().failure,
             Contains("comet") && Contains("the last to act on the scene was scene.lua:3, at 0.1 s"));
}

TEST_CASE("wrong calls are told") {
  CHECK_THAT(failure("scene:at(-1, print)"), Contains("at: argument 1, the time, must be >= 0 s, got -1"));
  CHECK_THAT(failure("scene:every(0, print)"), Contains("every: argument 1, the period, must be > 0 s, got 0"));
  CHECK_THAT(failure("scene:after('x', print)"),
             Contains("after: argument 1, the delay, must be a number [s], got a string"));
  CHECK_THAT(failure("scene:at(1, 3, print)"), Contains("must be a thing of the scene, got a number"));
  CHECK_THAT(failure("scene:at(1)"), Contains("at: argument 2"));
  CHECK_THAT(failure("scene:on('key', 'x')"), Contains("on: argument 3"));
  CHECK_THAT(failure("scene:on('steps', print)"), Contains("unknown moment 'steps'. Did you mean 'step'?"));
}

TEST_CASE("callbacks hear what happened, until they are cancelled") {
  const auto scene = open(R"(
    local s = ""
    local function say(...) for _, word in ipairs { ... } do s = s .. tostring(word) .. " " end scene:result("x", s) end
    local p = scene:particle { name = "p" }
    scene:on("key", function(name) say("key", name) end)
    scene:on("key", "j", function(name) say("named", name) end)
    scene:on("grab", function(thing, hand) say("grab", hand) end)
    scene:on("drop", function(thing, hand) say("drop", hand) end)
    scene:on("removed", function(thing, story) say(story) end)
    scene:button("go", function() say "go" end)
    local sub sub = scene:on("step", function(dt) say(dt == scene.step) sub:cancel() end)
    scene:after(0.02, function() p:remove() end))");
  World& world = scene->world();
  REQUIRE(scene->buttons() == std::vector<std::string>{"go"});
  const auto command = [&](Command::Kind kind, const char* name) {
    Command c;
    c.kind = kind;
    c.name = name;
    world.input.commands.push_back(c);
  };
  CHECK(scene->keys() == std::vector<std::string>{"j"});
  command(Command::Kind::key, "k");
  command(Command::Kind::key, "j");
  command(Command::Kind::button, "go");
  for (int i = 0; i < 10; i++) scene->step();
  CHECK_THAT(text_of(*scene), Contains("true") && Contains("key k key j named j") && Contains("go") &&
                                  Contains("particle 'p' was removed at") && Contains("by scene.lua:12"));
}

TEST_CASE("what is grabbed and dropped, cut, joined, broken and removed is told with the thing itself") {
  const auto scene = open(R"(
    scene.step, scene.gravity = 0.1, vec(0, 0, 0)
    local s = ""
    local function hear(moment)
      scene:on(moment, function(...)
        s = s .. moment
        for _, what in ipairs { ... } do s = s .. "|" .. (math.type(what) and ("%.0f N"):format(what) or tostring(what)) end
        s = s .. "\n" scene:result("x", s)
      end)
    end
    for _, moment in ipairs { "press", "release", "grab", "drop", "cut", "joined", "broke", "removed" } do hear(moment) end
    local held, gone = scene:particle { name = "held" }, scene:particle { name = "gone", at = vec(9, 0, 0) }
    local near, far = scene:particle { name = "near", at = vec(0, 5, 0) }, scene:particle { name = "far", at = vec(0, 6, 0) }
    local hand, other = scene:hand { path = function(t) return vec(t, 0, 0) end }, scene:hand { path = function(t) return vec(9, t, 0) end }
    local same = {}
    scene:on("grab", function(point, by) same[point] = by end)
    scene:on("drop", function(point, by) assert(same[point] == by) end)
    scene:at(0.1, function() hand:grab(held.points[1]) other:grab(gone) end)
    scene:at(0.3, function() hand:release() end)
    scene:at(0.4, function() gone:remove() end)
    local hinge
    scene:join(near, far, { time_constant = 0.01, on_met = function(met) hinge = met met.name = "met" end })
    scene:at(2, function() hinge:cut() end)
    local low = { scene:particle { at = vec(0, -5, 0) }, scene:particle { at = vec(3, -5, 0) } }
    scene:nail(low[1]) scene:nail(low[2])
    scene:connect(low, force.spring { stiffness = 1, length = 1 }, { breaks_at = { length = 1 }, name = "tie" }))");
  for (int i = 0; i < 25; i++) scene->step();
  const std::string broke = "connection 'tie' was removed at 0.1 s by its length of 3 m",
                    gone = "particle 'gone' was removed at 0.4 s by scene.lua:20",
                    cut = "was removed at 2 s by scene.lua:23";
  CHECK(text_of(*scene) == "broke|" + broke + "|2 N|" + broke +
                               "\ngrab|particle 'held'|hand 1\ngrab|particle 'gone'|hand 2\n"
                               "joined|hinge 'met'\ndrop|particle 'held'|hand 1\ndrop|" +
                               gone + "|hand 2\nremoved|" + gone + "|" + gone + "\ncut|hinge 'met' " + cut + "\n");
}

TEST_CASE("subscriptions that were cancelled leave nothing behind, and the others keep their order") {
  const auto scene = open(R"(
    local order = ""
    local function say(word) return function() order = order .. word end end
    scene:on("step", say "a")
    local old = scene:on("step", error) old:cancel()
    scene:on("step", function()
      for i = 1, 1000 do
        local sub = scene:on("step", error)
        sub:cancel() sub:cancel()
      end
      old:cancel()
    end)
    scene:on("step", say "b")
    scene:probe("x", function() scene:result("x", order) return 0 end))");
  for (int i = 0; i < 100; i++) scene->step();
  std::string order;
  for (int i = 0; i < 100; i++) order += "ab";
  CHECK(text_of(*scene) == order);
  CHECK(lua::script_of(*scene).subscriptions.size() < 100);
}

TEST_CASE("what callbacks do is told in the next step") {
  const auto scene = open(R"(
    local p = scene:particle()
    scene:on("removed", function(thing) scene:result("x", thing == p) end)
    scene:on("step", function() if p.alive then p:remove() end end))");
  scene->step();
  CHECK(scene->results().empty());
  scene->step();
  CHECK(std::get<bool>(scene->results().at("x")));
}

TEST_CASE("scripted hands move, grab and let go") {
  CHECK(failure(R"(
    scene.gravity = vec(0, 0, 0)
    local p = scene:particle()
    local hand = scene:hand { path = function(t) return vec(t, 0, 0) end }
    hand:grab(p, { max_force = 100 })
    assert(scene.hands[1] == hand)
    scene:at(0.02, function() assert(hand.position.x > 0 and p.velocity.x > 0) hand:release() end))") == "");
  CHECK_THAT(failure("scene:hand { path = 3 }"), Contains("hand: path must be a function, got a number"));
  CHECK_THAT(failure("scene:hand():grab(3)"), Contains("grab: argument 1 must be a point or a particle"));
}

TEST_CASE("over, when and play run in their steps") {
  const auto scene = open(R"(
    scene.step = 0.25 scene.gravity = vec(0, 0, 0)
    local s = ""
    local function say(word) s = s .. word .. " " scene:result("x", s) end
    local p = scene:particle { velocity = vec(1, 0, 0) }
    scene:over(0.25, 0.75, p, function(u, target) assert(target == p) say(u) end)
    scene:when({ distance_above = 0.6, of = { p, vec(0, 0, 0) } }, p, function(target) say("far " .. scene.time) end)
    scene:when(function() return scene.time >= 0.5 end, function() say "late" end)
    scene:play(p, function(wait, target)
      say "begin" wait(0.5) say "half" wait(function() return target.position.x > 1 end) say "there" wait() say "end"
    end))");
  for (int i = 0; i < 10; i++) scene->step();
  CHECK(text_of(*scene) == "begin 0.0 0.5 late half 1.0 far 0.75 there end ");
}

TEST_CASE("conditions measure temperature, energy, load and number") {
  CHECK(failure(R"(
    scene.gravity = vec(0, -10, 0)
    local family, group = scene:family "f", scene:group "g"
    local p, q = scene:particle { at = vec(0, 1, 0), family = family }, scene:particle { velocity = vec(2, 0, 0), family = family }
    group:add(p, q)
    local rod = scene:rod(p, vec(0, 2, 0))
    local seen = {}
    local function see(name) return function() seen[name] = true end end
    scene:when({ temperature_above = 0.1, of = group }, see "hot")
    scene:when({ energy_below = 1e9 }, see "energy")
    scene:when({ force_above = 9.9, of = rod }, see "load")
    scene:when({ count_below = 2, of = family }, see "few")
    scene:when({ count_below = 1.5, of = group }, see "lonely")
    scene:at(0.02, function() q:remove() end)
    local gone = scene:when({ force_above = 1e9, of = rod }, error)
    scene:at(0.03, function() rod:remove() end)
    scene:at(0.035, function()
      for _, name in ipairs { "hot", "energy", "load", "few", "lonely" } do assert(seen[name], name) end
      assert(gone.state == "dropped" and scene.log[1].text:find "what it watches is gone")
    end))") == "");
}

TEST_CASE("a condition or a play that fails tells its line, and a play that never waits is stopped") {
  CHECK(failure("scene:when(function()\nlocal x = nil\nreturn x.y end, print)") ==
        "scene.lua:3: attempt to index a nil value (local 'x')");
  CHECK_THAT(failure("scene:when(function()\nscene:particle() return true end, print)"),
             Contains("scene.lua:2") && Contains("cannot be edited while it steps"));
  CHECK(failure("scene:play(function(wait)\nwait(0.01)\nerror {} end)") == "scene.lua:3: error: {}");
  CHECK_THAT(
      failure("scene:play(function(wait)\nwhile true do end end)"),
      Contains("scene.lua:2: the script did not come back within 0.2 s") && Contains("does this play ever wait?"));
  CHECK(failure("scene:play(function(wait)\nwait(-1) end)") ==
        "scene.lua:2: wait: argument 1 must be >= 0 s or a function, got -1");
  CHECK_THAT(failure("scene:play(function(wait)\ncoroutine.wrap(function() wait(1) end)() end)"),
             Contains("scene.lua:2: wait: it belongs to the play that was given it"));
}

TEST_CASE("wrong conditions and times are told") {
  CHECK_THAT(failure("scene:when({}, print)"),
             Contains("scene.lua:1: when: a condition needs one of temperature_above"));
  CHECK_THAT(failure("scene:when({ energy_above = 1, energy_below = 2 }, print)"), Contains("has one limit, got two"));
  CHECK_THAT(failure("scene:when({ count_above = 1 }, print)"), Contains("a count is of a group or a family"));
  CHECK_THAT(failure("scene:when({ heat_above = 1 }, print)"), Contains("heat_above"));
  CHECK_THAT(failure("scene:when(3, print)"), Contains("argument 1, the condition, must be a function or a table"));
  CHECK_THAT(failure("scene:when(print, print, { mean = 1 })"),
             Contains("mean and hysteresis are for what is measured"));
  CHECK_THAT(failure("scene:over(1, 1, print)"), Contains("over: argument 2, the end, must be after the beginning"));
  CHECK_THAT(failure("scene:at(0/0, print)"), Contains("at: argument 1, the time, must be a finite number"));
  CHECK_THAT(failure("scene:at(0.01, function()\nscene:at(0, print) end)"),
             Contains("scene.lua:2: at: argument 1, the time, must not be past: got 0 s"));
  CHECK_THAT(failure("local p = scene:particle() p:remove()\nscene:at(1, p, print)"),
             Contains("scene.lua:2") && Contains("was removed at 0 s by scene.lua:1"));
}

TEST_CASE("the timeline is told to scripts") {
  CHECK(failure(R"(
    local p = scene:particle { name = "p" }
    scene:at(0.01, p, function() end) scene:every(0.03, function() end) scene:over(1, 2, function() end)
    scene:when(function() return false end, function() end)
    scene:at(0.02, function()
      local t = scene.timeline
      assert(t[1].state == "fired" and t[1].target == "particle 'p'" and t[1].label == "scene.lua:3")
      local kinds = {}
      for _, e in ipairs(t) do kinds[e.kind] = e end
      assert(kinds.every.period == 0.03 and kinds.every.time == 0.03 and kinds.every.state == "waiting")
      assert(kinds.over.from == 1 and kinds.over.to == 2 and kinds.when.time == nil)
    end))") == "");
}

TEST_CASE("a condition or a wait that uses a removed thing is dropped and logged, and asked no more") {
  CHECK(failure(R"(
    local p, asked = scene:particle { name = "p" }, 0
    scene:at(0.01, function() p:remove() end)
    local when = scene:when(function() asked = asked + 1 return p.mass > 5 end, error)
    local waits = scene:play(function(wait) wait(function() return p.mass > 5 end) error "not reached" end)
    local goes = scene:play(function(wait) wait(0.02) p.mass = 3 error "not reached" end)
    scene:at(0.04, function()
      assert(asked == 3)
      for _, event in ipairs { when, waits, goes } do assert(event.state == "dropped", event.state) end
      assert(#scene.log == 3)
      for i, line in ipairs { 4, 5, 6 } do
        local told = "^event scene.lua:%d+: scene.lua:" .. line .. ": particle 'p' was removed at .* by scene.lua:3$"
        assert(scene.log[i].kind == "dropped" and scene.log[i].text:find(told), scene.log[i].text)
      end
    end))") == "");
}
