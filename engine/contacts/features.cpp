#include "contacts/features.hpp"

#include <cmath>

namespace pantin {

namespace {

/// A face must look more along a direction than one before it by so much of the cosine.
constexpr double better_face = 1e-6;
constexpr std::uint32_t most_corners = 64;

/// Points on the rim of a cap: sixteenths of a turn, of which the one that is nearest to where a tilted rim lies farthest gives
/// way to that.
constexpr std::uint32_t rim_corners = 16, farthest_of_rim = 16;
/// Sine of the tilt above which one point of a rim lies farthest.
constexpr double least_tilt = 1e-7;
constexpr std::array<double, 5> cosines = {1.0, 0.9238795325112867, 0.7071067811865476, 0.3826834323650898, 0.0};

double cosine_of_sixteenths(std::uint32_t i) {
  i %= rim_corners;
  if (i > 8) i = 16 - i;
  return i <= 4 ? cosines[i] : -cosines[8 - i];
}

enum : std::uint32_t { hull_edge = 101 };

void box_face(Vec3 half, const Pose& pose, Vec3 along, Feature& feature) {
  const Vec3 local = transposed_times(pose.R, along);
  int g = 0;
  for (int i = 1; i < 3; i++)
    if (std::fabs(local[i]) > std::fabs(local[g]) + better_face) g = i;
  const bool up = local[g] > 0.0;
  const int u = (g + 1) % 3, v = (g + 2) % 3;
  const Vec3 outwards = up ? pose.R[g] : -pose.R[g], middle = pose.x + outwards * half[g];
  const Vec3 along_u = pose.R[u] * half[u], along_v = pose.R[v] * (up ? half[v] : -half[v]);
  const std::uint32_t one = 1, on_g = up ? one << g : 0, on_u = one << u, on_v = one << v;
  const auto edges_u = static_cast<std::uint32_t>(4 * u), edges_v = static_cast<std::uint32_t>(4 * v);
  const std::uint32_t near_v = up ? 0 : 1, up_u = up ? 2 : 0, up_v = up ? 1 : 0;
  const std::uint32_t first_v = up ? 0 : on_v, last_v = up ? on_v : 0;
  feature.kind = Feature::Kind::polygon;
  feature.normal = outwards;
  feature.number = static_cast<std::uint32_t>(2 * g) + (up ? 1u : 0u);
  feature.loop.count = 0;
  feature.loop.closed = true;
  feature.loop.add({middle - along_u - along_v, on_g | first_v, edges_u + near_v + up_u});
  feature.loop.add({middle + along_u - along_v, on_g | first_v | on_u, edges_v + 2 + up_v});
  feature.loop.add({middle + along_u + along_v, on_g | last_v | on_u, edges_u + 1 - near_v + up_u});
  feature.loop.add({middle - along_u + along_v, on_g | last_v, edges_v + up_v});
}

/// What is within `radius` of the z axis from -half to half: its line that lies farthest along a direction, which is not that
/// of the axis.
void side_line(double radius, double half, const Pose& pose, Vec3 local, Feature& feature) {
  const Vec3 across = pose.R[0] * local[0] + pose.R[1] * local[1];
  feature.kind = Feature::Kind::segment;
  feature.normal = across / std::sqrt(local[0] * local[0] + local[1] * local[1]);
  feature.number = 2;
  feature.radius = radius;
  feature.line = {pose.x - pose.R[2] * half, pose.x + pose.R[2] * half};
  feature.loop.count = 0;
  feature.loop.closed = false;
  for (std::uint32_t i = 0; i < 2; i++) feature.loop.add({feature.line[i] + feature.normal * radius, i, 0});
}

void single_point(Vec3 x, std::uint32_t number, Feature& feature) {
  feature.kind = Feature::Kind::point;
  feature.number = number;
  feature.loop.count = 0;
  feature.loop.closed = false;
  feature.loop.add({x, number, 0});
}

bool is_upright(Vec3 local) {
  return std::fabs(local[2]) > std::sqrt(local[0] * local[0] + local[1] * local[1]) - better_face;
}

void capsule_feature(double radius, double half, const Pose& pose, Vec3 along, Feature& feature) {
  const Vec3 local = transposed_times(pose.R, along);
  if (!is_upright(local)) return side_line(radius, half, pose, local, feature);
  const bool up = local[2] > 0.0;
  single_point(pose.x + pose.R[2] * (up ? half : -half) + along * radius, up ? 1 : 0, feature);
}

void cylinder_feature(double radius, double half, const Pose& pose, Vec3 along, Feature& feature) {
  const Vec3 local = transposed_times(pose.R, along);
  if (!is_upright(local)) return side_line(radius, half, pose, local, feature);
  const bool up = local[2] > 0.0;
  const Vec3 x = pose.R[0] * radius, y = pose.R[1] * (up ? radius : -radius);
  feature.kind = Feature::Kind::disc;
  feature.normal = up ? pose.R[2] : -pose.R[2];
  feature.number = up ? 1 : 0;
  feature.radius = radius;
  feature.centre = pose.x + feature.normal * half;
  feature.loop.count = 0;
  feature.loop.closed = true;
  const double across = std::hypot(local[0], local[1]);
  const double cosine = across > least_tilt ? local[0] / across : 0.0,
               sine = across > least_tilt ? (up ? local[1] : -local[1]) / across : 0.0;
  const auto along_rim = [&](std::uint32_t i) {
    return cosine * cosine_of_sixteenths(i) + sine * cosine_of_sixteenths(i + 12);
  };
  std::uint32_t farthest = 0;
  for (std::uint32_t i = 1; i < rim_corners; i++)
    if (along_rim(i) > along_rim(farthest)) farthest = i;
  for (std::uint32_t i = 0; i < rim_corners; i++)
    if (i == farthest && across > least_tilt)
      feature.loop.add({feature.centre + x * cosine + y * sine, across > lies_on_end ? farthest_of_rim : i, i});
    else
      feature.loop.add({feature.centre + x * cosine_of_sixteenths(i) + y * cosine_of_sixteenths(i + 12), i, i});
}

std::uint32_t face_along(const Hull& hull, Vec3 local) {
  std::uint32_t best = 0;
  double most = -infinity;
  for (std::uint32_t f = 0; f < hull.faces.size(); f++) {
    const double c = dot(hull.faces[f].normal, local);
    if (c > most + better_face) {
      most = c;
      best = f;
    }
  }
  return best;
}

}  // namespace

std::uint32_t name_of(std::uint32_t kind, std::uint32_t first, std::uint32_t second, std::uint32_t third) {
  std::uint64_t z = kind;
  for (const std::uint32_t part : {first, second, third}) {
    z = (z ^ part) * 0xbf58476d1ce4e5b9u;
    z ^= z >> 29;
  }
  return static_cast<std::uint32_t>(z >> 16) & 0x7fffffffu;
}

void find_face(const Hull& hull, const Pose& pose, std::uint32_t number, Feature& feature) {
  const Hull::Face& face = hull.faces[number];
  feature.kind = Feature::Kind::polygon;
  feature.normal = pose.R * face.normal;
  feature.number = number;
  feature.loop.count = 0;
  feature.loop.closed = true;
  const std::uint32_t told = std::min(face.count, most_corners);
  const auto vertex = [&](std::uint32_t i) {
    const std::uint64_t at = i < told ? std::uint64_t{i} * face.count / told : 0;
    return hull.loops[face.first + static_cast<std::uint32_t>(at)];
  };
  for (std::uint32_t i = 0; i < told; i++) {
    const std::uint32_t from = vertex(i), to = vertex(i + 1);
    feature.loop.add(
        {pose.to_world(hull.vertices[from]), from, name_of(hull_edge, std::min(from, to), std::max(from, to))});
  }
}

void find_feature(const Core& core, const Pose& pose, Vec3 along, Feature& feature) {
  switch (core.kind) {
    case Core::Kind::point: return single_point(pose.x + along * core.rounding, 0, feature);
    case Core::Kind::segment: return capsule_feature(core.rounding, core.half[2], pose, along, feature);
    case Core::Kind::box: return box_face(core.half, pose, along, feature);
    case Core::Kind::cylinder: return cylinder_feature(core.half[0], core.half[2], pose, along, feature);
    case Core::Kind::hull:
      return find_face(*core.hull, pose, face_along(*core.hull, transposed_times(pose.R, along)), feature);
  }
}

}  // namespace pantin
