#include <algorithm>
#include <numeric>

#include "base/stable.hpp"
#include "measure/measure.hpp"
#include "measure/near_pairs.hpp"
#include "world/checks.hpp"

namespace pantin {
namespace {

/// Union-find with path halving (Tarjan and van Leeuwen 1984); the smaller index is the root.
struct Sets {
  std::vector<std::size_t> parent;

  std::size_t root(std::size_t i) {
    for (; parent[i] != i; i = parent[i]) parent[i] = parent[parent[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) {
    i = root(i);
    j = root(j);
    parent[std::max(i, j)] = std::min(i, j);
  }
};

}  // namespace

std::vector<std::vector<AnyId>> clusters(const World& world, GroupId group, double distance) {
  internal::require_not_negative("clusters", "distance", distance, "m");
  const Things things = things_of(world, group);
  std::vector<AnyId> ids;
  std::vector<Vec3> positions;
  for (BodyId b : things.bodies) ids.emplace_back(b), positions.push_back(world.motion_of(b).x);
  for (PointId p : things.free_points) ids.emplace_back(p), positions.push_back(world.motion_of(p).x);
  Sets sets{std::vector<std::size_t>(ids.size())};
  std::iota(sets.parent.begin(), sets.parent.end(), std::size_t{0});
  const Box box{world.settings.box.value_or(zero3())};
  each_near_pair(positions, box, distance, [&](std::uint32_t a, std::uint32_t b) { sets.unite(a, b); });

  std::vector<std::vector<AnyId>> found(ids.size());
  for (std::size_t i = 0; i < ids.size(); i++) found[sets.root(i)].push_back(ids[i]);
  std::erase_if(found, [](const auto& cluster) { return cluster.empty(); });
  sort_stably(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return found;
}

}  // namespace pantin
