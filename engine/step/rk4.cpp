#include "step/rk4.hpp"

#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "forces/velocity_kick.hpp"

namespace pantin::phases {

namespace {

constexpr double weights[] = {1.0, 2.0, 2.0, 1.0};

/// Accelerations of loose points at the present state, to `slopes.acceleration`.
void find_accelerations(World& world) {
  std::vector<Vec3>& a = world.slopes.acceleration;
  for (std::uint32_t slot : world.loose_points) {
    const Point& p = world.points.at_slot(slot);
    a[slot] = world.settings.gravity + p.force / p.mass;
  }
  if (!world.forces) return;
  const Forces& f = *world.forces;
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != Forces::none)
      a[f.point[i]] += (f.nonconservative ? f.sites.force[i] + f.sites.nonconservative_force[i] : f.sites.force[i]) *
                       f.inverse_mass[i];
}

/// Work of pushes and laws over dt [s] at the present velocities [J].
void post_work(World& world, double dt) {
  double open = 0.0, damper = 0.0;
  const Forces* f = world.forces.get();
  if (f && f->nonconservative)
    for (std::size_t i = 0; i < f->sites.n; i++)
      if (f->point[i] != Forces::none) {
        const Vec3 damping = damping_of(*f, i), v = world.free_motion[f->point[i]].v;
        damper += dot(damping, v);
        open += dot(f->sites.nonconservative_force[i] - damping, v);
      }
  if (f)
    for (const Receiver& m : f->receivers) {
      const Vec3 v = world.motion[m.slot].p / world.motion[m.slot].mass, spin = angular_velocity(world.motion[m.slot]);
      damper += dot(m.damper_force, v) + dot(m.damper_torque, spin);
      open += dot(m.nonconservative_force - m.damper_force, v) + dot(m.nonconservative_torque - m.damper_torque, spin);
    }
  world.nonconservative_work += open * dt;
  world.work += open * dt;
  world.ledger.posted += std::fabs(open * dt);
  post(world, Source::damper, damper * dt);
  post_present_laws(world, dt);
  if (!world.pushed) return;
  double pushed = 0.0;
  for (std::uint32_t slot : world.loose_points)
    pushed += dot(world.points.at_slot(slot).force, world.free_motion[slot].v);
  for (std::uint32_t slot : world.loose_bodies) {
    const Motion& m = world.motion[slot];
    pushed += dot(m.force, m.p / m.mass) + dot(m.torque, angular_velocity(m));
  }
  post(world, Source::event, pushed * dt);
}

/// Under a force [N] and a torque [N m], world axes.
BodyRate rate_of(const Motion& m, Vec3 force, Vec3 torque) {
  const Vec3 spin = m.angular * inverse_inertia(m);
  BodyRate rate{m.p / m.mass, force, cross(m.angular, spin) + rotate(conjugate(m.q), torque),
                m.q * Quat{0.0, 0.5 * spin[0], 0.5 * spin[1], 0.5 * spin[2]}};
  if (m.freedom == Freedom::line) rate.angular[0] = 0.0;
  return rate;
}

Quat sum(const Quat& a, const Quat& b, double weight) {
  return {a.w + b.w * weight, a.x + b.x * weight, a.y + b.y * weight, a.z + b.z * weight};
}

void add(BodyRate& total, const BodyRate& rate, double weight) {
  total.x += rate.x * weight;
  total.p += rate.p * weight;
  total.angular += rate.angular * weight;
  total.q = sum(total.q, rate.q, weight);
}

void move(Motion& m, const Motion& start, const BodyRate& rate, double dt) {
  m.x = start.x + rate.x * dt;
  m.p = start.p + rate.p * dt;
  m.angular = start.angular + rate.angular * dt;
  m.q = normalised(sum(start.q, rate.q, dt));
}

void move_points(World& world, std::size_t stage, double dt) {
  Slopes& s = world.slopes;
  for (std::size_t i = 0; i < world.loose_points.size(); i++) {
    const std::uint32_t slot = world.loose_points[i];
    FreeMotion& m = world.free_motion[slot];
    const FreeMotion rate = {m.v, s.acceleration[slot]}, start = world.saved_points[i];
    FreeMotion& sum = s.points[slot];
    if (stage == 0) sum = {zero3(), zero3()};
    sum.x += rate.x * weights[stage];
    sum.v += rate.v * weights[stage];
    const FreeMotion& slope = stage == 3 ? sum : rate;
    m = {start.x + slope.x * dt, start.v + slope.v * dt};
  }
}

/// Forces [N] and torques [N m] on loose bodies at the present state, to `slopes.forces` and `torques`.
void find_loads(World& world) {
  Slopes& s = world.slopes;
  for (std::uint32_t slot : world.loose_bodies) {
    const Motion& m = world.motion[slot];
    s.forces[slot] = world.settings.gravity * m.mass + m.force;
    s.torques[slot] = m.torque;
  }
  if (!world.forces) return;
  for (const Receiver& m : world.forces->receivers) {
    s.forces[m.slot] += m.force + m.nonconservative_force;
    s.torques[m.slot] += m.torque + m.nonconservative_torque;
  }
}

void move_bodies(World& world, std::size_t stage, double dt) {
  Slopes& s = world.slopes;
  for (std::size_t i = 0; i < world.loose_bodies.size(); i++) {
    const std::uint32_t slot = world.loose_bodies[i];
    Motion& m = world.motion[slot];
    const BodyRate rate = rate_of(m, s.forces[slot], s.torques[slot]);
    BodyRate& sum = s.bodies[slot];
    if (stage == 0) sum = {};
    add(sum, rate, weights[stage]);
    move(m, world.saved_motion[i], stage == 3 ? sum : rate, dt);
  }
}

/// Its steps are explicit: what velocities change faster than they can follow would gain.
void require_slow_change(World& world) {
  constexpr double limit = 2.5;  // it is stable to 2.785 of damping, and to 2.828 of turning
  if (!world.forces || !world.forces->velocity_dependent || !world.trouble.empty()) return;
  const double rate = fastest_change(world, *world.forces);
  if (rate * world.settings.step <= limit) return;
  world.trouble = text(place_of_integrator(world), "the integrator \"rk4\" cannot follow ",
                       velocity_laws(world, *world.forces), ", a force that damps or turns what moves at ", rate,
                       " per second in steps of ", world.settings.step, " s: \"verlet\" can, or a shorter scene.step");
}

}  // namespace

void take_rk4_stage(World& world) {
  const std::size_t stage = world.stage.index;
  if (stage == 0) require_slow_change(world);
  const double h = world.settings.step, dt = stage == 3 ? h / 6.0 : world.stage.h;
  Slopes& s = world.slopes;
  s.acceleration.resize(world.points.slots());
  s.points.resize(world.points.slots());
  s.forces.resize(world.bodies.slots());
  s.torques.resize(world.bodies.slots());
  s.bodies.resize(world.bodies.slots());
  find_accelerations(world);
  find_loads(world);
  post_work(world, weights[stage] * h / 6.0);
  move_points(world, stage, dt);
  move_bodies(world, stage, dt);
}

}  // namespace pantin::phases
