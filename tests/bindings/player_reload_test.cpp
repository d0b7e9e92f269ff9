// Saving a scene's file while it is played.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "bindings/lua_support.hpp"
#include "choreography/hands.hpp"
#include "edit/edit.hpp"
#include "measure/query.hpp"
#include "player/reload.hpp"
#include "support/process.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;
using Catch::StartsWith;
using player::FileWatch;
using player::Reload;
using player::Reloaded;

namespace {

/// A scene in a folder, played and saved again.
struct Played {
  explicit Played(const std::string& text, std::map<std::string, std::string> set = {})
      : options(lua_tests::options(std::move(set))) {
    save(text);
    scene = reload.open(file, options);
  }
  void save(const std::string& text, const std::string& name = "scene.lua") {
    write_file(folder / name, text);
    // Two texts of one length may be written within the clock's tick.
    std::filesystem::last_write_time(folder / name, std::filesystem::file_time_type::clock::now() + ++saved * second);
  }
  void steps(int count) {
    for (int i = 0; i < count; i++) scene->step();
    REQUIRE(scene->world().failure == "");
  }
  void press(const std::string& button) {
    Command command;
    command.kind = Command::Kind::button;
    command.name = button;
    scene->world().input.commands.push_back(command);
    steps(1);
  }
  /// Time passes until the change is seen; the new scene takes over where there is one.
  Reloaded look() {
    for (int i = 0; i < 5; i++) {
      now += std::chrono::milliseconds(60);
      if (auto found = reload.look(*scene, file, options, now)) {
        if (found->scene) scene = std::move(found->scene);
        return std::move(*found);
      }
    }
    return {nullptr, {}, "nothing was seen"};
  }
  void save_and_look(const std::string& text) {
    save(text);
    REQUIRE(look().error == "");
  }
  BodyId body(const std::string& name) const { return std::get<BodyId>(find(scene->world(), name)); }
  Vec3 place(const std::string& name) const { return scene->world().motion_of(body(name)).x; }
  double probe() const { return scene->world().probes.at(0).latest; }

  static constexpr std::chrono::seconds second{1};
  Folder folder;
  std::string file = folder / "scene.lua";
  SceneOptions options;
  Reload reload;
  std::unique_ptr<Scene> scene;
  FileWatch::Clock::time_point now{};
  int saved = 0;
};

const std::string chain = R"(
  local links = {}
  for i = 1, 6 do
    links[i] = scene:body{ name = "link" .. i, mass = 1, inertia = vec(0.0017, 0.0842, 0.0842), at = vec(i - 0.5, 4, 0),
      points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    if i > 1 then scene:hinge(links[i - 1].tail, links[i].head) else scene:nail(links[i].head) end
  end
)";

}  // namespace

TEST_CASE("reload: things go on where they were, and time goes on") {
  Played played(chain), other(chain);
  played.steps(200);
  other.steps(200);
  played.save_and_look(chain + "scene.title = 'new'");
  CHECK(played.scene->title() == "new");
  CHECK(played.scene->world().time == 200.0 / 240);
  for (const char* name : {"link1", "link6"}) {
    CHECK(norm(played.place(name) - other.place(name)) < 1e-15);
    CHECK(norm(played.scene->world().motion_of(played.body(name)).p -
               other.scene->world().motion_of(other.body(name)).p) < 1e-14);
  }
  played.steps(120);
  other.steps(120);
  CHECK(norm(played.place("link6") - other.place("link6")) < 1e-6);
  CHECK(played.scene->world().error.hinge_gap < 1e-9);
  CHECK(played.scene->world().stats.fallback_steps == 0);
}

TEST_CASE("reload: nothing is reloaded before a file is saved, and what is being written is left alone") {
  Played played(chain);
  CHECK(played.look().error == "nothing was seen");
  write_file(played.file, "");
  played.now += std::chrono::milliseconds(60);
  CHECK_FALSE(played.reload.look(*played.scene, played.file, played.options, played.now));
  played.save(chain);
  CHECK(played.look().error == "");
  CHECK(played.scene->world().bodies.size() == 6);
  CHECK(played.look().error == "nothing was seen");
}

TEST_CASE("reload: an editor may write another file and give it the name") {
  Played played(chain);
  write_file(played.folder / "new", "scene.title = 'renamed'");
  std::filesystem::rename(played.folder / "new", played.file);
  CHECK(played.look().error == "");
  CHECK(played.scene->title() == "renamed");
}

TEST_CASE("reload: a handler is called once in each step, however often the file is saved") {
  const std::string text = R"(
    local calls, behaved = 0, 0
    scene:on("step", function() calls = calls + 1 end)
    scene:behave(scene, { step = function() behaved = behaved + 1 end })
    scene:every(0.1, function() scene.store.fired = (scene.store.fired or 0) + 1 end)
    scene.store.steps = scene.store.steps or 0
    scene:on("step", function() scene.store.steps = scene.store.steps + 1 end)
    scene:probe("all", function() return 10000 * calls + 100 * behaved + scene.store.fired end)
    scene:probe("steps", function() return scene.store.steps end)
  )";
  Played played(text + "scene.store.fired = 0");
  for (int i = 0; i < 3; i++) {
    played.steps(24);
    played.save_and_look(text + "scene.store.fired = 0");
  }
  played.steps(24);
  CHECK(played.probe() == 24 * 10000 + 24 * 100 + 3);
  CHECK(played.scene->world().probes[1].latest == 4 * 24);
  CHECK(played.scene->world().choreography.events.size() == 1);
}

TEST_CASE("reload: things keep their data, and the scene its store, as far as they are plain") {
  const std::string text = R"(
    local a = scene:particle{ name = "a" }
    local b = scene:particle{}
    local tie = scene:connect(a, b, force.spring{ stiffness = 0, length = 7 })
    a.data.hits, a.data.f = 0, function() return 7 end
    scene.store.list = { 0 }
    scene:button("hit", function()
      a.data.hits, a.data.mate, b.data.deep = 3, b, { { vec(1, 2, 3) } }
      scene.store.list[2], scene.store.who, scene.store.g = 5, a, print
      a.data.tie, scene.store.stats = tie.parameters, scene.stats
    end)
    scene:probe("all", function()
      assert(a.data.f() == 7)
      if a.data.hits == 0 then return 0 end
      assert(a.data.mate == b and b.data.deep[1][1] == vec(1, 2, 3) and scene.store.who == a)
      assert(a.data.tie.length == 7 and scene.store.stats.fallback_steps == 0)
      return a.data.hits + 10 * scene.store.list[2] + (scene.store.g and 100 or 0)
    end))";
  Played played(text);
  played.press("hit");
  CHECK(played.probe() == 153);
  played.save_and_look(text);
  played.steps(1);
  CHECK(played.probe() == 53);
}

TEST_CASE("reload: tables come along however deep, and one that is in two places is one") {
  const std::string text = R"(
    local a = scene:particle{ name = "a" }
    scene:button("hit", function()
      local list = {}
      scene.store.list, scene.store.of_a, a.data.list = list, a.data, list
      for i = 1, 20000 do
        list.next = { value = i }
        list = list.next
      end
      list.next = scene.store.list
    end)
    scene:probe("all", function()
      if not scene.store.list then return 0 end
      local list, sum = scene.store.list, 0
      repeat
        sum, list = sum + (list.value or 0), list.next
      until list == scene.store.list
      return scene.store.of_a == a.data and a.data.list == list and sum or -1
    end))";
  Played played(text);
  played.press("hit");
  CHECK(played.probe() == 20000 * 20001 / 2);
  played.save_and_look(text);
  played.steps(1);
  CHECK(played.probe() == 20000 * 20001 / 2);
}

TEST_CASE("reload: a file that is required while the scene plays is watched, too") {
  Played played("scene.title = 'a'");
  played.save("return 'one'", "late.lua");
  played.save_and_look("scene:at(0.1, function() scene.title = require('late') end)");
  played.steps(60);
  CHECK(played.scene->title() == "one");
  played.save("return 'two'", "late.lua");
  CHECK(played.look().error == "");
}

TEST_CASE("reload: what is past does not happen again, what is to come does") {
  const std::string text = R"(
    local count = function(name) return function() scene.store[name] = (scene.store[name] or 0) + 1 end end
    scene:at(0.5, count "at")
    scene:at(1, count "now")  -- when the file is saved
    scene:at(2, count "late")
    scene:every(0.25, count "every")
    scene:when(function() return scene.time > 0.3 end, count "when")
    scene:over(0, 1.5, count "over")
    scene:play(function(wait) count "play" () wait(0.5) count "waited" () end)
    scene:probe("all", function() return scene.time end)
  )";
  const auto stored = [&](Played& played, const char* name) {
    played.save_and_look(text + "scene:probe('x', function() return scene.store." + name + " or 0 end)");
    played.steps(1);
    return played.scene->world().probes[1].latest;
  };
  Played played(text);
  played.steps(240);
  played.save_and_look(text);
  played.steps(1);
  played.steps(360);
  CHECK(stored(played, "at") == 1);
  CHECK(stored(played, "now") == 1);
  CHECK(stored(played, "late") == 1);
  CHECK(stored(played, "when") == 1);
  CHECK(stored(played, "every") == 10);
  CHECK(stored(played, "over") == 361);
  CHECK(stored(played, "waited") == 2);
  CHECK(stored(played, "play") == 10);
}

TEST_CASE("reload: what was cut or removed stays so; what is new appears, what the file no longer has goes") {
  Played played(chain);
  played.steps(10);
  World& world = played.scene->world();
  const std::vector<ParticleId> hinges = [&] {
    std::vector<ParticleId> list;
    for (ParticleId id : world.particles.ids())
      if (world.particles[id].is_hinge()) list.push_back(id);
    return list;
  }();
  REQUIRE(hinges.size() == 5);
  cut(world, hinges[2]);
  remove(world, played.body("link6"));
  played.steps(10);
  played.save_and_look(chain + "scene:particle{ name = 'ball' }");
  const auto count = [&] {
    std::size_t n = 0;
    for (ParticleId id : played.scene->world().particles.ids())
      if (played.scene->world().particles[id].is_hinge()) n++;
    return n;
  };
  CHECK(played.scene->world().bodies.size() == 5);
  CHECK(count() == 3);
  CHECK(played.scene->world().notices.empty());
  played.steps(10);
  played.save_and_look(chain);
  CHECK(std::holds_alternative<std::monostate>(find(played.scene->world(), "ball")));
  CHECK(count() == 3);
}

TEST_CASE("reload: where some came, those without names go on that look alike, and the rest in their order") {
  const auto text = [](int boxes, double size) {
    return "for i = 1, " + std::to_string(boxes) + " do scene:box { size = " + std::to_string(size) +
           ", at = vec(3 * i, 5, 0), velocity = vec(0, 0, i) } end\nscene:ball { radius = 0.3, at = vec(0, 5, 0) }";
  };
  Played played(text(3, 1.0));
  played.steps(60);
  const auto place = [&](std::size_t i) {
    return played.scene->world().motion_of(played.scene->world().bodies.ids()[i]).x;
  };
  const Vec3 third = place(2), ball = place(3);
  played.save_and_look(text(5, 1.0));
  CHECK(norm(place(2) - third) < 1e-12);
  CHECK(norm(place(3) - vec(12, 5, 0)) < 1e-12);
  CHECK(norm(place(5) - ball) < 1e-12);
  played.save_and_look(text(4, 1.5));
  CHECK(norm(place(2) - third) < 1e-12);
  CHECK(norm(place(4) - ball) < 1e-12);
}

TEST_CASE("reload: an error names its line, and the old scene goes on until the file is right again") {
  Played played(chain);
  played.steps(10);
  played.save(chain + "\nlocal x = nothing.here");
  const Reloaded failed = played.look();
  CHECK_THAT(failed.error, StartsWith("scene.lua:"));
  CHECK(failed.scene == nullptr);
  played.steps(10);
  CHECK(played.scene->world().steps == 20);
  played.save_and_look(chain);
  CHECK(played.scene->world().time == 20.0 / 240);
}

TEST_CASE("reload: a file that the scene requires counts as the scene, even one that failed") {
  Played played("scene:param('n', 1)");
  played.save("scene.title = require('name')");
  CHECK_THAT(played.look().error, Contains("there is no 'name'"));
  played.save("return nothing.here", "name.lua");
  played.save("scene.title = require('name')");
  CHECK_THAT(played.look().error, StartsWith("name.lua:1: "));
  played.save("return 'one'", "name.lua");
  CHECK(played.look().error == "");
  CHECK(played.scene->title() == "one");
  played.save("return 'two'", "name.lua");
  CHECK(played.look().error == "");
  CHECK(played.scene->title() == "two");
}

TEST_CASE("reload: a hand keeps its grab where the point still exists") {
  const std::string text = chain + "scene:hand{ path = function(t) return vec(t, 0, 0) end }";
  Played played(text), other(text);
  const auto drag = [](Played& p, std::int32_t hand, int steps) {
    for (int i = 0; i < steps; i++) {
      p.scene->world().input.moves = {{hand, vec(3, 2, 1), true}};
      p.steps(1);
    }
  };
  for (Played* p : {&played, &other}) {
    drag(*p, 1, 1);
    World& world = p->scene->world();
    grab(world, 1, world.bodies[p->body("link4")].points[1]);
    drag(*p, 1, 240);
  }
  played.save(chain + "scene:hand{} scene:hand{ path = function(t) return vec(t, 0, 0) end }");
  const Reloaded reloaded = played.look();
  REQUIRE(reloaded.error == "");
  CHECK(reloaded.carried.hands.at(1) == 2);
  World& world = played.scene->world();
  REQUIRE(world.hands.size() == 3);
  CHECK(world.hands[2].pressed);
  REQUIRE(world.constraints.alive(world.hands[2].grab));
  CHECK(world.constraints[world.hands[2].grab].a == world.bodies[played.body("link4")].points[1]);
  const StepInput moved = player::carried_over({{{1, vec(3, 2, 1), true}}, {}}, reloaded.carried);
  CHECK(moved.moves.at(0).hand == 2);
  drag(played, 2, 60);
  drag(other, 1, 60);
  CHECK(norm(played.place("link4") - other.place("link4")) < 1e-3);
  played.save_and_look("scene:particle{}");
  CHECK_FALSE(played.scene->world().hands.back().grab);
}

TEST_CASE("reload: parameters that a person gave stay, and one that went is no error") {
  Played played("local n = scene:param('n', 3) scene:probe('n', function() return n end)", {{"n", "5"}});
  played.steps(1);
  CHECK(played.probe() == 5);
  played.save_and_look("local n = scene:param('n', 4) scene:probe('n', function() return n end) -- changed");
  played.steps(1);
  CHECK(played.probe() == 5);
  played.save_and_look("scene:probe('n', function() return 1 end)");
  played.save_and_look("local n = scene:param('n', 4, { max = 4.5 }) scene:probe('n', function() return n end)");
  played.steps(1);
  CHECK(played.probe() == 4);
}

TEST_CASE("reload: ages, targets and emitters go on") {
  const std::string text = R"(
    local p = scene:particle{ lifetime = 1 }
    local driven = scene:particle{ at = vec(5, 0, 0) }
    scene:follow(driven, function(t) return vec(5 + t, 0, 0) end)
    scene:emitter{ at = vec(0, 9, 0), rate = 100 }
    scene:probe("n", function() return #scene.particles end)
    scene:probe("speed", function() return driven.velocity.x end)
  )";
  Played played(text);
  played.steps(192);
  played.save_and_look(text);
  played.steps(24);
  CHECK(played.probe() == 2 + 10);
  CHECK(played.scene->world().probes[1].latest == Approx(1.0).margin(1e-9));
  played.steps(48);
  CHECK(played.probe() == 1 + 30);
}

TEST_CASE("reload: things come into another plane, and to other heights") {
  const auto text = [](const char* plane, double height) {
    return std::string(plane) + " scene.gravity = vec(0, 0, 0) local z = " + std::to_string(height) + R"(
      scene:body{ name = "b", at = vec(1, 2, z), velocity = vec(1, 0, 0), mass = 1, inertia = vec(1, 2, 3) }
      scene:particle{ name = "p", at = vec(0, 0, z), velocity = vec(0, 1, 0) }
    )";
  };
  Played played(text("scene.plane = 'xy'", 0.0));
  played.steps(240);
  played.save_and_look(text("scene.plane = 'xy'", 0.5));
  CHECK(norm(played.place("b") - vec(2, 2, 0.5)) < 1e-12);
  played.save_and_look(text("", 0.0));
  const BodyId body = played.body("b");
  set_orientation(played.scene->world(), body, Quat{0.8, 0.6, 0.0, 0.0});
  set_spin(played.scene->world(), body, vec(1, 0, 2));
  set_velocity(played.scene->world(), body, vec(1, 0, 1));
  played.save_and_look(text("scene.plane = 'xy'", 0.0));
  CHECK(norm(played.scene->world().motion_of(played.body("b")).p - vec(1, 0, 0)) < 1e-12);
  played.steps(10);
}

TEST_CASE("reload: reset goes back to the start, not to the moment of saving") {
  const std::string text = R"(
    local p = scene:particle{ at = vec(0, 3, 0) }
    scene:on("key", function() scene:reset() end)
    scene:probe("y", function() return p.position.y end))";
  Played played(text);
  played.steps(60);
  const double later = played.probe();
  played.save_and_look(text);
  played.steps(30);
  Command key;
  key.name = "k";
  played.scene->world().input.commands.push_back(key);
  played.steps(1);
  CHECK(played.scene->world().time == 0.0);
  played.steps(60);
  CHECK(played.probe() == later);
}

TEST_CASE("reload: what touches is not told again, layers are those of the file, and ground that went stays away") {
  const auto text = [](const std::string& rule) {
    return R"(
    scene:floor { name = "floor", layer = "floor" }
    local slab = scene:ground { shape = shape.box(1, 1, 1), at = vec(9, 0, 0) }
    local box = scene:box { size = 1, at = vec(0, 0.5, 0), layer = "box", name = "box" }
    scene:on("touched", function() end)
    scene:at(0.01, slab, function() slab:remove() end)
    )" + rule;
  };
  Played played(text(""));
  const auto told_in = [&](int steps) {
    std::size_t told = 0;
    for (int i = 0; i < steps; i++) {
      played.steps(1);
      for (const Notice& n : played.scene->world().notices) told += n.kind == Notice::Kind::touched ? 1 : 0;
    }
    return told;
  };
  CHECK(told_in(20) == 1);
  played.save_and_look(text("-- the same"));
  CHECK(told_in(20) == 0);
  CHECK(played.scene->world().shapes.size() == 2);
  played.save_and_look(text("scene:collide('box', 'floor', false)"));
  CHECK(told_in(60) == 0);
  CHECK(played.place("box")[1] < 0.4);
}

TEST_CASE(
    "reload: bodies go on where they were, with the shapes and the masses of the new file; what shattered stays gone") {
  const auto text = [](const std::string& options) {
    return R"(
    scene:floor {}
    scene:box { size = 1, at = vec(0, 0.5, 0), velocity = vec(2, 0, 0), name = "box" })" +
           options + R"(
    local plate = scene:box { size = vec(1, 0.1, 1), at = vec(9, 5, 0), name = "plate" }
    scene:at(0.05, plate, function() scene:shatter(plate, { pieces = 5 }) end)
    )";
  };
  Played played(text(""));
  played.steps(20);
  CHECK(played.scene->world().bodies.size() == 6);
  const Vec3 before = played.place("box");
  CHECK(before[0] > 0.1);
  played.save_and_look(text(R"(scene:find("box"):remove()
    scene:capsule { radius = 0.5, length = 1, at = vec(0, 0.5, 0), name = "box", density = 10 })"));
  World& world = played.scene->world();
  CHECK(norm(played.place("box") - before) < 1e-12);
  REQUIRE(world.bodies.size() == 1);
  const Body& box = world.bodies[world.bodies.ids()[0]];
  CHECK(std::holds_alternative<CapsuleShape>(world.shapes[box.shapes[0]].geometry));
  CHECK(world.motion_of(world.bodies.ids()[0]).mass == Approx(10 * M_PI * (0.25 + 4.0 / 3.0 * 0.125)));
  played.steps(240);
  CHECK(std::fabs(played.place("box")[1]) < 2.0);
}

TEST_CASE("reload: what the new file wants elsewhere is drawn there from where it is") {
  const std::string head = R"(
    local a = scene:box { size = 0.3, at = vec(0, 3, 0), name = "box", points = { top = vec(0, 0.15, 0) } }
    local b = scene:box { size = 0.3, at = vec(2, 3, 0), points = { top = vec(0, 0.15, 0) } }
    local peg = scene:particle { at = vec(0, 4.15, 0) }
    scene:nail(peg)
    )",
                    pulley = "scene:pulley(a.top, vec(0, 5, 0), vec(2, 5, 0), b.top, { length = ";
  struct Case {
    std::string before, after;
    double height;  // [m] that it comes to
  };
  for (const Case& c : {Case{"scene:nail(a.top)", "scene:nail(a.top, vec(0, 4, 0))", 3.85},
                        Case{"scene:string({ a.top, peg })", "scene:string({ a.top, peg }, { length = 0.5 })", 3.5},
                        Case{pulley + "3.7 })", pulley + "3 })", 3.35}, Case{pulley + "3.7 })", pulley + "4 })", 2.85},
                        Case{"scene:nail(a.top) scene:align(a, vec(1, 0, 0), nil, vec(1, 0, 0), { angle = 0 })",
                             "scene:nail(a.top) scene:align(a, vec(1, 0, 0), nil, vec(1, 0, 0), { angle = 1 })",
                             3.15 - 0.15 * std::cos(1.0)}}) {
    INFO(c.after);
    Played played(head + c.before);
    played.steps(60);
    played.save_and_look(head + c.after);
    played.steps(1);
    CHECK(norm(played.place("box") - vec(0, 3, 0)) < 1e-3);
    played.steps(480);
    CHECK(played.place("box")[1] == Approx(c.height).margin(1e-3));
    CHECK(played.scene->world().stats.fallback_steps == 0);
  }
}

TEST_CASE("reload: a motor that is told its speed goes on at it") {
  const std::string text = R"(
    scene.gravity = vec(0, 0, 0)
    local wheel = scene:cylinder { radius = 0.5, length = 0.1, axis = vec(0, 0, 1), name = "wheel", points = { hub = vec(0, 0, 0) } }
    scene:nail(wheel.hub)
    scene:align(wheel, vec(0, 0, 1), vec(0, 0, 1), { angle = 0 })
    scene:motor(wheel, { axis = vec(0, 0, 1), speed = 3 }))";
  Played played(text), other(text);
  for (Played* one : {&played, &other}) one->steps(100);
  played.save_and_look(text + " scene.title = 'new'");
  for (Played* one : {&played, &other}) one->steps(100);
  CHECK(state_hash(played.scene->world()) == state_hash(other.scene->world()));
}

TEST_CASE("reload: a picture that has changed is taken over, one that is none leaves all as it is") {
  const auto picture_of = [](const std::string& name) {
    return read_file(sources::folder() + "/assets/pictures/" + name);
  };
  Played played("");
  played.save(picture_of("crate.png"), "mine.png");
  played.save_and_look("scene:box { name = 'box', size = 1, picture = 'mine.png' }");
  const auto shown = [&] {
    const World& world = played.scene->world();
    return world.shapes[world.bodies[played.body("box")].shapes[0]].cover->picture->content;
  };
  played.steps(20);
  const Vec3 at = played.place("box");
  CHECK(shown() == picture_of("crate.png"));
  played.save("half of a picture", "mine.png");
  CHECK_THAT(played.look().error, Contains("'mine.png' is neither a PNG nor a JPEG"));
  CHECK(shown() == picture_of("crate.png"));
  played.save(picture_of("bricks.png"), "mine.png");
  CHECK(played.look().error == "");
  CHECK(shown() == picture_of("bricks.png"));
  CHECK(same(played.place("box"), at));
}
