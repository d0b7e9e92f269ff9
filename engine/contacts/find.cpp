#include "contacts/find.hpp"

#include <algorithm>

#include "base/subnormals.hpp"
#include "contacts/bodies.hpp"

namespace pantin {

namespace {

Pose in_principal_axes(const Body& body, const Shape& shape) {
  const Quat to_axes = conjugate(body.axes);
  return {rotate(to_axes, shape.at - body.centre), matrix(to_axes * shape.orientation)};
}

Placed place(const Placement& p, const Shape& shape) {
  constexpr double still = 0.01;  // of the thickness
  Placed placed;
  const double size = thickness_of(shape.geometry);
  if (std::isfinite(size)) placed.margin = still * size;
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
  const double arm = norm(placed.arm) + reach_of(shape.geometry);
  placed.margin += p.h * (norm(s.v) + norm(s.w) * arm + norm(p.gravity) * p.h);
  return placed;
}

Bounds widened(Bounds b, double margin) {
  const Vec3 by = vec(margin, margin, margin);
  return {b.low - by, b.high + by};
}

/// `rule`: of their layers, or null.
bool may_touch(const ContactFinder& finder, const Shape& a, const Shape& b, const LayerRule* rule) {
  if (rule && !rule->collide) return false;
  if (!a.body && !b.body) return false;
  if (a.body && b.body) {
    if (a.body == b.body) return false;
    const std::uint32_t x = a.body.slot - 1, y = b.body.slot - 1;
    if (std::binary_search(finder.tied.begin(), finder.tied.end(), std::pair(std::min(x, y), std::max(x, y))))
      return false;
  }
  return true;
}

/// Sets how bodies go on: less what contacts stopped in the last drift, since the end of the step does not give that back.
void find_going(const Model& model, ContactFinder& finder, const Contacts& contacts) {
  constexpr double least_stop = 1e-6;  // part of the speed: less is round-off
  std::vector<Going>& going = finder.going;
  for (const std::uint32_t s : finder.moving) going[model.shapes.at_slot(s).body.slot - 1] = finder.placed[s].going;
  for (const Contact& c : contacts.list) {
    Going world, &a = going[c.body_a], &b = c.body_b < 0 ? world : going[static_cast<std::size_t>(c.body_b)];
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

Travel travel(const Going& a, const Placed& at_a, const Going& b, const Placed& at_b, double h) {
  const Vec3 of_b = b.v + cross(b.w, at_a.pose.x - at_b.pose.x + at_b.arm);
  return {(a.v + cross(a.w, at_a.arm) - of_b) * h, (a.w - b.w) * h};
}

/// The points of one pair.
struct Collector final : ManifoldSink {
  ContactKey key;
  Contact like;
  Vec3 x_a = zero3();
  std::vector<Contact>* to = nullptr;

  void take(const Manifold& m, std::uint32_t part) override {
    for (std::uint32_t i = 0; i < m.count; i++) {
      const ManifoldPoint& p = m.points[i];
      Contact c = like;
      c.key = key;
      c.key.part = part;
      c.key.feature = p.id;
      c.normal = p.normal;
      c.gap = p.gap;
      if (p.id == inner_ball_id) c.round_a = {norm(p.on_a - x_a), zero3()};
      c.at = c.body_b < 0 ? p.on_a : p.on_a - p.normal * (0.5 * p.gap);
      to->push_back(c);
    }
  }
};

Roundness roundness_of(const Geometry& shape, const Pose& pose) {
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return {cylinder->radius, pose.R[2]};
  return {is_convex(shape) ? rounding_of(shape) : 0.0, zero3()};
}

/// How its surface moves on it [m/s], world axes.
Vec3 belt_of(const Shape& shape, const Placed& placed) {
  const Vec3 v = shape.material.surface_velocity;
  return norm2(v) == 0.0 ? v : placed.pose.R * transposed_times(matrix(shape.orientation), v);
}

double friction_of(const Shape& a, const Shape& b, const LayerRule* rule) {
  return rule && rule->friction ? *rule->friction : std::sqrt(a.material.friction * b.material.friction);
}

double restitution_of(const Shape& a, const Shape& b, const LayerRule* rule) {
  return rule && rule->restitution ? *rule->restitution : std::max(a.material.restitution, b.material.restitution);
}

void keep_impulses(const std::vector<Contact>& before, std::vector<Contact>& now) {
  auto old = before.begin();
  std::vector<char> inherited(before.size(), 0);
  std::vector<std::size_t> orphans;
  const auto inherit = [&](Contact& c, std::vector<Contact>::const_iterator from) {
    c.placing = from->placing;
    c.total = from->total;
    c.placing_moment = from->placing_moment;
    c.total_moment = from->total_moment;
    c.approach = from->approach;
    c.rebound = from->rebound;
    inherited[static_cast<std::size_t>(from - before.begin())] = 1;
  };
  for (std::size_t i = 0; i < now.size(); i++) {
    while (old != before.end() && old->key < now[i].key) old++;
    if (old != before.end() && old->key == now[i].key)
      inherit(now[i], old);
    else
      orphans.push_back(i);
  }
  constexpr double near = 0.3;  // of the size
  for (const std::size_t i : orphans) {
    const ContactKey first{now[i].key.a, now[i].key.b, 0, 0};
    auto best = before.end();
    double least = near * now[i].size;
    for (auto it = std::lower_bound(before.begin(), before.end(), first,
                                    [](const Contact&c, const ContactKey&k) { return c.key < k; });
         it != before.end() && it->key.same_shapes(first); it++) {
      if (inherited[static_cast<std::size_t>(it - before.begin())]) continue;
      const double distance = norm(it->at - now[i].at);
      if (distance >= least) continue;
      least = distance;
      best = it;
    }
    if (best != before.end()) inherit(now[i], best);
  }
}

}  // namespace

Pose pose_of(const Model& m, const Shape& shape) {
  if (!shape.body) return {shape.at, matrix(shape.orientation)};
  const Motion& motion = m.motion_of(shape.body);
  return Pose{motion.x, matrix(motion.q)} * in_principal_axes(m.bodies[shape.body], shape);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> tied_bodies(const Model& m) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const auto add = [&](BodyId a, BodyId b) {
    if (a && b && a != b) pairs.emplace_back(std::min(a.slot, b.slot) - 1, std::max(a.slot, b.slot) - 1);
  };
  for (const ParticleId id : m.particles.ids()) {
    const Particle& ring = m.particles[id];
    if (!ring.joins() || ring.collide) continue;
    for (std::size_t i = 0; i < ring.points.size(); i++)
      for (std::size_t j = 0; j < i; j++) add(m.points[ring.points[i]].body, m.points[ring.points[j]].body);
  }
  for (const ConstraintId id : m.constraints.ids())
    if (const Constraint& c = m.constraints[id]; c.is<WeldData>() && c.enabled) add(c.body_a, c.body_b);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

namespace {

std::vector<HingedPair> hinged_pairs(const Model& m) {
  std::vector<HingedPair> pairs;
  for (const ParticleId id : m.particles.ids()) {
    const Particle& ring = m.particles[id];
    if (!ring.joins() || !ring.collide) continue;
    Vec3 axis = zero3();
    if (!ring.axes.empty()) {
      const Constraint& c = m.constraints[ring.axes[0]];
      axis = rotate(orientation(m, c.body_a), c.axis_a);
    }
    for (const PointId i : ring.points)
      for (const PointId j : ring.points) {
        const BodyId a = m.points[i].body, b = m.points[j].body;
        if (a && b && a.slot < b.slot)
          pairs.push_back({a.slot - 1, b.slot - 1, arm(m, i), rotate(conjugate(m.motion_of(a).q), axis)});
      }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const HingedPair& x, const HingedPair& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  return pairs;
}

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

}  // namespace

bool renew(std::unique_ptr<ContactFinder>& finder, Model& model) {
  const bool changed = !finder || model.places_changed;
  if (!finder) finder = std::make_unique<ContactFinder>();
  if (changed) finder->tied = tied_bodies(model);
  if (changed) finder->hinged = hinged_pairs(model);
  model.places_changed = false;
  finder->changed = finder->changed || changed;
  return changed;
}

namespace {

void put(const Placement& p, ContactFinder& finder, std::uint32_t s) {
  const Shape& shape = p.model.shapes.at_slot(s);
  const Placed& placed = finder.placed[s] = place(p, shape);
  const double slack = placed.moves ? placed.margin + 0.1 * thickness_of(shape.geometry) : 0.0;
  finder.broad_phase.put({widened(bounds_of(shape.geometry, placed.pose), placed.margin), s, placed.moves}, slack);
}

void put_all(const Placement& p, ContactFinder& finder) {
  const Store<Shape>& shapes = p.model.shapes;
  finder.placed.resize(shapes.slots());
  finder.serials.resize(shapes.slots(), 0);
  finder.going.assign(p.model.bodies.slots(), Going{});
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

void find_of_pair(const Placement& p, const ContactFinder& finder, const Contacts& contacts, BroadPhase::Pair pair,
                  FoundContacts& found) {
  const auto [a, b] = pair;
  const Shape &sa = p.model.shapes.at_slot(a), &sb = p.model.shapes.at_slot(b);
  const LayerRule* rule = p.model.layers.rule(sa.layer, sb.layer);
  const Placed &at_a = finder.placed[a], &at_b = finder.placed[b];
  Collector collector;
  collector.to = sa.sensor || sb.sensor ? &found.sensed : &found.list;
  collector.key = {a, b, 0, 0};
  collector.like.body_a = sa.body.slot - 1;
  collector.like.body_b = sb.body ? static_cast<std::int32_t>(sb.body.slot - 1) : -1;
  const double ta = thickness_of(sa.geometry), tb = thickness_of(sb.geometry);
  collector.like.size = std::min(ta, tb);
  collector.x_a = at_a.pose.x;
  collector.like.friction = friction_of(sa, sb, rule);
  collector.like.restitution = restitution_of(sa, sb, rule);
  collector.like.rolling = std::max(sa.material.rolling, sb.material.rolling);
  collector.like.spinning = std::max(sa.material.spinning, sb.material.spinning);
  collector.like.round_a = roundness_of(sa.geometry, at_a.pose);
  collector.like.round_b = roundness_of(sb.geometry, at_b.pose);
  collector.like.belt = belt_of(sa, at_a) - belt_of(sb, at_b);
  const Going &a_goes = finder.going[sa.body.slot - 1], &b_goes = sb.body ? finder.going[sb.body.slot - 1] : at_b.going;
  const Travel motion = held(contacts, collector.key) ? Travel{} : travel(a_goes, at_a, b_goes, at_b, p.h);
  SeparationCache cache;
  const auto before = static_cast<std::ptrdiff_t>(collector.to->size());
  find_manifolds(sa.geometry, at_a.pose, sb.geometry, at_b.pose, at_a.margin + at_b.margin, cache, collector, motion);
  std::sort(collector.to->begin() + before, collector.to->end(), by_key);
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

}  // namespace

void find_contacts(const Placement& p, ContactFinder& finder, Workers& workers, Contacts& contacts) {
  put_bounds(p, finder);
  find_going(p.model, finder, contacts);
  choose_pairs(p.model, finder);
  find_of_pairs(p, finder, contacts, workers);
  FoundContacts& found = finder.found[0];
  drop_at_hinges(p, finder.hinged, found.list);
  keep_impulses(contacts.list, found.list);
  contacts.list.swap(found.list);
  contacts.sensed.swap(found.sensed);
  contacts.stale = false;
}

}  // namespace pantin
