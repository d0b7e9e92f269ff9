#include "choreography/conditions.hpp"

#include <algorithm>

#include "edit/common.hpp"
#include "forces/forces.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"

namespace pantin {

namespace {

constexpr double most_samples = 1e6;

/// NaN where there is nothing to be hot or cold, or to have energy.
template <class Measure>
double measured_in(const World& world, const AnyId& of, Measure measure) {
  const Things things = std::holds_alternative<std::monostate>(of) ? everything(world) : things_of(world, of);
  const bool none = things.bodies.empty() && things.free_points.empty();
  return none ? std::numeric_limits<double>::quiet_NaN() : measure(things);
}

double temperature_in(const World& world, const AnyId& of) {
  return measured_in(world, of, [&](const Things& things) { return temperature(world, things); });
}

double energy_in(const World& world, const AnyId& of) {
  if (std::holds_alternative<std::monostate>(of)) return energy(world).total();
  return measured_in(world, of, [&](const Things& things) { return energy(world, things).total(); });
}

double load(const World& world, const AnyId& thing) {
  if (const auto* connection = std::get_if<ConnectionId>(&thing)) return std::fabs(tension(world, *connection));
  if (const auto* constraint = std::get_if<ConstraintId>(&thing)) return norm(world.constraints[*constraint].force);
  double most = 0.0;
  for (PointId p : world.particles[std::get<ParticleId>(thing)].points)
    most = std::fmax(most, norm(world.points[p].row_force));
  return most;
}

bool has_load(const World& world, const AnyId& thing) {
  const auto* particle = std::get_if<ParticleId>(&thing);
  return std::holds_alternative<ConnectionId>(thing) || std::holds_alternative<ConstraintId>(thing) ||
         (particle && world.particles[*particle].is_hinge());
}

Vec3 whereabouts(const World& world, const Whereabouts& w) {
  if (const auto* point = std::get_if<PointId>(&w.thing)) return position(world, *point);
  if (const auto* particle = std::get_if<ParticleId>(&w.thing)) return position(world, *particle);
  if (const auto* body = std::get_if<BodyId>(&w.thing)) return world.motion_of(*body).x;
  return w.position;
}

bool has_position(const Whereabouts& w) {
  return std::holds_alternative<std::monostate>(w.thing) || std::holds_alternative<PointId>(w.thing) ||
         std::holds_alternative<ParticleId>(w.thing) || std::holds_alternative<BodyId>(w.thing);
}

double count_of(const World& world, const AnyId& of) {
  if (const auto* family = std::get_if<FamilyId>(&of)) return static_cast<double>(particles(world, *family).size());
  const auto& members = world.groups[std::get<GroupId>(of)].members;
  return static_cast<double>(
      std::count_if(members.begin(), members.end(), [&](const AnyId& thing) { return alive(world, thing); }));
}

/// The mean over the last `length` [s]; NaN until they are full.
double mean_of(std::deque<std::pair<double, double>>& samples, double now, double length, double value) {
  samples.push_back({now, value});
  const double begin = now - length * (1.0 - 1e-9);
  while (samples.size() > 2 && samples[1].first <= begin) samples.pop_front();
  if (samples.size() < 2 || samples.front().first > begin) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (std::size_t i = 1; i < samples.size(); i++)
    sum += 0.5 * (samples[i].second + samples[i - 1].second) * (samples[i].first - samples[i - 1].first);
  return sum / (samples.back().first - samples.front().first);
}

}  // namespace

double MeasureOf::operator()() const {
  const AnyId thing = of.empty() ? AnyId{} : of[0].thing;
  switch (quantity) {
    case Quantity::temperature: return temperature_in(*world, thing);
    case Quantity::energy: return energy_in(*world, thing);
    case Quantity::force: return load(*world, thing);
    case Quantity::distance: return norm(whereabouts(*world, of[0]) - whereabouts(*world, of[1]));
    case Quantity::count: break;
  }
  return count_of(*world, thing);
}

Measured measured(const World& world, Quantity quantity, const std::vector<Whereabouts>& of) {
  const bool of_all = of.empty() || (of.size() == 1 && std::holds_alternative<std::monostate>(of[0].thing));
  if (quantity == Quantity::distance)
    require(of.size() == 2 && has_position(of[0]) && has_position(of[1]),
            "when: a distance is of two points, particles, bodies or positions");
  else
    require(of.size() <= 1, "when: it is of one thing, got ", of.size());
  if (quantity == Quantity::force)
    require(!of_all && has_load(world, of[0].thing), "when: a force is of a hinge, a constraint or a connection");
  if (quantity == Quantity::count)
    require(!of_all && (std::holds_alternative<GroupId>(of[0].thing) || std::holds_alternative<FamilyId>(of[0].thing)),
            "when: a count is of a group or a family");
  Measured m;
  m.measure = MeasureOf{&world, quantity, of};
  for (const Whereabouts& w : of)
    if (!std::holds_alternative<std::monostate>(w.thing)) m.of.push_back(w.thing);
  return m;
}

void check(const World& world, const Measured& m) {
  require(static_cast<bool>(m.measure), "when: there is nothing to measure");
  internal::require_finite("when", "the limit", m.limit, "");
  internal::require_not_negative("when", "mean", m.mean, "s");
  internal::require_not_negative("when", "hysteresis", m.hysteresis, "");
  require(m.mean <= most_samples * world.settings.step, "when: mean must be at most ",
          most_samples * world.settings.step, " s (a million steps), got ", m.mean);
}

bool still_there(const World& world, const AnyId& thing) {
  const auto* group = std::get_if<GroupId>(&thing);
  return group ? world.groups.alive(*group) : alive(world, thing);
}

bool begins_to_hold(World& world, EventId id) {
  const Lock lock(world);
  Event& event = world.choreography.events[id];
  const Measured& m = event.condition;
  double value = m.measure();
  if (m.mean > 0.0) value = mean_of(event.samples, world.time, m.mean, value);
  const double limit = event.held ? m.limit + (m.above ? -m.hysteresis : m.hysteresis) : m.limit;
  const bool held = event.held;
  event.held = m.above ? value > limit : value < limit;
  return event.held && !held;
}

}  // namespace pantin
