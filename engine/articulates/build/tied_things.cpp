#include "articulates/build/tied_things.hpp"

#include <algorithm>

#include "articulates/build/build.hpp"
#include "articulates/build/edges.hpp"
#include "articulates/solve/state.hpp"
#include "base/stable.hpp"
#include "constraints/kind.hpp"

namespace pantin {

namespace {

/// Walks over what constraints tie together.
class Search {
 public:
  explicit Search(const Model& model)
      : model_(model), body_seen_(model.bodies.slots()), point_seen_(model.points.slots()) {}

  bool seen(Thing t) const { return t.is_body ? body_seen_[t.slot] : point_seen_[t.slot]; }

  /// All things tied to `start`, itself included; `constrained` tells whether any constraint was met.
  std::vector<Thing> from(Thing start, bool& constrained) {
    found_.clear();
    constrained_ = false;
    add(start);
    for (std::size_t i = 0; i < found_.size(); i++) {
      const Thing t = found_[i];
      if (!t.is_body) {
        visit(model_.points.id_at(t.slot));
        continue;
      }
      const Body& body = model_.bodies.at_slot(t.slot);
      for (PointId point : body.points) visit(point);
      for (ConstraintId id : body.constraints) visit(model_.constraints[id]);
    }
    constrained = constrained_;
    return found_;
  }

 private:
  void add(Thing t) {
    char& mark = t.is_body ? body_seen_[t.slot] : point_seen_[t.slot];
    if (mark) return;
    mark = 1;
    found_.push_back(t);
  }
  void add(PointId point) { add(owner(model_, point)); }
  /// What is tied by connections that are solved with their articulate.
  void visit(const Particle& particle) {
    for (ConnectionId id : particle.connections) {
      const Connection& c = model_.connections[id];
      if (!c.enabled || c.solve == Solve::explicitly) continue;
      const Thing first = c.particles[0] ? owner(model_, star(model_, c.particles[0])) : Thing{};
      const Thing second = c.particles[1] ? owner(model_, star(model_, c.particles[1])) : Thing{};
      const bool inside = c.particles[0] && c.particles[1] && first == second;
      constrained_ = constrained_ || !inside;
      if (c.particles[0]) add(first);
      if (c.particles[1]) add(second);
    }
  }
  void visit(PointId point) {
    const Particle& ring = model_.particles[model_.points[point].particle];
    visit(model_.particles[model_.points[point].own]);
    visit(ring);
    if (ring.joins()) {
      constrained_ = true;
      for (PointId member : ring.points) add(member);
    }
    for (ConstraintId id : model_.points[point].constraints) visit(model_.constraints[id]);
  }
  void visit(const Constraint& c) {
    if (!c.enabled) return;
    constrained_ = constrained_ || !rule_of(c).rows(model_, c).empty();
    c.each_point([&](PointId point) { add(point); });
    c.each_body([&](BodyId body) { add(Thing{body.slot - 1, true}); });
  }

  const Model& model_;
  std::vector<char> body_seen_, point_seen_;
  std::vector<Thing> found_;
  bool constrained_ = false;
};

std::int32_t& articulate_of(Model& model, Thing t) {
  return t.is_body ? model.motion[t.slot].articulate : model.points.at_slot(t.slot).articulate;
}

bool lives(const Model& model, Thing t) {
  return t.is_body ? model.bodies.alive_at(t.slot)
                   : model.points.alive_at(t.slot) && !model.points.at_slot(t.slot).body;
}

bool lives(const Model& model, const EditedThing& t) {
  return t.body ? model.bodies.alive(t.body) : model.points.alive(t.point) && !model.points[t.point].body;
}

Thing thing_of(const EditedThing& t) { return t.body ? Thing{t.body.slot - 1, true} : Thing{t.point.slot - 1, false}; }

/// Which articulates are no longer as their things are tied.
std::vector<char> changed_articulates(const Model& model, const Articulates& articulates) {
  std::vector<char> changed(articulates.size(), 0);
  for (const EditedThing& t : model.edited_things) {
    if (t.articulate < 0) continue;
    char& mark = changed[static_cast<std::size_t>(t.articulate)];
    if (!mark)
      mark = !lives(model, t) || !is_as_built(model, *articulates[static_cast<std::size_t>(t.articulate)], thing_of(t));
  }
  return changed;
}

/// Things of changed articulates, and edited untied ones; the dead among them.
std::vector<Thing> things_to_gather(const Model& model, const Articulates& articulates,
                                    const std::vector<char>& changed) {
  std::vector<Thing> list;
  for (std::size_t i = 0; i < articulates.size(); i++)
    if (changed[i])
      for (const Node& node : articulates[i]->nodes) list.push_back({node.slot, node.is_body});
  for (const EditedThing& t : model.edited_things)
    if (t.articulate < 0) list.push_back(thing_of(t));
  return list;
}

/// Takes out the changed articulates and puts in the new ones; all know their places.
void replace(Model& model, Articulates& articulates, const std::vector<char>& changed, Articulates& made) {
  std::size_t first = articulates.size();  // from there on places may have changed
  for (std::size_t i = articulates.size(); i-- > 0;)
    if (changed[i]) first = i;
  for (const auto& articulate : made) {
    const auto later = [](std::uint64_t serial, const auto& a) { return serial < a->serial; };
    const auto position = std::upper_bound(articulates.begin(), articulates.end(), articulate->serial, later);
    first = std::min(first, static_cast<std::size_t>(position - articulates.begin()));
  }
  for (std::size_t i = 0; i < changed.size(); i++)
    if (changed[i]) articulates[i].reset();
  std::erase(articulates, nullptr);
  std::move(made.begin(), made.end(), std::back_inserter(articulates));
  std::sort(articulates.begin(), articulates.end(), [](const auto& a, const auto& b) { return a->serial < b->serial; });
  for (std::size_t i = first; i < articulates.size(); i++)
    for (const Node& node : articulates[i]->nodes)
      articulate_of(model, {node.slot, node.is_body}) = static_cast<std::int32_t>(i);
}

/// Puts the slots of `things` into a rising list of loose ones, or takes them out: whichever holds now.
void update_loose(Model& model, const std::vector<Thing>& things, bool bodies, std::vector<std::uint32_t>& loose) {
  std::vector<std::uint32_t> in, out;
  for (Thing t : things) {
    if (t.is_body != bodies) continue;
    const bool is_loose = lives(model, t) && articulate_of(model, t) < 0;
    if (std::binary_search(loose.begin(), loose.end(), t.slot) != is_loose) (is_loose ? in : out).push_back(t.slot);
  }
  if (in.empty() && out.empty()) return;
  std::sort(in.begin(), in.end());
  in.erase(std::unique(in.begin(), in.end()), in.end());
  std::sort(out.begin(), out.end());
  std::erase_if(loose, [&](std::uint32_t slot) { return std::binary_search(out.begin(), out.end(), slot); });
  const auto old = static_cast<std::ptrdiff_t>(loose.size());
  loose.insert(loose.end(), in.begin(), in.end());
  merge_sorted(loose.begin(), loose.begin() + old, loose.end());
}

/// Bodies move with the inertia that they have loose or tied.
void take_inertia(Model& model, const std::vector<Thing>& found, bool tied, InertiaChanges& changes) {
  for (Thing t : found) {
    if (!t.is_body) continue;
    const BodyId body = model.bodies.id_at(t.slot);
    changes.energy += settle_inertia(model, body, tied);
    if (lift(model, body) > 0.0) changes.lifted.push_back(body);
  }
}

/// Finds what the given things are tied to; appends whatever else that is to them. Returns the new articulates.
Articulates gather(Model& model, const Articulates& before, std::vector<Thing>& things, InertiaChanges& changes) {
  Articulates made;
  std::vector<Thing> loose;
  Search search(model);
  const std::size_t count = things.size();
  for (std::size_t i = 0; i < count; i++) {
    const Thing t = things[i];
    if (!lives(model, t) || search.seen(t)) continue;
    bool constrained = false;
    std::vector<Thing> found = search.from(t, constrained);
    things.insert(things.end(), found.begin(), found.end());
    take_inertia(model, found, constrained, changes);
    if (!constrained) {
      loose.insert(loose.end(), found.begin(), found.end());
      continue;
    }
    const auto older = [&](Thing a, Thing b) { return serial_of(model, a) < serial_of(model, b); };
    if (!std::is_sorted(found.begin(), found.end(), older)) std::sort(found.begin(), found.end(), older);
    made.push_back(build_articulate(model, found, before));
  }
  for (Thing t : loose) articulate_of(model, t) = -1;
  return made;
}

}  // namespace

InertiaChanges find_tied_things(Model& model, std::vector<std::unique_ptr<Articulate>>& articulates,
                                std::vector<std::uint32_t>& loose_bodies, std::vector<std::uint32_t>& loose_points) {
  InertiaChanges changes;
  for (std::int32_t i : model.disturbed) disturb(*articulates[static_cast<std::size_t>(i)]);
  model.disturbed.clear();
  if (!model.topology_changed) return changes;
  for (const EditedThing& t : model.edited_things)
    if (t.articulate >= 0) wake(*articulates[static_cast<std::size_t>(t.articulate)]);
  const std::vector<char> changed = changed_articulates(model, articulates);
  std::vector<Thing> things = things_to_gather(model, articulates, changed);
  model.edited_things.clear();
  model.topology_changed = false;
  if (things.empty()) return changes;
  Articulates made = gather(model, articulates, things, changes);
  replace(model, articulates, changed, made);
  update_loose(model, things, true, loose_bodies);
  update_loose(model, things, false, loose_points);
  return changes;
}

}  // namespace pantin
