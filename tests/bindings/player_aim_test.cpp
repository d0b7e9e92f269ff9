#include <catch2/catch.hpp>

#include "lua/scene/open.hpp"
#include "player/aim.hpp"
#include "support/sources.hpp"

using namespace pantin;
using namespace pantin::player;

namespace {

std::unique_ptr<Scene> open(const std::string& script) {
  SceneOptions options;
  options.home = sources::folder();
  return lua::open_scene_text(script, "aim.lua", ".", options);
}

void move(Follower& follower, const Scene& scene, double seconds, Camera& camera) {
  follower.move(scene, find_stage(scene.world()), 16.0 / 9.0, seconds, camera);
}

Camera aim_at(const Scene& scene) { return aim(scene, find_stage(scene.world()), 16.0 / 9.0); }

double distance(Vec3 a, Vec3 b) { return norm(a - b); }

}  // namespace

TEST_CASE("aim: without a wish all is in the picture") {
  auto scene = open("for i = 1, 5 do scene:particle { at = vec(i * 10, 0, 0) } end");
  Camera camera = aim_at(*scene);
  for (double x : {10.0, 50.0}) {
    auto seen = camera.project(vec(x, 0, 0), 1280, 720);
    REQUIRE(seen);
    CHECK((seen->x > 0 && seen->x < 1280 && seen->y > 0 && seen->y < 720));
  }
}

TEST_CASE("aim: the scene's camera") {
  auto scene = open("scene:particle {} scene.camera = { at = vec(3, 4, 5), look_at = vec(0, 1, 0) }");
  Camera camera = aim_at(*scene);
  CHECK(distance(camera.eye(), vec(3, 4, 5)) < 1e-9);
  CHECK(distance(camera.target, vec(0, 1, 0)) < 1e-9);
}

TEST_CASE("aim: a place to look at alone keeps the usual distance") {
  auto plain = open("scene:particle { at = vec(1, 0, 0) } scene:particle {}");
  auto wished =
      open("scene:particle { at = vec(1, 0, 0) } scene:particle {} scene.camera = { look_at = vec(0, 5, 0) }");
  CHECK(distance(aim_at(*wished).target, vec(0, 5, 0)) < 1e-12);
  CHECK(aim_at(*wished).distance == Approx(aim_at(*plain).distance));
}

TEST_CASE("aim: the camera goes along with what it follows, and stays when that is gone") {
  auto scene = open(R"(
    local p = scene:particle { velocity = vec(2, 0, 0) }
    scene.gravity = vec(0, 0, 0)
    scene.camera = { follow = p }
    scene:at(1, function() p:remove() end)
  )");
  Camera camera = aim_at(*scene);
  Vec3 start = camera.target;
  Follower follower;
  move(follower, *scene, 0.0, camera);
  for (int i = 0; i < 120; i++) scene->step();
  move(follower, *scene, 0.0, camera);
  CHECK(distance(camera.target, start + vec(1, 0, 0)) < 1e-9);
  for (int i = 0; i < 240; i++) scene->step();
  move(follower, *scene, 0.0, camera);
  CHECK(distance(camera.target, start + vec(1, 0, 0)) < 1e-9);
}

TEST_CASE("aim: what was chosen is followed in place of what the scene wants, and nothing if that was nothing") {
  auto scene = open(R"(
    scene.gravity = vec(0, 0, 0)
    scene.camera = { follow = scene:particle { velocity = vec(2, 0, 0) } }
    scene:particle { name = "riser", velocity = vec(0, 3, 0) }
  )");
  Camera camera = aim_at(*scene);
  const Vec3 start = camera.target;
  Follower follower;
  follower.choose(scene->world().particles.ids()[1]);
  const auto second = [&] {
    move(follower, *scene, 0.0, camera);
    for (int i = 0; i < 240; i++) scene->step();
    move(follower, *scene, 0.0, camera);
  };
  second();
  CHECK(distance(camera.target, start + vec(0, 3, 0)) < 1e-9);
  follower.choose({});
  second();
  CHECK(distance(camera.target, start + vec(0, 3, 0)) < 1e-9);
}

TEST_CASE("aim: a camera that a script moves is there at once, or with ease") {
  auto scene = open(R"(
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0), ease = 0.5 }
    scene:at(0, function() scene.camera.at, scene.camera.look_at = vec(5, 0, 10), vec(5, 0, 0) end)
    scene:at(1, function() scene.camera.ease, scene.camera.zoom = 0, 2 end))");
  Camera camera = aim_at(*scene);
  Follower follower;
  move(follower, *scene, 0.0, camera);
  CHECK(distance(camera.target, vec(0, 0, 0)) < 1e-9);
  scene->step();
  move(follower, *scene, 0.5, camera);
  CHECK(camera.target[0] == Approx(5.0 * (1.0 - std::exp(-1.0))));
  for (int i = 0; i < 20; i++) move(follower, *scene, 0.5, camera);
  CHECK(camera.target[0] == Approx(5.0).margin(0.02));
  camera.target = vec(1, 2, 3);  // who watches moves it between
  move(follower, *scene, 0.5, camera);
  CHECK(distance(camera.target, vec(1, 2, 3)) < 1e-12);
  while (scene->world().time < 1.5) scene->step();
  move(follower, *scene, 0.0, camera);
  CHECK(camera.distance == Approx(5.0).margin(0.01));
}

TEST_CASE("aim: what is followed with ease comes to the middle") {
  auto scene = open(R"(
    scene:ground { shape = shape.box(30, 1, 30), at = vec(0, -3, 0) }
    local p = scene:particle { at = vec(7, 0, 0) }
    scene.gravity = vec(0, 0, 0)
    scene.camera = { look_at = vec(0, 0, 0), ease = 0.2 }
    scene.camera.follow = p)");
  Camera camera = aim_at(*scene);
  Follower follower;
  for (int i = 0; i < 40; i++) move(follower, *scene, 0.1, camera);
  CHECK(distance(camera.target, vec(7, 0, 0)) < 1e-6);
}

TEST_CASE("aim: a scene that a parameter made larger is seen whole, from the side that one looked from") {
  Camera now, aimed;
  now.yaw = 1.0;
  now.distance = 3.0;
  aimed.target = vec(0, 5, 0);
  aimed.distance = 30.0;
  CHECK(fit_to_size(now, aimed, 1.0, 1.05).distance == 3.0);
  const Camera fitted = fit_to_size(now, aimed, 1.0, 10.0);
  CHECK(fitted.distance == 30.0);
  CHECK(fitted.target[1] == 5.0);
  CHECK(fitted.yaw == 1.0);
}
