#include "world/editing.hpp"

#include "world/edit.hpp"

namespace pantin::editing {

void require_unlocked(const World& world, std::string_view call) {
  require(!world.locked, call, ": the world cannot be edited while it steps; edit in an event or a step callback");
}

std::string to_text(Vec3 v) {
  return text("(", static_cast<double>(v[0]), ", ", static_cast<double>(v[1]), ", ", static_cast<double>(v[2]), ")");
}

void require_finite(std::string_view call, std::string_view name, Vec3 v, std::string_view unit) {
  if (!finite(v)) throw Error(text(call, ": ", name, " must be finite, got ", to_text(v), " ", unit));
}
void require_finite(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(std::isfinite(x), call, ": ", name, " must be finite, got ", x, " ", unit);
}
void require_positive(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(x > 0.0 && std::isfinite(x), call, ": ", name, " must be > 0 ", unit, " and finite, got ", x);
}
void require_positive_or_infinite(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(x > 0.0, call, ": ", name, " must be > 0 ", unit, ", got ", x);
}
void require_not_negative(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(x >= 0.0 && std::isfinite(x), call, ": ", name, " must be >= 0 ", unit, " and finite, got ", x);
}

void require_inertia(std::string_view call, const Mat3& inertia) {
  double most = 0.0, skew = 0.0;
  for (int i = 0; i < 3; i++) {
    require(finite(inertia[i]), call, ": inertia must be finite, got ", to_text(inertia[i]), " kg m² in column ",
            i + 1);
    most = std::fmax(most, largest(inertia[i]));
  }
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < i; j++) skew = std::fmax(skew, std::fabs(inertia[i][j] - inertia[j][i]));
  require(skew <= 1e-9 * most, call, ": inertia must be symmetric, but two elements differ by ", skew, " kg m²");
  const Vec3 moments = principal_axes(inertia, identity33()).moments;
  require(moments[0] >= -1e-9 * most, call, ": inertia must not be negative about any axis; its principal moments are ",
          to_text(moments), " kg m²");
  require(moments[2] - moments[1] - moments[0] <= 1e-9 * most, call,
          ": no body has this inertia, as one principal moment is larger than the sum of the others: ",
          to_text(moments), " kg m²");
}

Quat unit(std::string_view call, const Quat& q) {
  const double most = std::fmax(std::fmax(std::fabs(q.w), std::fabs(q.x)), std::fmax(std::fabs(q.y), std::fabs(q.z)));
  const bool numbers = std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
  require(numbers && most > 0.0, call, ": orientation must be a finite quaternion other than 0, got (", q.w, ", ", q.x,
          ", ", q.y, ", ", q.z, ")");
  return normalised({q.w / most, q.x / most, q.y / most, q.z / most});
}

double energy_of(const World& world, BodyId body) {
  const Motion& m = world.motion_of(body);
  return 0.5 * norm2(m.p) / m.mass + 0.5 * dot(m.angular, m.angular * inverse_inertia(m)) -
         m.mass * dot(world.settings.gravity, m.x);
}

double energy_of(const World& world, PointId free_point) {
  const FreeMotion& m = world.motion_of(free_point);
  return world.points[free_point].mass * (0.5 * norm2(m.v) - dot(world.settings.gravity, m.x));
}

double energy_round(const World& world, PointId point) {
  const BodyId body = world.points[point].body;
  return body ? energy_of(world, body) : energy_of(world, point);
}

void post(World& world, double joules, Source source) { pantin::post(world, source, joules); }

std::string culprit(const World& world) {
  std::string name = world.who ? world.who() : "";
  return name.empty() ? "the program" : name;
}

void acted(World& world) {
  world.last_actor = culprit(world);
  world.last_act = world.time;
}

Obituary obituary(const World& world, std::string what) { return {std::move(what), world.time, culprit(world)}; }

void notice(World& world, Notice::Kind kind, const AnyId& thing, std::string story, std::int32_t hand) {
  world.notices.push_back({kind, thing, hand, std::move(story)});
}

double size_of(const Model& model, PointId point) {
  const BodyId id = model.points[point].body;
  if (!id) return 0.0;
  const Body& body = model.bodies[id];
  const Vec3 first = model.points[body.points[0]].place;
  double size = 0.0;
  for (PointId p : body.points) {
    const Vec3 place = model.points[p].place;
    size = std::fmax(size, std::fmax(norm(place - body.centre), norm(place - first)));
  }
  return size;
}

Vec3 turning_part(const Motion& motion, Vec3 v) {
  if (motion.freedom == Freedom::point) return zero3();
  Vec3 part = rotate(conjugate(motion.q), v);
  if (motion.freedom == Freedom::line) part[0] = 0.0;
  for (int i = 0; i < 3; i++)
    if (motion.inertia[i] == 0.0) part[i] = 0.0;
  return part;
}

PointId make_point(World& world, Point row) {
  row.serial = world.next_serial++;
  const PointId point = world.points.add(std::move(row));
  world.free_motion.resize(world.points.slots());
  Particle particle;
  particle.points = {point};
  particle.born = world.time;
  particle.serial = world.next_serial++;
  const ParticleId own = world.particles.add(std::move(particle));
  world.points[point].own = world.points[point].particle = own;
  return point;
}

namespace {

void wake(World& world, PointId id, const Particle& shared) {
  Point& point = world.points[id];
  Particle& own = world.particles[point.own];
  own.asleep_in = {};
  own.color = shared.color;
  own.radius = shared.radius;
  own.look = shared.look;
  own.courses = shared.courses;
  own.family = shared.family;
  own.values = shared.values;
  own.lifetime = std::numeric_limits<double>::infinity();
  point.particle = point.own;
  point.row_force = zero3();
}

}  // namespace

void end_ring(World& world, ParticleId hinge, std::string who) {
  disturb_sites(world);
  touch(world, hinge);
  drop_axes(world, hinge, {});
  const Particle shared = world.particles[hinge];
  for (ConnectionId c : shared.connections) remove(world, c);
  for (PointId p : shared.points) wake(world, p, shared);
  const std::string what = shared.name.empty() ? text("hinge ", shared.serial) : text("hinge '", shared.name, "'");
  disturb_forces_by_death(world, hinge);
  world.particles.remove(hinge, {what, world.time, std::move(who)});
}

void leave_ring(World& world, PointId point, const std::string& who) {
  const ParticleId hinge = world.points[point].particle;
  if (hinge == world.points[point].own) return;
  if (world.particles[hinge].points.size() <= 2) return end_ring(world, hinge, who);
  disturb_sites(world);
  touch(world, hinge);
  drop_axes(world, hinge, world.points[point].body);
  wake(world, point, world.particles[hinge]);
  std::erase(world.particles[hinge].points, point);
}

void erase_point(World& world, PointId point, const std::string& what) {
  const std::vector<ConstraintId> constraints = world.points[point].constraints;
  for (ConstraintId c : constraints)
    if (world.constraints.alive(c)) remove(world, c);  // a join takes what holds it along
  const ParticleId hinge = world.points[point].particle, own = world.points[point].own;
  const std::vector<ConnectionId> connections = world.particles[own].connections;
  for (ConnectionId c : connections) remove(world, c);
  leave_ring(world, point, culprit(world));
  if (hinge != own && !world.particles.alive(hinge))
    notice(world, Notice::Kind::removed, hinge, world.particles.story(hinge));
  if (const EmitterId emitter = world.particles[own].emitter; world.emitters.alive(emitter))
    world.emitters[emitter].count--;
  disturb_forces_by_death(world, own);
  world.particles.remove(own, obituary(world, what));
  world.points.remove(point, obituary(world, what));
}

ConstraintId holder(const Model& model, ParticleId ring) {
  for (PointId p : model.particles[awake(model, ring)].points)
    for (ConstraintId id : model.points[p].constraints) {
      const Constraint& c = model.constraints[id];
      const bool rigid = c.pins();
      if (rigid) return id;
    }
  return {};
}

void require_free_of_holders(const World& world, std::string_view call, PointId point, ConstraintId but) {
  const ConstraintId held = holder(world, world.points[point].particle);
  if (!held || held == but) return;
  const bool nailed = world.constraints[held].kind == ConstraintKind::nail;
  throw Error(text(call, ": ", describe(world, world.points[point].particle), " is already ",
                   nailed ? "nailed" : "held by a follow without max_force", " (", describe(world, held),
                   "); remove that first"));
}

Vec3 present(World& world, const std::function<Vec3(double)>& place) {
  const Lock lock(world);
  return place(world.time);
}

}  // namespace pantin::editing
