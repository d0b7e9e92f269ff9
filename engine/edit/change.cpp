#include <utility>

#include "articulates/articulate.hpp"
#include "articulates/solve/state.hpp"
#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "edit/life.hpp"
#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "measure/measure.hpp"

namespace pantin {

using namespace internal;

namespace {

void require_free(const World& world, const char* call, PointId point) {
  const BodyId body = world.points[point].body;
  require(!body, call, ": ", describe(world, point), " moves with its body; change ", body ? describe(world, body) : "",
          " instead");
}

/// Changes a thing and counts the energy that this made.
template <class Id, class Change>
void counted(World& world, Id id, Change change) {
  acted(world);
  const double before = energy_of(world, id);
  change();
  post(world, Source::edit, energy_of(world, id) - before);
}

/// The same of its position.
template <class Id, class Change>
void moved(World& world, Id id, Change change) {
  disturb_sites(world);
  counted(world, id, change);
  disturb(world, id);
}

/// The same of its velocity.
template <class Id, class Change>
void hurried(World& world, Id id, Change change) {
  disturb_forces_by_motion(world);
  counted(world, id, change);
  disturb(world, id);
}

/// Changes what a body weighs; where that makes no body, `undo` puts it back.
template <class Change, class Undo>
void reweigh(World& world, BodyId body, Change change, Undo undo) {
  acted(world);
  disturb_sites(world);
  const double before = energy_of(world, body);
  change();
  try {
    update_mass(world, body);
  } catch (const Error&) {
    undo();
    throw;
  }
  post(world, Source::edit, energy_of(world, body) - before);
  mark_edited(world, body);
}

/// Whether nothing can be said against a vec. What a thing is called takes longer than to move it, so it is asked last.
bool harmless(const World& world, Vec3 v) { return finite(v) && !world.plane.flat(); }

void check_position(const World& world, const auto& thing, const char* name, Vec3 at, Vec3 present) {
  if (harmless(world, at)) return;
  require_finite(describe(world, thing), name, at, "m");
  require_height(world, describe(world, thing), name, at, present);
}

void check_velocity(const World& world, const auto& thing, Vec3 velocity) {
  if (harmless(world, velocity)) return;
  require_finite(describe(world, thing), "velocity", velocity, "m/s");
  require_in_plane(world, describe(world, thing), "velocity", velocity, "m/s");
}

Vec3 angular_for(const Motion& m, Vec3 spin) { return m.inertia * turning_part(m, spin); }

}  // namespace

void set_position(World& world, PointId point, Vec3 at) {
  require_unlocked(world, "position");
  require_free(world, "position", point);
  Vec3& x = world.motion_of(point).x;
  check_position(world, point, "position", at, x);
  moved(world, point, [&] { x = world.plane.beside(at, x); });
}

void set_velocity(World& world, PointId point, Vec3 velocity) {
  require_unlocked(world, "velocity");
  require_free(world, "velocity", point);
  check_velocity(world, point, velocity);
  hurried(world, point, [&] { world.motion_of(point).v = world.plane.along(velocity); });
}

void set_mass(World& world, PointId id, double mass) {
  require_unlocked(world, "mass");
  Point& point = world.points[id];
  const double old = point.mass;
  if (point.body) {
    require_not_negative(describe(world, id), "mass", mass, "kg");
    reweigh(
        world, point.body, [&] { point.mass = mass; }, [&] { point.mass = old; });
  } else {
    require_positive(describe(world, id), "mass", mass, "kg");
    disturb_site(world, point.particle);
    counted(world, id, [&] { point.mass = mass; });
    mark_edited(world, id);
  }
}

void set_position(World& world, BodyId body, Vec3 centre) {
  require_unlocked(world, "position");
  Vec3& x = world.motion_of(body).x;
  check_position(world, body, "position", centre, x);
  moved(world, body, [&] { x = world.plane.beside(centre, x); });
}

void set_origin(World& world, BodyId body, Vec3 origin) {
  require_unlocked(world, "origin");
  Vec3& x = world.motion_of(body).x;
  check_position(world, body, "origin", origin, pantin::origin(world, body));
  const Vec3 centre = origin + rotate(orientation(world, body), world.bodies[body].centre);
  moved(world, body, [&] { x = world.plane.beside(centre, x); });
}

void set_orientation(World& world, BodyId body, Quat orientation) {
  require_unlocked(world, "orientation");
  const Quat frame = unit(describe(world, body), orientation);
  require_turn(world, describe(world, body), body, frame);
  moved(world, body, [&] {
    Motion& m = world.motion_of(body);
    const Vec3 spin = angular_velocity(m);
    m.q = world.plane.about(normalised(frame * world.bodies[body].axes));
    m.angular = angular_for(m, spin);
  });
}

void set_velocity(World& world, BodyId body, Vec3 velocity) {
  require_unlocked(world, "velocity");
  check_velocity(world, body, velocity);
  hurried(world, body, [&] {
    Motion& m = world.motion_of(body);
    m.p = world.plane.along(velocity) * m.mass;
  });
}

void set_spin(World& world, BodyId body, Vec3 spin) {
  require_unlocked(world, "spin");
  if (!harmless(world, spin)) {
    require_finite(describe(world, body), "spin", spin, "rad/s");
    require_about_normal(world, describe(world, body), "spin", spin, "rad/s");
  }
  hurried(world, body, [&] {
    Motion& m = world.motion_of(body);
    m.angular = angular_for(m, spin);
  });
}

void set_lifetime(World& world, ParticleId id, double lifetime) {
  require_unlocked(world, "lifetime");
  require_positive_or_infinite(describe(world, id), "lifetime", lifetime, "s");
  world.particles[id].lifetime = lifetime;
  await_end(world, id);
}

void set_own_mass(World& world, BodyId id, double mass) {
  require_unlocked(world, "mass");
  require_not_negative(describe(world, id), "mass", mass, "kg");
  Body& body = world.bodies[id];
  const double old = body.own_mass;
  reweigh(
      world, id, [&] { body.own_mass = mass; }, [&] { body.own_mass = old; });
}

void set_own_inertia(World& world, BodyId id, const Mat3& inertia) {
  require_unlocked(world, "inertia");
  require_inertia(describe(world, id), inertia);
  Body& body = world.bodies[id];
  const Mat3 old = body.own_inertia;
  reweigh(
      world, id, [&] { body.own_inertia = inertia; }, [&] { body.own_inertia = old; });
}

void set_gravity(World& world, Vec3 gravity) {
  require_unlocked(world, "gravity");
  require_finite("scene", "gravity", gravity, "m/s²");
  acted(world);
  const double before = energy(world).potential;
  world.settings.gravity = world.plane.along(gravity);
  wake_all(world);
  post(world, Source::edit, energy(world).potential - before);
}

void set_box(World& world, std::optional<Vec3> box) {
  require_unlocked(world, "box");
  for (int i = 0; box && i < 3; i++) require_positive("scene", "box", (*box)[i], "m");
  disturb_forces(world);
  world.settings.box = box;
  world.stiffness_unknown = true;
}

void set_integrator(World& world, Integrator integrator) {
  require_unlocked(world, "integrator");
  require_integrator(integrator);
  const Integrator before = std::exchange(world.settings.integrator, integrator);
  try {
    require_integrator_fits(world);
  } catch (const Error&) {
    world.settings.integrator = before;
    throw;
  }
  world.integrator_from = world.who ? world.who() : "";
  if (integrator == before) return;
  disturb_forces(world);
  world.stiffness_unknown = true;
  for (const auto& articulate : world.articulates) articulate->symmetric_h = 0.0;
}

void set_accuracy(World& world, std::optional<double> accuracy) {
  require_unlocked(world, "accuracy");
  if (accuracy) require_positive("scene", "accuracy", *accuracy, "1/s");
  const std::optional<double> before = std::exchange(world.settings.accuracy, accuracy);
  try {
    require_integrator_fits(world);
  } catch (const Error&) {
    world.settings.accuracy = before;
    throw;
  }
  world.mean_error = world.error_span = 0.0;
  if (accuracy) return;
  world.sub_steps = {};
  for (const auto& articulate : world.articulates) {
    articulate->sub_steps = {};
    articulate->error_by_jerk = 0.0F;
  }
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++) world.motion[s].sub_steps = {};
}

void set_accuracy_per_step(World& world, bool per_step) {
  require_unlocked(world, "accuracy_per");
  world.settings.accuracy_per_step = per_step;
}

void set_step(World& world, double step) {
  require_unlocked(world, "step");
  require_step(step);
  acted(world);
  world.settings.step = step;
  world.stiffness_unknown = true;
  world.step_origin = world.time;
  world.step_count = 0;
  // Three samples of a target at two distances in time give no velocity.
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++)
    if (world.constraints.alive_at(s)) world.constraints.at_slot(s).moves = 0;
}

}  // namespace pantin
