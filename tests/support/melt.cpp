#include "support/melt.hpp"

#include <cstdint>
#include <cstring>

namespace pantin::cases {

namespace {

constexpr double cell = 1.6795961913825073;  // (4 / 0.8442)^(1/3) as LAMMPS rounds it

struct ParkMiller {
  std::int64_t state;
  double next() {
    state = 16807 * state % 2147483647;
    return static_cast<double>(state) * (1.0 / 2147483647);
  }
};

/// Jenkins' one-at-a-time hash of the bytes, which count as signed.
std::int64_t seed_of(Vec3 position) {
  constexpr std::int32_t seed = 87287;
  const double coordinates[3] = {position[0], position[1], position[2]};
  signed char bytes[sizeof seed + sizeof coordinates];
  std::memcpy(bytes, &seed, sizeof seed);
  std::memcpy(bytes + sizeof seed, coordinates, sizeof coordinates);
  std::uint32_t hash = 0;
  for (const signed char byte : bytes) {
    hash += static_cast<std::uint32_t>(byte);
    hash += hash << 10;
    hash ^= hash >> 6;
  }
  hash += hash << 3;
  hash ^= hash >> 11;
  hash += hash << 15;
  const std::uint32_t result = hash & 0x7ffffff;
  return result == 0 ? 1 : result;
}

Vec3 velocity_at(Vec3 position) {
  ParkMiller random{seed_of(position)};
  for (int i = 0; i < 5; i++) random.next();
  Vec3 v = zero3();
  for (int k = 0; k < 3; k++) v[k] = random.next() - 0.5;
  return v;
}

}  // namespace

Melt::Melt(int cells) : edge(cells * cell) {
  for (int z = 0; z < cells; z++)
    for (int y = 0; y < cells; y++)
      for (int x = 0; x < cells; x++)
        for (const Vec3 corner : {vec(0, 0, 0), vec(0.5, 0.5, 0), vec(0.5, 0, 0.5), vec(0, 0.5, 0.5)})
          positions.push_back((vec(x, y, z) + corner) * cell);
  const auto n = static_cast<double>(positions.size());
  Vec3 mean = zero3();
  for (const Vec3 position : positions) {
    velocities.push_back(velocity_at(position));
    mean += velocities.back();
  }
  mean /= zero3() + n;
  double sum = 0.0;
  for (Vec3& v : velocities) {
    v -= mean;
    sum += norm2(v);
  }
  const double scale = std::sqrt(1.44 * (3.0 * n - 3.0) / sum);
  for (Vec3& v : velocities) v *= scale;
}

}  // namespace pantin::cases
