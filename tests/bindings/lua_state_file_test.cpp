// States of scenes in files: a scene that is opened from one goes on to the bits of the one that went on.
#include <algorithm>
#include <filesystem>

#include "bindings/lua_support.hpp"
#include "choreography/hands.hpp"
#include "fields/property.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "scene/errors.hpp"
#include "snapshot/snapshot.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

namespace {

void step_on(Scene& scene, int count) {
  for (int i = 0; i < count; i++) scene.step();
  REQUIRE(scene.world().failure == "");
}

SceneOptions roomy(int threads = 1) {
  SceneOptions o = options();
  o.script_limit = 0.0;
  o.memory_limit = std::size_t{1} << 30;
  o.threads = threads;
  return o;
}

std::vector<std::string> shipped_files() {
  std::vector<std::string> paths;
  for (const auto& file : std::filesystem::directory_iterator(sources::folder() + "/scripts/scenes"))
    if (file.path().extension() == ".lua") paths.push_back(file.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::unique_ptr<Scene> reopened(Scene& scene, int threads = 1) {
  return lua::open_state(scene.state(), "state.pantin", roomy(threads));
}

/// Runs a scene for `count` steps, opens its state anew, and runs both on for as many: all hashes are the same.
void check_goes_on(Scene& scene, int count, int threads = 1) {
  step_on(scene, count);
  const auto other = reopened(scene, threads);
  REQUIRE(state_hash(other->world()) == state_hash(scene.world()));
  for (int i = 0; i < count; i++) {
    scene.step();
    other->step();
    INFO("step " << i);
    REQUIRE(state_hash(other->world()) == state_hash(scene.world()));
  }
}

/// What a scene says, some time after it was saved in a step of its life, and of its other.
void check_says_the_same(const std::string& source, int before = 20, int after = 100) {
  const auto scene = open(source);
  step_on(*scene, before);
  const auto other = reopened(*scene);
  step_on(*scene, after);
  step_on(*other, after);
  CHECK(other->results() == scene->results());
  CHECK(state_hash(other->world()) == state_hash(scene->world()));
  CHECK(scene->results().contains("x"));
}

void press(Scene& scene, const std::string& button) {
  Command command;
  command.kind = Command::Kind::button;
  command.name = button;
  scene.world().input.commands.push_back(command);
}

}  // namespace

TEST_CASE("state_file: every scene that ships goes on to the same bits, whatever the threads") {
  for (const std::string& path : shipped_files()) {
    CAPTURE(path);
    check_goes_on(*lua::open_scene(path, roomy()), 20, 2);
  }
}

TEST_CASE("state_file: every scene that ships goes on to the same bits, for a second", "[slow][shipped]") {
  for (const std::string& path : shipped_files()) {
    CAPTURE(path);
    const auto scene = lua::open_scene(path, roomy(2));
    check_goes_on(*scene, static_cast<int>(1.0 / scene->world().settings.step));
  }
}

TEST_CASE("state_file: a point on a path in wind goes on, whose kick asks for the path before its step begins") {
  check_goes_on(*open(R"(
    local rod = scene:body { mass = 1000, inertia = vec(0.01, 0.1, 0.1), points = { tip = vec(0.5, 0, 0) } }
    scene:field(scene, force.wind { velocity = vec(-0.5, 4, 0.2), linear = 0.3, quadratic = 0.1 })
    scene:on_path(rod.tip, { rod.tip.position, vec(-6, 1, -2), vec(-9, -1, -3) }, { smooth = true })
  )"),
                20);
}

TEST_CASE("state_file: counters in locals, shared by functions and changed in mid-run, go on") {
  check_says_the_same(R"(
    local count, list, name = 0, { 1, deep = { at = vec(1, 2, 3) } }, "a"
    local function up() count = count + 1 return count end
    local function told() return count * 10 + #list end
    other = { up = up, self = nil }
    other.self = other
    scene:every(0.02, function()
      up() list[#list + 1] = count
      name = name .. count % 10
      list.deep.at = list.deep.at * 1.5
    end)
    scene:on("step", function() scene:result("x", told() + list.deep.at.x + #name + (other.self == other and 1 or 0)) end))");
}

TEST_CASE("state_file: what hangs from a place by a law goes on") {
  check_goes_on(*open(R"(
    local p = scene:particle { at = vec(0, 1, 0), mass = 1 }
    scene:connect(p, vec(0, 0, 0), force.spring { stiffness = 1, length = 2 })
  )"),
                20);
}

TEST_CASE("state_file: what a script holds of parameters, stats, ledger and keys goes on") {
  check_says_the_same(R"(
    local p = scene:particle { at = vec(0, 1, 0), mass = 1 }
    local own = scene:connect(p, vec(0, 0, 0), force.spring { stiffness = 1, length = 1 }).parameters
    local stats, ledger, keys = scene.stats, scene.ledger, scene.keys
    scene.store.own, scene.store.stats = own, stats
    scene:on("step", function()
      own.stiffness = own.stiffness + 1
      scene:result("x", scene.store.own.stiffness + #tostring(stats.articulates) + ledger.fallback_step)
      scene:result("same", scene.store.own == own and not keys.j and next(scene.store.own) == "length")
    end))");
}

TEST_CASE("state_file: functions that were made while the scene ran go on with their own locals") {
  check_says_the_same(R"(
    local sum = 0
    scene:every(0.05, function()
      local own = sum + 1
      scene:after(0.12, function() own = own * 2 sum = sum + own scene:result("x", sum) end)
    end))");
}

TEST_CASE(
    "state_file: what the world holds of the script goes on: targets, rates, lengths, joins, whens, probes, laws") {
  check_says_the_same(R"(
    local speed, met, often = 2, 0, 0
    local a = scene:particle { at = vec(0, 0, 0), name = "a" }
    local b = scene:particle { at = vec(1, 0, 0) }
    local c = scene:particle { at = vec(2, 0, 0) }
    local d = scene:particle { at = vec(2.5, 0, 0) }
    scene:follow(a, function(t) return vec(speed * t, 0, 0) end)
    scene:rod(b, vec(1, 1, 0), function(t) return 1 + 0.1 * math.sin(speed * t) end)
    scene:join(c, d, { on_met = function() met = met + 1 end })
    local family = scene:family("dust", { attributes = { charge = 1 } })
    scene:emitter { at = vec(0, 3, 0), rate = function(t) return 50 + speed end, family = family, lifetime = 0.3 }
    scene:when(function() return a.position.x > 0.5 end, function() speed = 3 end)
    scene:when({ distance_above = 1.2, of = { a, b } }, function() often = often + 1 end, { again = true })
    scene:probe("x", function() return speed + met end)
    scene:field(scene, force.point { force = function(p) return p.position * -speed end })
    scene:connect(a, b, force.pair { tension = function(r) return 5 * (r - 1) end })
    scene:hand { path = function(t) return vec(t, speed, 0) end }
    scene:on("step", function()
      scene:result("x", speed + met * 10 + often * 100 + #scene.particles * 1000)
      if speed == 3 then speed = 4 end
    end))",
                      40, 200);
}

TEST_CASE("state_file: behaviours, stores, data, parameters, buttons and the order of making go on") {
  const auto scene = open(R"(
    local p = scene:particle { name = "p" }
    local gain = scene:param("gain", 2, { on_change = function(v) gain_now = v end })
    gain_now = gain
    p.data.hits, scene.store.list = 1, { 1, p, { p } }
    scene:behave(p, { step = function(self) self.n = (self.n or 0) + gain_now self.target.data.hits = self.n end })
    scene:button("tell", function()
      assert(scene.store.list[2] == p and scene.store.list[3][1] == p and scene:find("p") == p)
      scene:result("x", p.data.hits)
      scene:particle { at = vec(p.data.hits, 0, 0) }
    end))",
                          {{"gain", "3"}});
  step_on(*scene, 10);
  const auto other = reopened(*scene);
  CHECK(std::get<double>(other->parameters().at(0).value) == 3.0);
  for (Scene* one : {scene.get(), other.get()}) {
    one->set_parameter("gain", SceneValue(5.0));
    press(*one, "tell");
    step_on(*one, 5);
  }
  CHECK(std::get<double>(other->results().at("x")) == 30.0);
  CHECK(other->results() == scene->results());
  CHECK(state_hash(other->world()) == state_hash(scene->world()));
}

TEST_CASE("state_file: what a person holds goes on being held, and a state of a state is one") {
  const auto scene = open("box = scene:box { size = 1, at = vec(0, 2, 0) } scene:floor {}");
  const std::int32_t hand = add_hand(scene->world());
  Command grab;
  grab.kind = Command::Kind::grab;
  grab.hand = hand;
  grab.position = vec(0, 2, 0);
  scene->world().input.moves.push_back({hand, vec(0, 2, 0), true});
  scene->world().input.commands.push_back(grab);
  step_on(*scene, 10);
  auto other = reopened(*scene);
  for (int i = 0; i < 5; i++) {
    other = reopened(*other);
    for (Scene* one : {scene.get(), other.get()}) {
      one->world().input.moves.push_back({hand, vec(0.1 * i, 2, 0), true});
      step_on(*one, 7);
    }
    CHECK(state_hash(other->world()) == state_hash(scene->world()));
  }
}

TEST_CASE("state_file: a scene that went on from a changed file and was edited goes on") {
  const std::string source = R"(
    local n = 0
    scene:floor {}
    local box = scene:box { size = 1, at = vec(0, 2, 0), name = "box" }
    box.data.hits = 3
    scene:rod(scene:particle { at = vec(1, 1, 0) }, vec(0, 4, 0))
    scene:every(0.05, function() n = n + 1 scene:result("x", n + box.data.hits) end))";
  SceneOptions o = options();
  o.changing = true;
  const auto old = lua::open_scene_text(source, "scene.lua", "", o);
  step_on(*old, 30);
  const auto scene = lua::open_scene_text("scene.gravity = vec(0, -5, 0)\n" + source, "scene.lua", "", o);
  scene->go_on_from(*old);
  step_on(*scene, 20);
  World& world = scene->world();
  fields::write(world, world.bodies.ids()[0], "velocity", vec(1, 2, 0));
  const auto other = reopened(*scene);
  step_on(*scene, 100);
  step_on(*other, 100);
  CHECK(other->results() == scene->results());
  CHECK(state_hash(other->world()) == state_hash(scene->world()));
}

TEST_CASE("state_file: scene:save hands over the state after the step, and the script goes on") {
  std::map<std::string, std::string> saved;
  SceneOptions o = options();
  o.save = [&](const std::string& name, const std::string& state) { saved[name] = state; };
  const auto scene = lua::open_scene_text(R"(
    local saves = 0
    scene:at(0.1, function() saves = saves + 1 scene:save("here.pantin") end)
    scene:on("step", function() scene:result("x", saves) end)
    scene:particle {})",
                                          "scene.lua", "", o);
  step_on(*scene, 60);
  REQUIRE(saved.contains("here.pantin"));
  const auto other = lua::open_state(saved["here.pantin"], "here.pantin", options());
  CHECK(other->world().time == Approx(0.1).margin(0.01));
  CHECK(other->file() == "scene.lua");
  while (other->world().steps < scene->world().steps) other->step();
  CHECK(other->results() == scene->results());
  CHECK(state_hash(other->world()) == state_hash(scene->world()));
  CHECK(failure("scene:save('a.pantin')") == "scene.lua:1: save: files are not written here");
}

TEST_CASE("state_file: a scene that waits in a play is run again when it is opened, and says the same") {
  check_says_the_same(R"(
    local ball, heard = scene:particle {}, 0
    scene:play(function(wait)
      for i = 1, 30 do wait(0.03) heard = heard + i ball:kick(vec(0, 1, 0)) scene:result("x", heard) end
    end))",
                      50, 100);
}

TEST_CASE("state_file: what no file can keep is told with its line") {
  const auto why = [](const std::string& source) {
    SceneOptions o = options();
    o.changing = true;  // in a window
    const auto scene = lua::open_scene_text(source, "scene.lua", "", o);
    scene->step();
    try {
      (void)scene->state();
    } catch (const Error& error) { return std::string(error.what()); }
    return std::string();
  };
  CHECK(why("scene:play(function(wait) wait(1) end)") ==
        "save: the scene's script waits (scene.lua:1), which only a scene that is run without a window can be saved "
        "with");
  CHECK(why("local co = coroutine.create(print)\nscene:on('step', function() return co end)") ==
        "save: 'co' in the function at scene.lua:2 is a thread, which cannot be kept in a file");
  CHECK_THAT(why("kept = { here = scene:snapshot() }"),
             Contains("the global.kept.here is a snapshot, which cannot be kept in a file"));
}

TEST_CASE("state_file: a file that is cut off, altered, foreign or of another version is refused") {
  const auto scene = open(R"(
    local n = 0
    scene:box { size = 1, at = vec(0, 2, 0) }
    scene:floor {}
    scene:on("step", function() n = n + 1 end))");
  step_on(*scene, 100);
  const std::string state = scene->state();
  const auto why = [](const std::string& bytes) {
    try {
      lua::open_state(bytes, "s.pantin", options());
    } catch (const UsageError& error) { return std::string(error.what()); }
    return std::string("it was read");
  };
  CHECK(why(state) == "it was read");
  CHECK(why("") == "s.pantin: this is no state that Pantin saved");
  CHECK(why("scene:particle {}") == "s.pantin: this is no state that Pantin saved");
  CHECK(why(state + " ") == "s.pantin: the state is damaged: its checksum is wrong");
  for (std::size_t size = 1; size < state.size(); size += 1 + state.size() / 200)
    CHECK(why(state.substr(0, size)) == "s.pantin: the state is cut off");
  for (std::size_t at = 0; at < state.size(); at += at < 64 ? 1 : 1 + state.size() / 500) {
    std::string other = state;
    other[at] = static_cast<char>(other[at] ^ (1 << (at % 8)));
    CHECK_THAT(why(other), Contains("s.pantin: "));
  }
}
