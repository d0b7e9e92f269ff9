#include "contacts/take_back.hpp"

#include <algorithm>
#include <array>

#include "articulates/solve/momenta.hpp"
#include "articulates/solve/project.hpp"
#include "contacts/bodies.hpp"
#include "contacts/gather.hpp"
#include "contacts/heat.hpp"
#include "contacts/pass_parts.hpp"
#include "contacts/turn_back.hpp"

namespace pantin {

namespace {

/// An impulse of one frame in the frame of another normal, by the smallest turn between them.
Vec3 turned_with(Vec3 from, Vec3 to, Vec3 impulse) {
  const Vec3 axis = cross(from, to);
  const double cosine = dot(from, to);
  return cosine > 0.0 ? impulse + cross(axis, impulse) + cross(axis, cross(axis, impulse)) / (1.0 + cosine) : impulse;
}

constexpr double badly_foreseen = 0.05;  // of what turning moves it: to the next order of the drift

/// What became of a contact that `place` held.
struct PlacedNow {
  const Contact* touching = nullptr;  // if it touches still
  bool is_met = false;                // by `meet`,
  bool was_foreseen = false;          // where it was foreseen
};

/// (by number of what `place` gave)
std::vector<PlacedNow> placed_now(const Contacts& contacts, std::span<const TouchIsland> islands) {
  std::size_t count = 0;
  for (const TouchIsland& island : islands) count += island.placed.size();
  std::vector<PlacedNow> all(count);
  for (const Contact& c : contacts.list) {
    if (c.place_index < 0) continue;
    PlacedNow& now = all[static_cast<std::size_t>(c.place_index)];
    const double open = closed_gap * c.size + (c.rebound == 0.0 ? badly_foreseen * c.turning : 0.0);
    if (!c.from_before && c.gap <= open) now.touching = &c;
    now.was_foreseen = now.was_foreseen || c.from_before;
    now.is_met = now.is_met || c.from_before || c.gap <= held_gap * c.size;
  }
  return all;
}

/// Takes back what `place` gave in an island.
class TakeBack {
 public:
  /// `now` (placed).
  TakeBack(TouchIsland& island, std::span<const PlacedNow> now, std::span<const Contact> contacts, TouchSpace& space,
           Model& model, const Articulates& articulates, const TouchSettings& settings)
      : island_(island),
        now_(now),
        contacts_(contacts),
        space_(space),
        model_(model),
        articulates_(articulates),
        settings_(settings),
        thrown_(thrown_back(island)),
        losses_(island.things.size()),
        carried_(island.things.size(), zero3()) {}

  /// Returns the change of the kinetic energy [J].
  double run() {
    if (island_.solved) lose_as_then();
    if (!thrown_.empty()) keep_what_springs_threw();
    keep_what_bore_until_it_rolled_off();
    for (const BodyImpulse& g : island_.given) lose(g);
    if (island_.solved) lose_as_now();
    lose_scalars();
    double work = 0.0;
    for (std::size_t i = 0; i < losses_.size(); i++)
      if (norm2(losses_[i].force) + norm2(losses_[i].moment) > 0.0) work += take(i);
    return work + give_turns_back();
  }

 private:
  void lose(const BodyImpulse& g) {
    losses_[g.body].force += g.impulse;
    losses_[g.body].moment += g.moment;
  }
  Vec3 centre(std::size_t body) const {
    return centre_of(model_, articulates_, island_.things[body], settings_.drifted);
  }
  /// Calls f with what both bodies of a contact were given where this impulse and moment on a, at these arms, take it back.
  template <class F>
  void each_given(const Placing& p, Vec3 impulse, Vec3 moment, Vec3 arm_a, Vec3 arm_b, F&& f) {
    const auto one = [&](std::int32_t body, Vec3 arm, double sign) {
      f(BodyImpulse{static_cast<std::uint32_t>(body), model_.plane.along(impulse) * sign,
                    (cross(arm, impulse) + moment) * sign});
    };
    one(p.a, arm_a, -1.0);
    if (p.b >= 0) one(p.b, arm_b, 1.0);
  }
  void lose_as_then(const Placing& p, double times) {
    each_given(p, p.impulse * times, p.moment * times, p.arm_a, p.arm_b, [&](const BodyImpulse& g) {
      if (p.foreseen)
        lose(g);
      else
        island_.given.push_back(g);
    });
  }
  /// Whether a contact touches still, and is no blow of free bodies, nor where they rolled on to in the drift: that only kept them
  /// apart, and they are as fast then as they were.
  bool touches_on(std::size_t k) const {
    const Contact* c = now_[k].touching;
    if (c == nullptr || island_.problem.is_tied()) return c != nullptr;
    const bool is_blow = c->gap_before > closed_gap * c->size && c->approach < -slow_of(settings_, island_.problem);
    return c->rebound == 0.0 && !is_blow && !island_.placed[k].rolled_on;
  }
  void keep_what_bore_until_it_rolled_off() {
    for (const RolledOff& r : island_.rolled) {
      const auto now = std::lower_bound(contacts_.begin(), contacts_.end(), r.from,
                                        [](const Contact& c, const ContactKey& key) { return c.key < key; });
      if (now != contacts_.end() && now->key == r.from && now->gap <= closed_gap * now->size) continue;
      each_given(r.given, r.given.impulse, zero3(), r.given.arm_a, r.given.arm_b,
                 [&](const BodyImpulse& g) { lose(g); });
    }
  }
  /// What contacts gave that touch no more: as they gave it.
  void lose_as_then() {
    for (std::size_t k = 0; k < now_.size(); k++) {
      const Placing& p = island_.placed[k];
      if (touches_on(k)) continue;
      lose_as_then(p, 1.0);
      if (p.b < 0 && !p.foreseen && is_thin(p.a))
        carried_[static_cast<std::size_t>(p.a)] += cross(carried(p.a, p.core_a), p.impulse) * -1.0;
    }
  }
  /// Articulates with springs that throw back what swings faster than the step: in its drift such a thing ends with
  /// 2 v̄ - v0 - γ/m, v̄ what `place` foresaw.
  static std::vector<std::uint32_t> thrown_back(const TouchIsland& island) {
    std::vector<std::uint32_t> all;
    for (std::size_t k = 0; k < island.rows.size(); k++)
      if (const IslandTie& t = island.problem.ties[k]; t.softness > 0.0 && t.softness < t.w)
        all.push_back(island.rows[k][0]);
    return all;  // rising
  }
  bool is_thrown_back(std::uint32_t thing) const {
    return std::binary_search(thrown_.begin(), thrown_.end(), island_number(model_, articulates_.size(), thing));
  }
  /// What `meet` does not stop goes on with 2 v̄ - v0: to take γ back from it would leave it with -2 γ/m.
  void keep_what_springs_threw() {
    for (std::size_t k = 0; k < now_.size(); k++) {
      const Placing& p = island_.placed[k];
      if (now_[k].is_met ||
          !(is_thrown_back(p.body_a) || (p.b >= 0 && is_thrown_back(static_cast<std::uint32_t>(p.body_b)))))
        continue;
      lose_as_then(p, -2.0);
    }
  }
  /// Whether it turns about its length as good as without inertia; in a plane nothing does.
  bool is_thin(std::int32_t body) const {
    constexpr double thin = 50.0;
    const Vec3 inverse = island_.states[static_cast<std::size_t>(body)].inverse_inertia;
    const auto [least, most] = std::minmax({inverse[0], inverse[1], inverse[2]});
    return least > 0.0 && most > thin * least;
  }
  /// By how much its body's turn has carried the end of an arm of then.
  Vec3 carried(std::int32_t body, Vec3 arm) const {
    const auto i = static_cast<std::size_t>(body);
    const BodyState now = state_of(model_, articulates_, island_.things[i], settings_.drifted);
    return now.R * transposed_times(island_.states[i].R, arm) - arm;
  }
  /// What contacts gave that touch still: as they would give it now.
  void lose_as_now() {
    for (std::size_t k = 0; k < now_.size(); k++) {
      if (!touches_on(k)) continue;
      const Placing& p = island_.placed[k];
      const Vec3 normal = now_[k].touching->normal;
      const auto arm = [&](std::int32_t body) {
        return body < 0 ? zero3() : now_[k].touching->at - centre(static_cast<std::size_t>(body));
      };
      each_given(p, turned_with(p.normal, normal, p.impulse), turned_with(p.normal, normal, p.moment), arm(p.a),
                 arm(p.b), [&](const BodyImpulse& g) { lose(g); });
    }
  }
  /// What scalars within bounds gave, as they would give it now.
  void lose_scalars() {
    for (std::size_t k = 0; k < island_.held.size();) {
      const std::uint32_t number = island_.held[k].articulate;
      Articulate& a = *articulates_[number];
      place_velocity_constraints(a, settings_.step, settings_.at, settings_.wanted_at);
      const std::vector<ScalarRow> now = scalar_rows(a, settings_.step, settings_.wanted_at);
      for (; k < island_.held.size() && island_.held[k].articulate == number; k++) {
        const TouchScalar& then = island_.held[k];
        const auto same = std::find_if(now.begin(), now.end(), [&](const ScalarRow& row) {
          return row.row() == then.row.row() && dot(row.terms.front().along, then.row.terms.front().along) > 0.0;
        });
        for (const ScalarRow::End& end : same == now.end() ? then.row.ends : same->ends)
          lose({first_node(number) + static_cast<std::uint32_t>(end.node), model_.plane.along(end.force) * then.given,
                end.moment * then.given});
      }
    }
  }
  std::uint32_t first_node(std::uint32_t articulate) const {
    const auto found = std::lower_bound(island_.articulates.begin(), island_.articulates.end(), articulate);
    return island_.first_nodes[static_cast<std::size_t>(found - island_.articulates.begin())];
  }
  double take(std::size_t body) {
    const std::uint32_t thing = island_.things[body];
    const BodyState s = state_of(model_, articulates_, thing, settings_.drifted);
    const double before = kinetic_energy(model_, s, thing);
    add_momenta(model_, s, thing, losses_[body].force * -1.0, losses_[body].moment * -1.0);
    const double by = take_where_carried(s, thing, carried_[body]) - before;
    if (const std::size_t i = number_of(model_, thing); i < space_.placing_work.size()) space_.placing_work[i] += by;
    return by;
  }
  /// What the world gave acted on a point of the body, which has gone on since: taken back there, too, if that leaves less energy.
  /// What is thin would else get a spin about its length of the momentum that it turned with. Returns its kinetic energy [J].
  double take_where_carried(const BodyState& s, std::uint32_t thing, Vec3 moment) {
    const double then = kinetic_energy(model_, s, thing);
    if (norm2(moment) == 0.0) return then;
    add_momenta(model_, s, thing, zero3(), moment * -1.0);
    const double carried = kinetic_energy(model_, s, thing);
    if (carried <= then) return carried;
    add_momenta(model_, s, thing, zero3(), moment);
    return then;
  }
  /// Impulses acted at one point of two bodies, and are taken back where each of them has carried it: what that changes of the
  /// angular momentum is given back. Of those that were foreseen it is noted: `meet` gives them where they are met.
  double give_turns_back() {
    const bool any_foreseen = std::any_of(island_.placed.begin(), island_.placed.end(),
                                          [](const Placing& p) { return p.foreseen && p.b >= 0; });
    if (island_.given.empty() && !any_foreseen) return 0.0;
    std::vector<Vec3> missing(island_.things.size(), zero3());  // [N m s]
    for (const BodyImpulse& g : island_.given) missing[g.body] += angular(g);
    std::vector<std::array<std::int32_t, 2>> pushed;
    for (std::size_t k = 0; k < now_.size(); k++) {
      const Placing& p = island_.placed[k];
      pushed.push_back({p.a, p.b});
      if (!p.foreseen || p.b < 0) continue;
      Vec3 lost = zero3();
      each_given(p, p.impulse, p.moment, p.arm_a, p.arm_b, [&](const BodyImpulse& g) {
        lost += angular(g);
        if (!island_.solved) missing[g.body] -= angular(g);
      });
      if (now_[k].was_foreseen)
        space_.turned[number_of(model_, p.body_a)] += p.turned - lost;
      else
        missing[static_cast<std::size_t>(p.a)] += lost - p.turned;
    }
    return turn_back(model_, articulates_, island_, settings_.drifted, pushed, missing);
  }
  /// About the origin [N m s].
  Vec3 angular(const BodyImpulse& g) const { return cross(centre(g.body), g.impulse) + g.moment; }

  TouchIsland& island_;
  std::span<const PlacedNow> now_;
  std::span<const Contact> contacts_;  // by key
  TouchSpace& space_;
  Model& model_;
  const Articulates& articulates_;
  const TouchSettings& settings_;
  std::vector<std::uint32_t> thrown_;
  std::vector<BodyLoad> losses_;  // (bodies) [N s], [N m s]
  std::vector<Vec3>
      carried_;  // (bodies) [N m s] more of it, where the world's impulses are taken back where they are by now
};

}  // namespace

void take_back(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
               const TouchSettings& settings, TouchReport& sum) {
  const std::span<TouchIsland> islands = std::span(space.placing).first(space.placed);
  const std::vector<PlacedNow> now = placed_now(contacts, islands);
  each_island(workers, islands, sum, [&](TouchIsland& island, TouchReport& report) {
    report = {};
    island.heat.clear();
    if (island.placed.empty()) return;
    for (Placing& p : island.placed) {
      p.impulse = p.impulse * -1.0;
      p.moment = p.moment * -1.0;
    }
    HeatOf heat(model, articulates, contacts, settings.drifted, island.placed, island.heat);
    const std::span of_island = std::span(now).subspan(island.first_placed, island.placed.size());
    report.work =
        TakeBack(island, of_island, contacts.list, space, model, articulates, settings).run() + island.answered.all();
    report.ties.anchors -= island.answered.anchors;
    report.ties.angular_rows -= island.answered.angular_rows;
    heat.add(report.work);
  });
  collect_heat(contacts, islands);
}

}  // namespace pantin
