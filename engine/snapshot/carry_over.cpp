#include "snapshot/carry_over.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <tuple>
#include <utility>

#include "base/hash.hpp"
#include "choreography/hands.hpp"
#include "choreography/resume.hpp"
#include "constraints/coupling.hpp"
#include "contacts/touching.hpp"
#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "shapes/shape.hpp"

namespace pantin {

namespace {

constexpr std::size_t sorts = 32, no_sort = sorts;  // of one kind, at most

/// Things of the rows whose `sort` is one.
template <class Row, class Sort>
void add(Made& list, const Store<Row>& rows, Sort sort) {
  for (const Handle<Row> id : rows.ids())
    if (const std::size_t kind = sort(rows[id]); kind != no_sort)
      list.things.push_back({id, AnyId(id).index() * sorts + kind, rows[id].name, 0, {}, {}});
}

using Match = std::pair<const MadeThing*, const MadeThing*>;  // the old, the new

using ThingsInOrder = std::vector<const MadeThing*>;
using OldOfNew = std::map<const MadeThing*, const MadeThing*>;

/// In order; what finds none stays in the lists.
void match_alike(ThingsInOrder& before, ThingsInOrder& now, OldOfNew& found) {
  std::map<std::uint64_t, std::deque<const MadeThing*>> alike;
  for (const MadeThing* thing : before) alike[thing->looks].push_back(thing);
  std::set<const MadeThing*> taken;
  std::erase_if(now, [&](const MadeThing* thing) {
    auto& list = alike[thing->looks];
    if (list.empty()) return false;
    taken.insert(found[thing] = list.front());
    list.pop_front();
    return true;
  });
  std::erase_if(before, [&](const MadeThing* thing) { return taken.contains(thing); });
}

/// Of one sort and name by their order; where some came or went, first those that look alike.
std::vector<Match> matches(const Made& before, const Made& now) {
  std::map<std::pair<std::size_t, std::string>, std::pair<ThingsInOrder, ThingsInOrder>> named;
  for (const MadeThing& thing : before.things) named[{thing.sort, thing.name}].first.push_back(&thing);
  for (const MadeThing& thing : now.things) named[{thing.sort, thing.name}].second.push_back(&thing);
  OldOfNew found;
  for (auto& [key, things] : named) {
    auto& [old, fresh] = things;
    if (old.size() != fresh.size()) match_alike(old, fresh, found);
    for (std::size_t i = 0; i < std::min(old.size(), fresh.size()); i++) found[fresh[i]] = old[i];
  }
  std::vector<Match> list;
  for (const MadeThing& thing : now.things)
    if (const auto old = found.find(&thing); old != found.end()) list.emplace_back(old->second, &thing);
  return list;
}

/// Points of matched things: by name, else by their place in the list.
void match_points(const Match& match, Counterparts& to) {
  const auto& [before, now] = match;
  for (std::size_t i = 0; i < now->points.size(); i++) {
    const std::string& name = now->point_names[i];
    const auto named = std::find(before->point_names.begin(), before->point_names.end(), name);
    const std::size_t k = name.empty() ? i : static_cast<std::size_t>(named - before->point_names.begin());
    if (k < before->points.size() && before->point_names[k] == name) to[before->points[k]] = now->points[i];
  }
}

bool differ(double a, double b) { return a != b; }
bool differ(Vec3 a, Vec3 b) { return norm(a - b) > 0.0; }
bool differ(const Quat& a, const Quat& b) { return !same(a, b); }

/// Whether something is to be elsewhere than before, by the script's word and at no time of its own.
bool wants_other(const Constraint& before, const Constraint& now) {
  const auto other = [](const auto& past, const auto& present) {
    return !past.of_time && !present.of_time && differ(past.now, present.now);
  };
  const auto total = [](const Constraint& c) { return c.is<CouplingData>() ? c.as<CouplingData>().total : 0.0; };
  return other(before.position, now.position) || other(before.number, now.number) || other(before.turn, now.turn) ||
         before.low != now.low || before.high != now.high || total(before) != total(now) ||
         differ(before.axis_a, now.axis_a) || differ(before.axis_b, now.axis_b);
}

/// What living things of a kind take over from living ones, as far as the new world's plane lets them.
class Carrier {
 public:
  Carrier(const World& old, World& fresh, const Counterparts& to) : old_(old), fresh_(fresh), to_(to) {}

  void operator()(BodyId from, BodyId to) {
    const Motion& motion = old_.motion_of(from);
    const Plane& plane = fresh_.plane;
    set_orientation(fresh_, to, internal::turned_in_plane(fresh_, to, orientation(old_, from)));
    set_origin(fresh_, to, plane.beside(origin(old_, from), origin(fresh_, to)));
    set_velocity(fresh_, to, plane.along(motion.p / motion.mass));
    set_spin(fresh_, to, plane.about(angular_velocity(motion)));
  }

  void operator()(ParticleId from, ParticleId to) {
    const Particle &before = old_.particles[from], &now = fresh_.particles[to];
    fresh_.particles[to].born = before.born;
    if (now.is_hinge()) return part(before, to);
    const PointId point = now.points[0];
    if (fresh_.points[point].body) return;
    set_position(fresh_, point, fresh_.plane.beside(position(old_, from), position(fresh_, point)));
    set_velocity(fresh_, point, fresh_.plane.along(velocity(old_, from)));
  }

  /// What it follows has its past, and what is drawn in has come as far.
  void operator()(ConstraintId from, ConstraintId to) {
    const Constraint& before = old_.constraints[from];
    Constraint& now = fresh_.constraints[to];
    now.attract = before.attract;
    std::tie(now.angle, now.moves) = std::tie(before.angle, before.moves);
    if (now.is<PathData>() && before.is<PathData>()) now.as<PathData>().along = before.as<PathData>().along;
    if (now.is<CouplingData>() && before.is<CouplingData>()) carry_values(before, now);
    carry_past(before.position, now.position);
    carry_past(before.number, now.number);
    carry_past(before.turn, now.turn);
  }

  template <class T, class Rate>
  static void carry_past(const Prescribed<T, Rate>& before, Prescribed<T, Rate>& now) {
    if (!now.of_time || !before.of_time) return;
    const std::function<T(double)> of_time = std::move(now.of_time);
    now = before;
    now.of_time = of_time;
  }

  /// A coupling goes on where it was; one of another ratio meshes anew.
  static void carry_values(const Constraint& before, Constraint& now) {
    const CouplingData& past = before.as<CouplingData>();
    CouplingData& data = now.as<CouplingData>();
    double change = 0.0;
    for (std::size_t i = 0; i < std::min(data.values.size(), past.values.size()); i++) {
      change += weight_of(now, data.values[i]) * (past.values[i].angle - data.values[i].angle);
      data.values[i].angle = past.values[i].angle;
    }
    if (data.given) return;
    data.total = now.number.now == before.number.now ? past.total : data.total + change;
  }

  template <class Id>
  void operator()(Id, Id) {}  // laws, groups and families have no state of their own

 private:
  /// Bodies that left a hinge leave the new one.
  void part(const Particle& before, ParticleId hinge) {
    std::set<AnyId> members;
    for (PointId point : before.points)
      if (const auto found = to_.find(point); found != to_.end()) members.insert(found->second);
    std::set<PointId> known;
    for (const auto& [from, to] : to_)
      if (const auto* point = std::get_if<PointId>(&to)) known.insert(*point);
    for (PointId point : std::vector<PointId>(fresh_.particles[hinge].points)) {
      const BodyId body = fresh_.points[point].body;
      if (body && known.contains(point) && !members.contains(point) && fresh_.particles.alive(hinge) &&
          fresh_.particles[hinge].is_hinge())
        cut(fresh_, hinge, body);
    }
  }

  const World& old_;
  World& fresh_;
  const Counterparts& to_;
};

/// A thing that is gone from the old world goes from the new one. A join that met is made again: its points are together.
void remove_too(World& fresh, const AnyId& id) {
  if (!alive(fresh, id)) return;
  if (const auto* particle = std::get_if<ParticleId>(&id); particle && fresh.particles[*particle].is_hinge())
    return cut(fresh, *particle);
  const auto* constraint = std::get_if<ConstraintId>(&id);
  const bool stays = constraint ? fresh.constraints[*constraint].kind == ConstraintKind::join
                                : std::holds_alternative<FamilyId>(id) || std::holds_alternative<GroupId>(id) ||
                                      std::holds_alternative<InteractionId>(id) || std::holds_alternative<FieldId>(id);
  if (!stays) remove(fresh, id);
}

bool lives(const World& world, const AnyId& id) {
  const auto* particle = std::get_if<ParticleId>(&id);
  return alive(world, id) && (!particle || !world.particles[*particle].asleep_in);
}

void carry_things(const World& old, World& fresh, const std::vector<Match>& list, const Counterparts& to) {
  Carrier carrier(old, fresh, to);
  for (const Match& match : list) {
    const AnyId &before = match.first->id, &now = match.second->id;
    if (!lives(fresh, now)) continue;
    if (!lives(old, before))
      remove_too(fresh, now);
    else
      std::visit(
          [&](const auto& from) {
            using Id = std::decay_t<decltype(from)>;
            if constexpr (!std::is_same_v<Id, std::monostate>) carrier(from, std::get<Id>(now));
          },
          before);
  }
}

/// A `when` that has fired or was cancelled stays so; all others go by their time, but what was cancelled.
void carry_events(const Made& before, World& fresh, const Made& now) {
  std::map<EventKind, std::vector<const Made::OfEvent*>> known;
  std::map<EventKind, std::size_t> count;
  for (const Made::OfEvent& event : before.events) known[event.kind].push_back(&event);
  for (const Made::OfEvent& event : now.events) {
    const std::vector<const Made::OfEvent*>& list = known[event.kind];
    const std::size_t k = count[event.kind]++;
    if (k >= list.size() || event.kind == EventKind::play) continue;
    const EventState state = *list[k]->state;
    const bool stays = event.kind == EventKind::when ? state != EventState::waiting : state == EventState::cancelled;
    if (stays) end_event(fresh, event.id, state);
  }
}

/// Things attract each other to where the changed script wants them, from where they are.
void start_changed(const World& old, World& fresh, const std::vector<Match>& list) {
  for (const Match& match : list) {
    const auto *before = std::get_if<ConstraintId>(&match.first->id),
               *now = std::get_if<ConstraintId>(&match.second->id);
    if (!before || !now || !old.constraints.alive(*before) || !fresh.constraints.alive(*now)) continue;
    Constraint& c = fresh.constraints[*now];
    if (wants_other(old.constraints[*before], c)) internal::start_constraint(fresh, c);
  }
}

void carry_emitters(World& fresh) {
  for (EmitterId id : fresh.emitters.ids()) {
    Emitter& emitter = fresh.emitters[id];
    emitter.origin = fresh.time;
    emitter.phase = 0.0;
    emitter.since = 0;
  }
}

/// Hands of the outside come after those of the file; they hold what they held.
void carry_hands(const World& old, const Made& before, World& fresh, CarriedOver& carried) {
  for (std::size_t i = before.hands; i < old.hands.size(); i++) {
    const Hand& hand = old.hands[i];
    if (hand.path) continue;
    const std::int32_t index = add_hand(fresh);
    carried.hands[static_cast<std::int32_t>(i)] = index;
    Hand& made = fresh.hands.back();
    std::tie(made.position, made.velocity, made.pressed, made.placed) =
        std::tie(hand.position, hand.velocity, hand.pressed, hand.placed);
    if (!old.constraints.alive(hand.grab)) continue;
    const Constraint& hold = old.constraints[hand.grab];
    const auto point = carried.things.find(hold.a);
    if (point == carried.things.end() || !alive(fresh, point->second)) continue;
    const PointId held = std::get<PointId>(point->second);
    grab(fresh, index, held, hold.max_force);
  }
}

/// What touched is not told anew, should somebody listen.
void carry_touching(const World& old, World& fresh, const Counterparts& to) {
  std::vector<TouchPair>& touching = fresh.contacts.touching;
  for (const TouchPair& pair : touching_now(old, old.contacts)) {
    const auto a = to.find(pair.a), b = to.find(pair.b);
    if (a == to.end() || b == to.end()) continue;
    touching.push_back({std::min(a->second, b->second), std::max(a->second, b->second)});
  }
  std::sort(touching.begin(), touching.end());
  fresh.contacts.watched = !touching.empty();
}

std::uint64_t looks_of(const World& world, const Body& body) {
  Hash hash;
  for (const ShapeId id : body.shapes) {
    const Geometry& geometry = world.shapes[id].geometry;
    const Bounds bounds = bounds_of(geometry, Pose{});
    hash.add(std::uint64_t{geometry.index()});
    hash.add(bounds.low);
    hash.add(bounds.high);
  }
  return hash.value;
}

}  // namespace

Made made(const World& world) {
  Made list;
  const auto any = [](const auto&) { return std::size_t{0}; };
  add(list, world.families, any);
  add(list, world.bodies, any);
  add(list, world.particles, [&](const Particle& p) {
    if (p.is_hinge()) return std::size_t{1};
    return p.asleep_in || world.points[p.points[0]].body ? no_sort : std::size_t{0};
  });
  add(list, world.constraints,
      [](const Constraint& c) { return c.kind == ConstraintKind::axis ? no_sort : static_cast<std::size_t>(c.kind); });
  add(list, world.connections, any);
  add(list, world.interactions, any);
  add(list, world.fields, any);
  add(list, world.emitters, any);
  add(list, world.shapes, [](const Shape& shape) { return shape.body ? no_sort : std::size_t{0}; });
  add(list, world.groups, any);
  for (MadeThing& thing : list.things) {
    if (const auto* body = std::get_if<BodyId>(&thing.id)) {
      thing.points = world.bodies[*body].points;
      thing.looks = looks_of(world, world.bodies[*body]);
    }
    if (const auto* particle = std::get_if<ParticleId>(&thing.id); particle && !world.particles[*particle].is_hinge())
      thing.points = world.particles[*particle].points;
    for (PointId point : thing.points) thing.point_names.push_back(world.points[point].name);
  }
  for (EventId id : world.choreography.events.ids()) {
    const Event& event = world.choreography.events[id];
    list.events.push_back({id, event.kind, event.state});
  }
  list.hands = world.hands.size();
  return list;
}

CarriedOver carry_over(const World& old, const Made& before, World& fresh, const Made& now) {
  const std::vector<Match> list = matches(before, now);
  CarriedOver carried;
  Counterparts& to = carried.things;
  for (const Match& match : list) {
    to[match.first->id] = match.second->id;
    match_points(match, to);
  }
  begin_at(fresh, old.time, old.choreography.reached);
  carry_events(before, fresh, now);
  carry_things(old, fresh, list, to);
  start_changed(old, fresh, list);
  carry_emitters(fresh);
  carry_touching(old, fresh, to);
  carry_hands(old, before, fresh, carried);
  fresh.random = old.random;
  // What was done here is no news to the scripts, nor anybody's act.
  fresh.notices.clear();
  fresh.breaks.clear();
  fresh.last_actor.clear();
  return carried;
}

}  // namespace pantin
