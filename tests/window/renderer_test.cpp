#include "view/renderer.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <sstream>
#include <vector>

#include "base/check.hpp"
#include "choreography/hands.hpp"
#include "lua/scene/open.hpp"
#include "support/sources.hpp"
#include "view/draw_list.hpp"
#include "view/gl.hpp"
#include "view/window.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;

namespace {

constexpr int width = 640, height = 360;

struct Still {
  std::vector<std::uint8_t> pixels;

  int at(int x, int y, int channel) const {
    return pixels[4u * static_cast<std::size_t>(y * width + x) + static_cast<std::size_t>(channel)];
  }
  // Largest difference of a channel.
  int apart(const Still& other, int x, int y) const {
    int most = 0;
    for (int c = 0; c < 3; c++) most = std::max(most, std::abs(at(x, y, c) - other.at(x, y, c)));
    return most;
  }
  // Pixels that differ clearly.
  int covered(const Still& other) const {
    int n = 0;
    for (int y = 0; y < height; y++)
      for (int x = 0; x < width; x++) n += apart(other, x, y) > 24;
    return n;
  }
};

Still draw(const World& world, const Camera& camera, int samples = 0, const Overlay& overlay = {}) {
  Renderer renderer(width, height, samples);
  renderer.open(world);
  renderer.draw(world, camera, overlay);
  return {renderer.read_pixels()};
}

Camera camera_of(const World& world) { return first_camera(find_stage(world), 640.0 / 360.0); }

// Where a position is drawn, whole pixels.
std::pair<int, int> pixel(const Camera& camera, Vec3 position) {
  const auto seen = camera.project(position, width, height);
  REQUIRE(seen);
  return {static_cast<int>(seen->x), static_cast<int>(seen->y)};
}

}  // namespace

TEST_CASE("rods show where they are, hinges stand out from them", "[window]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  const int samples = GENERATE(0, 4);
  const Window window("test", width, height, true);
  World world;
  const auto rods = small_worlds::chain(world, 3, size);
  const Camera camera = camera_of(world);
  const Still bare = draw(World{}, camera, samples), still = draw(world, camera, samples);
  for (const BodyId rod : rods) {
    const auto [x, y] = pixel(camera, world.motion_of(rod).x);
    CHECK(still.apart(bare, x, y) > 40);
    CHECK(still.at(x, y, 0) > still.at(x, y, 2) + 40);  // orange
  }
  const auto [hx, hy] = pixel(camera, position(world, world.bodies[rods[0]].points[1]));
  const auto [rx, ry] = pixel(camera, world.motion_of(rods[0]).x);
  CHECK(still.at(hx, hy, 2) > still.at(rx, ry, 2) + 60);  // cream, not orange
  const int covered = still.covered(bare);
  CHECK(covered > 300);
  CHECK(covered < width * height / 4);
}

TEST_CASE("two pictures of one world are the same, one of a later time is not", "[window]") {
  const Window window("test", width, height, true);
  World world;
  small_worlds::chain(world, 3);
  const Camera camera = camera_of(world);
  const Still one = draw(world, camera);
  CHECK(one.pixels == draw(world, camera).pixels);
  set_position(world, world.bodies.ids()[2], vec(1.5, 2.5, 0));
  CHECK(one.covered(draw(world, camera)) > 50);
}

TEST_CASE("a ball's edge is smooth with samples, and its middle has its colour", "[window]") {
  const Window window("test", width, height, true);
  World world;
  ParticleDef def;
  def.at = vec(0, 1, 0);
  def.radius = 0.5;
  add_particle(world, def);
  Camera camera;
  camera.look(vec(0, 1, 6), vec(0, 1, 0));
  const Still still = draw(world, camera, 4), coarse = draw(world, camera, 0);
  CHECK(still.at(width / 2, height / 2, 2) > still.at(width / 2, height / 2, 0) + 60);
  const auto shades = [](const Still& s) {
    std::set<int> values;
    for (int y = 120; y < 240; y++)
      for (int x = 280; x < 360; x++) values.insert(s.at(x, y, 0));
    return values.size();
  };
  CHECK(shades(still) > shades(coarse));
  CHECK(still.covered(coarse) < 900);  // but for the edge they are alike
  const double area = M_PI * std::pow(0.5 / camera.project(vec(0, 1, 0), width, height)->pixel, 2);
  const int covered = coarse.covered(draw(World{}, camera));
  CHECK(covered > 0.8 * area);
  CHECK(covered < 2.2 * area);  // with its shadow
}

TEST_CASE("plates, solids, single points and tops are all visible", "[window]") {
  const Window window("test", width, height, true);
  World world;
  BodyDef def;
  const int kind = GENERATE(0, 1, 2, 3);
  for (int i = 0; i < 8; i++) {
    PointDef point;
    point.mass = 1.0;
    point.at = vec(i & 1, (i >> 1) & 1, kind == 1 ? i >> 2 : 0);
    if (kind == 2) point.at = zero3();
    def.points.push_back(point);
  }
  if (kind == 3) {
    small_worlds::top(world);
  } else {
    add_body(world, def);
  }
  const Camera camera = camera_of(world);
  const Still still = draw(world, camera), bare = draw(World{}, camera);
  const auto [x, y] = pixel(camera, world.motion_of(world.bodies.ids()[0]).x);
  CHECK(still.apart(bare, x, y) > 24);
  CHECK(still.covered(bare) > 200);
}

TEST_CASE("a hand's pull, a highlight, lines and text are drawn", "[window]") {
  const Window window("test", width, height, true);
  World world;
  const auto rods = small_worlds::chain(world, 3);
  const Camera camera = camera_of(world);
  const Still still = draw(world, camera);
  Overlay overlay;
  overlay.highlight = world.bodies[rods[2]].points[1];
  CHECK(draw(world, camera, 0, overlay).covered(still) > 20);
  overlay = {};
  overlay.marks.push_back(
      {Mark::Kind::line, vec(0, 0, 0), vec(3, 1, 0), Color{0.0f, 0.0f, 0.0f, 1.0f}, 3.0, false, ""});
  CHECK(draw(world, camera, 0, overlay).covered(still) > 100);
  overlay = {};
  overlay.status = {"time 1.50 s", "1.00 × real time"};
  const Still text = draw(world, camera, 0, overlay);
  int low = 0, high = 0;
  for (int y = 0; y < height; y++)
    for (int x = 0; x < width; x++) (y > height - 40 ? low : high) += text.apart(still, x, y) > 24;
  CHECK(low > 100);
  CHECK(high == 0);
  world.hands.resize(1);
  world.hands[0].position = vec(3, 1, 0);
  world.hands[0].placed = true;
  grab(world, 0, world.bodies[rods[2]].points[1], 100.0);
  const Still pulled = draw(world, camera);
  const auto [x, y] = pixel(camera, vec(3, 1, 0));
  CHECK(pulled.apart(still, x, y) > 60);
}

TEST_CASE("marks are drawn over the scene and on the screen, not behind the eye, and far ends do no harm", "[window]") {
  const Window window("test", width, height, true);
  const World world;
  Camera camera;
  camera.look(vec(0, 1, 6), vec(0, 1, 0));
  const Still bare = draw(world, camera);
  const Color red = {1.0f, 0.0f, 0.0f, 1.0f};
  const auto with = [&](const Mark& mark) {
    Overlay overlay;
    overlay.marks = {mark};
    return draw(world, camera, 0, overlay);
  };
  using Kind = Mark::Kind;
  const Still dot = with({Kind::point, vec(0, 1, 0), zero3(), red, 12.0, false, ""});
  CHECK(dot.at(width / 2, height / 2, 0) > 240);
  CHECK(dot.at(width / 2, height / 2, 2) < 20);
  CHECK(dot.covered(bare) == Approx(M_PI * 36.0).epsilon(0.15));
  const Still corner = with({Kind::point, vec(-20, -10, 0), zero3(), red, 12.0, true, ""});
  CHECK(corner.at(width - 20, height - 10, 1) < 20);
  const Still line = with({Kind::line, vec(10, 20, 0), vec(110, 20, 0), red, 4.0, true, ""});
  CHECK(line.covered(bare) == Approx(450.0).epsilon(0.15));
  const Still head = with({Kind::arrow, vec(10, 50, 0), vec(110, 50, 0), red, 4.0, true, ""});
  CHECK(head.covered(bare) > line.covered(bare) + 50);
  CHECK(with({Kind::text, vec(0, 1, 0), zero3(), {}, 20.0, false, "ring"}).covered(bare) > 60);
  CHECK(with({Kind::point, vec(0, 1, 9), zero3(), red, 12.0, false, ""}).covered(bare) == 0);
  CHECK(with({Kind::arrow, vec(0, 1, 9), vec(0, 2, 8), red, 2.0, false, ""}).covered(bare) == 0);
  const Still through = with({Kind::line, vec(0, 1, 0), vec(0, 1.001, 1e300), red, 3.0, false, ""});
  CHECK(through.covered(bare) < 200);
  CHECK(with({Kind::line, vec(-1e9, 1, 0), vec(1e9, 1, 0), red, 2.0, false, ""}).covered(bare) ==
        Approx(2.5 * width).epsilon(0.25));
}

TEST_CASE("a button answers to a press, which the scene does not see", "[window]") {
  const Window window("test", width, height, true);
  Renderer renderer(width, height);
  World world;
  Overlay overlay;
  overlay.buttons = {"cut all", "kick"};
  Gestures gestures;
  const auto event = [&](PointerEvent::Kind kind, double x) {
    Pointer& mouse = gestures.pointers[0];
    mouse = {x, 25.0, kind == PointerEvent::Kind::press, false, false};
    PointerEvent e;
    e.kind = kind;
    e.button = kind == PointerEvent::Kind::move ? PointerEvent::Button::none : PointerEvent::Button::left;
    e.x = x;
    e.y = 25.0;
    gestures.events.push_back(e);
  };
  std::string pressed;
  const auto frame = [&] {
    renderer.listen(gestures);
    const std::size_t left = gestures.events.size();
    renderer.draw(world, Camera{}, overlay);
    if (!renderer.pressed_button().empty()) pressed += renderer.pressed_button() + ";";
    gestures.events.clear();
    return left;
  };
  frame();
  frame();
  event(PointerEvent::Kind::press, 30.0);
  CHECK(frame() == 0);
  CHECK_FALSE(gestures.pointers[0].left);
  event(PointerEvent::Kind::release, 30.0);
  CHECK(frame() == 0);
  frame();
  CHECK(pressed == "cut all;");
  CHECK(renderer.pointer_on_panel());
  event(PointerEvent::Kind::press, 500.0);
  CHECK(frame() == 1);
  CHECK(gestures.pointers[0].left);
  event(PointerEvent::Kind::release, 500.0);
  CHECK(frame() == 1);
  CHECK_FALSE(renderer.pointer_on_panel());
  CHECK(pressed == "cut all;");
}

TEST_CASE("a renderer can change its size", "[window]") {
  const Window window("test", width, height, true);
  Renderer renderer(width, height, 4);
  World world;
  small_worlds::chain(world, 2);
  renderer.resize(320, 200);
  renderer.draw(world, camera_of(world));
  CHECK(renderer.read_pixels().size() == 4u * 320u * 200u);
  CHECK_THROWS_WITH(Renderer(0, 10), Catch::Contains("must be > 0 pixels, got 0 x 10"));
}

namespace {

/// What the shadow of a ball of 0.4 m across darkens, seen from above beside it.
struct Darkened {
  double x = 0.0, y = 0.0;  // [px] from where the light draws the ball's middle to the shadow's
  double wide = 0.0;        // [px] root of the mean square of its extent
  int most = 0;
};

Darkened shadow_of_ball(double above) {
  World world;
  small_worlds::particle(world, zero3());  // on the ground
  world.points.at_slot(0).radius = 1e-4;
  ParticleDef def;
  def.at = vec(0, above, 0);
  def.radius = 0.2;
  add_particle(world, def);
  const Vec3 light = key_light(), fallen = def.at - light * (above / light[1]);
  Camera camera;
  camera.look(fallen + vec(4, 8, -4), fallen);
  Overlay bare;
  bare.views.set(View::shadows, false);
  const Still with = draw(world, camera), without = draw(world, camera, 0, bare);
  Darkened d;
  double sum = 0.0, square = 0.0;
  for (int y = 0; y < height; y++)
    for (int x = 0; x < width; x++) {
      const int dark = without.at(x, y, 1) - with.at(x, y, 1);
      const double dx = x + 0.5 - 0.5 * width, dy = y + 0.5 - 0.5 * height;
      d.most = std::max(d.most, dark);
      d.x += dark * dx;
      d.y += dark * dy;
      square += dark * (dx * dx + dy * dy);
      sum += dark;
    }
  REQUIRE(sum > 0.0);
  d.x /= sum;
  d.y /= sum;
  d.wide = std::sqrt(square / sum);
  return d;
}

}  // namespace

TEST_CASE("a shadow lies where the light draws it, wider and fainter from higher up", "[window]") {
  const Window window("test", width, height, true);
  Darkened last;
  for (const double above : {1.0, 2.0, 4.0, 8.0}) {
    INFO(above << " m above the ground");
    const Darkened shadow = shadow_of_ball(above);
    CHECK(std::fabs(shadow.x) < 2.0);
    CHECK(std::fabs(shadow.y) < 2.0);
    if (above > 1.0) {
      CHECK(shadow.wide > 1.2 * last.wide);
      CHECK(shadow.most < last.most);
    }
    last = shadow;
  }
  CHECK(last.most > 3);
}

TEST_CASE("on a dense display all is as large as on another, with more pixels", "[window]") {
  const Window window("test", width, height, true);
  World world;
  small_worlds::chain(world, 3);
  Overlay overlay;
  const Color red = {1.0f, 0.0f, 0.0f, 1.0f};
  overlay.marks.push_back({Mark::Kind::point, vec(-20, -10, 0), zero3(), red, 12.0, true, ""});
  overlay.marks.push_back({Mark::Kind::line, vec(10, 20, 0), vec(110, 20, 0), red, 4.0, true, ""});
  overlay.marks.push_back({Mark::Kind::text, vec(300, 100, 0), zero3(), Color{0, 0, 0, 1}, 20.0, true, "words"});
  overlay.title = "a title";
  const auto of_scale = [&](double scale) {
    Renderer renderer(width, height);
    renderer.resize(width, height, scale);
    CHECK(renderer.width() == width);
    CHECK(renderer.pixels_wide() == static_cast<int>(width * scale));
    renderer.draw(world, camera_of(world), overlay);
    std::vector<std::uint8_t> pixels = renderer.read_pixels();
    REQUIRE(pixels.size() == static_cast<std::size_t>(4 * renderer.pixels_wide() * renderer.pixels_high()));
    return pixels;
  };
  const auto one = of_scale(1.0), two = of_scale(2.0);
  // Means of squares of 20 px.
  int apart = 0;
  for (int y = 0; y < height; y += 20)
    for (int x = 0; x < width; x += 20) {
      const auto mean = [&](const std::vector<std::uint8_t>& pixels, int scale) {
        double sum = 0.0;
        for (int i = y * scale; i < (y + 20) * scale; i++)
          for (int j = x * scale; j < (x + 20) * scale; j++)
            sum += pixels[4u * static_cast<std::size_t>(i * width * scale + j) + 1];
        return sum / (400.0 * scale * scale);
      };
      apart += std::fabs(mean(one, 1) - mean(two, 2)) > 6.0;
    }
  CHECK(apart == 0);
}

TEST_CASE("the renderer has every shader that it asks for", "[window]") {
  const Window window("test", width, height, true);
  std::ostringstream told;
  std::streambuf* const before = std::cerr.rdbuf(told.rdbuf());
  draw(World{}, camera_of(World{}));
  std::cerr.rdbuf(before);
  CHECK(told.str() == "");
}

TEST_CASE("a body that has nothing but inertia is visible", "[window]") {
  const Window window("test", width, height, true);
  World world;
  BodyDef def;
  def.mass = 1.0;
  def.inertia = diagonal(vec(0.1, 0.1, 0.1));
  const BodyId body = add_body(world, def);
  const Camera camera = camera_of(world);
  const Still still = draw(world, camera), bare = draw(World{}, camera);
  const auto [x, y] = pixel(camera, world.motion_of(body).x);
  CHECK(still.apart(bare, x, y) > 24);
  CHECK(still.covered(bare) > 200);
}

TEST_CASE("a shader that OpenGL refuses is told, and the rest is drawn", "[window]") {
  const Window window("test", width, height, true);
  std::ostringstream told;
  std::streambuf* const before = std::cerr.rdbuf(told.rdbuf());
  const ShaderProgram refused("ball", {"common.glsl"}, "this is not GLSL\n"), missing("nothing", {}, "");
  std::cerr.rdbuf(before);
  CHECK_FALSE(refused.usable());
  CHECK_FALSE(missing.usable());
  CHECK(told.str().find("shader 'ball.vert': ") != std::string::npos);
  CHECK(told.str().find("no shader is called 'nothing.vert'") != std::string::npos);
  FloatRows rows({3}, false);
  rows.send(std::vector<Vec3>(3));
  rows.draw(refused, GL_TRIANGLES);
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("a picture without panels has the marks, and what is drawn after it is as always", "[view]") {
  const Window window("test", width, height, true);
  World world;
  small_worlds::chain(world, 4);
  const Camera camera = camera_of(world);
  Overlay overlay;
  Mark mark;
  mark.kind = Mark::Kind::line;
  mark.from = vec(20, 300, 0);
  mark.to = vec(600, 330, 0);
  mark.size = 5.0;
  mark.on_screen = true;
  overlay.marks = {mark};
  const Still marked = draw(world, camera, 0, overlay);
  overlay.title = "Title";
  overlay.status = {"status"};
  overlay.buttons = {"button"};
  const Still all = draw(world, camera, 0, overlay);
  Renderer renderer(width, height);
  renderer.open(world);
  Still early;
  overlay.without_panels = [&] { early.pixels = renderer.read_pixels(); };
  renderer.draw(world, camera, overlay);
  CHECK(early.covered(marked) == 0);
  CHECK(early.covered(draw(world, camera)) > 1000);
  CHECK(all.covered(marked) > 50);
  CHECK(Still{renderer.read_pixels()}.covered(all) == 0);
}

namespace {

constexpr int kinds = 6;

/// A ball, a bar, a mesh, an ellipsoid, and, with pictures, a mesh and a sprite, of a color; as wide as high.
Still things_of(const std::string& color, const Camera* from, Camera& seen, int samples) {
  SceneOptions options;
  options.home = sources::folder();
  const auto scene = lua::open_scene_text("local color = " + color + R"(
    scene.gravity, scene.plane = vec(0, 0, 0), "xy"
    scene:particle { at = vec(0, 0, 0), radius = 0.5, color = color }
    scene:capsule { at = vec(2, 0, 0), radius = 0.5, length = 1, color = color }
    scene:box { at = vec(4, 0, 0), size = vec(1, 1, 1), color = color }
    scene:ball { at = vec(6, 0, 0), radius = 0.5, color = color }
    scene:box { at = vec(8, 0, 0), size = vec(1, 1, 1), color = color, picture = "crate.png" }
    local birds = scene:family("birds", { sprite = { file = "beach_ball.png", width = 1 } })
    scene:particle { at = vec(10, 0, 0), family = birds, color = color })",
                                          "things.lua", ".", options);
  seen = from ? *from : camera_of(scene->world());
  return draw(scene->world(), seen, samples);
}

/// The mean of the channels about the middle of each thing.
std::array<double, kinds> middles(const Still& still, const Camera& camera) {
  std::array<double, kinds> sums{};
  for (int kind = 0; kind < kinds; kind++) {
    const auto [x, y] = pixel(camera, vec(2.0 * kind, 0, 0));
    for (int i = -4; i < 4; i++)
      for (int k = -4; k < 4; k++)
        for (int c = 0; c < 3; c++) sums[static_cast<std::size_t>(kind)] += still.at(x + i, y + k, c) / 192.0;
  }
  return sums;
}

}  // namespace

TEST_CASE("what is half opaque shows half of what is behind, of every sort, and what is clear all of it", "[window]") {
  const int samples = GENERATE(0, 4);
  const Window window("test", width, height, true);
  Camera camera, same;
  const auto full = middles(things_of("{ 0.2, 0, 0, 1 }", nullptr, camera, samples), camera);
  const auto none = middles(things_of("{ 0.2, 0, 0, 0 }", &camera, same, samples), camera);
  for (const double opacity : {0.25, 0.5, 0.75}) {
    const auto part = middles(things_of(text("{ 0.2, 0, 0, ", opacity, " }"), &camera, same, samples), camera);
    for (std::size_t kind = 0; kind < kinds; kind++) {
      CAPTURE(samples, opacity, kind, full[kind], none[kind], part[kind]);
      CHECK(none[kind] - full[kind] > 15.0);
      CHECK((none[kind] - part[kind]) / (none[kind] - full[kind]) == Approx(opacity).margin(0.08));
    }
  }
}
