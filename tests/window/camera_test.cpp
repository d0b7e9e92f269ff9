#include "view/camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pantin;

TEST_CASE("a position seen at a pixel projects back to that pixel, at any size of scene", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  Camera camera;
  camera.look(vec(3, 2, 5) * size, vec(0.5, 1, 0) * size);
  const Vec3 position = camera.place(310, 95, 4.0 * size, 1280, 720);
  const auto seen = camera.project(position, 1280, 720);
  REQUIRE(seen);
  CHECK(seen->x == Approx(310).margin(1e-6));
  CHECK(seen->y == Approx(95).margin(1e-6));
  CHECK(seen->depth == Approx(4.0 * size));
  const Ray ray = camera.ray(310, 95, 1280, 720);
  CHECK(norm(cross(ray.direction, direction(position - ray.from))) < 1e-12);
}

TEST_CASE("the matrices of the camera agree with its projection", "[view]") {
  Camera camera;
  camera.look(vec(3, 2, 5), vec(0.5, 1, 0));
  const Vec3 position = vec(0.9, 0.3, -0.4), relative = (position - camera.eye()) / camera.distance;
  const Eigen::Vector4f clip = camera.projection(1280.0 / 720.0) * camera.view() *
                               Eigen::Vector4f(static_cast<float>(relative[0]), static_cast<float>(relative[1]),
                                               static_cast<float>(relative[2]), 1.0f);
  const auto seen = camera.project(position, 1280, 720);
  REQUIRE(seen);
  CHECK(640.0 * (1.0 + static_cast<double>(clip.x() / clip.w())) == Approx(seen->x).margin(1e-3));
  CHECK(360.0 * (1.0 - static_cast<double>(clip.y() / clip.w())) == Approx(seen->y).margin(1e-3));
}

TEST_CASE("look keeps the eye where it was asked to be", "[view]") {
  Camera camera;
  camera.look(vec(-3, 2, 5), vec(0.5, 1, 0));
  CHECK(norm(camera.eye() - vec(-3, 2, 5)) < 1e-12);
  const Camera before = camera;
  camera.look(vec(std::nan(""), 0, 0), zero3());
  camera.look(vec(1, 1, 1), vec(1, 1, 1));
  CHECK(norm(camera.eye() - before.eye()) == 0.0);
}

TEST_CASE("a framed box fits the picture and fills most of it", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  const Vec3 lower = vec(-2, 0, -1) * size, upper = vec(9, 3, 1) * size;
  Camera camera;
  camera.frame(lower, upper, 1280.0 / 720.0);
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (int corner = 0; corner < 8; corner++) {
    const auto seen = camera.project(
        vec(corner & 1 ? lower[0] : upper[0], corner & 2 ? lower[1] : upper[1], corner & 4 ? lower[2] : upper[2]), 1280,
        720);
    REQUIRE(seen);
    left = std::fmin(left, seen->x);
    right = std::fmax(right, seen->x);
    top = std::fmin(top, seen->y);
    bottom = std::fmax(bottom, seen->y);
  }
  CHECK(left >= 0.0);
  CHECK(right <= 1280.0);
  CHECK(top >= 0.0);
  CHECK(bottom <= 720.0);
  CHECK((right - left > 0.7 * 1280.0 || bottom - top > 0.7 * 720.0));
}

TEST_CASE("a framed box of no extent keeps a finite camera", "[view]") {
  Camera camera;
  camera.frame(vec(1, 2, 3), vec(1, 2, 3), 1.5);
  CHECK(same(camera.target, vec(1, 2, 3)));
  CHECK(camera.distance > 0.0);
}

TEST_CASE("zooming at a pixel keeps what is under it, panning moves it with the pointer", "[view]") {
  Camera camera;
  const Vec3 position = camera.place(900, 200, camera.distance, 1280, 720);
  camera.zoom_at(0.5, 900, 200, 1280, 720);
  CHECK(camera.distance == Approx(3.0));
  auto seen = camera.project(position, 1280, 720);
  REQUIRE(seen);
  CHECK(seen->x == Approx(900));
  CHECK(seen->y == Approx(200));
  camera.pan(36.0 / 720.0, -18.0 / 720.0);
  seen = camera.project(position, 1280, 720);
  REQUIRE(seen);
  CHECK(seen->x == Approx(936));
  CHECK(seen->y == Approx(182));
}

TEST_CASE("turning stops short of straight down and up", "[view]") {
  Camera camera;
  camera.orbit(0.3, 10.0);
  CHECK(camera.pitch < 1.5707);
  CHECK(std::fabs(dot(camera.up(), camera.forward())) < 1e-12);
  camera.orbit(0.0, -20.0);
  CHECK(camera.pitch > -1.5707);
}
