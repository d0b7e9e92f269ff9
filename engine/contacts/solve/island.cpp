#include "contacts/solve/island.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

/// How much a unit impulse along `way` changes the velocity of its point along it [1/kg].
double mobility_along(const IslandBody& body, Vec3 arm, Vec3 way) {
  const Vec3 moment = cross(arm, way);
  return body.inverse_mass + dot(moment, body.inverse_inertia * moment);
}

double mobility_along(const ContactIsland& island, const IslandPair& p, Vec3 way) {
  const double of_a = mobility_along(island.bodies[static_cast<std::size_t>(p.a)], p.ra, way);
  return p.b < 0 ? of_a : of_a + mobility_along(island.bodies[static_cast<std::size_t>(p.b)], p.rb, way);
}

double mean_mobility(const ContactIsland& island, const IslandTie& t) {
  double sum = 0.0;
  for (int i = 0; i < 3; i++) {
    const Vec3 axis = vec(i == 0, i == 1, i == 2);
    if (t.lever == 0.0) {
      sum += mobility_along(island, t, axis);
      continue;
    }
    sum += t.lever * t.lever * dot(axis, island.bodies[static_cast<std::size_t>(t.a)].inverse_inertia * axis);
    if (t.b >= 0)
      sum += t.lever * t.lever * dot(axis, island.bodies[static_cast<std::size_t>(t.b)].inverse_inertia * axis);
  }
  return sum / 3.0;
}

}  // namespace

void ContactIsland::clear() {
  bodies.clear();
  contacts.clear();
  rolls.clear();
  ties.clear();
  scalars.clear();
  ends.clear();
  ties_prepared = false;
}

namespace {

void add_load(std::vector<BodyLoad>& loads, std::int32_t body, Vec3 force, Vec3 moment) {
  if (body < 0) return;
  loads[static_cast<std::size_t>(body)].force += force;
  loads[static_cast<std::size_t>(body)].moment += moment;
}

void add_at_point(std::vector<BodyLoad>& loads, const IslandPair& p, Vec3 impulse) {
  add_load(loads, p.a, impulse, cross(p.ra, impulse));
  add_load(loads, p.b, impulse * -1.0, cross(p.rb, impulse) * -1.0);
}

}  // namespace

void add_contact_loads(const ContactIsland& island, std::vector<BodyLoad>& loads) {
  for (const IslandContact& c : island.contacts) add_at_point(loads, c, to_world(c, c.impulse));
  for (const IslandRoll& r : island.rolls) {
    const Vec3 moment = moment_of(island, r, r.impulse);
    add_load(loads, island.contacts[r.contact].a, zero3(), moment);
    add_load(loads, island.contacts[r.contact].b, zero3(), moment * -1.0);
  }
}

void add_tie_loads(const ContactIsland& island, std::vector<BodyLoad>& loads) {
  for (const IslandTie& t : island.ties) add_load(loads, t, t.kept * t.impulse);
  for (const IslandScalar& s : island.scalars) add_load(island, loads, s, s.impulse);
}

void add_load(const ContactIsland& island, std::vector<BodyLoad>& loads, const IslandScalar& s, double impulse) {
  for (const ScalarEnd& end : ends_of(island, s)) {
    loads[end.body].force += end.force * impulse;
    loads[end.body].moment += end.moment * impulse;
  }
}

void add_load(std::vector<BodyLoad>& loads, const IslandTie& t, Vec3 impulse) {
  if (t.lever == 0.0) return add_at_point(loads, t, impulse);
  add_load(loads, t.a, zero3(), impulse * t.lever);
  add_load(loads, t.b, zero3(), impulse * -t.lever);
}

void start_without_impulses(ContactIsland& island) {
  for (IslandBody& body : island.bodies) {
    body.v = body.v0;
    body.w = body.w0;
  }
}

void apply_impulses(ContactIsland& island) {
  std::vector<BodyLoad>& loads = island.applied;
  loads.assign(island.bodies.size(), {});
  add_contact_loads(island, loads);
  add_tie_loads(island, loads);
  for (std::size_t i = 0; i < loads.size(); i++) {
    IslandBody& b = island.bodies[i];
    b.v = b.v0 + loads[i].force * b.inverse_mass;
    b.w = b.w0 + b.inverse_inertia * loads[i].moment;
  }
}

void observe(ContactIsland& island) {
  for (IslandContact& c : island.contacts)
    c.u = to_frame(c, relative(c, island.bodies, &IslandBody::v, &IslandBody::w)) + c.bias;
  for (IslandRoll& r : island.rolls) r.u = velocity_of(island, r, &IslandBody::w);
  for (IslandTie& t : island.ties)
    t.u = velocity_of(t, island.bodies, &IslandBody::v, &IslandBody::w) - t.kept * t.wanted + t.impulse * t.softness;
  for (IslandScalar& s : island.scalars) s.u = velocity_of(island, s, &IslandBody::v, &IslandBody::w) + s.bias;
}

void prepare(ContactIsland& island) {
  constexpr double softest = 1e-2;  // of w: what strikes where the last loads were small is not softened by them
  for (IslandContact& c : island.contacts) {
    c.wn = mobility_along(island, c, c.frame[0]);
    c.compliance = std::min(c.compliance, softest * c.wn);
    c.wt = std::max(mobility_along(island, c, c.frame[1]), mobility_along(island, c, c.frame[2]));
    c.impulse = c.start;
  }
  for (IslandRoll& r : island.rolls) {
    const IslandContact& c = island.contacts[r.contact];
    const auto mobility = [&](int k) {
      const auto of = [&](std::int32_t body) {
        return body < 0 ? 0.0
                        : dot(c.frame[k], island.bodies[static_cast<std::size_t>(body)].inverse_inertia * c.frame[k]);
      };
      return r.lever[k] * r.lever[k] * (of(c.a) + of(c.b));
    };
    r.wn = mobility(0);
    r.wt = mobility(1) + mobility(2);
    r.impulse = r.start;
  }
  weigh_ties(island);
  for (IslandTie& t : island.ties) t.impulse = t.start;
  for (IslandScalar& s : island.scalars) s.impulse = std::clamp(s.start, s.low, s.high);
}

void weigh_ties(ContactIsland& island) {
  for (IslandTie& t : island.ties) t.w = mean_mobility(island, t);
  for (IslandScalar& s : island.scalars) {
    s.w = 0.0;
    for (const ScalarEnd& end : ends_of(island, s)) {
      const IslandBody& b = island.bodies[end.body];
      s.w += norm2(end.force) * b.inverse_mass + dot(end.moment, b.inverse_inertia * end.moment);
    }
  }
}

namespace {

/// Distance of x from the projection of x - u on the disc of this radius.
double disc_residual(double x1, double x2, double u1, double u2, double radius) {
  const double y1 = x1 - u1, y2 = x2 - u2;
  const double size = std::sqrt(y1 * y1 + y2 * y2), part = size > radius ? radius / size : 1.0;
  const double d1 = x1 - y1 * part, d2 = x2 - y2 * part;
  return std::sqrt(d1 * d1 + d2 * d2);
}

}  // namespace

double coulomb_residual(const IslandContact& c) {
  const double normal = std::fabs(std::fmin(c.impulse[0] * c.wn, c.u[0] + c.compliance * c.impulse[0]));
  const double bound = c.friction * std::fmax(0.0, c.impulse[0]) * c.wt;
  return std::fmax(normal, disc_residual(c.impulse[1] * c.wt, c.impulse[2] * c.wt, c.u[1], c.u[2], bound));
}

double scalar_residual(const IslandScalar& s) {
  const double x = s.impulse * s.w;
  return std::fabs(x - std::clamp(x - s.u, s.low * s.w, s.high * s.w));
}

double roll_residual(const ContactIsland& island, const IslandRoll& r) {
  const double most = std::fmax(0.0, island.contacts[r.contact].impulse[0]);
  return std::fmax(disc_residual(r.impulse[0] * r.wn, 0.0, r.u[0], 0.0, most * r.wn),
                   disc_residual(r.impulse[1] * r.wt, r.impulse[2] * r.wt, r.u[1], r.u[2], most * r.wt));
}

double residual(const ContactIsland& island) {
  double most = 0.0;
  for (const IslandContact& c : island.contacts) most = std::fmax(most, coulomb_residual(c));
  for (const IslandRoll& r : island.rolls) most = std::fmax(most, roll_residual(island, r));
  for (const IslandTie& t : island.ties) most = std::fmax(most, norm(t.u));
  for (const IslandScalar& s : island.scalars) most = std::fmax(most, scalar_residual(s));
  return most;
}

double kinetic_energy(const ContactIsland& island) {
  double sum = 0.0;
  for (const IslandBody& b : island.bodies) sum += 0.5 * (b.mass * norm2(b.v) + dot(b.w, b.inertia * b.w));
  return sum;
}

bool is_even(const ContactIsland& island) {
  constexpr double most = 100.0;
  double lightest = infinity, heaviest = 0.0;
  for (const IslandBody& b : island.bodies) {
    lightest = std::min(lightest, b.mass);
    heaviest = std::max(heaviest, b.mass);
  }
  return heaviest <= most * lightest;
}

}  // namespace pantin
