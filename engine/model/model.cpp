#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include "model/weigh.hpp"

namespace pantin {

Vec3 inverse_inertia(const Motion& m) {
  Vec3 inverse = zero3();
  for (int i = 0; i < 3; i++) inverse[i] = m.inertia[i] > 0.0 ? 1.0 / m.inertia[i] : 0.0;
  return inverse;
}

Vec3 angular_velocity(const Motion& m) { return rotate(m.q, m.angular * inverse_inertia(m)); }

double kinetic_energy(const Motion& m) {
  return 0.5 * norm2(m.p) / m.mass + 0.5 * dot(m.angular, m.angular * inverse_inertia(m));
}

double gyration(const Motion& m) {
  return std::sqrt(std::max(m.inertia[0], std::max(m.inertia[1], m.inertia[2])) / m.mass);
}

const Solid* solid_of(const Model& m, const Point& point) {
  if (!m.solids || point.body) return nullptr;
  const FamilyId family = m.particles[point.particle].family;
  return family && m.families[family].solid ? &*m.families[family].solid : nullptr;
}

double radius_of(const Model& m, const Point& point) {
  return m.particles[point.particle].radius.value_or(point.radius);
}

Vec3 arm(const Model& m, PointId point) {
  const Point& p = m.points[point];
  if (!p.body) return zero3();
  const Body& body = m.bodies[p.body];
  return rotate(conjugate(body.axes), p.position - body.centre);
}

Vec3 position(const Model& m, PointId point) {
  const Point& p = m.points[point];
  if (!p.body) return m.free_motion[point.slot - 1].x;
  const Motion& motion = m.motion_of(p.body);
  return motion.x + rotate(motion.q, arm(m, point));
}

Vec3 velocity(const Model& m, PointId point) {
  const Point& p = m.points[point];
  if (!p.body) return m.free_motion[point.slot - 1].v;
  const Motion& motion = m.motion_of(p.body);
  return motion.p / motion.mass + cross(angular_velocity(motion), rotate(motion.q, arm(m, point)));
}

ParticleId awake(const Model& m, ParticleId particle) {
  const Particle& p = m.particles[particle];
  return p.asleep_in ? p.asleep_in : particle;
}

namespace {

template <class Read>
Vec3 mean(const Model& m, ParticleId particle, Read read) {
  const Particle& ring = m.particles[awake(m, particle)];
  // Sums differences to the first, so that points which coincide give their very position.
  const Vec3 first = read(ring.points[0]);
  Vec3 sum = zero3();
  for (PointId p : ring.points) sum += read(p) - first;
  return first + sum / static_cast<double>(ring.points.size());
}

template <class Row>
std::string called(std::string_view kind, const Row& row) {
  return row.name.empty() ? text(kind, " ", row.serial) : text(kind, " '", row.name, "'");
}

}  // namespace

Vec3 position(const Model& m, ParticleId particle) {
  return mean(m, particle, [&](PointId p) { return position(m, p); });
}

Vec3 velocity(const Model& m, ParticleId particle) {
  return mean(m, particle, [&](PointId p) { return velocity(m, p); });
}

Vec3 end_of(const Model& m, const Connection& connection, std::size_t end) {
  return connection.particles[end] ? position(m, connection.particles[end]) : connection.positions[end];
}

double mass(const Model& m, ParticleId particle) {
  double sum = 0.0;
  for (PointId p : m.particles[awake(m, particle)].points) sum += m.points[p].mass;
  return sum;
}

PointId star(const Model& m, ParticleId particle) {
  PointId best;
  double most = -1.0;
  for (PointId id : m.particles[awake(m, particle)].points) {
    const Point& p = m.points[id];
    const double weight = p.body ? m.motion_of(p.body).mass : p.mass;
    if (weight < most || (weight == most && m.points[best].serial < p.serial)) continue;
    best = id;
    most = weight;
  }
  return best;
}

Quat orientation(const Model& m, BodyId body) {
  return normalised(m.motion_of(body).q * conjugate(m.bodies[body].axes));
}

Vec3 normal_in(const Model& m, const Quat& frame) {
  return m.plane.flat() ? rotate(conjugate(frame), m.plane.about(vec(1, 1, 1))) : zero3();
}

Vec3 origin(const Model& m, BodyId body) {
  return m.motion_of(body).x - rotate(orientation(m, body), m.bodies[body].centre);
}

Vec3 angular_momentum(const Model& m, BodyId body) {
  const Motion& motion = m.motion_of(body);
  return rotate(motion.q, motion.angular);
}

Mat3 inertia(const Model& m, BodyId body) {
  const Motion& motion = m.motion_of(body);
  const Mat3 r = matrix(motion.q);
  return times_transposed(r * diagonal(motion.inertia), r);
}

namespace {

struct Turning {
  Freedom freedom;
  Vec3 inertia;  // [kg m²] principal
};

/// How a body turns, alone or along with what it is tied to.
Turning turning_of(const Model& m, const Body& body, bool tied) {
  const bool as_weighed = !tied || body.freedom == Freedom::point || m.plane.flat();
  if (as_weighed) return {body.freedom, body.moments};
  if (body.freedom == Freedom::rigid) return {Freedom::rigid, lifted(body.moments)};
  if (body.constraints.empty()) return {Freedom::line, body.moments};
  return {Freedom::rigid, lifted(vec(0, body.moments[1], body.moments[2]))};  // what ties its rotation shows its spin
}

/// Sets how a body turns, at a spin [rad/s, principal axes].
void set_turning(Motion& motion, const Turning& t, Vec3 spin) {
  motion.freedom = t.freedom;
  motion.inertia = t.inertia;
  motion.angular = t.inertia * spin;
  if (t.freedom == Freedom::line) motion.angular[0] = 0.0;
}

}  // namespace

double settle_inertia(Model& m, BodyId id, bool tied) {
  Motion& motion = m.motion_of(id);
  const Turning t = turning_of(m, m.bodies[id], tied);
  if (t.freedom == motion.freedom && same(t.inertia, motion.inertia)) return 0.0;
  const auto energy = [&] { return 0.5 * dot(motion.angular, motion.angular * inverse_inertia(motion)); };
  const double before = energy();
  set_turning(motion, t, motion.angular * inverse_inertia(motion));
  return energy() - before;
}

double lift(const Model& m, BodyId id) {
  const Body& body = m.bodies[id];
  const Motion& motion = m.motion_of(id);
  if (motion.freedom != Freedom::rigid || m.plane.flat()) return 0.0;
  return motion.inertia[0] - (body.bare || body.freedom == Freedom::line ? 0.0 : body.moments[0]);
}

void update_mass(Model& m, BodyId id) {
  Body& body = m.bodies[id];
  Motion& motion = m.motion_of(id);
  std::vector<MassPoint> points;
  points.reserve(body.points.size());
  for (PointId p : body.points) points.push_back({m.points[p].position, m.points[p].mass});
  const std::string who = body.name.empty() ? "body" : describe(m, id);
  const Quat frame = orientation(m, id);
  const Quat near = m.plane.flat() ? conjugate(frame) * m.plane.about(motion.q) : body.axes;
  const Weighed w = weigh(who, points, own_mass_of(body), near, normal_in(m, frame));

  const Vec3 from = origin(m, id), spin = angular_velocity(motion);
  const Vec3 x = from + rotate(frame, w.centre);
  const Vec3 speed = motion.mass > 0.0 ? motion.p / motion.mass + cross(spin, x - motion.x) : zero3();
  body.centre = w.centre;
  body.axes = w.axes;
  body.moments = w.moments;
  body.bare = w.bare;
  body.freedom = w.freedom;
  motion.x = x;
  motion.q = m.plane.about(normalised(frame * w.axes));
  motion.mass = w.mass;
  motion.p = speed * w.mass;
  const bool tied = motion.articulate >= 0 || !body.constraints.empty();
  set_turning(motion, turning_of(m, body, tied), rotate(conjugate(motion.q), spin));
}

namespace {

void disturb(Model& m, std::int32_t articulate) {
  if (articulate >= 0) m.disturbed.push_back(articulate);
}

}  // namespace

void mark_edited(Model& m, BodyId body) {
  m.topology_changed = m.places_changed = true;
  m.edited_things.push_back({body, {}, m.motion_of(body).articulate});
  m.stirred.push_back(body);
}

void mark_edited(Model& m, PointId point) {
  const Point& p = m.points[point];
  if (p.body) return mark_edited(m, p.body);
  m.topology_changed = true;
  m.places_changed = m.places_changed || solid_of(m, p);
  m.edited_things.push_back({{}, point, p.articulate});
}

void mark_edited(Model& m, ParticleId particle) {
  for (PointId p : m.particles[awake(m, particle)].points) mark_edited(m, p);
}

void mark_edited(Model& m, const Constraint& constraint) {
  const auto both = [&](auto id) {
    mark_edited(m, id);
    disturb(m, id);
  };
  constraint.each_point([&](PointId point) {
    if (m.points.alive(point)) both(point);
  });
  constraint.each_body([&](BodyId body) {
    if (m.bodies.alive(body)) both(body);
  });
}

void disturb(Model& m, BodyId body) {
  m.places_changed = true;
  m.stirred.push_back(body);
  disturb(m, m.motion_of(body).articulate);
}

void disturb(Model& m, PointId point) {
  const Point& p = m.points[point];
  m.places_changed = m.places_changed || solid_of(m, p);
  p.body ? disturb(m, p.body) : disturb(m, p.articulate);
}

namespace {
/// Point `i` of a body, from 0.
std::string describe_point(const Model& m, const Point& p, std::size_t i) {
  const std::string body = describe(m, p.body);
  return p.name.empty() ? text("point ", i + 1, " of ", body) : text("point '", p.name, "' of ", body);
}
}  // namespace

std::string describe(const Model& m, PointId id) {
  if (!m.points.alive(id)) return m.points.story(id);
  const Point& p = m.points[id];
  if (!p.body) return called("particle", m.particles[p.own]);
  const auto& all = m.bodies[p.body].points;
  return describe_point(m, p, static_cast<std::size_t>(std::find(all.begin(), all.end(), id) - all.begin()));
}

std::vector<std::string> describe_points(const Model& m, BodyId body) {
  std::vector<std::string> names;
  for (PointId p : m.bodies[body].points) names.push_back(describe_point(m, m.points[p], names.size()));
  return names;
}

std::string describe(const Model& m, ParticleId id) {
  if (!m.particles.alive(id)) return m.particles.story(id);
  const Particle& p = m.particles[id];
  return called(p.is_hinge() ? "hinge" : "particle", p);
}

std::string describe(const Model& m, BodyId id) {
  return m.bodies.alive(id) ? called("body", m.bodies[id]) : m.bodies.story(id);
}

std::string_view kind_name(ConstraintKind kind) { return constraint_names[static_cast<std::size_t>(kind)]; }

std::string describe(const Model& m, ConstraintId id) {
  if (!m.constraints.alive(id)) return m.constraints.story(id);
  const Constraint& c = m.constraints[id];
  return called(kind_name(c.kind), c);
}

std::string describe(const Model& m, GroupId id) {
  return m.groups.alive(id) ? called("group", m.groups[id]) : m.groups.story(id);
}

std::string describe(const Model& m, FamilyId id) {
  return m.families.alive(id) ? called("family", m.families[id]) : m.families.story(id);
}

std::string describe(const Model& m, ConnectionId id) {
  return m.connections.alive(id) ? called("connection", m.connections[id]) : m.connections.story(id);
}

std::string describe(const Model& m, InteractionId id) {
  return m.interactions.alive(id) ? called("interaction", m.interactions[id]) : m.interactions.story(id);
}

std::string describe(const Model& m, FieldId id) {
  return m.fields.alive(id) ? called("field", m.fields[id]) : m.fields.story(id);
}

std::string describe(const Model& m, EmitterId id) {
  return m.emitters.alive(id) ? called("emitter", m.emitters[id]) : m.emitters.story(id);
}

std::string describe(const Model& m, ShapeId id) {
  if (!m.shapes.alive(id)) return m.shapes.story(id);
  const Shape& shape = m.shapes[id];
  const bool plane = std::holds_alternative<HalfSpaceShape>(shape.geometry);
  const std::string own = called(shape.body ? "shape" : plane ? "floor" : "ground", shape);
  return shape.body ? text(own, " of ", describe(m, shape.body)) : own;
}

std::string describe(const Model& m, const AnyId& id) {
  return std::visit(
      [&](const auto& which) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(which)>, std::monostate>)
          return "nothing";
        else
          return describe(m, which);
      },
      id);
}

double size_of(const Model& model, PointId point) {
  const BodyId id = model.points[point].body;
  if (!id) return 0.0;
  const Body& body = model.bodies[id];
  const Vec3 first = model.points[body.points[0]].position;
  double size = 0.0;
  for (PointId p : body.points) {
    const Vec3 position = model.points[p].position;
    size = std::fmax(size, std::fmax(norm(position - body.centre), norm(position - first)));
  }
  for (const ShapeId id_of_shape : body.shapes) {
    const Shape& shape = model.shapes[id_of_shape];
    if (!shape.sensor) size = std::fmax(size, norm(shape.at - body.centre) + reach_of(shape.geometry));
  }
  return size;
}

Vec3 turning_part(const Motion& motion, Vec3 v) { return turning_part(motion, motion.q, v); }

Vec3 turning_part(const Motion& motion, Quat q, Vec3 v) {
  if (motion.freedom == Freedom::point) return zero3();
  Vec3 part = rotate(conjugate(q), v);
  if (motion.freedom == Freedom::line) part[0] = 0.0;
  for (int i = 0; i < 3; i++)
    if (motion.inertia[i] == 0.0) part[i] = 0.0;
  return part;
}

namespace {

struct RowOf {
  const Model& m;
  const ForceElement& operator()(ConnectionId id) const { return m.connections[id]; }
  const ForceElement& operator()(InteractionId id) const { return m.interactions[id]; }
  const ForceElement& operator()(FieldId id) const { return m.fields[id]; }
};

}  // namespace

const ForceElement& force_element(const Model& m, const ForceElementId& id) { return std::visit(RowOf{m}, id); }
ForceElement& force_element(Model& m, const ForceElementId& id) {
  return const_cast<ForceElement&>(force_element(std::as_const(m), id));
}

namespace {

struct Alive {
  const Model& m;
  bool operator()(std::monostate) const { return false; }
  bool operator()(PointId id) const { return m.points.alive(id); }
  bool operator()(ParticleId id) const { return m.particles.alive(id); }
  bool operator()(BodyId id) const { return m.bodies.alive(id); }
  bool operator()(ConstraintId id) const { return m.constraints.alive(id); }
  bool operator()(FamilyId id) const { return m.families.alive(id); }
  bool operator()(ConnectionId id) const { return m.connections.alive(id); }
  bool operator()(InteractionId id) const { return m.interactions.alive(id); }
  bool operator()(FieldId id) const { return m.fields.alive(id); }
  bool operator()(EmitterId id) const { return m.emitters.alive(id); }
  bool operator()(ShapeId id) const { return m.shapes.alive(id); }
  /// A group is gone when it had members and none lives.
  bool operator()(GroupId id) const {
    if (!m.groups.alive(id)) return false;
    const auto& members = m.groups[id].members;
    return members.empty() || std::any_of(members.begin(), members.end(), [&](const AnyId& a) { return alive(m, a); });
  }
};

}  // namespace

bool alive(const Model& m, const AnyId& id) { return std::visit(Alive{m}, id); }

std::vector<AnyId> all_members(const Model& m, GroupId group) {
  std::vector<AnyId> found;
  const auto add = [&](const auto& self, GroupId of) -> void {
    for (const AnyId& id : m.groups[of].members) {
      if (!alive(m, id)) continue;
      found.push_back(id);
      if (const auto* inner = std::get_if<GroupId>(&id)) self(self, *inner);
    }
  };
  add(add, group);
  return found;
}

}  // namespace pantin
