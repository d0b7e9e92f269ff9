#include "view/views.hpp"

#include <imgui.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <set>

#include "articulates/articulate.hpp"
#include "bindings/lua_support.hpp"
#include "measure/measure.hpp"
#include "support/allocations.hpp"
#include "view/draw_list.hpp"
#include "view/player_input.hpp"
#include "view/renderer.hpp"
#include "view/tints.hpp"
#include "view/view_keys.hpp"
#include "view/view_marks.hpp"
#include "view/window.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

constexpr int wide = 480, high = 270;

// Something for every view to show.
const char* const everything_at_once = R"(
  local previous
  for i = 1, 6 do
    local link = scene:body { at = vec(i - 0.5, 4, 0), spin = vec(0, 0, i),
      points = { head = { at = vec(-0.5, 0, 0), mass = 0.5 }, tail = { at = vec(0.5, 0, 0), mass = 0.5 } } }
    if previous then scene:hinge(previous.tail, link.head) else scene:nail(link.head) end
    previous = link
  end
  local gas = scene:family("gas", { radius = 0.1 })
  local atoms = {}
  for i = 1, 20 do
    atoms[i] = scene:particle { family = gas, at = vec(i % 5, 1 + i // 5 * 0.4, 1), velocity = vec(0, i * 0.1, 0.3) }
    if i % 5 > 1 then scene:connect(atoms[i - 1], atoms[i], force.spring { stiffness = 50, length = 0.8 }) end
  end
  scene:interact(gas, gas, force.wca { epsilon = 0.1, sigma = 0.2 })
  scene:floor {}
  for i = 0, 2 do scene:block { size = 0.6, at = vec(2, 0.3 + 0.6 * i, -1) } end
  scene:block { size = 0.6, at = vec(4, 0.3, -1) }
  local sleeper = scene:body { at = vec(6, 1.95, -1), shape = shape.box(0.6, 0.1, 0.6),
    points = { head = { at = vec(0, 0.05, 0) } } }
  scene:nail(sleeper.head)
)";

Overlay with(const Views& views) {
  Overlay overlay;
  overlay.views = views;
  return overlay;
}

int apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); i += 4)
    count += std::abs(a[i] - b[i]) + std::abs(a[i + 1] - b[i + 1]) + std::abs(a[i + 2] - b[i + 2]) > 24;
  return count;
}

Views all_views() {
  Views views;
  for (const NamedView& named : view_table()) views.set(named.view, true);
  return views;
}

/// Dear ImGui asks for memory in its own way.
struct CountedImGui {
  static inline std::uint64_t count = 0;

  CountedImGui() {
    ImGui::GetAllocatorFunctions(&give_, &take_, &user_);
    ImGui::SetAllocatorFunctions(
        [](std::size_t size, void*) {
          count++;
          return std::malloc(size);
        },
        [](void* memory, void*) { std::free(memory); });
  }
  ~CountedImGui() { ImGui::SetAllocatorFunctions(give_, take_, user_); }

 private:
  ImGuiMemAllocFunc give_ = nullptr;
  ImGuiMemFreeFunc take_ = nullptr;
  void* user_ = nullptr;
};

}  // namespace

TEST_CASE("each view shows something, and toggled back the picture is the same to the bit", "[window]") {
  const Window window("test", wide, high, true);
  const auto scene = lua_tests::open(everything_at_once);
  Renderer renderer(wide, high);
  const auto picture = [&](const Views& views) {
    renderer.draw(scene->world(), first_camera(renderer.stage(), 480.0 / 270.0), with(views));
    return renderer.read_pixels();
  };
  renderer.open(scene->world());
  for (int i = 0; i < 60; i++) {
    scene->step();
    renderer.watch(scene->world(), {View::trails}, 1.0);
  }
  for (const auto& articulate : scene->world().articulates)
    if (articulate->nodes.size() == 1) articulate->rest.asleep = true;  // the nailed plate, which hangs at rest

  for (const NamedView& named : view_table()) {
    INFO(named.name);
    renderer.watch(scene->world(), {View::trails}, 1.0);
    Views views;
    const auto before = picture(views);
    views.toggle(named.view);
    if (named.view == View::trails) {
      for (int i = 0; i < 30; i++) {
        scene->step();
        renderer.watch(scene->world(), views, 1.0);
      }
    }
    const auto toggled = picture(views);
    views.toggle(named.view);
    const auto after = picture(views);
    CHECK(apart(toggled, after) > 40);
    if (named.view != View::trails) CHECK(before == after);
  }
}

TEST_CASE("no view changes the world by a bit", "[window]") {
  const Window window("test", wide, high, true);
  Renderer renderer(wide, high);
  std::uint64_t hashes[2] = {};
  for (const bool drawn : {false, true}) {
    const auto scene = lua_tests::open(everything_at_once);
    for (int i = 0; i < 240; i++) {
      scene->step();
      if (drawn && i % 4 == 0) renderer.draw(scene->world(), Camera{}, with(all_views()));
    }
    hashes[drawn ? 1 : 0] = state_hash(scene->world());
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("drawing a frame asks for no memory, whatever it shows", "[window]") {
  const Window window("test", wide, high, true);
  const CountedImGui counted;
  const auto scene = lua_tests::open(everything_at_once);
  for (int i = 0; i < 3; i++) scene->step();
  Renderer renderer(wide, high);
  renderer.open(scene->world());
  const Camera camera = first_camera(renderer.stage(), 480.0 / 270.0);
  Overlay overlay;
  overlay.marks.push_back({Mark::Kind::arrow, vec(0, 0, 0), vec(1, 1, 0), {}, 2.0, false, ""});
  overlay.marks.push_back(
      {Mark::Kind::text, vec(0, 0, 0), zero3(), {}, 14.0, false, "more letters than fit in a string"});
  overlay.highlight = scene->world().points.ids().back();
  for (const NamedView& named : view_table()) {
    INFO(named.name);
    overlay.views = {View::bodies, View::loads, View::shadows,  View::rings,          View::forces, View::velocities,
                     View::trails, View::cells, View::contacts, View::contact_forces, View::asleep};
    overlay.views.set(named.view, true);
    for (int i = 0; i < 3; i++) renderer.draw(scene->world(), camera, overlay);
    const std::uint64_t before = allocations() + CountedImGui::count;
    for (int i = 0; i < 5; i++) renderer.draw(scene->world(), camera, overlay);
    CHECK(allocations() + CountedImGui::count == before);
  }
}

TEST_CASE("a picture of one pixel is drawn, with all views", "[window]") {
  const Window window("test", 1, 1, true);
  const auto scene = lua_tests::open(everything_at_once);
  scene->step();
  Renderer renderer(1, 1);
  renderer.draw(scene->world(), Camera{}, with(all_views()));
  CHECK(renderer.read_pixels().size() == 4);
}

TEST_CASE("views have names of their own") {
  std::set<std::string> names;
  for (const NamedView& named : view_table()) CHECK(names.insert(named.name).second);
}

TEST_CASE("views are read by their names") {
  const Views views = read_views("rings,-shadows,dark");
  CHECK(views.on(View::rings));
  CHECK(views.on(View::dark));
  CHECK(views.on(View::bodies));
  CHECK_FALSE(views.on(View::shadows));
  CHECK_THROWS_WITH(read_views("rings,halos"), Contains("there is no view 'halos'; there are: bodies, loads, shadows"));
  CHECK_THROWS_WITH(read_views(""), Contains("there is no view ''"));
}

TEST_CASE("of the views that colour things one is on") {
  Views views;
  views.set(View::families, true);
  views.set(View::errors, true);
  CHECK_FALSE(views.on(View::families));
  CHECK(views.on(View::errors));
  views.set(View::errors, false);
  CHECK(views == Views{});
}

TEST_CASE("keys toggle views and turn the camera, but not with ctrl") {
  Gestures gestures;
  Views views;
  Camera camera;
  gestures.keys = {"g", "p", "9"};
  take_view_keys(gestures, views, camera);
  CHECK(views.on(View::rings));
  CHECK(camera.forward()[1] == Approx(-1.0));
  gestures.keys = {"ctrl+g", "ctrl+p"};
  take_view_keys(gestures, views, camera);
  CHECK(views.on(View::rings));
  gestures = {};
  gestures.keys = {"u", "g"};
  take_view_keys(gestures, views, camera);
  CHECK_FALSE(views.on(View::rings));
  CHECK(camera.fov == Camera{}.fov);
}

TEST_CASE("along an axis, near and far things have one size, and what is at the target keeps its own") {
  const Side side = GENERATE(Side::front, Side::right, Side::top);
  Camera camera;
  camera.target = vec(1, 2, 3);
  const double before = camera.project(camera.target, 1280, 720)->pixel;
  camera.look_along(side);
  CHECK(camera.project(camera.target, 1280, 720)->pixel == Approx(before));
  for (const double depth : {-2.0, 2.0}) {
    const auto seen = camera.project(camera.target + camera.forward() * depth + camera.up(), 1280, 720);
    REQUIRE(seen);
    CHECK(seen->pixel == Approx(before).epsilon(0.01));
    CHECK(360.0 - seen->y == Approx(1.0 / before).epsilon(0.01));
  }
  const int axis = side == Side::front ? 2 : side == Side::right ? 0 : 1;
  CHECK(camera.forward()[axis] == Approx(-1.0));
  camera.look_freely();
  CHECK(camera.project(camera.target, 1280, 720)->pixel == Approx(before));
}

TEST_CASE("contacts are shown where they are, with forces that add up to the weight", "[view]") {
  const auto scene = lua_tests::open(R"(
    scene:floor {}
    scene:block { size = 1, at = vec(0, 0.5, 0), mass = 3 }
    scene:block { size = 1, at = vec(0, 1.5, 0), mass = 2 })");
  for (int i = 0; i < 24; i++) scene->step();
  const World& world = scene->world();
  const Stage stage = find_stage(world);
  const auto marks_of = [&](const Views& views) {
    std::vector<Mark> marks;
    ViewMarks shown;
    shown.add(world, views, stage, 1.0, marks);
    return std::pair(marks, shown.legend());
  };
  CHECK(marks_of({}).first.empty());
  const auto contacts = marks_of({View::contacts}).first;
  int points = 0, lines = 0;
  for (const Mark& mark : contacts) {
    points += mark.kind == Mark::Kind::point;
    lines += mark.kind == Mark::Kind::line;
    if (mark.kind != Mark::Kind::point) continue;
    CHECK(std::min(std::fabs(mark.from[1]), std::fabs(mark.from[1] - 1.0)) < 1e-6);
    CHECK(std::fabs(std::fabs(mark.from[0]) - 0.5) < 1e-6);
  }
  CHECK(points == 8);
  CHECK(lines == 8);  // two manifolds of four
  const auto [forces, legend] = marks_of({View::contact_forces});
  CHECK(forces.size() == 8);
  CHECK(legend.starts_with("forces: longest "));
  Vec3 on_floor = zero3();
  for (const Contact& c : world.contacts.list)
    if (c.body_b < 0) on_floor += contact_force(world, c);
  CHECK(norm(on_floor - vec(0, 5 * 9.81, 0)) < 1e-4);
  for (const Mark& mark : forces)
    if (mark.from[1] < 0.5) CHECK(mark.to[1] > mark.from[1]);
}

TEST_CASE("islands have colours of their own, and what touches has one", "[view]") {
  const auto scene = lua_tests::open(R"(
    scene:floor {}
    scene:block { size = 1, at = vec(0, 0.5, 0) }
    scene:block { size = 1, at = vec(0, 1.5, 0) }
    scene:block { size = 1, at = vec(5, 0.5, 0) }
    scene:block { size = 1, at = vec(9, 5, 0) }
    local function link(x)
      return scene:body { shape = shape.box(0.8, 0.2, 0.2), at = vec(x, 0.1, 5), points = { vec(-0.5, 0, 0), vec(0.5, 0, 0) } }
    end
    local first, second = link(0), link(1)
    scene:hinge(first.points[2], second.points[1]))");
  for (int i = 0; i < 5; i++) scene->step();
  Tints tints;
  tints.update(scene->world(), {View::islands}, 10.0);
  const auto color = [&](std::uint32_t body) { return tints.of_body(body).of({0, 0, 0, 1}); };
  CHECK(color(0) == color(1));
  CHECK_FALSE(color(0) == color(2));
  CHECK(color(4) == color(5));
  CHECK_FALSE(color(4) == color(0));
  CHECK_FALSE(color(3) == color(2));
  tints.update(scene->world(), {View::bodies}, 10.0);
  CHECK(color(0) == Color{0, 0, 0, 1});
}

TEST_CASE("what sleeps is dim where that is shown, in the colours of other views too", "[view]") {
  const auto scene = lua_tests::open(R"(
    scene:nail(scene:body { at = vec(0, -0.05, 0), shape = shape.ball(0.02), points = { head = { at = vec(0, 0.05, 0) } } }.head)
    scene:nail(scene:body { at = vec(1, -0.05, 0), shape = shape.ball(0.02), spin = vec(0, 0, 9),
      points = { head = { at = vec(0, 0.05, 0) } } }.head))");
  for (int i = 0; i < 1200; i++) scene->step();
  Tints tints;
  constexpr Color own = {0.9f, 0.5f, 0.1f, 1.0f};
  tints.update(scene->world(), {View::asleep}, 1.0);
  CHECK(tints.of_body(0).dim);
  CHECK_FALSE(tints.of_body(1).dim);
  CHECK(tints.of_body(0).of(own).r < 0.5f * own.r);
  CHECK(tints.of_body(1).of(own) == own);
  tints.update(scene->world(), {View::asleep, View::articulates}, 1.0);
  CHECK(tints.of_body(0).dim);
  CHECK(tints.of_body(1).color);
  tints.update(scene->world(), {}, 1.0);
  CHECK_FALSE(tints.of_body(0).dim);
}

TEST_CASE("ties and hinges take the colour of their load", "[view]") {
  const auto scene = lua_tests::open(R"(
    local function weight(x) return scene:particle { at = vec(x, 0, 0) } end
    scene:rod(weight(0), vec(0, 1, 0))
    scene:string({ weight(1), vec(1, 1, 0) }, { length = 1 })
    scene:connect(weight(2), vec(2, 1, 0), force.spring { stiffness = 100, length = 1 })
    scene:rod(weight(3), vec(3, -1, 0))  -- it is pushed
    local function link(x)
      return scene:body { at = vec(x, 0, 0), mass = 1, inertia = vec(0.1, 0.1, 0.1), points = { vec(-0.5, 0, 0), vec(0.5, 0, 0) } }
    end
    local first, second = link(5), link(6)
    scene:nail(first.points[1])
    scene:hinge(first.points[2], second.points[1]))");
  for (int i = 0; i < 24; i++) scene->step();
  const Stage stage = find_stage(scene->world());
  const auto draw_list_of = [&](const Views& views) {
    DrawList draw_list;
    DrawListMaker().draw(scene->world(), first_camera(stage, 1.6), stage, with(views), 720, draw_list);
    return draw_list;
  };
  const DrawList plain = draw_list_of({View::bodies}), loaded = draw_list_of({View::bodies, View::loads});
  REQUIRE(loaded.bars.size() == plain.bars.size());
  int redder = 0, bluer = 0;
  for (std::size_t i = 0; i < loaded.bars.size(); i++) {
    redder += loaded.bars[i].color.r > plain.bars[i].color.r + 0.02f;
    bluer += loaded.bars[i].color.b > plain.bars[i].color.b + 0.02f;
  }
  CHECK(redder == 3);
  CHECK(bluer == 1);
  int hinges = 0;
  for (std::size_t i = 0; i < loaded.balls.size(); i++)
    hinges += loaded.balls[i].second.r > plain.balls[i].second.r + 0.02f;
  CHECK(hinges == 1);
}

TEST_CASE("loads that are rounding alone are not shown", "[view]") {
  const auto scene = lua_tests::open(R"(
    scene.gravity = vec(0, 0, 0)
    scene:rod(scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }))");
  scene->step();
  World& world = scene->world();
  const Stage stage = find_stage(world);
  const auto color_at = [&](double tension) {
    world.constraints.at_slot(0).tension = tension;
    DrawList draw_list;
    DrawListMaker().draw(world, first_camera(stage, 1.6), stage, with({View::bodies, View::loads}), 720, draw_list);
    return draw_list.bars.at(0).color.r;
  };
  CHECK(color_at(1e-15) == color_at(0.0));
  CHECK(color_at(1.0) > color_at(0.0));
}
