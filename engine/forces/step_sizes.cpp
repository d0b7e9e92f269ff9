#include "forces/step_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "forces/forces_parts.hpp"

namespace pantin {

void find_partners(World& world, Forces& f) {
  const Box box = box_of(world);
  f.notes.partner.assign(world.particles.slots(), Forces::none);
  std::vector<double> least(f.sites.n, infinity);
  const auto meet = [&](std::uint32_t i, std::uint32_t j, double square) {
    if (!(square < least[i])) return;
    least[i] = square;
    f.notes.partner[f.sites.particle[i]] = f.sites.particle[j];
  };
  for (const ActingInteraction& a : f.interactions)
    each_pair(a.pairs.neighbours, f.sites, [&](std::uint32_t i, std::uint32_t j) {
      const double square = norm2(box.nearest(f.sites.x[j] - f.sites.x[i]));
      meet(i, j, square);
      meet(j, i, square);
    });
}

namespace {

double displacement_along(Vec3 change, Vec3 moved) { return std::fabs(dot(change, moved)) / norm(change); }

}  // namespace

double stiffness_along(Vec3 change, Vec3 moved) {
  const double size = norm(change);
  return size > 0.0 ? size / displacement_along(change, moved) : 0.0;
}

double swing_by(double stiffness, Vec3 change, Vec3 moved, double h) {
  return stiffness > 0.0 ? displacement_along(change, moved) / (h * std::sqrt(stiffness)) : 0.0;
}

}  // namespace pantin
