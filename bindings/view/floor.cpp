#include "view/floor.hpp"

#include <cmath>

namespace pantin {

Floor floor_of(const World& world, ShapeId plane, const Stage& stage) {
  const Shape& shape = world.shapes[plane];
  if (shape.extent) return {shape.at, 0.5 * *shape.extent};
  const Vec3 middle = 0.5 * (stage.lower + stage.upper), normal = matrix(shape.orientation)[2];
  return {middle - normal * dot(middle - shape.at, normal), 2.2 * stage.size};
}

Floor floor_seen(const World& world, ShapeId plane, const Stage& stage, Vec3 target, double distance) {
  Floor floor = floor_of(world, plane, stage);
  const Shape& shape = world.shapes[plane];
  if (shape.extent) return floor;
  floor.reach = std::fmax(floor.reach, distance);
  const Vec3 normal = matrix(shape.orientation)[2], off = target - floor.middle, way = off - normal * dot(off, normal);
  const double too_far = norm(way) - 0.2 * floor.reach;
  if (too_far > 0.0) floor.middle += direction(way) * too_far;
  return floor;
}

double ground_square(const Stage& stage) {
  // 1, 2 or 5 times a power of ten.
  const double length = stage.size / 8.0, power = std::pow(10.0, std::floor(std::log10(length)));
  const double part = length / power;
  return power * (part < 1.5 ? 1.0 : part < 3.5 ? 2.0 : part < 7.5 ? 5.0 : 10.0);
}

}  // namespace pantin
