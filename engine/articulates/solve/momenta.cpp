#include "articulates/solve/momenta.hpp"

#include <algorithm>

#include "articulates/solve/state.hpp"

namespace pantin {

namespace {

void add_rigid_motion(Articulate& a, Vec3 X, Vec3 velocity, Vec3 spin) {
  for (Node& n : a.nodes) {
    n.p0 += (velocity + cross(spin, n.x0 - X)) * n.mass;
    if (!n.turns) continue;
    n.P0 += n.inertia * transposed_times(n.R0, spin) * n.felt_axes;
    n.spin0 = n.inverse_inertia * n.P0;
  }
}

}  // namespace

bool is_free(const Articulate& a) {
  return std::all_of(a.rows.begin(), a.rows.end(), [&](const Row& row) {
    return row.b >= 0 || (row.condition >= 0 && condition(a, row).turns_axis);
  });
}

Vec3 centre_of_mass(const Articulate& a) {
  const Vec3 first = a.nodes[0].x0;
  Vec3 moment = zero3();
  for (const Node& n : a.nodes) moment += (n.x0 - first) * n.mass;
  return first + moment / a.total_mass;
}

Momenta momenta_of(const Articulate& a) {
  const Vec3 X = centre_of_mass(a);
  Momenta m{.energy = kinetic_energy(a)};
  for (const Node& n : a.nodes) {
    m.p += n.p0;
    m.angular += cross(n.x0 - X, n.p0);
    if (n.turns) m.angular += n.R0 * n.P0;
  }
  return m;
}

Vec3 spin_for(const Articulate& a, Vec3 X, Vec3 angular, double most) {
  Mat3 inertia = zero33();
  for (const Node& n : a.nodes) add_locked_inertia(inertia, n, X);
  const auto about = [&](Vec3 axis, double moment) {
    const double along = dot(axis, angular);
    return along * along <= 2.0 * most * moment && moment > 0.0 ? axis * (along / moment) : zero3();
  };
  if (a.plane.flat()) {
    const Vec3 normal = direction(a.plane.about(vec(1, 1, 1)));
    return about(normal, dot(normal, inertia * normal));
  }
  const Principal principal = principal_axes(inertia, identity33());
  Vec3 spin = zero3();
  for (int i = 0; i < 3; i++) spin += about(principal.axes[i], principal.moments[i]);
  return spin;
}

Vec3 angular_momentum_at_distance(const Articulate& a, double h) {
  Vec3 sum = zero3();
  for (const Row& row : a.rows)
    if (row.lever == 0.0) sum += cross(row.d0 + row.d1, row.f) * (0.5 * h);
  return sum;
}

double restore_momenta(Articulate& a, const Momenta& wanted) {
  const Vec3 X = centre_of_mass(a);
  const double before = kinetic_energy(a);
  for (int i = 0; i < 2; i++) {  // the second takes round-off out
    const Momenta now = momenta_of(a);
    const Vec3 spin = spin_for(a, X, wanted.angular - now.angular, std::max(before, wanted.energy));
    add_rigid_motion(a, X, (wanted.p - now.p) / a.total_mass, spin);
  }
  return kinetic_energy(a) - before;
}

}  // namespace pantin
