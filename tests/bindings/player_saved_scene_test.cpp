// What was built by hand, saved as a scene and opened again.
#include "player/saved_scene.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "choreography/commands.hpp"
#include "edit/edit.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "support/process.hpp"
#include "support/sources.hpp"

using namespace pantin;
using Catch::Contains;
using Kind = Command::Kind;
using support::Folder;

namespace {

const std::string empty = "scene.plane = \"xy\"\nscene:floor {}\n";

SceneOptions options_here() {
  SceneOptions options;
  options.home = sources::folder();
  return options;
}

/// A scene of a text, in which somebody builds while it is paused.
struct Built {
  Folder folder;
  std::string source;
  std::unique_ptr<Scene> scene;
  std::uint64_t state;

  explicit Built(std::string text_of_scene, std::uint64_t seed = 1) : source(std::move(text_of_scene)), state(seed) {
    support::write_file(folder / "mine.lua", source);
    scene = lua::open_scene(folder / "mine.lua", options_here());
  }
  World& world() { return scene->world(); }
  void send(const Command& command) { carry_out(world(), std::vector{command}); }
  BodyId last() { return world().bodies.ids().back(); }

  BodyId make(MadeForm form, Vec3 at, Vec3 amount = vec(0.5, 0.25, 0.25), std::vector<Vec3> points = {zero3()}) {
    Command c;
    c.kind = Kind::make;
    c.form = form;
    c.position = at;
    c.points = std::move(points);
    c.amount = amount;
    c.radius = 0.3;
    send(c);
    return last();
  }
  player::SavedScene save() {
    const std::string file = player::free_scene_name(folder / "mine.lua", folder.path);
    return player::save_scene(*scene, folder / "mine.lua", source, options_here(), file);
  }
  static std::unique_ptr<Scene> open(const player::SavedScene& saved) {
    return lua::open_scene(saved.file, options_here());
  }
  /// What was added to the script.
  std::string added(const player::SavedScene& saved) const {
    return support::read_file(saved.file).substr(source.size());
  }

  double number() {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(number() * static_cast<double>(n)));
  }
  /// To hundredths, as what hands make.
  double around(double middle, double reach) {
    return std::round(100.0 * (middle + reach * (2.0 * number() - 1.0))) / 100.0;
  }
  Vec3 anywhere() { return vec(around(0, 3), around(4, 3), world().plane.flat() ? 0.0 : around(0, 2)); }
  BodyId any_body() {
    const std::vector<BodyId> bodies = world().bodies.ids();
    return bodies.empty() ? BodyId{} : bodies[below(bodies.size())];
  }
  /// A place on a body, or its first point.
  void aim(BodyId body, PointId& point, AnyId& thing, Vec3& at) {
    const std::vector<PointId>& points = world().bodies[body].points;
    if (!points.empty() && number() < 0.4) {
      point = points[below(points.size())];
      at = position(world(), point);
    } else {
      thing = body;
      at = world().motion_of(body).x + vec(around(0, 0.1), around(0, 0.1), 0);
    }
  }
  void do_anything() {
    const Kind kinds[] = {Kind::make, Kind::make, Kind::make,  Kind::join,
                          Kind::tie,  Kind::tie,  Kind::drive, Kind::nail};
    Command c;
    c.kind = kinds[below(std::size(kinds))];
    const BodyId a = any_body(), b = any_body();
    c.position = anywhere();
    c.points = {zero3()};
    c.radius = around(0.3, 0.1);
    if (c.kind == Kind::make) {
      c.form = static_cast<MadeForm>(1 + below(6));
      c.amount = c.form == MadeForm::wheel ? vec(0, 0, 0.2) : vec(around(0.5, 0.2), around(0.5, 0.2), around(0.4, 0.2));
      if (c.form == MadeForm::hull)
        c.points = {vec(-0.3, -0.3, -0.3), vec(0.4, -0.3, -0.3), vec(0, 0.5, -0.3), vec(0, 0, 0.4)};
      if (c.form == MadeForm::polygon) {
        c.points = {vec(0, 0, 0), vec(1, 0, 0), vec(1, 0.4, 0), vec(0.4, 0.4, 0), vec(0.4, around(1, 0.3), 0),
                    vec(0, 1, 0)};
        c.amount = vec(0, 0, 0.2);
      }
      if (c.form == MadeForm::rod) c.amount = number() < 0.5 ? vec(0, 1, 0) : zero3();
      if (c.form == MadeForm::rod) c.points = {zero3(), vec(around(1, 0.5), around(0, 1), 0)};
      if (a && number() < 0.7 && c.form != MadeForm::box) aim(a, c.point, c.thing, c.position);
      if (b && c.form == MadeForm::rod && number() < 0.5 && b != a) {
        Vec3 at = zero3();
        aim(b, c.other, c.other_thing, at);
        c.points[1] = at - c.position;
      }
    } else if (!a) {
      return;
    } else {
      aim(a, c.point, c.thing, c.position);
      c.points = {anywhere()};
      c.name = std::array{"rod", "rope", "spring", "chain"}[below(4)];
      if (b && (c.kind == Kind::join || number() < 0.6)) aim(b, c.other, c.other_thing, c.points[0]);
      if (c.kind == Kind::tie) c.radius = 0.05;
      if (c.kind == Kind::join && number() < 0.5) c.amount = vec(0, 0, 1);
      if (c.kind == Kind::join && source.find("plane") == std::string::npos && number() < 0.3)
        c.amount = direction(vec(number(), number(), number()));
      if (c.kind == Kind::drive) c.amount = vec(0, 0, around(0, 5));
    }
    send(c);
  }
};

void check_random_machines(const std::string& text, std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed <= last; seed++) {
    Built built(text, seed);
    for (int i = 0; i < 25; i++) built.do_anything();
    const player::SavedScene saved = built.save();
    INFO(seed << "\n" << built.added(saved));
    CHECK(saved.left_out == std::vector<std::string>());
    const auto again = Built::open(saved);
    REQUIRE(state_hash(again->world()) == state_hash(built.world()));
    CHECK(again->world().constraints.size() == built.world().constraints.size());
    CHECK(again->world().connections.size() == built.world().connections.size());
    CHECK(hinges(again->world()).size() == hinges(built.world()).size());
    for (int i = 0; i < 60; i++) {
      built.scene->step();
      again->step();
    }
    CHECK(state_hash(again->world()) == state_hash(built.world()));
  }
}

const std::string floor_in_plane = "scene.plane = \"xy\"\nscene:floor {}\n", floor_in_space = "scene:floor {}\n";

}  // namespace

TEST_CASE(
    "saved scene: random machines that were built by hand are equal when they are opened again, and go on equal") {
  check_random_machines(floor_in_plane, 1, 5);
  check_random_machines(floor_in_space, 1, 5);
}

TEST_CASE("saved scene: more random machines are equal when they are opened again, and go on equal", "[slow]") {
  check_random_machines(floor_in_plane, 6, 30);
  check_random_machines(floor_in_space, 6, 30);
}

TEST_CASE("saved scene: a cart is what a person would have written") {
  Built built(empty);
  const BodyId box = built.make(MadeForm::box, vec(0, 1.5, 0), vec(1, 0.5, 0.5));
  Command wheel;
  wheel.kind = Kind::make;
  wheel.form = MadeForm::wheel;
  wheel.position = vec(0.6, 1.3, 0);
  wheel.points = {zero3()};
  wheel.amount = vec(0, 0, 0.55);
  wheel.radius = 0.4;
  wheel.thing = box;
  built.send(wheel);
  Command motor;
  motor.kind = Kind::drive;
  motor.thing = built.last();
  motor.amount = vec(0, 0, -3);
  built.send(motor);
  const std::string added = built.added(built.save());
  CHECK_THAT(added, Contains("-- Built by hand.\ndo\n"));
  CHECK_THAT(added, Contains("local box1 = scene:box { size = vec(2, 1, 1), at = vec(0, 1.5, 0), color = \"#"));
  CHECK_THAT(added,
             Contains("local wheel1 = scene:cylinder { radius = 0.4, length = 1.1, axis = vec(0, 0, 1), points = "
                      "{ vec(0, 0, 0) }, at = vec(0.6, 1.3, 0)"));
  CHECK_THAT(added, Contains("scene:hinge(box1:add_point(vec(0.6, -0.2, 0)), wheel1.points[1])"));
  CHECK_THAT(added, Contains("scene:motor(wheel1, box1, { axis = vec(0, 0, -1), speed = 3, max_torque = "));
}

TEST_CASE("saved scene: alike things at equal distances are a loop") {
  Built built(empty);
  for (int i = 0; i < 12; i++) built.make(MadeForm::box, vec(-3 + 0.5 * i, 0.25, 0), vec(0.25, 0.25, 0.25));
  const player::SavedScene saved = built.save();
  CHECK_THAT(built.added(saved), Contains("for i = 0, 11 do\n") && Contains("at = vec(-3 + 0.5 * i, 0.25, 0)"));
  CHECK(state_hash(Built::open(saved)->world()) == state_hash(built.world()));
}

TEST_CASE("saved scene: places in a row that are short decimals, whose sums are not to the bit, are a loop") {
  Built built(empty);
  for (int i = 0; i < 30; i++) built.make(MadeForm::box, vec((i - 3) / 10.0, 0.7, 0), vec(0.04, 0.04, 0.04));
  const player::SavedScene saved = built.save();
  CHECK_THAT(built.added(saved), Contains("for i = 0, 29 do\n") && Contains("at = vec((-3 + i) / 10, 0.7, 0)"));
  CHECK(state_hash(Built::open(saved)->world()) == state_hash(built.world()));
}

TEST_CASE("saved scene: chains are loops, of their links and of their hinges") {
  Built built(GENERATE(floor_in_plane, floor_in_space));
  Command tie;
  tie.kind = Kind::tie;
  tie.name = "chain";
  tie.radius = 0.05;
  tie.thing = built.make(MadeForm::box, vec(-2, 4, 0));
  tie.position = vec(-2, 4, 0);
  tie.other_thing = built.make(MadeForm::ball, vec(3, 3.3, 0));
  tie.points = {vec(3, 3.3, 0)};
  built.send(tie);
  const std::size_t links = built.world().bodies.size() - 2;
  tie.thing = built.make(MadeForm::ball, vec(5, 2, 0));
  tie.position = vec(5, 2.3, 0);
  tie.other_thing = AnyId{};
  tie.points = {vec(5, 6.3, 0)};
  built.send(tie);
  const player::SavedScene saved = built.save();
  CHECK(saved.left_out == std::vector<std::string>());
  const std::string added = built.added(saved);
  CHECK_THAT(added, Contains(text("for i = 0, ", links - 3, " do\n    rods1[i + 1] = scene:capsule { radius = 0.05")));
  CHECK_THAT(added, Contains("at = vec(5, 2.3 + 0.4 * i, 0)"));
  CHECK_THAT(added, Contains(text("for i = 1, ", links - 3,
                                  " do\n    scene:hinge(rods1[i].points[2], rods1[i + 1].points[1])\n  end\n")));
  CHECK(std::ranges::count(added, '\n') < 35);
  const auto again = Built::open(saved);
  REQUIRE(state_hash(again->world()) == state_hash(built.world()));
  for (int i = 0; i < 60; i++) {
    built.scene->step();
    again->step();
  }
  CHECK(state_hash(again->world()) == state_hash(built.world()));
}

TEST_CASE("saved scene: alike ties of a row are a loop, and what names have in brackets is none") {
  Built built(empty +
              "for i = 1, 4 do scene:nail(scene:particle { at = vec(i, 9, 0) }, { name = 'a[' .. i .. ']' }) end\n");
  for (int i = 0; i < 5; i++) built.make(MadeForm::ball, vec(-3 + i, 3, 0));
  for (const BodyId body : built.world().bodies.ids()) {
    Command nail;
    nail.kind = Kind::nail;
    nail.thing = body;
    nail.position = built.world().motion_of(body).x;
    nail.points = {zero3()};
    built.send(nail);
  }
  for (const ConstraintId id : built.world().constraints.ids())
    if (!built.world().constraints[id].name.empty()) remove(built.world(), id);
  const player::SavedScene saved = built.save();
  INFO(built.added(saved));
  CHECK_THAT(built.added(saved), Contains("balls1[i + 1] = scene:ball") && Contains("scene:nail(balls1[i]") &&
                                     Contains("scene:find \"a[3]\":remove()"));
  CHECK(state_hash(Built::open(saved)->world()) == state_hash(built.world()));
}

TEST_CASE("saved scene: what the script made is found again, moved and removed") {
  Built built(empty + R"(
    local arm = scene:body { at = vec(0, 3, 0), mass = 1, inertia = vec(0.1, 0.1, 0.1), points = { tip = vec(1, 0, 0), vec(0, 0, 0) } }
    local nail = scene:nail(arm.points[1])
    scene:box { size = 1, at = vec(4, 0.5, 0) }
    scene:box { size = 1, at = vec(6, 0.5, 0) }
  )");
  const std::vector<BodyId> bodies = built.world().bodies.ids();
  Command tie;
  tie.kind = Kind::tie;
  tie.name = "rope";
  for (const PointId point : built.world().bodies[bodies[0]].points)
    if (built.world().points[point].name == "tip") tie.point = point;
  tie.other_thing = bodies[1];
  tie.points = {vec(4, 1, 0)};
  built.send(tie);
  Command gone;
  gone.kind = Kind::remove;
  gone.thing = bodies[2];
  built.send(gone);
  const player::SavedScene saved = built.save();
  CHECK(saved.left_out == std::vector<std::string>());
  CHECK_THAT(built.added(saved), Contains("bodies[3]:remove()") &&
                                     Contains("scene:string({ bodies[1].tip, bodies[2]:add_point(vec(0, 0.5, 0)) })"));
  CHECK(state_hash(Built::open(saved)->world()) == state_hash(built.world()));
}

TEST_CASE("saved scene: hinges and ties that went with what was removed are not cut once more") {
  Built built(empty + R"(
    local links = {}
    for i = 1, 5 do
      links[i] = scene:box { size = vec(1, 0.1, 0.1), at = vec(i, 3, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
      if i > 1 then scene:hinge(links[i - 1].b, links[i].a) else scene:nail(links[i].a) end
    end
  )");
  for (const std::size_t removed : {std::size_t{2}, std::size_t{0}}) {
    Command gone;
    gone.kind = Kind::remove;
    gone.thing = built.world().bodies.ids()[removed];
    built.send(gone);
    const player::SavedScene saved = built.save();
    INFO(built.added(saved));
    CHECK(saved.left_out == std::vector<std::string>());
    CHECK(state_hash(Built::open(saved)->world()) == state_hash(built.world()));
  }
}

TEST_CASE("saved scene: one that has run is written as it is, and what was saved is built on and saved again") {
  Built built(empty);
  built.make(MadeForm::ball, vec(0, 3, 0));
  for (int i = 0; i < 50; i++) built.scene->step();
  const player::SavedScene saved = built.save();
  CHECK(std::filesystem::path(saved.file).filename() == "mine-0001.lua");
  CHECK_THAT(built.added(saved), Contains("as it was at") && Contains("velocity = vec(0, -2."));
  const auto again = Built::open(saved);
  const BodyId here = built.last(), there = again->world().bodies.ids().back();
  CHECK(norm(again->world().motion_of(there).x - built.world().motion_of(here).x) < 1e-12);
  CHECK(norm(again->world().motion_of(there).p - built.world().motion_of(here).p) < 1e-9);
  CHECK(player::free_scene_name(saved.file, built.folder.path) == built.folder / "mine-0002.lua");
}

TEST_CASE("saved scene: what cannot be written is told by its name, and the rest is there") {
  Built built(empty + "scene:at(0.1, function() scene:ground { shape = shape.box(1, 1, 1) } end)\n" +
              "local p = scene:particle { at = vec(0, 9, 0) } scene:nail(p)\n");
  for (int i = 0; i < 30; i++) built.scene->step();
  built.make(MadeForm::box, vec(2, 3, 0));
  remove(built.world(), built.world().constraints.ids().front());
  const player::SavedScene saved = built.save();
  REQUIRE(saved.left_out.size() == 2);
  CHECK_THAT(saved.left_out[0], Contains("nail ") && Contains("of the script, which is gone here"));
  CHECK_THAT(saved.left_out[1], Contains("came while the scene ran"));
  CHECK_THAT(built.added(saved), Contains("scene:box"));
}

TEST_CASE("saved scene: where nothing can be written to there is an error, and no file") {
  Built built(empty);
  built.make(MadeForm::box, vec(2, 3, 0));
  CHECK_THROWS_WITH(
      player::save_scene(*built.scene, built.folder / "mine.lua", built.source, options_here(), "/dev/full"),
      Contains("cannot write /dev/full"));
  built.source += "do return end";
  const std::string file = built.folder / "mine-0001.lua";
  CHECK_NOTHROW(player::save_scene(*built.scene, built.folder / "mine.lua", built.source, options_here(), file));
  built.source = empty + "return 1";
  CHECK_THROWS_WITH(player::save_scene(*built.scene, built.folder / "mine.lua", built.source, options_here(),
                                       built.folder / "other.lua"),
                    Contains("cannot be saved as a scene, for it would not open: other.lua:"));
  CHECK_FALSE(std::filesystem::exists(built.folder / "other.lua"));
}

TEST_CASE("saved scene: ten thousand things are saved and opened again") {
  Built built("scene:floor {}\n");
  for (int i = 0; i < 10000; i++)
    built.make(MadeForm::ball, vec(0.7 * (i % 100), 0.3 + 0.61 * (i / 1000), 0.7 * (i / 100 % 10)));
  for (int i = 0; i < 300; i++) {
    Command tie;
    tie.kind = Kind::tie;
    tie.name = "rod";
    tie.thing = built.world().bodies.ids()[static_cast<std::size_t>(i)];
    tie.position = built.world().motion_of(std::get<BodyId>(tie.thing)).x;
    tie.points = {tie.position + vec(0, 9, 0)};
    built.send(tie);
  }
  const player::SavedScene saved = built.save();
  CHECK(saved.left_out == std::vector<std::string>());
  CHECK(state_hash(Built::open(saved)->world()) == state_hash(built.world()));
}

TEST_CASE("saved scene: the picture and the sprite of what a hand copied are written") {
  Built built(empty + R"(
    scene:box { size = 1, at = vec(0, 3, 0), picture = { file = "bricks.png", width = 0.5 }, color = "#ff0000",
      sprite = { file = "bird.png", width = 2 } }
    scene:ball { radius = 0.5, at = vec(2, 3, 0), picture = "beach_ball.png" }
  )");
  for (const BodyId body : built.world().bodies.ids()) {
    Command copy;
    copy.kind = Kind::make;
    copy.name = "copy";
    copy.thing = body;
    copy.position = built.world().motion_of(body).x + vec(0, 4, 0);
    built.send(copy);
  }
  const player::SavedScene saved = built.save();
  CHECK(saved.left_out == std::vector<std::string>());
  CHECK_THAT(built.added(saved), Contains("picture = { file = \"bricks.png\", width = 0.5 }") &&
                                     Contains("sprite = { file = \"bird.png\", width = 2 }") &&
                                     Contains("picture = \"beach_ball.png\""));
  CHECK(state_hash(Built::open(saved)->world()) == state_hash(built.world()));
}

TEST_CASE("saved scene: a piece has its part of the picture of the whole") {
  Built built(empty + R"(
    local block = scene:box { size = 1, at = vec(0, 3, 0), picture = "bricks.png" }
    scene:at(0.05, function() scene:shatter(block, { pieces = 5 }) end)
  )");
  for (int i = 0; i < 20; i++) built.scene->step();
  const World& world = built.world();
  REQUIRE(world.bodies.size() == 5);
  const player::SavedScene saved = built.save();
  CHECK(saved.left_out == std::vector<std::string>());
  const auto again = Built::open(saved);
  const std::vector<BodyId> here = world.bodies.ids(), there = again->world().bodies.ids();
  REQUIRE(there.size() == here.size());
  for (std::size_t i = 0; i < here.size(); i++) {
    const Shape &piece = world.shapes[world.bodies[here[i]].shapes[0]],
                &opened = again->world().shapes[again->world().bodies[there[i]].shapes[0]];
    REQUIRE(opened.cover);
    CHECK(same(opened.cover->low, piece.cover->low));
    CHECK(same(opened.cover->high, piece.cover->high));
  }
}
