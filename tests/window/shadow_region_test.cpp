#include "view/shadow_region.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace pantin;

namespace {

constexpr std::array<double, 2> slant = {-0.5, 0.45};
constexpr double level = -0.3, aspect = 16.0 / 9.0;

Eigen::Vector3f on_map(const ShadowRegion& region, Vec3 place) {
  const double height = place[1] - level;
  return region.to_map * Eigen::Vector3d(place[0] - slant[0] * height, place[2] - slant[1] * height, 1.0).cast<float>();
}

Camera looking(Vec3 from, Vec3 at) {
  Camera camera;
  camera.look(from, at);
  return camera;
}

bool seen(const Camera& camera, Vec3 relative) {
  const auto p = camera.project(camera.eye() + relative * camera.distance, 1600, 900);
  return p && p->x > 0.0 && p->x < 1600.0 && p->y > 0.0 && p->y < 900.0;
}

}  // namespace

TEST_CASE("maps of shadows hold all that is seen above the ground, from wherever", "[view]") {
  const Camera camera = GENERATE(looking(vec(0, 3, 5), vec(0, 0, 0)), looking(vec(4, 0.1, 1), vec(0, 0, 0)),
                                 looking(vec(0, 9, 0.001), vec(0, 0, 0)), looking(vec(0, 0.5, 3), vec(0, 2, 0)));
  const Vec3 half = GENERATE(vec(0.3, 0.2, 0.1), vec(15, 0.5, 12), vec(0.01, 3, 0.01));
  const Vec3 middle = direction(camera.target - camera.eye()) + vec(0, 0.1, 0);
  const ShadowRegion region = find_shadow_region(middle - half, middle + half, level, slant, camera, aspect);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int i = 0; i < 5000; i++) {
    const Vec3 place = middle + half * vec(part(random), part(random), part(random));
    if (place[1] < level || !seen(camera, place) || dot(place, camera.forward()) > 20.0) continue;
    REQUIRE_FALSE(region.empty);
    const Eigen::Vector3f p = on_map(region, place);
    REQUIRE(p[2] > 0.0f);
    REQUIRE(std::max(std::fabs(p[0]), std::fabs(p[1])) <= p[2]);
  }
}

TEST_CASE("maps of shadows are as fine where one looks, however far things reach", "[view]") {
  const Camera camera = looking(vec(0, 2, 3), vec(0, 0, 0));
  const Vec3 eye = camera.eye() / camera.distance, ground = vec(0, level + 0.001, 0);
  const double wide = GENERATE(10.0, 1e3, 1e6);
  const Vec3 middle = vec(0, level, 0) - vec(eye[0], 0, eye[2]), half = vec(wide, 0.01, wide);
  const ShadowRegion region = find_shadow_region(middle - half, middle + half, level, slant, camera, aspect);
  const Vec3 at = ground - vec(eye[0], 0, eye[2]);
  const float depth = on_map(region, at)[2];
  CHECK(depth * region.across < 2.0f);
  CHECK(depth * depth * region.along < 2.0f);
}

TEST_CASE("there are no maps of shadows where none is seen", "[view]") {
  const Camera camera = looking(vec(0, 1, 3), vec(0, 1, 0));
  CHECK(find_shadow_region(vec(-1, 0, 3), vec(1, 1, 5), level, slant, camera, aspect).empty);
  CHECK_FALSE(find_shadow_region(vec(-1, 0, -3), vec(1, 1, -1), level, slant, camera, aspect).empty);
}
