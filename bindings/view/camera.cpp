#include "view/camera.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

constexpr double steepest = 1.55;                      // [rad] just short of straight down
constexpr double usual_fov = 0.62, narrow_fov = 0.01;  // [rad]
constexpr double far_plane = 400.0;

// In units of the distance: far off where all is far off, so that depths stay distinct.
double near_plane(double fov) { return std::max(0.02, 1.0 - 50.0 * fov); }

// Changes the field of view and keeps the size of what is at the target.
void set_fov(Camera& camera, double fov) {
  camera.distance *= std::tan(0.5 * camera.fov) / std::tan(0.5 * fov);
  camera.fov = fov;
}

}  // namespace

void Camera::orbit(double dx, double dy) {
  yaw = std::remainder(yaw + dx, 2.0 * M_PI);
  pitch = std::clamp(pitch + dy, -steepest, steepest);
}

void Camera::pan(double dx, double dy) {
  const double height = 2.0 * distance * std::tan(0.5 * fov);
  target += (right() * -dx + up() * dy) * height;
}

void Camera::zoom(double factor) {
  if (std::isfinite(factor) && factor > 0.0) distance = std::clamp(distance * factor, 1e-300, 1e300);
}

void Camera::zoom_at(double factor, double x, double y, int width, int height) {
  const Vec3 before = place(x, y, distance, width, height);
  zoom(factor);
  target += before - place(x, y, distance, width, height);
}

void Camera::frame(Vec3 lower, Vec3 upper, double aspect) {
  const Vec3 centre = (lower + upper) * 0.5, half = (upper - lower) * 0.5;
  if (!finite(centre)) return;
  const double tan_y = std::tan(0.5 * fov) * 0.88, tan_x = tan_y * aspect;
  const Vec3 r = right(), u = up(), f = forward();
  double needed = 0.0;
  for (int corner = 0; corner < 8; corner++) {
    const Vec3 c = half * vec(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    needed = std::max({needed, std::fabs(dot(c, r)) / tan_x - dot(c, f), std::fabs(dot(c, u)) / tan_y - dot(c, f)});
  }
  target = centre;
  if (needed > 0.0) distance = needed;
}

void Camera::look(Vec3 from, Vec3 at) {
  const Vec3 d = from - at;
  if (!finite(d) || !(norm(d) > 0.0)) return;
  target = at;
  distance = norm(d);
  pitch = std::clamp(std::asin(std::clamp(d[1] / distance, -1.0, 1.0)), -steepest, steepest);
  if (std::hypot(d[0], d[2]) > 1e-9 * distance) yaw = std::atan2(d[0], d[2]);
}

void Camera::look_along(Side side) {
  set_fov(*this, narrow_fov);
  yaw = side == Side::right ? 0.5 * M_PI : 0.0;
  pitch = side == Side::top ? 0.5 * M_PI : 0.0;
}

void Camera::look_freely() {
  set_fov(*this, usual_fov);
  pitch = std::clamp(pitch, -steepest, steepest);
}

double Camera::nearest() const { return near_plane(fov) * distance; }

Vec3 Camera::forward() const {
  return vec(-std::sin(yaw) * std::cos(pitch), -std::sin(pitch), -std::cos(yaw) * std::cos(pitch));
}
Vec3 Camera::right() const { return vec(std::cos(yaw), 0, -std::sin(yaw)); }
Vec3 Camera::up() const { return cross(right(), forward()); }
Vec3 Camera::eye() const { return target - forward() * distance; }

Eigen::Matrix4f Camera::view() const {
  Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
  const Vec3 rows[3] = {right(), up(), -forward()};
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) m(i, j) = static_cast<float>(rows[i][j]);
  return m;
}

Eigen::Matrix4f Camera::projection(double aspect) const {
  const double scale = 1.0 / std::tan(0.5 * fov), near = near_plane(fov);
  Eigen::Matrix4f m = Eigen::Matrix4f::Zero();
  m(0, 0) = static_cast<float>(scale / aspect);
  m(1, 1) = static_cast<float>(scale);
  m(2, 2) = static_cast<float>(-(far_plane + near) / (far_plane - near));
  m(2, 3) = static_cast<float>(-2.0 * far_plane * near / (far_plane - near));
  m(3, 2) = -1.0f;
  return m;
}

Vec3 Camera::place(double x, double y, double depth, int width, int height) const {
  const double pixel = 2.0 * depth * std::tan(0.5 * fov) / height;
  return eye() + forward() * depth + (right() * (x - 0.5 * width) + up() * (0.5 * height - y)) * pixel;
}

Ray Camera::ray(double x, double y, int width, int height) const {
  const Vec3 from = eye();
  return {from, direction(place(x, y, distance, width, height) - from)};
}

std::optional<Projected> Camera::project(Vec3 p, int width, int height) const {
  const Vec3 d = p - eye();
  const double depth = dot(d, forward());
  if (!(depth > nearest())) return std::nullopt;
  const double pixel = 2.0 * depth * std::tan(0.5 * fov) / height;
  return Projected{0.5 * width + dot(d, right()) / pixel, 0.5 * height - dot(d, up()) / pixel, depth, pixel};
}

}  // namespace pantin
