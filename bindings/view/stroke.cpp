#include "view/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/find.hpp"
#include "shapes/ray.hpp"
#include "view/draw_list.hpp"
#include "view/pick.hpp"

namespace pantin {

namespace {

constexpr double click_reach = 24.0, tie_reach = 9.0, stroke_reach = 6.0,
                 reach_on_shape = 14.0;  // [px]

struct StrokeSpot {
  double x = 0.0, y = 0.0;  // [px]
};

double across(StrokeSpot o, StrokeSpot a, StrokeSpot b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

double distance(StrokeSpot p, StrokeSpot a, StrokeSpot b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Of two lines; 0 where they cross.
double distance(StrokeSpot a, StrokeSpot b, StrokeSpot c, StrokeSpot d) {
  const bool cross = across(a, b, c) * across(a, b, d) < 0.0 && across(c, d, a) * across(c, d, b) < 0.0;
  if (cross) return 0.0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// Puts all that can be cut before `visit(thing, from, to, tie)`.
template <class Visit>
void each_cuttable(const World& world, const Visit& visit) {
  for (std::uint32_t s = 0; s < world.particles.slots(); s++)
    if (world.particles.alive_at(s) && world.particles.at_slot(s).is_hinge()) visit(AnyId(world.particles.id_at(s)));
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++) {
    if (!world.constraints.alive_at(s)) continue;
    const Constraint& c = world.constraints.at_slot(s);
    if (is_cuttable(c) && c.hand < 0) visit(AnyId(world.constraints.id_at(s)));
  }
  for (std::uint32_t s = 0; s < world.connections.slots(); s++)
    if (world.connections.alive_at(s) && world.connections.at_slot(s).count == 2)
      visit(AnyId(world.connections.id_at(s)));
}

/// Pixels between a stroke and a line of the world; infinite where that is not seen. Of a string all parts count.
double distance_to(const Viewport& viewport, const AnyId& thing, const Stroke& stroke) {
  const auto to_line = [&](Vec3 from, Vec3 to) {
    const auto a = viewport.project(from), b = viewport.project(to);
    if (!a || !b) return std::numeric_limits<double>::infinity();
    return distance({stroke.x0, stroke.y0}, {stroke.x1, stroke.y1}, {a->x, a->y}, {b->x, b->y});
  };
  if (const auto* id = std::get_if<ConstraintId>(&thing)) {
    ConstraintLook look;
    find_look(viewport.world, viewport.world.constraints[*id], viewport.stage, look);
    double least = std::numeric_limits<double>::infinity();
    for (const ConstraintLook::Line& line : look.lines) least = std::min(least, to_line(line.from, line.to));
    if (!look.lines.empty()) return least;
  }
  const Seen seen = seen_place(viewport, thing);
  return to_line(seen.from, seen.to);
}

/// Pixels of the pixel from the body's outline, 0 within: of the hull of its points and centre as they are seen.
double distance_to_outline(std::vector<StrokeSpot>& spots, StrokeSpot at) {
  std::sort(spots.begin(), spots.end(),
            [](StrokeSpot a, StrokeSpot b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<StrokeSpot> hull;  // Andrew's monotone chain
  for (int side = 0; side < 2; side++) {
    const std::size_t start = hull.size();
    for (const StrokeSpot& p : spots) {
      while (hull.size() >= start + 2 && across(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(spots.begin(), spots.end());
  }
  if (hull.size() < 2) return std::hypot(spots[0].x - at.x, spots[0].y - at.y);
  bool inside = hull.size() > 2;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); i++) {
    const StrokeSpot a = hull[i], b = hull[(i + 1) % hull.size()];
    inside = inside && across(a, b, at) >= 0.0;
    least = std::min(least, distance(at, a, b));
  }
  return inside ? 0.0 : least;
}

}  // namespace

Seen seen_place(const Viewport& viewport, const AnyId& thing) {
  const World& world = viewport.world;
  if (const auto* hinge = std::get_if<ParticleId>(&thing)) {
    const Vec3 at = shown_place(world, star(world, *hinge));
    return {at, at, false};
  }
  if (const auto* tie = std::get_if<ConnectionId>(&thing)) {
    const Connection& c = world.connections[*tie];
    const Vec3 a = end_of(world, c, 0), from = a + image_shift(world, a);
    return {from, from + end_of(world, c, 1) - a, true};
  }
  if (const auto* body = std::get_if<BodyId>(&thing)) {
    const Vec3 at = world.motion_of(*body).x;
    return {at + image_shift(world, at), at + image_shift(world, at), false};
  }
  const auto* id = std::get_if<ConstraintId>(&thing);
  if (!id) return {};
  const Constraint& c = world.constraints[*id];
  ConstraintLook look;
  find_look(world, c, viewport.stage, look);
  if (!look.lines.empty()) return {look.lines.front().from, look.lines.back().to, true};
  if (!c.a) return {};
  return {shown_place(world, c.a), shown_place(world, c.a), false};
}

std::vector<AnyId> cuttable(const Viewport& viewport, const Stroke& stroke) {
  const bool click = stroke.x0 == stroke.x1 && stroke.y0 == stroke.y1;
  std::vector<AnyId> found;
  double best = std::numeric_limits<double>::infinity();
  each_cuttable(viewport.world, [&](const AnyId& thing) {
    const bool tie = seen_place(viewport, thing).tie;
    const double away = distance_to(viewport, thing, stroke);
    if (!click) {
      if (away <= (tie ? 0.0 : stroke_reach)) found.push_back(thing);
      return;
    }
    // What is small wins against the lines that end in it.
    const double score = tie ? away + click_reach : away;
    if (away > (tie ? tie_reach : click_reach) || score >= best) return;
    best = score;
    found = {thing};
  });
  return found;
}

std::optional<OnShape> pick_shape(const Viewport& viewport, double x, double y) {
  const World& world = viewport.world;
  if (world.shapes.size() == 0) return {};
  const double deepest = 4.0 * (viewport.camera.distance + viewport.stage.size);
  const Vec3 from = viewport.camera.eye(), to = viewport.place(x, y, deepest);
  std::optional<OnShape> found;
  double best = infinity;
  for (std::uint32_t s = 0; s < world.shapes.slots(); s++) {
    if (!world.shapes.alive_at(s)) continue;
    const Shape& shape = world.shapes.at_slot(s);
    const Vec3 shift = shape.body ? image_shift(world, world.motion_of(shape.body).x) : zero3();
    Pose pose = pose_of(world, shape);
    pose.x += shift;
    const auto hit = finite(pose.x) ? ray(shape.geometry, pose, from, to) : std::nullopt;
    if (!hit || hit->part >= best) continue;
    best = hit->part;
    found = {shape.body, from + (to - from) * best - shift, best * deepest};
  }
  return found;
}

namespace {

/// In or near the outline of a body's points and its centre.
BodyId pick_outline(const Viewport& viewport, double x, double y, double reach) {
  BodyId found;
  double best = reach, depth = std::numeric_limits<double>::infinity();
  std::vector<StrokeSpot> spots;
  for (std::uint32_t s = 0; s < viewport.world.bodies.slots(); s++) {
    if (!viewport.world.bodies.alive_at(s)) continue;
    const BodyId id = viewport.world.bodies.id_at(s);
    const Vec3 centre = viewport.world.motion[s].x;
    const auto middle = viewport.project(centre + image_shift(viewport.world, centre));
    if (!middle) continue;
    spots = {{middle->x, middle->y}};
    for (PointId p : viewport.world.bodies[id].points)
      if (const auto seen = viewport.project(shown_place(viewport.world, p))) spots.push_back({seen->x, seen->y});
    const double away = distance_to_outline(spots, {x, y});
    if (away > best || (away == best && middle->depth >= depth)) continue;
    best = away;
    depth = middle->depth;
    found = id;
  }
  return found;
}

}  // namespace

BodyId pick_body(const Viewport& viewport, double x, double y, double reach) {
  if (const auto spot = pick_shape(viewport, x, y); spot && spot->body) return spot->body;
  return pick_outline(viewport, x, y, reach);
}

Vec3 shown_place(const World& world, const Held& held) {
  if (held.point) return shown_place(world, held.point);
  return held.at + (held.body ? image_shift(world, world.motion_of(held.body).x) : zero3());
}

Held pick_held(const Viewport& viewport, double x, double y) {
  const World& world = viewport.world;
  const auto spot = pick_shape(viewport, x, y);
  const double reach = spot && spot->body ? reach_on_shape : 40.0;
  if (const PointId point =
          pick_point(world, viewport.stage, viewport.camera, x, y, viewport.width, viewport.height, reach)) {
    const auto seen = viewport.project(shown_place(world, point));
    const bool same = spot && spot->body && world.points[point].body == spot->body;
    if (!spot || same || (seen && seen->depth <= spot->depth)) return {point, {}, zero3()};
  }
  if (spot && spot->body) return {{}, spot->body, spot->at};
  const BodyId body = pick_outline(viewport, x, y, 12.0);
  Held found;
  double best = infinity;
  if (!body) return found;
  for (PointId p : world.bodies[body].points) {
    const auto seen = viewport.project(shown_place(world, p));
    const double away = seen ? std::hypot(seen->x - x, seen->y - y) : best;
    if (away < best) best = away, found.point = p;
  }
  return found;
}

AnyId pick_thing(const Viewport& viewport, double x, double y) {
  if (const BodyId body = pick_body(viewport, x, y, 6.0)) return body;
  const PointId point =
      pick_point(viewport.world, viewport.stage, viewport.camera, x, y, viewport.width, viewport.height, 14.0);
  if (point && !viewport.world.points[point].body) return viewport.world.points[point].own;
  if (const std::vector<AnyId> ties = cuttable(viewport, {x, y, x, y});
      !ties.empty() && seen_place(viewport, ties[0]).tie)
    return ties[0];
  if (const BodyId body = pick_body(viewport, x, y)) return body;
  return {};
}

}  // namespace pantin
