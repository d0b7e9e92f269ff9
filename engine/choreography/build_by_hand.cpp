#include "choreography/build_by_hand.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "base/shortened.hpp"
#include "choreography/hands.hpp"
#include "edit/assemble.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "laws/library.hpp"
#include "measure/hits.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "measure/reach.hpp"
#include "shapes/convex_parts.hpp"
#include "shapes/hull.hpp"

namespace pantin {

using namespace internal;

namespace {

/// A new point of a body, at a position in the world [m].
PointId point_on(World& world, BodyId body, Vec3 position, std::string name = "") {
  PointDef def;
  const Vec3 from = origin(world, body);
  def.at = shortened(rotate(conjugate(orientation(world, body)), position - from),
                     std::fmax(largest(position), largest(from)));
  def.name = std::move(name);
  return add_point(world, body, def);
}

/// Points that a command adds to bodies; they go again unless it is done, and leave no round-off behind.
class Anchors {
 public:
  explicit Anchors(World& world) : world_(world) {}
  ~Anchors() {
    if (done_) return;
    for (const PointId point : made_) remove_point(world_, point);
    for (auto was = before_.rbegin(); was != before_.rend(); ++was) put_back(*was);
  }
  Anchors(const Anchors&) = delete;
  Anchors& operator=(const Anchors&) = delete;
  void keep() { done_ = true; }

  /// The point, or one at a position [m] on a body; null where neither is meant.
  PointId at(PointId point, const AnyId& thing, Vec3 position) {
    if (world_.points.alive(point)) return point;
    const auto* body = std::get_if<BodyId>(&thing);
    if (!body || !world_.bodies.alive(*body)) return {};
    before_.push_back({*body, world_.bodies[*body], world_.motion_of(*body)});
    made_.push_back(point_on(world_, *body, position));
    return made_.back();
  }

 private:
  /// A body as it was before it got a point.
  struct Before {
    BodyId id;
    Body body;
    Motion motion;
  };
  void put_back(const Before& was) {
    Body& body = world_.bodies[was.id];
    body.centre = was.body.centre;
    body.axes = was.body.axes;
    body.moments = was.body.moments;
    Motion& motion = world_.motion_of(was.id);
    motion.x = was.motion.x;
    motion.p = was.motion.p;
    motion.q = was.motion.q;
    motion.angular = was.motion.angular;
    motion.inertia = was.motion.inertia;
  }

  World& world_;
  std::vector<PointId> made_;
  std::vector<Before> before_;
  bool done_ = false;
};

Color of_bytes(int r, int g, int b) {
  return {static_cast<float>(r) / 255.0f, static_cast<float>(g) / 255.0f, static_cast<float>(b) / 255.0f, 1.0f};
}

Color color_of_next(const World& world) {
  static const std::array<Color, 6> colors = {of_bytes(227, 89, 64),  of_bytes(242, 179, 92),  of_bytes(46, 120, 184),
                                              of_bytes(120, 166, 82), of_bytes(140, 112, 181), of_bytes(61, 158, 161)};
  return colors[world.bodies.size() % colors.size()];
}

std::vector<Vec3> with_ends(const World& world, const Command& c) {
  std::vector<Vec3> points = c.points;
  if (points.size() < 2) return points;
  const auto from_here = [&](PointId end) {
    const Vec3 at = position(world, end);
    return shortened(at - c.position, std::fmax(largest(at), largest(c.position)));
  };
  const Vec3 last = c.position + points.back();
  points.back() = shortened(points.back(), std::fmax(largest(last), largest(c.position)));
  if (world.points.alive(c.point)) points.front() = from_here(c.point);
  if (world.points.alive(c.other)) points.back() = from_here(c.other);
  return points;
}

void add_points(BodyDef& def, const Command& c, std::span<const Vec3> points) {
  for (const Vec3 at : points) {
    PointDef& point = def.points.emplace_back();
    point.at = at;
    point.radius = c.radius;
    point.mass = c.mass / static_cast<double>(points.size());
  }
}

/// Over a convex outline, half as thick as `half` is long to either side.
std::shared_ptr<const Hull> prism(std::span<const Vec3> outline, Vec3 half) {
  std::vector<Vec3> corners;
  for (const Vec3 at : outline) corners.insert(corners.end(), {at - half, at + half});
  return make_hull(corners);
}

void add_prisms(BodyDef& def, const Command& c, std::span<const Vec3> outline) {
  require(norm2(c.amount) > 0.0, "make: a polygon has a thickness");
  for (const std::vector<Vec3>& part : convex_parts(outline, c.amount)) {
    ShapeDef& shape = def.shapes.emplace_back();
    shape.color = def.color;
    shape.geometry = prism(part, c.amount);
  }
}

/// What touches has its mass by its shape; its points are anchors.
void add_shape(const World& world, BodyDef& def, const Command& c, std::span<const Vec3> points) {
  def.color = color_of_next(world);
  def.mass = c.mass;
  if (c.form == MadeForm::polygon) return add_prisms(def, c, points);
  ShapeDef& shape = def.shapes.emplace_back();
  shape.color = def.color;
  const auto add_anchor = [&](Vec3 at) { def.points.emplace_back().at = at; };
  switch (c.form) {
    case MadeForm::bare:
    case MadeForm::polygon: break;
    case MadeForm::rod: {
      require(points.size() == 2, "make: a rod has two points");
      const Vec3 way = points[1] - points[0];
      shape.geometry = CapsuleShape{c.radius, 0.5 * norm(way)};
      shape.at = 0.5 * (points[0] + points[1]);
      shape.orientation = turn_to(norm2(way) > 0.0 ? direction(way) : vec(0, 0, 1));
      for (const Vec3 at : points) add_anchor(at);
      break;
    }
    case MadeForm::ball:
      shape.geometry = BallShape{c.radius};
      add_anchor(zero3());
      break;
    case MadeForm::box: shape.geometry = BoxShape{c.amount}; break;
    case MadeForm::wheel: {
      const double half = norm(c.amount);
      require(half > 0.0, "make: a wheel has an axle");
      shape.geometry = CylinderShape{c.radius, half};
      shape.orientation = turn_to(c.amount / half);
      add_anchor(zero3());
      break;
    }
    case MadeForm::hull: shape.geometry = make_hull(points); break;
  }
}

/// Whether an axis means anything there: in a plane things turn about no other, and a particle or a line does not turn about all.
bool takes_axis(const World& world, PointId to, Vec3 axis) {
  const BodyId body = world.points[to].body;
  if (world.plane.flat() || !body || norm2(axis) == 0.0) return false;
  const Vec3 inertia = world.motion_of(body).inertia;
  return std::fmin(inertia[0], std::fmin(inertia[1], inertia[2])) > 1e-6 * largest(inertia);
}

/// Hinges an end to the point there; a wheel turns about its axle, and a rod about its axis.
void hinge_end(World& world, const Command& c, PointId end, PointId to) {
  if (!to) return;
  HingeDef def;
  const bool has_axis = c.form == MadeForm::wheel || c.form == MadeForm::rod;
  if (has_axis && takes_axis(world, to, c.amount)) def.axis = c.amount;
  const std::array ring = {to, end};
  add_hinge(world, ring, def);
}

/// [m] How far it is from a position within a body until its shapes end, on the way to another position.
double way_out(World& world, BodyId body, Vec3 from, Vec3 to) {
  double way = 0.0;
  if (!body) return way;
  for (const Hit& hit : hits_of_ray(world, to, from))
    if (world.shapes[hit.shape].body == body) way = std::fmax(way, norm(to - from) - hit.distance);
  return way;
}

/// A chain on a straight line from `from` to `to`: `count` links of one length from `start` on, each `way` after the one
/// before; and where it begins or ends in a body, a first or a last one that leads out of it.
struct ChainPlan {
  Vec3 from = zero3(), start = zero3(), way = zero3(), to = zero3();
  int count = 1;
  bool leads_out = false, leads_in = false;
  /// Where the k-th of the alike ones begins: sums of short numbers, as a loop would have them.
  Vec3 at(int k) const { return start + way * static_cast<double>(k); }
};

ChainPlan plan_chain(Vec3 from, Vec3 to, double radius, double out_of_first, double out_of_last) {
  constexpr double slender = 8.0;  // a link's length by its radius
  constexpr double most_links = 40.0;
  ChainPlan plan{from, from, zero3(), to};
  const double length = norm(to - from);
  const double first = out_of_first > 0.0 ? out_of_first + 2.0 * radius : 0.0;
  const double last = out_of_last > 0.0 ? out_of_last + 2.0 * radius : 0.0;
  const double rest = length - first - last;
  require(rest > 2.0 * radius, "chain: there is no room for one between them");
  const double count = std::clamp(std::round(rest / (slender * radius)), 1.0, most_links);
  plan.count = static_cast<int>(count);
  plan.leads_out = first > 0.0;
  plan.leads_in = last > 0.0;
  const double link = rest / count;
  const auto brief = [&](Vec3 v) {  // in parts of a link that are not seen
    for (int k = 0; k < 3; k++) v[k] = shortened(static_cast<double>(v[k]), 1e6 * link);
    return v;
  };
  plan.way = brief((to - from) * (link / length));
  if (plan.leads_out) plan.start = brief(from + (to - from) * (first / length));
  return plan;
}

/// Rods in a row that touch things, each hinged to the next; from a point to another, or to a place where its end is nailed.
void tie_by_chain(World& world, PointId a, PointId b, const Command& c) {
  require_positive("chain", "radius", c.radius, "m");
  const Vec3 from = position(world, a), to = b ? position(world, b) : c.points[0];
  const ChainPlan plan = plan_chain(from, to, c.radius, way_out(world, world.points[a].body, from, to),
                                    b ? way_out(world, world.points[b].body, to, from) : 0.0);
  std::vector<BodyId> links;
  const auto add_link = [&](Vec3 at, Vec3 way) {
    Command link;
    link.form = MadeForm::rod;
    link.radius = c.radius;
    BodyDef def;
    def.at = at;
    add_shape(world, def, link, std::array{zero3(), way});
    def.shapes[0].color = def.color = of_bytes(196, 164, 110);
    links.push_back(add_body(world, def));
  };
  const auto brief_way = [&](Vec3 at, Vec3 end) { return shortened(end - at, std::fmax(largest(at), largest(end))); };
  try {
    if (plan.leads_out) add_link(from, brief_way(from, plan.start));
    const int alike = plan.leads_in ? plan.count : plan.count - 1;
    for (int k = 0; k < alike; k++) add_link(plan.at(k), plan.way);
    const Vec3 rest = brief_way(plan.at(alike), to);
    // What was rounded off is in the last, which is like the others where that is nothing.
    add_link(plan.at(alike), norm(rest - plan.way) < 1e-9 * norm(plan.way) ? plan.way : rest);
    const auto end_of_link = [&](std::size_t i, std::size_t end) { return world.bodies[links[i]].points[end]; };
    for (std::size_t i = 0; i + 1 < links.size(); i++)
      add_hinge(world, std::array{end_of_link(i, 1), end_of_link(i + 1, 0)});
    add_hinge(world, std::array{a, end_of_link(0, 0)});
    if (b)
      add_hinge(world, std::array{b, end_of_link(links.size() - 1, 1)});
    else
      add_nail(world, end_of_link(links.size() - 1, 1));
  } catch (const Error&) {
    for (const BodyId link : links) remove(world, link);
    throw;
  }
}

/// [kg] Of what a point is of.
double mass_of(const World& world, PointId point) {
  const BodyId body = world.points[point].body;
  return body ? world.motion_of(body).mass : world.points[point].mass;
}

void tie_by_spring(World& world, PointId a, PointId b, Vec3 place) {
  constexpr double frequency = 3.0, damping = 0.1;  // [1/s]; of the critical one
  const double mass = b ? 1.0 / (1.0 / mass_of(world, a) + 1.0 / mass_of(world, b)) : mass_of(world, a);
  const double rate = 2.0 * std::numbers::pi * frequency;
  LawArguments arguments;
  const Vec3 to = b ? position(world, b) : place;
  arguments.numbers = {{"stiffness", mass * rate * rate},
                       {"damping", 2.0 * damping * mass * rate},
                       {"length", norm(to - position(world, a))}};
  std::vector<Law> laws = make_library_law("spring", arguments);
  auto law = std::make_shared<Law>(std::move(laws[0]));
  if (laws.size() > 1) law->also = std::make_shared<const Law>(std::move(laws[1]));
  ConnectionDef def;
  def.ends = {End{world.points[a].particle}, b ? End{world.points[b].particle} : End{ParticleId{}, place}};
  if (!world.settings.box) def.solve = Solve::at_middle;
  add_connection(world, law, def);
}

/// What it may turn against: the other body of its hinges; null: the world, where it is nailed.
BodyId held_by(const World& world, BodyId body) {
  BodyId found;
  bool nailed = false;
  for (const ParticleId hinge : hinges_of(world, body))
    for (const PointId point : world.particles[hinge].points)
      if (const BodyId other = world.points[point].body; other && other != body) found = other;
  for (const PointId point : world.bodies[body].points)
    for (const ConstraintId id : world.points[point].constraints)
      nailed = nailed || world.constraints[id].kind == ConstraintKind::nail;
  require(found || nailed, "motor: ", describe(world, body),
          " is hinged to nothing; a wheel is, where it is made on a body");
  return found;
}

}  // namespace

BodyId body_meant(const Command& c) {
  const auto* body = std::get_if<BodyId>(&c.thing);
  return body && !c.point ? *body : BodyId{};
}

PointId point_meant(World& world, const Command& c, std::string name) {
  const BodyId body = body_meant(c);
  if (!body) return c.point;
  require_finite(name_of(c.kind), "position", c.position, "m");
  return point_on(world, body, c.position, std::move(name));
}

void make_by_hand(World& world, const Command& given) {
  require(!given.points.empty(), "make: no points were given");
  require_finite("make", "position", given.position, "m");
  Command c = given;
  c.position = shortened(c.position, largest(c.position));
  if (c.points.size() == 1 && c.form == MadeForm::bare) {
    ParticleDef def;
    def.at = c.position + c.points[0];
    def.mass = c.mass;
    def.radius = c.radius;
    add_particle(world, def);
    return;
  }
  const std::vector<Vec3> points = with_ends(world, c);
  BodyDef def;
  def.at = c.position;
  if (c.form == MadeForm::bare)
    add_points(def, c, points);
  else
    add_shape(world, def, c, points);
  const BodyId body = add_body(world, def);
  try {
    Anchors anchors(world);
    const std::vector<PointId> ends = world.bodies[body].points;
    if (!ends.empty()) hinge_end(world, c, ends.front(), anchors.at(c.point, c.thing, c.position));
    if (ends.size() > 1)
      hinge_end(world, c, ends.back(), anchors.at(c.other, c.other_thing, c.position + points.back()));
    anchors.keep();
  } catch (const Error&) {
    remove(world, body);
    throw;
  }
}

void join_by_hand(World& world, const Command& c) {
  Anchors anchors(world);
  const Vec3 there = c.points.empty() ? zero3() : c.points[0];
  const PointId a = anchors.at(c.point, c.thing, c.position), b = anchors.at(c.other, c.other_thing, there);
  if (!a) throw Error(text("join: ", world.points.story(c.point)));
  if (!b) throw Error(text("join: ", world.points.story(c.other)));
  JoinDef def;
  def.max_force = c.max_force == 0.0 ? std::fmax(usual_grab_force(world, a), usual_grab_force(world, b)) : c.max_force;
  def.time_constant = 0.1;
  if (takes_axis(world, a, c.amount) && takes_axis(world, b, c.amount)) def.axis = c.amount;
  add_join(world, a, b, def);
  anchors.keep();
}

void tie_by_hand(World& world, const Command& c) {
  require(c.points.size() == 1, "tie: one place of the other end is given");
  require_finite("tie", "position", c.position, "m");
  require_finite("tie", "position", c.points[0], "m");
  Anchors anchors(world);
  const PointId a = anchors.at(c.point, c.thing, c.position);
  require(static_cast<bool>(a), "tie: what it begins at is gone");
  const PointId b = anchors.at(c.other, c.other_thing, c.points[0]);
  require(a != b, "tie: both ends are one");
  if (c.name == "rod") {
    b ? add_rod(world, a, b) : add_rod(world, a, c.points[0]);
  } else if (c.name == "rope") {
    add_string(world, {Passage{a}, b ? Passage{b} : Passage{PointId{}, c.points[0]}});
  } else if (c.name == "chain") {
    tie_by_chain(world, a, b, c);
  } else {
    require(c.name == "spring", "tie: there is no '", c.name, "'");
    tie_by_spring(world, a, b, c.points[0]);
  }
  anchors.keep();
}

void drive_by_hand(World& world, const Command& c) {
  require_finite("motor", "speed", c.amount, "rad/s");
  const BodyId body = body_meant(c) ? body_meant(c) : world.points[c.point].body;
  require(static_cast<bool>(body), "motor: ", describe(world, c.point), " is a free particle, which cannot turn");
  const Vec3 speed = world.plane.about(c.amount);
  const BodyId against = held_by(world, body);
  for (const ConstraintId id : world.constraints.ids())
    if (world.constraints[id].kind == ConstraintKind::motor && world.constraints[id].body_a == body) remove(world, id);
  if (norm2(speed) == 0.0) return;
  const Things tied = tied_to(world, world.bodies[body].points[0], false);
  const Bounds of = bounds(world, tied);
  const double reach = 0.5 * norm(of.high - of.low);
  MotorDef def;
  def.axis = speed;
  def.speed = norm(speed);
  def.max_torque = mass(world, tied) * reach * (norm(world.settings.gravity) + 5.0 * norm(speed) * reach);
  add_motor(world, body, against, def);
}

}  // namespace pantin
