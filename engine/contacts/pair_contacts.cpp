// Contacts of a pair that may touch: two shapes, or a solid point and another or a shape.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

#include "base/rotation.hpp"
#include "contacts/find_parts.hpp"
#include "shapes/ray.hpp"

namespace pantin {

namespace {

/// Whether one of these shapes kept the other out in the last drift: they touch, and neither passes the other by.
bool kept_apart(const Contacts& contacts, const ContactKey& key) {
  auto c = first_of_shapes(contacts.list, key);
  for (; c != contacts.list.end() && c->key.same_shapes(key); c++)
    if (norm2(c->place_impulse) > 0.0) return true;
  return false;
}

Travel travel(const ContactSide& a, const ContactSide& b, double h) {
  const Vec3 turn = turn_of(b.geometry, b.now.pose, b.going.w);
  const Vec3 of_b = b.going.v + cross(b.going.w, b.now.arm) + cross(turn, a.now.pose.x - b.now.pose.x);
  return {(a.going.v + cross(a.going.w, a.now.arm) - of_b) * h, (a.going.w - turn) * h};
}

Roundness roundness_of(const Geometry& shape, const Pose& pose) {
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return {cylinder->radius, pose.R[2]};
  return {is_convex(shape) ? rounding_of(shape) : 0.0, zero3()};
}

/// Whether a point of a cylinder is none of its line, or of its rim, that lies farthest along `out`: it goes with the cylinder.
bool is_beside_rim(const Geometry& shape, const Pose& pose, Vec3 on_it, Vec3 out) {
  constexpr double same_direction = 1.0 - 1e-6;
  if (!std::holds_alternative<CylinderShape>(shape)) return false;
  const Vec3 arm = pose.to_local(on_it), local = transposed_times(pose.R, out);
  const double along = arm[0] * local[0] + arm[1] * local[1];
  return along < same_direction * std::hypot(arm[0], arm[1]) * std::hypot(local[0], local[1]);
}

double restitution_of(const ContactSide& a, const ContactSide& b, const LayerRule* rule) {
  return restitution_of(a.restitution, b.restitution, rule);
}

/// The points of one pair.
class Collector final : public ManifoldSink {
 public:
  Collector(const ContactSide& a, const ContactSide& b, const LayerRule* rule, const Contacts& before, double h,
            FoundContacts& found)
      : a_(a), b_(b), rule_(rule), before_(before), h_(h), to_(a.sensor || b.sensor ? found.sensed : found.list) {}

  void take(const Manifold& m, std::uint32_t part) override {
    if (like_.body_a == none) set_like();
    const bool in_point = a_.is_solid_point() && !b_.is_solid_point();
    std::array<std::uint32_t, std::tuple_size_v<decltype(m.points)>> order;
    std::iota(order.begin(), order.end(), 0u);
    const auto end = order.begin() + m.count;
    std::partial_sort(order.begin(), end, end,
                      [&](std::uint32_t i, std::uint32_t j) { return m.points[i].id < m.points[j].id; });
    for (std::uint32_t i = 0; i < m.count; i++) {
      const ManifoldPoint& p = m.points[order[i]];
      Contact& c = to_.emplace_back(like_);
      c.key.part = part;
      c.key.feature = p.id;
      c.normal = p.normal;
      c.gap = p.gap;
      const Vec3 x_a = a_.now.pose.x;
      if (p.id == inner_ball_id)
        c.round_a = {inner_ball(a_.geometry).radius, zero3()};
      else if (is_beside_rim(a_.geometry, a_.now.pose, p.on_a, -p.normal))
        c.round_a = {};
      if (is_beside_rim(b_.geometry, b_.now.pose, p.on_a - p.normal * p.gap, p.normal)) c.round_b = {};
      c.at = in_point ? x_a : c.body_b < 0 ? p.on_a : p.on_a - p.normal * (0.5 * p.gap);
      if (m.meeting && p.id != inner_ball_id) foresee(c, p, *m.meeting, in_point);
    }
  }
  Travel motion() const override {
    return kept_apart(before_, {a_.key, b_.key, 0, 0}) ? Travel{} : motion_even_if_held();
  }
  Travel motion_even_if_held() const override { return travel(a_, b_, h_); }
  void tell_behind() override { behind_ = true; }
  bool is_behind() const { return behind_; }

 private:
  static constexpr std::uint32_t none = ~0u;

  /// Where it will be once a is there and b has turned, but not moved.
  void foresee(Contact& c, const ManifoldPoint& p, const PoseAhead& meeting, bool in_point) const {
    const Pose& there = meeting.pose;
    const Pose& now = a_.now.pose;
    const Vec3 on_a = there.to_world(now.to_local(p.on_a));
    const double gap = p.gap - dot(p.normal, p.on_a - on_a);
    const Vec3 at = in_point ? there.x : on_a - p.normal * (0.5 * gap);
    c.foreseen = true;
    c.arm_a = at - there.x + there.R * transposed_times(now.R, a_.now.arm);
    c.arm_b = at - b_.now.pose.x + b_.now.arm;
    const Vec3 turn = turn_of(b_.geometry, b_.now.pose, b_.going.w) * (h_ * meeting.part);
    if (norm2(turn) == 0.0) return;
    const Quat q = quaternion_of(turn);
    for (Vec3* v : {&c.normal, &c.arm_a, &c.arm_b}) *v = rotate(q, *v);
  }
  void set_like() {
    like_.key = {a_.key, b_.key, 0, 0};
    like_.body_a = static_cast<std::uint32_t>(a_.thing);
    like_.body_b = b_.thing;
    like_.size = std::min(a_.now.thickness, b_.now.thickness);
    like_.friction = rule_ && rule_->friction ? *rule_->friction : std::sqrt(a_.friction * b_.friction);
    like_.restitution = restitution_of(a_, b_, rule_);
    if (!a_.is_solid_point()) {  // what does not turn does not roll
      like_.rolling = std::max(a_.rolling, b_.rolling);
      like_.spinning = std::max(a_.spinning, b_.spinning);
    }
    like_.round_a = roundness_of(a_.geometry, a_.now.pose);
    like_.round_b = roundness_of(b_.geometry, b_.now.pose);
    like_.belt = a_.belt - b_.belt;
  }

  const ContactSide &a_, &b_;
  const LayerRule* rule_;
  const Contacts& before_;
  double h_;
  std::vector<Contact>& to_;
  bool behind_ = false;
  Contact like_ = [] {
    Contact c;
    c.body_a = none;
    return c;
  }();
};

/// Whether balls about two shapes are farther apart than the margin.
bool is_far(const ContactSide& a, const ContactSide& b, double margin) {
  const Vec3 d = a.now.pose.x - b.now.pose.x;
  const double reach = a.now.reach + margin;
  if (std::holds_alternative<HalfSpaceShape>(b.geometry)) return dot(b.now.pose.R[2], d) > reach;
  const double both = reach + b.now.reach;
  return is_convex(b.geometry) && norm2(d) > both * both;
}

bool turns_far(const ContactSide& side, double h) {
  constexpr double far = 0.5;  // [rad]
  const double far_in_step = far * far / (h * h);
  if (!(norm2(side.going.w) > far_in_step)) return false;
  const bool central = norm2(side.now.arm) == 0.0;
  return !central || norm2(turn_of(side.geometry, side.now.pose, side.going.w)) > far_in_step;
}

/// Whether one turns so far in the step that its points go anywhere, and yet the two cannot meet: what turns far is any turn of
/// itself about its body's centre.
bool only_turns(const ContactSide& a, const ContactSide& b, double h) {
  const bool a_turns = turns_far(a, h), b_turns = turns_far(b, h);
  if (!a_turns && !b_turns) return false;
  const auto ball = [](const ShapeNow& now) { return BallShape{norm(now.arm) + now.reach}; };
  const auto centre = [](const ShapeNow& now) { return Pose{now.pose.x - now.arm, now.pose.R}; };
  const auto way = [&](const ContactSide& side, bool turns) {
    return (turns ? side.going.v : side.going.v + cross(side.going.w, side.now.arm)) * h;
  };
  return !cast(a_turns ? ball(a.now) : a.geometry, a_turns ? centre(a.now) : a.now.pose,
               way(a, a_turns) - way(b, b_turns), b_turns ? ball(b.now) : b.geometry,
               b_turns ? centre(b.now) : b.now.pose);
}

/// Whether what is found of a pair is of one that passes through a front from behind. From before it nothing comes so deep in a
/// drift that was not near at its start.
bool passes(const ThingsNow& p, const ContactKey& key, const Collector& collector, std::span<const Contact> found) {
  const bool passed =
      std::binary_search(p.contacts.passing.begin(), p.contacts.passing.end(), PassingPair{key.a, key.b});
  if (!passed && !(p.drifted && collector.is_behind() && !are_known(p.contacts.list, key))) return false;
  return std::any_of(found.begin(), found.end(), [](const Contact& c) { return c.gap < 0.0; });
}

}  // namespace

void add_contacts(const ThingsNow& p, const ContactSide& a, const ContactSide& b, const LayerRule* rule, double margin,
                  FoundContacts& found) {
  if (is_far(a, b, margin) || only_turns(a, b, p.h)) return;
  const bool sensed = a.sensor || b.sensor;
  std::vector<Contact>& to = sensed ? found.sensed : found.list;
  const std::size_t first = to.size();
  Collector collector(a, b, rule, p.contacts, p.h, found);
  SeparationCache cache;
  const double turning = p.h * norm(a.going.w - b.going.w) * std::min(a.now.reach, b.now.reach);
  const bool strikes = restitution_of(a, b, rule) > 0.0 || !(a.going.is_held || b.going.is_held);
  find_manifolds(a.geometry, a.now.pose, b.geometry, b.now.pose, {margin, turning, strikes}, cache, collector);
  const ContactKey key{a.key, b.key, 0, 0};
  if (!sensed && is_one_sided(b.geometry) && passes(p, key, collector, std::span(to).subspan(first))) {
    to.resize(first);
    found.passing.push_back({a.key, b.key});
  }
  const auto begin = to.begin() + static_cast<std::ptrdiff_t>(first);
  if (!std::is_sorted(begin, to.end(), by_key)) std::sort(begin, to.end(), by_key);
}

}  // namespace pantin
