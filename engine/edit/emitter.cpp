#include "edit/emitter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/functions.hpp"
#include "base/rotation.hpp"
#include "edit/common.hpp"
#include "edit/life.hpp"
#include "forces/curves.hpp"

namespace pantin {

using namespace internal;

namespace {

constexpr double most_at_once = 1e6;  // particles of one emitter in one step: more is a slip of the pen
constexpr double most_alive = 1e7;    // of one emitter: more than memory holds
constexpr std::uint64_t draws = 8;    // random numbers of one particle

void require_rate(std::string_view call, double rate) { require_not_negative(call, "rate", rate, "1/s"); }

void require_few(const World& world, const std::string& who, const Emitter& e, double due) {
  require(due <= most_at_once, who, ": rate must be at most ", most_at_once / world.settings.step, " 1/s, which is ",
          most_at_once, " particles in a step of ", world.settings.step, " s, got ", e.rate, " 1/s");
  const double alive = std::fmin(static_cast<double>(e.count) + due, static_cast<double>(e.max));
  require(alive <= most_alive, who, ": more than ", most_alive,
          " of its particles would live at once; give it a lifetime or a max, or a rate below ", e.rate, " 1/s");
}

std::string acting(const World& world) { return world.who ? world.who() : ""; }

void require_spread(std::string_view call, double spread) {
  require(spread >= 0.0 && spread <= std::numbers::pi, call, ": spread must be from 0 to pi rad, got ", spread);
}

void require_lifetimes(std::string_view call, double shortest, double longest) {
  require_positive_or_infinite(call, "lifetime", shortest, "s");
  require(longest >= shortest, call, ": the longest lifetime must not be below the shortest, got ", shortest, " and ",
          longest, " s");
  require(std::isfinite(longest) || longest == shortest, call, ": the longest lifetime must be finite, got ", longest,
          " s");
}

void require_max(std::string_view call, std::uint64_t max) { require(max > 0, call, ": max must be > 0, got 0"); }

void place_at(const World& world, std::string_view call, const EmitterPosition& position, Emitter& row) {
  require_finite(call, "at", position.at, "m");
  const Vec3 to = position.to.value_or(position.at);
  require_finite(call, "at", to, "m");
  if (position.point) (void)world.points[position.point];
  row.point = position.point;
  for (int i = 0; i < 3; i++) {
    row.lower[i] = std::fmin(position.at[i], to[i]);
    row.upper[i] = std::fmax(position.at[i], to[i]);
  }
}

/// The rate changes at the present time: what was due of the next particle until now stays due.
void rebase(Emitter& e, double now) {
  e.phase += e.rate * (now - e.origin) - static_cast<double>(e.since);
  e.since = 0;
  e.origin = now;
}

template <class Change>
void change_rate(World& world, EmitterId id, const char* call, Change change) {
  require_unlocked(world, call);
  Emitter& e = world.emitters[id];
  if (e.enabled && !e.rate_at) rebase(e, world.time);
  e.origin = world.time;
  change(e);
}

/// A direction within the cone about v, or its section with the plane, with v's length.
Vec3 spread_out(const Plane& plane, Vec3 v, double spread, double u1, double u2) {
  const double speed = norm(v);
  if (spread == 0.0 || speed == 0.0) return v;
  if (plane.flat()) {
    const double aside = spread * (2.0 * u1 - 1.0);
    return v * functions::cos(aside) + cross(plane.about(vec(1, 1, 1)), v) * functions::sin(aside);
  }
  const double c = 1.0 - u1 * (1.0 - functions::cos(spread)), s = std::sqrt(std::fmax(0.0, 1.0 - c * c));
  const double angle = 2.0 * std::numbers::pi * u2;
  const Vec3 along = v / speed, side = direction(cross(along, std::fabs(along[1]) < 0.9 ? vec(0, 1, 0) : vec(1, 0, 0)));
  return (along * c + side * (s * functions::cos(angle)) + cross(along, side) * (s * functions::sin(angle))) * speed;
}

/// Where and how the emitter is at the start of the step, and on what it turns.
struct Base {
  Vec3 x = zero3(), v = zero3();
  Vec3 arm = zero3(), spin = zero3();

  /// After a time [s], as what nothing pushes goes on.
  Base after(double time) const {
    const Vec3 turned = rotate(quaternion_of(spin * time), arm), centre = v - cross(spin, arm);
    return {x + (centre * time + (turned - arm)), centre + cross(spin, turned), turned, spin};
  }
};

Base base_of(const World& world, PointId point) {
  Base base = {position(world, point), velocity(world, point)};
  if (const BodyId body = world.points[point].body) {
    base.arm = base.x - world.motion_of(body).x;
    base.spin = angular_velocity(world.motion_of(body));
  }
  return base;
}

/// Makes the particle that is born at `time` [s], where the emitter is `base`; `end` is that of the step.
void make(World& world, EmitterId id, const Base& base, double time, double end) {
  Emitter& e = world.emitters[id];
  Random random{Random{world.settings.seed, e.serial}.bits(), e.due * draws};
  e.due++;
  if (e.count >= e.max) return;
  Vec3 at = base.x;
  for (int i = 0; i < 3; i++) at[i] += e.lower[i] + (e.upper[i] - e.lower[i]) * random.uniform();
  const double u1 = random.uniform(), u2 = random.uniform();
  const Vec3 v = base.v + spread_out(world.plane, e.velocity, e.spread, u1, u2);
  const double lifetime =
      e.longest > e.shortest ? e.shortest + (e.longest - e.shortest) * random.uniform() : e.shortest;
  e.made++;
  if (time + lifetime <= end) return;  // it lives between two moments that are seen
  const Vec3 g = world.settings.gravity;
  const double before = time - world.time;
  Point row;
  row.mass = e.mass;
  row.radius = e.radius;
  row.color = e.color;
  const PointId point = make_point(world, std::move(row));
  world.motion_of(point) = {at - v * before + g * (0.5 * before * before), v - g * before};
  Particle& particle = world.particles[world.points[point].own];
  particle.born = time;
  particle.family = e.family;
  particle.values = e.values;
  particle.look = e.look;
  particle.curves = e.curves;
  particle.emitter = id;
  note_site(world, world.points[point].own);
  e.count++;
  if (std::isfinite(lifetime)) {
    particle.lifetime = lifetime;
    await_end(world, world.points[point].own);
  }
  mark_edited(world, point);
  post(world, Source::emitter, energy_of(world, point));
}

/// Removes an emitter whose point is gone.
bool lost_its_point(World& world, EmitterId id) {
  const PointId point = world.emitters[id].point;
  if (!point || world.points.alive(point)) return false;
  const std::string what = describe(world, id);
  world.emitters.remove(id, {what, world.time, "the end of its point"});
  notice(world, Notice::Kind::removed, id, world.emitters.story(id));
  return true;
}

/// Asks for a rate that changes with time: that in the middle of the step holds for all of it.
void ask_rate(World& world, EmitterId id, double end) {
  const std::function<double(double)> rate_at = world.emitters[id].rate_at;
  if (!rate_at) return;
  const Lock lock(world);
  const double rate = rate_at(0.5 * (world.time + end));
  require_rate(describe(world, id), rate);
  world.emitters[id].rate = rate;
}

void emit(World& world, EmitterId id, double end) {
  if (lost_its_point(world, id)) return;
  ask_rate(world, id, end);
  Emitter& e = world.emitters[id];
  const double reached = with_round_off(end);
  const double due = e.rate * (reached - e.origin) + e.phase - static_cast<double>(e.since);
  require_few(world, text(e.rate_from, e.rate_from.empty() ? "" : ": ", describe(world, id)), e, due);
  Base base;
  if (e.point) base = base_of(world, e.point);
  if (due >= 0.5 && e.rate > 0.0) disturb_forces_by_birth(world, e.family);
  while (e.rate > 0.0) {
    const double time = e.origin + (static_cast<double>(e.since + 1) - e.phase) / e.rate;
    if (!(time <= reached)) break;
    e.since++;
    const double born = std::fmax(time, world.time);
    make(world, id, base.after(born - world.time), born, reached);
  }
  if (e.rate_at) rebase(e, end);
}

}  // namespace

EmitterId add_emitter(World& world, const EmitterDef& def) {
  const std::string call = def.name.empty() ? "emitter" : text("emitter '", def.name, "'");
  require_unlocked(world, call);
  const Family family = def.family ? world.families[def.family] : Family{};
  Emitter row;
  place_at(world, call, def.position, row);
  require_rate(call, def.rate);
  require_finite(call, "velocity", def.velocity, "m/s");
  require_in_plane(world, call, "velocity", def.velocity, "m/s");
  require_spread(call, def.spread);
  require_lifetimes(call, def.shortest, def.longest);
  require_max(call, def.max);
  row.mass = def.mass.value_or(family.mass.value_or(row.mass));
  row.radius = def.radius.value_or(family.radius.value_or(row.radius));
  require_positive(call, "mass", row.mass, "kg");
  require_not_negative(call, "radius", row.radius, "m");
  row.values = attribute_values(call, family, def.attributes);
  row.curves = curves_of(call, family, def.curves, def.radius.has_value(), def.color.has_value(), def.attributes);
  require_solid_radius(call, family, row.radius, row.curves.get());
  row.color = def.color.value_or(family.color.value_or(ParticleDef::usual_color));
  row.look = def.look;
  row.rate = def.rate;
  row.rate_at = def.rate_at;
  row.rate_from = acting(world);
  row.velocity = world.plane.along(def.velocity);
  row.spread = def.spread;
  row.shortest = def.shortest;
  row.longest = def.longest;
  row.max = def.max;
  row.family = def.family;
  row.enabled = def.enabled;
  row.origin = world.time;
  row.name = def.name;
  row.serial = world.next_serial++;
  return world.emitters.add(std::move(row));
}

void remove(World& world, EmitterId id) {
  require_unlocked(world, "remove");
  const std::string what = describe(world, id);
  world.emitters.remove(id, obituary(world, what));
  notice(world, Notice::Kind::removed, id, world.emitters.story(id));
}

void set_position(World& world, EmitterId id, const EmitterPosition& position) {
  require_unlocked(world, "at");
  place_at(world, describe(world, id), position, world.emitters[id]);
}

void set_rate(World& world, EmitterId id, double rate) {
  require_rate(describe(world, id), rate);
  change_rate(world, id, "rate", [&](Emitter& e) {
    e.rate = rate;
    e.rate_at = {};
    e.rate_from = acting(world);
  });
}

void set_rate(World& world, EmitterId id, std::function<double(double)> rate) {
  change_rate(world, id, "rate", [&](Emitter& e) {
    e.rate_at = std::move(rate);
    e.rate_from = acting(world);
  });
}

void set_enabled(World& world, EmitterId id, bool enabled) {
  change_rate(world, id, "enabled", [&](Emitter& e) { e.enabled = enabled; });
}

void set_velocity(World& world, EmitterId id, Vec3 velocity) {
  require_unlocked(world, "velocity");
  require_finite(describe(world, id), "velocity", velocity, "m/s");
  require_in_plane(world, describe(world, id), "velocity", velocity, "m/s");
  world.emitters[id].velocity = world.plane.along(velocity);
}

void set_spread(World& world, EmitterId id, double spread) {
  require_unlocked(world, "spread");
  require_spread(describe(world, id), spread);
  world.emitters[id].spread = spread;
}

void set_lifetimes(World& world, EmitterId id, double shortest, double longest) {
  require_unlocked(world, "lifetime");
  require_lifetimes(describe(world, id), shortest, longest);
  world.emitters[id].shortest = shortest;
  world.emitters[id].longest = longest;
}

void set_max(World& world, EmitterId id, std::uint64_t max) {
  require_unlocked(world, "max");
  require_max(describe(world, id), max);
  world.emitters[id].max = max;
}

void emit(World& world) {
  if (world.emitters.empty()) return;
  const double end = next_time(world);
  for (EmitterId id : world.emitters.ids())
    if (world.emitters[id].enabled) emit(world, id, end);
}

}  // namespace pantin
