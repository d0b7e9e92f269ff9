#include "view/stage.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

#include "constraints/kind.hpp"
#include "contacts/find.hpp"
#include "model/path.hpp"
#include "view/constraint_look.hpp"

namespace pantin {

namespace {

/// Of a body's shapes.
Bounds box_of(const World& world, const Body& body) {
  Bounds sum;
  for (const ShapeId id : body.shapes) sum.add(bounds_of(world.shapes[id].geometry, pose_of(world, world.shapes[id])));
  return sum;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Lengths of bodies and rods, [m].
std::vector<double> lengths(const World& world) {
  std::vector<double> list;
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++) {
    const Body& body = world.bodies.at_slot(s);
    if (!world.bodies.alive_at(s)) continue;
    Vec3 lower = zero3(), upper = zero3();
    bool first = body.own_mass <= 0.0;
    for (const PointId id : body.points) {
      const Vec3 p = world.points[id].position;
      for (int i = 0; i < 3; i++) {
        lower[i] = first ? p[i] : std::fmin(lower[i], p[i]);
        upper[i] = first ? p[i] : std::fmax(upper[i], p[i]);
      }
      first = false;
    }
    if (!body.shapes.empty()) {
      const Bounds box = box_of(world, body);
      list.push_back(norm(box.high - box.low));
      continue;
    }
    const Motion& m = world.motion[s];
    const double extent = norm(upper - lower);
    const double turning = m.mass > 0.0 ? 2.0 * std::sqrt(2.5 * largest(m.inertia) / m.mass) : 0.0;
    if (extent > 0.0 || turning > 0.0) list.push_back(extent > 0.0 ? extent : turning);
  }
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++)
    if (const Constraint& c = world.constraints.at_slot(s); world.constraints.alive_at(s) && !has_range(c))
      if (const auto reach = drawing_of(c).reach; reach != nullptr && reach(c) > 0.0) list.push_back(reach(c));
  return list;
}

// Typical distance of a free point to its nearest, from a sample; 0: there are not two.
double nearest_distance(const World& world) {
  std::vector<Vec3> free;
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (world.points.alive_at(s) && !world.points.at_slot(s).body) free.push_back(world.free_motion[s].x);
  std::vector<double> list;
  for (std::size_t i = 0; i < free.size(); i += 1 + free.size() / 64) {
    double best = infinity;
    for (const Vec3 p : free)
      if (const double d = norm(p - free[i]); d > 0.0) best = std::fmin(best, d);
    if (best < infinity) list.push_back(best);
  }
  return list.empty() ? 0.0 : median(list);
}

struct Reached {
  double length = infinity;  // [m] of the way from the anchor
  Vec3 anchor = zero3();
};

// Ways along bodies, rings, rods and connections from nails and other fixed places: what hangs there stays that near.
class Reach {
 public:
  explicit Reach(const World& world) : world_(world), reached_(world.points.slots()) {
    for (std::uint32_t s = 0; s < world.constraints.slots(); s++) {
      const Constraint& c = world.constraints.at_slot(s);
      if (!world.constraints.alive_at(s) || !c.a || drawing_of(c).reach == nullptr) continue;
      const double length = drawing_of(c).reach(c);
      if (c.b) ties_[c.a.slot].push_back({c.b, length});
      if (c.b) ties_[c.b.slot].push_back({c.a, length});
      if (c.hand < 0 && !c.b) offer(c.a, length, c.position.now);
    }
    tie_connections();
    expanded_.assign(world.bodies.slots(), 0);
    while (!queue_.empty()) {
      const auto [key, id] = queue_.top();
      queue_.pop();
      if (const Reached r = reached_[id.slot - 1]; - key <= r.length - r.anchor[1]) expand(id, r);
    }
  }
  const std::vector<Reached>& reached() const { return reached_; }

 private:
  // As long as they are now.
  void tie_connections() {
    for (std::uint32_t s = 0; s < world_.connections.slots(); s++) {
      const Connection& c = world_.connections.at_slot(s);
      if (!world_.connections.alive_at(s) || c.count != 2) continue;
      const Vec3 places[] = {end_of(world_, c, 0), end_of(world_, c, 1)};
      const double length = norm(places[0] - places[1]);
      for (const std::size_t i : {0u, 1u}) {
        const ParticleId here = c.particles[i], there = c.particles[1 - i];
        if (!here) continue;
        if (there)
          ties_[world_.particles[there].points[0].slot].push_back({world_.particles[here].points[0], length});
        else
          offer(world_.particles[here].points[0], length, places[1 - i]);
      }
    }
  }
  // The lowest that a point can hang is the highest that its anchors allow.
  void offer(PointId id, double length, Vec3 anchor) {
    if (!world_.points.alive(id)) return;
    Reached& r = reached_[id.slot - 1];
    if (length - anchor[1] >= r.length - r.anchor[1]) return;
    r = {length, anchor};
    queue_.push({-(length - anchor[1]), id});
  }
  void expand(PointId id, const Reached& r) {
    const Point& point = world_.points[id];
    for (const PointId other : world_.particles[point.particle].points) offer(other, r.length, r.anchor);
    if (const auto found = ties_.find(id.slot); found != ties_.end())
      for (const auto& [other, length] : found->second) offer(other, r.length + length, r.anchor);
    if (!point.body || (world_.bodies[point.body].points.size() > 64 && expanded_[point.body.slot - 1]++)) return;
    for (const PointId other : world_.bodies[point.body].points)
      offer(other, r.length + norm(world_.points[other].position - point.position), r.anchor);
  }

  const World& world_;
  std::vector<Reached> reached_;
  std::vector<char> expanded_;
  std::unordered_map<std::uint32_t, std::vector<std::pair<PointId, double>>> ties_;
  std::priority_queue<std::pair<double, PointId>> queue_;
};

void include(Stage& stage, Vec3 p) {
  for (int i = 0; i < 3; i++) {
    stage.lower[i] = stage.empty ? p[i] : std::fmin(stage.lower[i], p[i]);
    stage.upper[i] = stage.empty ? p[i] : std::fmax(stage.upper[i], p[i]);
  }
  stage.empty = false;
}

// Where the particles of an emitter begin, and where most of them fly.
void include_flight(const World& world, const Emitter& emitter, Stage& stage) {
  const bool carried = world.points.alive(emitter.point);
  const Vec3 base = carried ? position(world, emitter.point) : zero3();
  const double longest = std::fmin(emitter.longest, 1.5);  // [s]
  const double aside = norm(emitter.velocity) * std::sin(std::fmin(emitter.spread, 1.57));
  for (const double time : {0.0, 0.5 * longest, longest}) {
    const Vec3 way = emitter.velocity * time + world.settings.gravity * (0.5 * time * time);
    const Vec3 margin = vec(1, 0, 1) * (aside * time);
    include(stage, base + emitter.lower + way - margin);
    include(stage, base + emitter.upper + way + margin);
  }
}

/// Places that it holds on to, as a rope over a wheel, and the way that something is on.
void include_held_places(const Constraint& c, Stage& stage) {
  if (const auto* string = std::get_if<StringData>(&c.own))
    for (const Passage& p : string->passages)
      if (!p.point) include(stage, p.position);
  if (const auto* coupling = std::get_if<CouplingData>(&c.own))
    for (const CoupledValue& v : coupling->values)
      if (v.point_a && !v.point_b && norm2(v.axis_b) == 0.0) include(stage, v.position);
  if (const auto* way = std::get_if<PathData>(&c.own); way != nullptr && way->path)
    for (double at = 0.0; at <= way->path->pieces(); at++) include(stage, way->path->position(at));
}

void include_ground(const World& world, Stage& stage) {
  const Bounds things = stage.empty ? Bounds{} : Bounds{stage.lower, stage.upper};
  const Bounds all = with_ground(world, things, 0.5 * largest(stage.upper - stage.lower));
  if (all.empty()) return;
  include(stage, all.low);
  include(stage, all.high);
}

/// The highest level plane that things are above.
std::optional<double> level_floor(const World& world, const Stage& stage) {
  std::optional<double> found;
  for (const ShapeId id : world.shapes.ids()) {
    const Shape& shape = world.shapes[id];
    if (shape.body || !std::holds_alternative<HalfSpaceShape>(shape.geometry)) continue;
    const double height = shape.at[1];
    if (matrix(shape.orientation)[2][1] > 1.0 - 1e-9 && height <= stage.lower[1] + 0.2 * stage.size &&
        height >= stage.lower[1] - 3.0 * stage.size)
      found = std::fmax(found.value_or(height), height);
  }
  return found;
}

void find_box(const World& world, Stage& stage) {
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
    if (world.bodies.alive_at(s)) include(stage, world.motion[s].x);
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (world.points.alive_at(s)) include(stage, position(world, world.points.id_at(s)));
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++) {
    if (!world.bodies.alive_at(s) || world.bodies.at_slot(s).shapes.empty()) continue;
    const Bounds box = box_of(world, world.bodies.at_slot(s));
    include(stage, box.low);
    include(stage, box.high);
  }
  for (EmitterId id : world.emitters.ids()) include_flight(world, world.emitters[id], stage);
  for (const ConstraintId id : world.constraints.ids()) include_held_places(world.constraints[id], stage);
  include_ground(world, stage);
  if (stage.empty || !(world.settings.gravity[1] < 0.0)) return;
  const Reach reach(world);
  for (std::uint32_t s = 0; s < world.points.slots(); s++) {
    const Reached& r = reach.reached()[s];
    if (!world.points.alive_at(s) || r.length == infinity) continue;
    const Vec3 p = position(world, world.points.id_at(s));
    if (p[1] - r.anchor[1] > 0.3 * r.length) continue;  // it stands there, as a top does
    include(stage, r.anchor - vec(0, r.length, 0));
    include(stage, vec(2.0 * r.anchor[0] - p[0], p[1], p[2]));  // swung over to the other side
  }
}

}  // namespace

Bounds with_ground(const World& world, const Bounds& things, double margin) {
  const Bounds near = widened(things, margin);
  Bounds all = things;
  for (const ShapeId id : world.shapes.ids()) {
    const Shape& shape = world.shapes[id];
    if (shape.body || std::holds_alternative<HalfSpaceShape>(shape.geometry)) continue;
    const Bounds box = bounds_of(shape.geometry, pose_of(world, shape));
    for (Vec3 corner : {box.low, box.high}) {
      for (int i = 0; i < 3 && !things.empty(); i++)
        corner[i] = std::clamp<double>(corner[i], near.low[i], near.high[i]);
      all.add(corner);
    }
  }
  return all;
}

Stage find_stage(const World& world) {
  Stage stage;
  find_box(world, stage);
  stage.size = largest(stage.upper - stage.lower);
  std::vector<double> list = lengths(world);
  stage.unit = list.empty() ? nearest_distance(world) : median(list);
  if (!(stage.unit > 0.0)) stage.unit = stage.size > 0.0 ? stage.size : 1.0;
  if (!(stage.size > 0.0)) stage.size = stage.unit;
  stage.size = std::fmax(stage.size, stage.unit);
  if (const auto floor = level_floor(world, stage)) {
    stage.ground = *floor;
    return stage;
  }
  const double low = stage.lower[1];
  stage.ground = low >= -1e-6 * stage.size && low < 0.6 * stage.size ? 0.0 : low - 0.1 * stage.size;
  return stage;
}

Camera first_camera(const Stage& stage, double aspect) {
  Camera camera;
  const Vec3 margin = vec(1, 1, 1) * (0.12 * stage.unit);
  const Vec3 floor = vec(0, std::fmin(0.0, stage.ground - stage.lower[1]), 0);
  camera.frame(stage.lower - margin + floor * 0.5, stage.upper + margin, aspect);
  return camera;
}

}  // namespace pantin
