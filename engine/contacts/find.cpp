#include "contacts/find.hpp"

#include <algorithm>

#include "base/subnormals.hpp"
#include "contacts/bodies.hpp"
#include "contacts/crowd.hpp"

namespace pantin {

namespace {

Pose in_principal_axes(const Body& body, const Shape& shape) {
  const Quat to_axes = conjugate(body.axes);
  return {rotate(to_axes, shape.at - body.centre), matrix(to_axes * shape.orientation)};
}

constexpr double still = 0.01;  // of the thickness

Placed place(const Placement& p, const Shape& shape) {
  Placed placed;
  placed.thickness = thickness_of(shape.geometry);
  placed.reach = reach_of(shape.geometry);
  if (std::isfinite(placed.thickness)) placed.margin = still * placed.thickness;
  if (!shape.body) {
    placed.pose = {shape.at, matrix(shape.orientation)};
    return placed;
  }
  const std::uint32_t slot = shape.body.slot - 1;
  const BodyState s = state_of(p.model, p.articulates, slot, p.drifted);
  placed.moves = !sleeps_in_touch(p.contacts, slot);
  placed.pose = Pose{s.x, s.R} * in_principal_axes(p.model.bodies[shape.body], shape);
  placed.arm = placed.pose.x - s.x;
  placed.going.mass = s.mass;
  if (!placed.moves) return placed;
  placed.going = {p.drifted ? s.v - p.gravity * (0.5 * p.drift) : s.v, s.w, s.mass};
  const double arm = norm(placed.arm) + placed.reach;
  placed.margin += p.h * (norm(s.v) + norm(s.w) * arm + norm(p.gravity) * p.h);
  return placed;
}

Bounds widened(Bounds b, double margin) {
  const Vec3 by = vec(margin, margin, margin);
  return {b.low - by, b.high + by};
}

bool are_tied(const ContactFinder& finder, std::uint32_t x, std::uint32_t y) {
  return std::binary_search(finder.tied.begin(), finder.tied.end(), std::pair(std::min(x, y), std::max(x, y)));
}

/// `rule`: of their layers, or null.
bool may_touch(const ContactFinder& finder, const Shape& a, const Shape& b, const LayerRule* rule) {
  if (rule && !rule->collide) return false;
  if (!a.body && !b.body) return false;
  return !a.body || !b.body || (a.body != b.body && !are_tied(finder, a.body.slot - 1, b.body.slot - 1));
}

/// Sets how bodies go on: less what contacts stopped in the last drift, since the end of the step does not give that back.
void find_going(const Model& model, ContactFinder& finder, const Contacts& contacts) {
  constexpr double least_stop = 1e-6;  // part of the speed: less is round-off
  std::vector<Going>& going = finder.going;
  for (const std::uint32_t s : finder.moving) going[model.shapes.at_slot(s).body.slot - 1] = finder.placed[s].going;
  for (const Contact& c : contacts.list) {
    Going world, &a = going[number_of(model, c.body_a)],
                 &b = c.body_b < 0 ? world : going[number_of(model, static_cast<std::uint32_t>(c.body_b))];
    const double nearing = -dot(c.normal, a.v - b.v), lightness = 1.0 / a.mass + 1.0 / b.mass;
    if (!(nearing > 0.0 && dot(c.placing, c.normal) * lightness > least_stop * nearing)) continue;
    a.v += c.normal * (nearing / (a.mass * lightness));
    b.v -= c.normal * (nearing / (b.mass * lightness));
  }
}

/// Whether one of these shapes kept the other out in the last drift: they touch, and neither passes the other by.
bool held(const Contacts& contacts, const ContactKey& key) {
  const auto before = [](const Contact& c, const ContactKey& k) {
    return std::pair(c.key.a, c.key.b) < std::pair(k.a, k.b);
  };
  auto c = std::lower_bound(contacts.list.begin(), contacts.list.end(), key, before);
  for (; c != contacts.list.end() && c->key.same_shapes(key); c++)
    if (norm2(c->placing) > 0.0) return true;
  return false;
}

/// One of two that may touch.
struct Side {
  std::uint32_t key;
  std::int32_t thing;  // or -1: the world
  const Geometry& geometry;
  const Placed& placed;
  const Going& going;
  double friction, restitution, rolling, spinning;
  Vec3 belt;  // [m/s]
  bool sensor;
  bool is_solid_point() const { return thing >= 0 && is_point(static_cast<std::uint32_t>(thing)); }
};

Travel travel(const Side& a, const Side& b, double h) {
  const Vec3 of_b = b.going.v + cross(b.going.w, a.placed.pose.x - b.placed.pose.x + b.placed.arm);
  return {(a.going.v + cross(a.going.w, a.placed.arm) - of_b) * h, (a.going.w - b.going.w) * h};
}

Roundness roundness_of(const Geometry& shape, const Pose& pose) {
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return {cylinder->radius, pose.R[2]};
  return {is_convex(shape) ? rounding_of(shape) : 0.0, zero3()};
}

/// How its surface moves on it [m/s], world axes.
Vec3 belt_of(const Shape& shape, const Placed& placed) {
  const Vec3 v = shape.material.surface_velocity;
  return norm2(v) == 0.0 ? v : placed.pose.R * transposed_times(matrix(shape.orientation), v);
}

/// The points of one pair.
class Collector final : public ManifoldSink {
 public:
  Collector(const Side& a, const Side& b, const LayerRule* rule, const Contacts& before, double h, FoundContacts& found)
      : a_(a), b_(b), rule_(rule), before_(before), h_(h), to_(a.sensor || b.sensor ? found.sensed : found.list) {}

  void take(const Manifold& m, std::uint32_t part) override {
    if (like_.body_a == none) set_like();
    const bool in_point = a_.is_solid_point() && !b_.is_solid_point();
    for (std::uint32_t i = 0; i < m.count; i++) {
      const ManifoldPoint& p = m.points[i];
      Contact& c = to_.emplace_back(like_);
      c.key.part = part;
      c.key.feature = p.id;
      c.normal = p.normal;
      c.gap = p.gap;
      const Vec3 x_a = a_.placed.pose.x;
      if (p.id == inner_ball_id) c.round_a = {norm(p.on_a - x_a), zero3()};
      c.at = in_point ? x_a : c.body_b < 0 ? p.on_a : p.on_a - p.normal * (0.5 * p.gap);
    }
  }
  Travel motion() const override { return held(before_, {a_.key, b_.key, 0, 0}) ? Travel{} : travel(a_, b_, h_); }

 private:
  static constexpr std::uint32_t none = ~0u;

  void set_like() {
    like_.key = {a_.key, b_.key, 0, 0};
    like_.body_a = static_cast<std::uint32_t>(a_.thing);
    like_.body_b = b_.thing;
    like_.size = std::min(a_.placed.thickness, b_.placed.thickness);
    like_.friction = rule_ && rule_->friction ? *rule_->friction : std::sqrt(a_.friction * b_.friction);
    like_.restitution = rule_ && rule_->restitution ? *rule_->restitution : std::max(a_.restitution, b_.restitution);
    if (!a_.is_solid_point()) {  // what does not turn does not roll
      like_.rolling = std::max(a_.rolling, b_.rolling);
      like_.spinning = std::max(a_.spinning, b_.spinning);
    }
    like_.round_a = roundness_of(a_.geometry, a_.placed.pose);
    like_.round_b = roundness_of(b_.geometry, b_.placed.pose);
    like_.belt = a_.belt - b_.belt;
  }

  const Side &a_, &b_;
  const LayerRule* rule_;
  const Contacts& before_;
  double h_;
  std::vector<Contact>& to_;
  Contact like_ = [] {
    Contact c;
    c.body_a = none;
    return c;
  }();
};

}  // namespace

Pose pose_of(const Model& m, const Shape& shape) {
  if (!shape.body) return {shape.at, matrix(shape.orientation)};
  const Motion& motion = m.motion_of(shape.body);
  return Pose{motion.x, matrix(motion.q)} * in_principal_axes(m.bodies[shape.body], shape);
}

namespace {

/// Leaves out contacts where a hinge is: it keeps these together, so that impulses there would have no bound.
void drop_at_hinges(const Placement& p, const std::vector<HingedPair>& hinged, std::vector<Contact>& list) {
  constexpr double near = 0.05;  // of the size
  if (hinged.empty()) return;
  const auto is_before = [](const HingedPair& h, const std::pair<std::uint32_t, std::uint32_t>& bodies) {
    return std::pair(h.a, h.b) < bodies;
  };
  std::erase_if(list, [&](const Contact& c) {
    const auto b = static_cast<std::uint32_t>(c.body_b);  // of the world: of no body
    const std::pair bodies(std::min(c.body_a, b), std::max(c.body_a, b));
    auto h = std::lower_bound(hinged.begin(), hinged.end(), bodies, is_before);
    for (; h != hinged.end() && std::pair(h->a, h->b) == bodies; h++) {
      const BodyState s = state_of(p.model, p.articulates, h->a, p.drifted);
      const Vec3 d = c.at - s.x - s.R * h->arm, axis = s.R * h->axis;
      if (norm(d - axis * dot(axis, d)) < near * c.size) return true;
    }
    return false;
  });
}

void put(const Placement& p, ContactFinder& finder, std::uint32_t s) {
  const Shape& shape = p.model.shapes.at_slot(s);
  const Placed& placed = finder.placed[s] = place(p, shape);
  const double slack = placed.moves ? placed.margin + 0.1 * placed.thickness : 0.0;
  const std::uint32_t owner = shape.body ? shape.body.slot : BoundsTree::none;
  finder.broad_phase.put({widened(bounds_of(shape.geometry, placed.pose), placed.margin), s, placed.moves, owner},
                         slack);
}

void put_all(const Placement& p, ContactFinder& finder) {
  const Store<Shape>& shapes = p.model.shapes;
  finder.placed.resize(shapes.slots());
  finder.serials.resize(shapes.slots(), 0);
  finder.going.assign(p.model.bodies.slots() + (p.model.solids ? p.model.points.slots() : 0), Going{});
  finder.height_fields.clear();
  finder.moving.clear();
  for (std::uint32_t s = 0; s < shapes.slots(); s++) {
    const bool alive = shapes.alive_at(s);
    if (finder.serials[s] != 0 && (!alive || finder.serials[s] != shapes.at_slot(s).serial))
      finder.broad_phase.remove(s);
    finder.serials[s] = alive ? shapes.at_slot(s).serial : 0;
    if (!alive) continue;
    const Shape& shape = shapes.at_slot(s);
    if (std::holds_alternative<std::shared_ptr<const HeightField>>(shape.geometry)) finder.height_fields.push_back(s);
    put(p, finder, s);
    if (finder.placed[s].moves) finder.moving.push_back(s);
    if (shape.body) finder.going[shape.body.slot - 1] = finder.placed[s].going;
  }
  finder.changed = false;
  finder.sleep_changes = p.contacts.sleep_changes;
}

}  // namespace

void put_bounds(const Placement& p, ContactFinder& finder) {
  finder.displaced = false;
  if (finder.changed || finder.sleep_changes != p.contacts.sleep_changes) return put_all(p, finder);
  for (const std::uint32_t s : finder.moving) put(p, finder, s);
}

namespace {

/// Pairs that may touch, first the slot of a contact's shape a, in the order of their keys.
void choose_pairs(const Model& model, ContactFinder& finder) {
  finder.pairs.clear();
  for (const auto& [first, second] : finder.broad_phase.pairs()) {
    const Shape &x = model.shapes.at_slot(first), &y = model.shapes.at_slot(second);
    if (!may_touch(finder, x, y, model.layers.rule(x.layer, y.layer))) continue;
    finder.pairs.push_back(x.body ? BroadPhase::Pair(first, second) : BroadPhase::Pair(second, first));
  }
  if (!std::is_sorted(finder.pairs.begin(), finder.pairs.end())) std::sort(finder.pairs.begin(), finder.pairs.end());
}

bool by_key(const Contact& a, const Contact& b) { return a.key < b.key; }

/// Whether balls about two shapes are farther apart than the margin.
bool is_far(const Side& a, const Side& b, double margin) {
  const Vec3 d = a.placed.pose.x - b.placed.pose.x;
  const double reach = a.placed.reach + margin;
  if (std::holds_alternative<HalfSpaceShape>(b.geometry)) return dot(b.placed.pose.R[2], d) > reach;
  const double both = reach + b.placed.reach;
  return is_convex(b.geometry) && norm2(d) > both * both;
}

void add_contacts(const Side& a, const Side& b, const LayerRule* rule, const Contacts& before, double h, double margin,
                  FoundContacts& found) {
  if (is_far(a, b, margin)) return;
  std::vector<Contact>& to = a.sensor || b.sensor ? found.sensed : found.list;
  const auto first = static_cast<std::ptrdiff_t>(to.size());
  Collector collector(a, b, rule, before, h, found);
  SeparationCache cache;
  const double turning = h * norm(a.going.w - b.going.w) * std::min(a.placed.reach, b.placed.reach);
  find_manifolds(a.geometry, a.placed.pose, b.geometry, b.placed.pose, {margin, turning}, cache, collector);
  if (!std::is_sorted(to.begin() + first, to.end(), by_key)) std::sort(to.begin() + first, to.end(), by_key);
}

Side side_of(const Model& model, const ContactFinder& finder, std::uint32_t slot) {
  const Shape& s = model.shapes.at_slot(slot);
  const Placed& at = finder.placed[slot];
  return {slot,
          s.body ? static_cast<std::int32_t>(s.body.slot - 1) : -1,
          s.geometry,
          at,
          s.body ? finder.going[s.body.slot - 1] : at.going,
          s.material.friction,
          s.material.restitution,
          s.material.rolling,
          s.material.spinning,
          belt_of(s, at),
          s.sensor};
}

void find_of_pair(const Placement& p, const ContactFinder& finder, const Contacts& contacts, BroadPhase::Pair pair,
                  FoundContacts& found) {
  const auto [a, b] = pair;
  const LayerRule* rule = p.model.layers.rule(p.model.shapes.at_slot(a).layer, p.model.shapes.at_slot(b).layer);
  add_contacts(side_of(p.model, finder, a), side_of(p.model, finder, b), rule, contacts, p.h,
               finder.placed[a].margin + finder.placed[b].margin, found);
}

/// Of all pairs, by key.
void find_of_pairs(const Placement& p, ContactFinder& finder, const Contacts& contacts, Workers& workers) {
  constexpr std::size_t enough = 24;  // some 20 us of work: a thread is slow to wake
  const std::size_t count = finder.pairs.size();
  const std::size_t blocks = workers.count() == 1 ? 1 : std::clamp<std::size_t>(count / enough, 1, 64);
  if (finder.found.size() < blocks) finder.found.resize(blocks);
  workers.run(blocks, [&](std::size_t block, int) {
    const SubnormalsAreZero subnormals_are_zero;
    FoundContacts& found = finder.found[block];
    found.list.clear();
    found.sensed.clear();
    for (std::size_t k = count * block / blocks; k < count * (block + 1) / blocks; k++)
      find_of_pair(p, finder, contacts, finder.pairs[k], found);
  });
  const auto append = [](std::vector<Contact>& to, const std::vector<Contact>& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  FoundContacts& all = finder.found[0];
  for (std::size_t block = 1; block < blocks; block++) {
    append(all.list, finder.found[block].list);
    append(all.sensed, finder.found[block].sensed);
  }
}

/// Places solid points and tells how they go on.
void place_points(const Placement& p, ContactFinder& finder) {
  finder.placed_points.clear();
  for (const SolidPoint& point : finder.solids) {
    const std::uint32_t thing = point_thing(point.slot);
    const BodyState s = state_of(p.model, p.articulates, thing, p.drifted);
    const bool falls = p.drifted && !is_loose_point(p.model, thing);
    finder.going[number_of(p.model, thing)] = {falls ? s.v - p.gravity * (0.5 * p.drift) : s.v, zero3(), s.mass};
    const double rest = still * 2.0 * point.radius + norm(p.gravity) * p.h * p.h;
    finder.placed_points.push_back(
        {s.x, s.v * p.h, rest, rest + norm(s.v) * p.h, !asleep(p.model, p.articulates, p.contacts, thing)});
  }
}

/// Calls use(side) with one of the solid points.
template <class Use>
void with_point(const Model& model, const ContactFinder& finder, std::size_t i, Use use) {
  const SolidPoint& point = finder.solids[i];
  const std::uint32_t thing = point_thing(point.slot);
  const Geometry ball = BallShape{point.radius};
  Placed at;
  at.reach = point.radius;
  at.thickness = 2.0 * point.radius;
  at.pose.x = finder.placed_points[i].x;
  use(Side{thing, static_cast<std::int32_t>(thing), ball, at, finder.going[number_of(model, thing)],
           point.touch.friction, point.touch.restitution, 0.0, 0.0, zero3(), false});
}

void points_on_shapes(const Placement& p, const ContactFinder& finder, const Contacts& contacts, FoundContacts& found) {
  for (std::size_t i = 0; i < finder.solids.size(); i++) {
    const SolidPoint& point = finder.solids[i];
    const PlacedPoint& at = finder.placed_points[i];
    finder.broad_phase.in_box(widened({at.x, at.x}, point.radius + at.margin), [&](std::uint32_t slot) {
      const Shape& shape = p.model.shapes.at_slot(slot);
      const Placed& placed = finder.placed[slot];
      const LayerRule* rule = p.model.layers.rule(point.touch.layer, shape.layer);
      if ((rule && !rule->collide) || !(at.moves || placed.moves)) return;
      if (shape.body && are_tied(finder, point_thing(point.slot), shape.body.slot - 1)) return;
      with_point(p.model, finder, i, [&](const Side& a) {
        add_contacts(a, side_of(p.model, finder, slot), rule, contacts, p.h, at.margin + placed.margin, found);
      });
      require_no_crowd(found.list.size(), finder.solids.size() + finder.placed.size(), {at.x, at.x});
    });
  }
}

void points_on_points(const Placement& p, ContactFinder& finder, const Contacts& contacts, FoundContacts& found) {
  std::vector<std::uint32_t> index(p.model.points.slots());
  for (std::uint32_t i = 0; i < finder.solids.size(); i++) {
    const SolidPoint& point = finder.solids[i];
    if (!point.among_others) continue;
    const PlacedPoint& at = finder.placed_points[i];
    index[point.slot] = i;
    Bounds bounds;
    bounds.add(at.x);
    bounds.add(at.x + at.way);
    finder.points.put({widened(bounds, point.radius + at.still), point.slot, at.moves}, 0.2 * point.radius);
  }
  for (const auto& pair : finder.points.pairs()) {
    const std::uint32_t i = index[pair.first], j = index[pair.second];
    const SolidPoint &x = finder.solids[i], &y = finder.solids[j];
    PlacedPoint &at_x = finder.placed_points[i], &at_y = finder.placed_points[j];
    const double nearing = norm(at_x.way - at_y.way);
    const double margin = at_x.still + at_y.still + nearing, reach = x.radius + y.radius + margin;
    if (norm2(at_x.x - at_y.x) > reach * reach) continue;
    const LayerRule* rule = p.model.layers.rule(x.touch.layer, y.touch.layer);
    if ((rule && !rule->collide) || are_tied(finder, point_thing(x.slot), point_thing(y.slot))) continue;
    for (PlacedPoint* pushed : {&at_x, &at_y})  // one may push the other on to what it would not have met
      pushed->margin = std::max(pushed->margin, pushed->still + norm(pushed->way) + nearing);
    with_point(p.model, finder, i, [&](const Side& a) {
      with_point(p.model, finder, j, [&](const Side& b) { add_contacts(a, b, rule, contacts, p.h, margin, found); });
    });
  }
}

/// Their keys are above those of shapes.
void find_of_points(const Placement& p, ContactFinder& finder, const Contacts& contacts, FoundContacts& found) {
  const auto first = static_cast<std::ptrdiff_t>(found.list.size()),
             first_sensed = static_cast<std::ptrdiff_t>(found.sensed.size());
  points_on_points(p, finder, contacts, found);
  points_on_shapes(p, finder, contacts, found);
  std::sort(found.list.begin() + first, found.list.end(), by_key);
  std::sort(found.sensed.begin() + first_sensed, found.sensed.end(), by_key);
}

}  // namespace

void find_contacts(const Placement& p, ContactFinder& finder, Workers& workers, Contacts& contacts) {
  put_bounds(p, finder);
  place_points(p, finder);
  find_going(p.model, finder, contacts);
  choose_pairs(p.model, finder);
  find_of_pairs(p, finder, contacts, workers);
  FoundContacts& found = finder.found[0];
  if (!finder.solids.empty()) find_of_points(p, finder, contacts, found);
  drop_at_hinges(p, finder.hinged, found.list);
  keep_impulses(contacts.list, found.list);
  contacts.list.swap(found.list);
  contacts.sensed.swap(found.sensed);
  contacts.stale = false;
}

}  // namespace pantin
