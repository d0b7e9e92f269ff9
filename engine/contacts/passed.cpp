#include "contacts/passed.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "contacts/bodies.hpp"
#include "contacts/find_parts.hpp"
#include "contacts/manifold.hpp"
#include "shapes/ray.hpp"

namespace pantin {

namespace {

/// Of the inner ball: what of it may be in another shape for a step.
constexpr double grazing = 0.1;

/// How a shape went in the drift [m], taken as straight and without a turn.
struct DriftOf {
  std::int32_t body = -1;
  Vec3 way = zero3();
  Pose start;  ///< where it would have been, turned as it is now
  bool loose = false;
};

DriftOf drift_of(const ThingsNow& p, const ContactFinder& finder, std::uint32_t slot) {
  const Shape& shape = p.model.shapes.at_slot(slot);
  DriftOf g;
  g.start = finder.shapes_now[slot].pose;
  if (!shape.body || !finder.shapes_now[slot].moves) return g;
  g.body = static_cast<std::int32_t>(shape.body.slot) - 1;
  g.loose = p.model.motion[shape.body.slot - 1].articulate < 0;
  g.way = finder.shapes_now[slot].going.v * p.drift;
  g.start.x -= g.way;
  return g;
}

struct Crossing {
  double part;  ///< of the drift
  std::uint32_t a, b;
  friend bool operator<(const Crossing& x, const Crossing& y) {
    return std::tie(x.part, x.a, x.b) < std::tie(y.part, y.a, y.b);
  }
};

/// [m] The way of a body that nothing ties.
Vec3 way_in_drift(const ThingsNow& p, const Motion& m) {
  return (m.p / m.mass - p.gravity * (0.5 * p.drift)) * p.drift;
}

/// Slots of shapes that went farther than their inner ball is thick.
std::vector<std::uint32_t> far_gone(const ThingsNow& p, const ContactFinder& finder) {
  std::vector<std::uint32_t> far;
  for (const std::uint32_t slot : finder.moving) {
    const Shape& shape = p.model.shapes.at_slot(slot);
    const Motion& m = p.model.motion[shape.body.slot - 1];
    if (m.articulate >= 0 || shape.sensor) continue;
    const double way = norm(way_in_drift(p, m));
    if (way > 0.5 * finder.shapes_now[slot].thickness || way > inner_ball(shape.geometry).radius) far.push_back(slot);
  }
  return far;
}

/// Adds where a shape first went through another, if it did.
void add_crossing(const ThingsNow& p, const ContactFinder& finder, std::uint32_t a, std::uint32_t b,
                  std::vector<Crossing>& crossings) {
  const Shape &shape = p.model.shapes.at_slot(a), &other = p.model.shapes.at_slot(b);
  if (a == b || other.sensor || !may_touch(finder, shape, other, p.model.layers.rule(shape.layer, other.layer))) return;
  const DriftOf of_a = drift_of(p, finder, a), of_b = drift_of(p, finder, b);
  const auto [centre, radius] = inner_ball(shape.geometry);
  const Vec3 way = of_a.way - of_b.way;
  if (!(norm(way) > radius)) return;
  const Geometry inner = BallShape{(1.0 - grazing) * std::fmin(radius, 0.5 * finder.shapes_now[b].thickness)};
  const auto met = cast(inner, {of_a.start.to_world(centre), of_a.start.R}, way, other.geometry, of_b.start, true);
  if (!met || met->part == 0.0) return;
  const auto touched = cast(shape.geometry, of_a.start, way, other.geometry, of_b.start, true);
  crossings.push_back({touched ? touched->part : met->part, a, b});
}

/// Parts of the drift [0 … 1] where bodies are put back to. The earliest crossing first; who is put back there meets nothing later.
std::map<std::int32_t, double> choose(const ThingsNow& p, const ContactFinder& finder,
                                      std::vector<Crossing>& crossings) {
  std::sort(crossings.begin(), crossings.end());
  std::map<std::int32_t, double> parts;
  const auto waits = [&](const DriftOf& d) { return parts.contains(d.body); };
  for (const Crossing& c : crossings) {
    const DriftOf a = drift_of(p, finder, c.a), b = drift_of(p, finder, c.b);
    if (waits(a)) continue;
    if (!waits(b)) {
      parts[a.body] = c.part;
      if (b.loose && norm(b.way) > inner_ball(p.model.shapes.at_slot(c.b).geometry).radius) parts[b.body] = c.part;
      continue;
    }
    const Pose there = {b.start.x + b.way * parts[b.body], b.start.R};
    const auto met =
        cast(p.model.shapes.at_slot(c.a).geometry, a.start, a.way, p.model.shapes.at_slot(c.b).geometry, there);
    if (met) parts[a.body] = std::fmax(met->part, parts[b.body]);
  }
  return parts;
}

}  // namespace

double put_back_passed(const ThingsNow& p, ContactFinder& finder, Model& model, Contacts& contacts) {
  if (finder.changed || finder.sleep_changes != contacts.sleep_changes) put_bounds(p, finder);
  const std::vector<std::uint32_t> far = far_gone(p, finder);
  if (far.empty()) return 0.0;
  put_bounds(p, finder);
  std::vector<Crossing> crossings;
  for (const std::uint32_t a : far) {
    const DriftOf of_a = drift_of(p, finder, a);
    const auto try_with = [&](std::uint32_t b) { add_crossing(p, finder, a, b, crossings); };
    const auto [centre, radius] = inner_ball(model.shapes.at_slot(a).geometry);
    const Bounds inner = bounds_of(BallShape{radius}, {of_a.start.to_world(centre), of_a.start.R});
    finder.broad_phase.along(inner, of_a.way, try_with);
    for (const std::uint32_t field : finder.height_fields) try_with(field);
  }
  double work = 0.0;
  const auto parts = choose(p, finder, crossings);
  for (const auto& [body, part] : parts) {
    Motion& m = model.motion[static_cast<std::size_t>(body)];
    const Vec3 back = way_in_drift(p, m) * (part - 1.0);
    m.x += back;
    work -= m.mass * dot(p.gravity, back);
  }
  const auto is_back = [&](std::int32_t body) { return parts.contains(body); };
  for (Contact& c : contacts.list)  // it may never have come to where it was to meet something else
    if (is_back(static_cast<std::int32_t>(c.body_a)) || is_back(c.body_b)) c.foreseen = false;
  return work;
}

}  // namespace pantin
