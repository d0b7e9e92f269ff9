// What the forces of the laws do to velocities and momenta.
#include <algorithm>

#include "articulates/articulate.hpp"
#include "forces/forces.hpp"
#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"
#include "forces/receiver_momenta.hpp"
#include "forces/tied_kick.hpp"
#include "forces/velocity_kick.hpp"
#include "world/share_blocks.hpp"

namespace pantin {

namespace {

/// Work of laws without energy [J].
struct NonconservativeWork {
  double damper = 0.0;  // of those that depend on velocities
  double rest = 0.0;

  double all() const { return damper + rest; }
  void operator+=(const NonconservativeWork& more) {
    damper += more.damper;
    rest += more.rest;
  }
};

/// Of the forces that kicks apply to the receiver alone.
NonconservativeWork nonconservative_work(const Receiver& m, Vec3 moved, Vec3 turned) {
  if (m.solved)
    return {0.0, dot(m.nonconservative_force - m.solved_force, moved) +
                     dot(m.nonconservative_torque - m.solved_torque, turned)};
  return {
      dot(m.damper_force, moved) + dot(m.damper_torque, turned),
      dot(m.nonconservative_force - m.damper_force, moved) + dot(m.nonconservative_torque - m.damper_torque, turned)};
}

/// Of what rows tie, and of all else.
struct KickWork {
  NonconservativeWork tied, loose;
};

/// Whether the velocities of what rows tie are without what these forbid: at the start of the kick that begins a part of
/// the step; after the projection that follows the kick at its end.
bool allowed_before(const World& world) { return rule_of(world).conserves && world.stage.first; }
bool allowed_after(const World& world) { return rule_of(world).conserves && world.stage.last; }

NonconservativeWork kick_points(World& world, Forces& f, double half) {
  NonconservativeWork work;
  FreeMotion* motion = world.free_motion.data();
  if (!f.nonconservative) {
    share_each(world, f.sites.n, [&](std::size_t i) {
      if (f.point[i] != Forces::none) motion[f.point[i]].v += f.sites.force[i] * (f.inverse_mass[i] * half);
    });
    return work;
  }
  const Vec3 fallen =
      world.settings.gravity * (0.5 * half);  // gravity has had its part of the kick: it is in both halves
  double with_gravity = 0.0;
  for (std::size_t i = 0; i < f.sites.n; i++) {
    if (f.point[i] == Forces::none) continue;
    Vec3& v = motion[f.point[i]].v;
    const Vec3 open = f.sites.nonconservative_force[i], change = (f.sites.force[i] + open) * (f.inverse_mass[i] * half);
    const Vec3 damping = damping_of(f, i), mean = v + change * 0.5 - fallen;
    with_gravity += dot(open, fallen) * half;
    work.damper += dot(damping, mean) * half;
    work.rest += dot(open - damping, mean) * half;
    // What is stopped is as it was solved: the sum would round it.
    v = f.velocity_dependent && f.velocity.theta[i] == 1.0 ? f.velocity.v[i] : v + change;
  }
  post_falling(world, with_gravity);
  return work;
}

KickWork kick_receivers(World& world, Forces& f, double half, bool drifted) {
  KickWork work;
  for (const Receiver& m : f.receivers) {
    if (sleeps(world, m)) continue;
    ReceiverMomenta s = momenta_of(world, m, drifted);
    const Vec3 v = s.velocity(), spin = s.spin();
    s.add((m.force + m.nonconservative_force - m.solved_force) * half,
          (m.torque + m.nonconservative_torque - m.solved_torque) * half);
    (m.articulate < 0 ? work.loose : work.tied) +=
        nonconservative_work(m, (v + s.velocity()) * (0.5 * half), (spin + s.spin()) * (0.5 * half));
  }
  return work;
}

/// What the present forces give to tied receivers over `dt` [s] at the present velocities.
NonconservativeWork present_work(World& world, const Forces& f, double dt, bool drifted) {
  NonconservativeWork work;
  for (const Receiver& m : f.receivers) {
    if (m.articulate < 0 || sleeps(world, m)) continue;
    const ReceiverMomenta s = momenta_of(world, m, drifted);
    work += nonconservative_work(m, s.velocity() * dt, s.spin() * dt);
  }
  return work;
}

void post_nonconservative(World& world, const NonconservativeWork& work) {
  world.work += work.rest;
  world.nonconservative_work += work.rest;
  world.ledger.posted += std::fabs(work.rest);
  post(world, Source::damper, work.damper);
}

/// Copies the velocities of sites that rows tie.
void copy_tied(const Forces& f, const AlignedVector<Vec3>& from, AlignedVector<Vec3>& to) {
  for (const Attached& a : f.attached)
    if (f.receivers[a.receiver].articulate >= 0) to[a.site] = from[a.site];
}

/// What the forces that the sites now have gave in a kick over `half` [s], with velocities that
/// changed evenly, [J].
double work_of(const Forces& f, const AlignedVector<Vec3>& before, const AlignedVector<Vec3>& after, double half) {
  double work = 0.0;
  for (std::size_t i = 0; i < f.sites.n; i++) work += dot(f.sites.force[i], before[i] + after[i]) * (0.5 * half);
  return work;
}

double work_on_tied(const Forces& f, const AlignedVector<Vec3>& before, const AlignedVector<Vec3>& after, double half) {
  double work = 0.0;
  for (const Attached& a : f.attached)
    if (f.receivers[a.receiver].articulate >= 0)
      work += dot(f.sites.force[a.site], before[a.site] + after[a.site]) * (0.5 * half);
  return work;
}

/// With the forces that sites have now, velocities that changed evenly, over `half` [s].
void post_laws(World& world, Forces& f, const AlignedVector<Vec3>& before, const AlignedVector<Vec3>& after,
               double half) {
  if (!world.ledger.kept) return;
  const double work = work_of(f, before, after, half);
  world.ledger.laws += work;
  world.ledger.posted += std::fabs(work);
  const KeptForces kept(f.sites);
  each_element(f, [&](ActingElement& a) {
    if (!a.law->has_energy()) return;
    std::fill(f.sites.force.begin(), f.sites.force.end(), zero3());
    run_law(world, f, a, instant_of(world, world.time, world.instant));
    world.ledger.kicks[a.name(world)] += work_of(f, before, after, half);
  });
}

/// What kicks gave to motions that the rows forbid.
void post_forbidden(World& world, double joules) {
  world.ledger.given[static_cast<std::size_t>(Source::projection)] += joules;
  world.ledger.posted += std::fabs(joules);
}

}  // namespace

AlignedVector<Vec3> site_velocities(World& world, bool drifted) {
  AlignedVector<Vec3> list;
  if (!world.ledger.kept || !world.forces) return list;
  Forces& f = *world.forces;
  list.assign(f.sites.n, zero3());
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != Forces::none) list[i] = world.free_motion[f.point[i]].v;
  for (const Attached& a : f.attached) {
    const ReceiverMomenta s = momenta_of(world, f.receivers[a.receiver], drifted);
    list[a.site] = s.velocity() + cross(s.spin(), a.r);
  }
  return list;
}

void post_laws_beside_kicks(World& world, const AlignedVector<Vec3>& before) {
  if (before.size() == 0) return;
  AlignedVector<Vec3> less;
  less.assign(before.size(), zero3());
  for (std::size_t i = 0; i < before.size(); i++) less[i] = before[i] * -1.0;
  post_laws(world, *world.forces, less, site_velocities(world, world.stage.index > 0), world.stage.h);
}

void post_displacements(World& world, const AlignedVector<Vec3>& ways) {
  Forces& f = *world.forces;
  post(world, Source::push_out, -work_of(f, ways, ways, 1.0));
  post_laws(world, f, ways, ways, 1.0);
}

void post_tied(World& world, const TiedWork& work) {
  post_nonconservative(world, {work.damper, work.rest});
  post(world, Source::hand, work.rows.anchors);
  post(world, Source::motor, work.rows.angular_rows);
}

void kick(World& world, double half) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  const bool drifted = world.stage.index > 0, allowed = allowed_before(world);
  for (Receiver& m : f.receivers) {
    if (drifted) break;
    const ReceiverMomenta s = momenta_of(world, m, false);
    m.start_p = s.v ? *s.v : *s.p;
    m.start_P = s.P ? *s.P : zero3();
  }
  if (f.velocity_dependent) {
    solve_velocity_kick(world, f, half, time_within(world, world.stage.from), {drifted, true});
    post_tied(world, kick_tied(world, f));
  }
  const AlignedVector<Vec3> before = site_velocities(world, drifted);
  const NonconservativeWork present = present_work(world, f, half, drifted);
  NonconservativeWork told = kick_points(world, f, half);
  const KickWork given = kick_receivers(world, f, half, drifted);
  told += given.loose;
  told += allowed ? present : given.tied;
  post_nonconservative(world, told);
  AlignedVector<Vec3> after = site_velocities(world, drifted);
  if (allowed && world.ledger.kept) {
    post_forbidden(world, given.tied.all() - present.all() + work_on_tied(f, before, after, half) -
                              work_on_tied(f, before, before, half));
    copy_tied(f, before, after);
  }
  post_laws(world, f, before, after, half);
}

void kick_from_rest(World& world, const std::vector<char>& woken, double half) {
  double given = 0.0;
  NonconservativeWork others;
  for (const Receiver& m : world.forces->receivers) {
    if (m.articulate < 0 || !woken[static_cast<std::size_t>(m.articulate)]) continue;
    const NodePull& pull = world.articulates[static_cast<std::size_t>(m.articulate)]->rest.pulls[m.node];
    const Vec3 force = pull.force + pull.nonconservative_force, torque = pull.torque + pull.nonconservative_torque;
    ReceiverMomenta s = momenta_of(world, m, true);
    s.add(force * half, torque * half);
    given += (dot(pull.force, s.velocity()) + dot(pull.torque, s.spin())) * (0.5 * half);
    others.rest +=
        (dot(pull.nonconservative_force, s.velocity()) + dot(pull.nonconservative_torque, s.spin())) * (0.5 * half);
    s.add(force * (-2.0 * half), torque * (-2.0 * half));  // the drift turns what the rows forbid
  }
  post_nonconservative(world, others);
  world.ledger.laws += given;
  world.ledger.posted += std::fabs(given);
}

void post_present_laws(World& world, double dt) {
  if (!world.forces) return;
  const AlignedVector<Vec3> present = site_velocities(world, false);
  post_laws(world, *world.forces, present, present, dt);
}

void put_back(World& world) {
  for (std::size_t i = 0; i < world.loose_points.size(); i++)
    world.free_motion[world.loose_points[i]] = world.saved_points[i];
  for (std::size_t i = 0; i < world.loose_bodies.size(); i++)
    world.motion[world.loose_bodies[i]] = world.saved_motion[i];
  if (world.forces)
    for (const Receiver& m : world.forces->receivers) {
      ReceiverMomenta s = momenta_of(world, m, false);
      (s.v ? *s.v : *s.p) = m.start_p;
      if (s.P) *s.P = m.start_P;
    }
  for (const TiedStart& s : world.tied_starts) {
    (s.is_body ? world.motion[s.slot].p : world.free_motion[s.slot].v) = s.p;
    if (s.is_body) world.motion[s.slot].angular = s.P;
  }
}

void kick_to_end(World& world, double half) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  if (f.velocity_dependent) solve_velocity_kick(world, f, half, time_within(world, world.stage.to), {true, false});
  f.kicked_from = site_velocities(world, true);
  NonconservativeWork told = kick_points(world, f, half);
  const KickWork given = kick_receivers(world, f, half, true);
  told += given.loose;
  if (!allowed_after(world)) told += given.tied;
  post_nonconservative(world, told);
  const AlignedVector<Vec3> after = site_velocities(world, true);
  if (!allowed_after(world)) {
    post_tied(world, kick_tied(world, f));
    return post_laws(world, f, f.kicked_from, after, half);
  }
  if (world.ledger.kept) post_forbidden(world, given.tied.all() + work_on_tied(f, f.kicked_from, after, half));
}

void end_kick(World& world, double half) {
  if (!world.forces || !allowed_after(world)) return;
  Forces& f = *world.forces;
  const NonconservativeWork present = present_work(world, f, half, true);
  post_nonconservative(world, present);
  const AlignedVector<Vec3> after = site_velocities(world, true);
  post_tied(world, kick_tied(world, f));
  if (!world.ledger.kept) return;
  post_forbidden(world, -present.all() - work_on_tied(f, after, after, half));
  copy_tied(f, after, f.kicked_from);
  post_laws(world, f, f.kicked_from, after, half);
}

}  // namespace pantin
