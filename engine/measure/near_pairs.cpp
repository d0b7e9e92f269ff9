#include "measure/near_pairs.hpp"

#include <algorithm>
#include <vector>

#include "base/near_positions.hpp"

namespace pantin {

namespace {

/// Calls `visit` with each image of a position of the box that is in it, or at most `distance` out of it.
template <class Visit>
void each_image(Vec3 position, const Box& box, double distance, const Visit& visit) {
  const int most = box.periodic() ? 1 : 0;
  const auto is_near = [&](Vec3 x) {
    for (int k = 0; k < 3; k++)
      if (x[k] < -distance || x[k] > box.edge[k] + distance) return false;
    return true;
  };
  for (int i = -most; i <= most; i++)
    for (int j = -most; j <= most; j++)
      for (int k = -most; k <= most; k++) {
        const Vec3 image = position + vec(i * box.edge[0], j * box.edge[1], k * box.edge[2]);
        if (most == 0 || is_near(image)) visit(image);
      }
}

}  // namespace

void each_near_pair(std::span<const Vec3> positions, const Box& box, double distance,
                    const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  std::vector<Vec3> wrapped;
  for (Vec3 position : positions) wrapped.push_back(box.wrapped(position));
  const NearPositions grid(wrapped, distance);
  std::vector<std::uint32_t> near;
  for (std::uint32_t a = 0; a < wrapped.size(); a++) {
    near.clear();
    each_image(wrapped[a], box, distance, [&](Vec3 image) {
      grid.each(image, [&](std::uint32_t b) {
        if (b > a) near.push_back(b);
      });
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (std::uint32_t b : near) visit(a, b);
  }
}

}  // namespace pantin
