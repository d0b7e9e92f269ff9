// Each shipped scene, left to itself, stays sane: its energy, its shapes, and that there is something to see.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "support/process.hpp"
#include "support/sources.hpp"

using namespace pantin;

namespace {

const std::string folder = sources::folder() + "/scripts/scenes/";

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

Vec3 place_of(const World& world, const AnyId& thing) {
  const Bounds box = bounds(world, things_of(world, thing));
  return 0.5 * (box.low + box.high);
}

/// The share of bodies and particles within 35° of where the camera looks; it goes along with what it follows.
double share_in_picture(const Scene& scene, Vec3 followed_first) {
  const World& world = scene.world();
  const CameraWish camera = scene.camera();
  if (!camera.at || !camera.look_at) return 1.0;
  Vec3 moved = zero3();
  if (alive(world, camera.follow)) {
    const Vec3 place = place_of(world, camera.follow);
    moved = place - (camera.ease > 0.0 ? *camera.look_at : followed_first);
  }
  const Vec3 at = *camera.at + moved, way = *camera.look_at - *camera.at;
  double seen = 0.0, all = 0.0;
  const auto count = [&](const AnyId& thing) {
    const Vec3 d = place_of(world, thing) - at;
    all++;
    if (dot(d, way) > std::cos(0.61) * norm(d) * norm(way)) seen++;
  };
  for (const BodyId id : world.bodies.ids()) count(id);
  for (const ParticleId id : world.particles.ids()) count(id);
  return all > 0.0 ? seen / all : 0.0;
}

void check_stays_sane(const std::string& name, double seconds) {
  INFO(name);
  SceneOptions options;
  options.home = sources::folder();
  options.script_limit = 0.0;
  const auto scene = lua::open_scene(folder + name + ".lua", options);
  const World& world = scene->world();
  const AnyId followed = scene->camera().follow;
  const Vec3 first = alive(world, followed) ? place_of(world, followed) : zero3();
  while (world.time < seconds && world.failure.empty()) scene->step();
  CHECK(world.failure == "");
  const Accuracy now = accuracy(world);
  CHECK(std::fmax(world.worst.energy, now.energy) < 0.2);
  CHECK(std::fmax(world.worst.hinge_gap, now.hinge_gap) < 1e-6);  // [m]
  CHECK(share_in_picture(*scene, first) > 0.3);
}

}  // namespace

TEST_CASE("shipped scenes: the light ones stay sane for 12 s that nobody touches them") {
  for (const char* name : {"auxetic", "chain", "combine", "cradle", "differential", "gears", "machines", "marbles",
                           "orbits", "pendulum", "puppet", "sandbox", "top"})
    check_stays_sane(name, 12.0);
}

TEST_CASE("shipped scenes: each stays sane for a minute that nobody touches it", "[.minute]") {
  for (const std::string& name : shipped_names()) check_stays_sane(name, 60.0);
}

TEST_CASE("shipped scenes: the browser's list names each of them once") {
  std::istringstream list(support::read_file(folder + "order.txt"));
  std::vector<std::string> listed;
  for (std::string line, name; std::getline(list, line);)
    if (std::istringstream(line) >> name) listed.push_back(name);
  std::ranges::sort(listed);
  CHECK(listed == shipped_names());
}

TEST_CASE("shipped scenes: each is under 60 lines") {
  for (const std::string& name : shipped_names()) {
    INFO(name);
    CHECK(std::ranges::count(support::read_file(folder + name + ".lua"), '\n') < 60);
  }
}
