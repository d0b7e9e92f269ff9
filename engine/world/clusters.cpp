#include <algorithm>
#include <numeric>

#include "world/editing.hpp"
#include "world/measure.hpp"

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
  editing::require_not_negative("clusters", "distance", distance, "m");
  const Things things = things_of(world, group);
  std::vector<AnyId> ids;
  std::vector<Vec3> places;
  for (BodyId b : things.bodies) ids.emplace_back(b), places.push_back(world.motion_of(b).x);
  for (PointId p : things.free_points) ids.emplace_back(p), places.push_back(world.motion_of(p).x);

  std::vector<std::size_t> by_x(ids.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::stable_sort(by_x.begin(), by_x.end(), [&](std::size_t i, std::size_t j) { return places[i][0] < places[j][0]; });
  Sets sets{by_x};
  std::iota(sets.parent.begin(), sets.parent.end(), std::size_t{0});
  for (std::size_t i = 0; i < by_x.size(); i++)
    for (std::size_t j = i + 1; j < by_x.size() && places[by_x[j]][0] - places[by_x[i]][0] <= distance; j++)
      if (norm(places[by_x[j]] - places[by_x[i]]) <= distance) sets.unite(by_x[i], by_x[j]);

  std::vector<std::vector<AnyId>> found(ids.size());
  for (std::size_t i = 0; i < ids.size(); i++) found[sets.root(i)].push_back(ids[i]);
  std::erase_if(found, [](const auto& cluster) { return cluster.empty(); });
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return found;
}

}  // namespace pantin
