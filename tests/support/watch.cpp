#include "support/watch.hpp"

#include <algorithm>
#include <cmath>

#include "measure/measure.hpp"
#include "step/step.hpp"

namespace pantin {

Watched watch(World& world, double time, const std::function<void()>& each) {
  Watched course;
  const double start = energy(world).total();
  while (world.failure.empty() && world.time < time - 0.5 * world.settings.step) {
    step(world);
    const Energy now = energy(world);
    course.kinetic = std::max(course.kinetic, now.kinetic);
    course.energy_change = std::max(course.energy_change, std::fabs(now.total() - start));
    course.gap = std::max(course.gap, largest_gap(world));
    course.finite = course.finite && all_finite(world);
    if (each) each();
  }
  course.failure = world.failure;
  return course;
}

double largest_gap(const World& world) {
  double gap = 0.0;
  for (const ParticleId id : world.particles.ids()) {
    const Particle& ring = world.particles[id];
    if (!ring.is_hinge()) continue;
    const Vec3 first = position(world, ring.points.front());
    for (const PointId point : ring.points) gap = std::max(gap, norm(position(world, point) - first));
  }
  for (const ConstraintId id : world.constraints.ids()) {
    const Constraint& c = world.constraints[id];
    if (c.kind == ConstraintKind::nail) gap = std::max(gap, norm(position(world, c.a) - c.position.now));
  }
  return gap;
}

bool all_finite(const World& world) {
  for (const BodyId id : world.bodies.ids()) {
    const Motion& m = world.motion_of(id);
    if (!finite(m.x) || !finite(m.p) || !finite(m.angular) || !std::isfinite(m.q.w + m.q.x + m.q.y + m.q.z))
      return false;
  }
  const std::vector<PointId> points = world.points.ids();
  return std::all_of(points.begin(), points.end(),
                     [&](PointId id) { return finite(position(world, id)) && finite(velocity(world, id)); });
}

double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double a = 0.0, b = 0.0, aa = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < x.size(); i++) {
    const double u = std::log(x[i]), v = std::log(y[i]);
    a += u;
    b += v;
    aa += u * u;
    ab += u * v;
  }
  return (n * ab - a * b) / (n * aa - a * a);
}

}  // namespace pantin
