#include "player/lammps/near_distances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/bounds.hpp"
#include "base/near_positions.hpp"
#include "laws/run/sites.hpp"
#include "measure/measure.hpp"
#include "player/lammps/refused.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_looked_at = 100000;

Box box_of(const World& world) { return {world.settings.box.value_or(zero3())}; }

}  // namespace

bool NearDistances::are_apart(std::uint32_t a, std::uint32_t b) const {
  return system_.body_of[a] == 0 || system_.body_of[a] != system_.body_of[b];
}

NearDistances::NearDistances(const World& world, const LammpsSystem& system, LeftOut left_out)
    : world_(world), system_(system), left_out_(std::move(left_out)) {
  const Box box = box_of(world);
  std::vector<Vec3> positions;
  Bounds bounds;
  for (ParticleId id : system_.atoms) {
    positions.push_back(box.wrapped(position(world_, id)));
    bounds.add(positions.back());
  }
  const Vec3 size = world_.settings.box.value_or(bounds.high - bounds.low);
  double longest = std::max({size[0], size[1], size[2]}), volume = 1.0;
  if (longest == 0.0) longest = 1.0;
  const double count = static_cast<double>(positions.size());
  for (int k = 0; k < 3; k++) volume *= std::max(size[k], longest / count);
  nearest_ = spacing_ = 1.3 * std::cbrt(volume / count);
  const NearPositions grid(positions, spacing_);
  const std::size_t stride = std::max<std::size_t>(1, positions.size() / most_looked_at);
  std::size_t looked_at = 0, found = 0;
  for (std::uint32_t a = 0; a < positions.size(); a += static_cast<std::uint32_t>(stride), looked_at++)
    each_image(positions[a], [&](Vec3 image) {
      grid.each(image, [&](std::uint32_t b) {
        if (a == b || !are_apart(a, b)) return;
        if (note(a, b, norm(positions[b] - image))) found++;
      });
    });
  pairs_ = 0.5 * count * static_cast<double>(found) / static_cast<double>(looked_at);
}

bool NearDistances::note(std::uint32_t a, std::uint32_t b, double distance) {
  require(distance > 0.0, describe(world_, system_.atoms[a]), " and ", describe(world_, system_.atoms[b]),
          " are at one position; LAMMPS cannot have that");
  const auto i = static_cast<std::size_t>(system_.type_of[a] - 1), j = static_cast<std::size_t>(system_.type_of[b] - 1);
  nearest_ = std::min(nearest_, distance);
  if (left_out_(a, b)) return false;
  by_types_[{std::min(i, j), std::max(i, j)}].push_back(distance);
  return true;
}

/// Calls `visit` with the images of a position of the box from which something in it may be near.
template <class Visit>
void NearDistances::each_image(Vec3 x, Visit visit) const {
  const Vec3 edge = box_of(world_).edge;
  const auto first = [&](int k) { return edge[k] > 0.0 && x[k] >= edge[k] - spacing_ ? -1 : 0; };
  const auto last = [&](int k) { return edge[k] > 0.0 && x[k] <= spacing_ ? 1 : 0; };
  for (int i = first(0); i <= last(0); i++)
    for (int j = first(1); j <= last(1); j++)
      for (int k = first(2); k <= last(2); k++) visit(x + vec(i * edge[0], j * edge[1], k * edge[2]));
}

std::vector<double> NearDistances::of(const Interaction& row) const {
  std::vector<double> list;
  for (const auto& [types, near] : by_types_) {
    const FamilyId i = system_.types[types.first].family, j = system_.types[types.second].family;
    if ((i == row.a && j == row.b) || (i == row.b && j == row.a)) list.insert(list.end(), near.begin(), near.end());
  }
  return list.empty() ? of_some(row) : list;
}

std::vector<std::uint32_t> NearDistances::some_of(FamilyId family) const {
  constexpr std::size_t enough = 300;
  std::vector<std::uint32_t> all, some;
  for (std::uint32_t i = 0; i < system_.atoms.size(); i++)
    if (world_.particles[system_.atoms[i]].family == family) all.push_back(i);
  const std::size_t stride = std::max<std::size_t>(1, all.size() / enough);
  for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

std::vector<double> NearDistances::of_some(const Interaction& row) const {
  const Box box = box_of(world_);
  std::vector<double> list;
  for (const std::uint32_t a : some_of(row.a))
    for (const std::uint32_t b : some_of(row.b))
      if (a != b && are_apart(a, b) && !left_out_(a, b))
        list.push_back(norm(box.nearest(position(world_, system_.atoms[a]) - position(world_, system_.atoms[b]))));
  return list;
}

}  // namespace pantin::player
