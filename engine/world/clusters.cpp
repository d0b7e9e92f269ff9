#include <algorithm>
#include <limits>
#include <numeric>

#include "laws/sites.hpp"
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
  const Box box{world.settings.box.value_or(zero3())};
  for (BodyId b : things.bodies) ids.emplace_back(b), places.push_back(box.wrapped(world.motion_of(b).x));
  for (PointId p : things.free_points) ids.emplace_back(p), places.push_back(box.wrapped(world.motion_of(p).x));

  std::vector<std::size_t> by_x(ids.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::stable_sort(by_x.begin(), by_x.end(), [&](std::size_t i, std::size_t j) { return places[i][0] < places[j][0]; });
  Sets sets{by_x};
  std::iota(sets.parent.begin(), sets.parent.end(), std::size_t{0});
  const double round = box.periodic() ? box.edge[0] : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < by_x.size(); i++)
    for (std::size_t k = i + 1; k < i + by_x.size(); k++) {
      const std::size_t a = by_x[i], b = by_x[k % by_x.size()];
      if (!(places[b][0] - places[a][0] + (k < by_x.size() ? 0.0 : round) <= distance)) break;
      if (norm(box.nearest(places[b] - places[a])) <= distance) sets.unite(a, b);
    }

  std::vector<std::vector<AnyId>> found(ids.size());
  for (std::size_t i = 0; i < ids.size(); i++) found[sets.root(i)].push_back(ids[i]);
  std::erase_if(found, [](const auto& cluster) { return cluster.empty(); });
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return found;
}

}  // namespace pantin
