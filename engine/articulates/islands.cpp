#include "articulates/islands.hpp"

#include <algorithm>

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
      for (PointId point : model_.bodies.at_slot(t.slot).points) visit(point);
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
  void add(PointId point) {
    const Point& p = model_.points[point];
    add(p.body ? Thing{p.body.slot - 1, true} : Thing{point.slot - 1, false});
  }
  void visit(PointId point) {
    const Particle& ring = model_.particles[model_.points[point].particle];
    if (ring.is_hinge()) {
      constrained_ = true;
      for (PointId member : ring.points) add(member);
    }
    for (ConstraintId id : model_.points[point].constraints) {
      const Constraint& c = model_.constraints[id];
      if (!c.enabled) continue;
      constrained_ = true;
      add(c.a);
      if (c.b) add(c.b);
    }
  }

  const Model& model_;
  std::vector<char> body_seen_, point_seen_;
  std::vector<Thing> found_;
  bool constrained_ = false;
};

std::uint64_t serial_of(const Model& model, Thing t) {
  return t.is_body ? model.bodies.at_slot(t.slot).serial : model.points.at_slot(t.slot).serial;
}

std::int32_t& articulate_of(Model& model, Thing t) {
  return t.is_body ? model.motion[t.slot].articulate : model.points.at_slot(t.slot).articulate;
}

bool lives(const Model& model, Thing t) {
  return t.is_body ? model.bodies.alive_at(t.slot)
                   : model.points.alive_at(t.slot) && !model.points.at_slot(t.slot).body;
}

/// Living things of dirty articulates, which are dropped, and touched untied ones.
std::vector<Thing> touched(Model& model, std::vector<std::unique_ptr<Articulate>>& articulates) {
  std::vector<Thing> list;
  for (std::size_t i = 0; i < articulates.size() && i < model.dirty_articulates.size(); i++) {
    if (!model.dirty_articulates[i]) continue;
    for (const Node& node : articulates[i]->nodes) list.push_back({node.slot, node.is_body});
    articulates[i].reset();
  }
  for (BodyId id : model.untied_bodies)
    if (model.bodies.alive(id)) list.push_back({id.slot - 1, true});
  for (PointId id : model.untied_points)
    if (model.points.alive(id)) list.push_back({id.slot - 1, false});
  std::erase_if(list, [&](Thing t) { return !lives(model, t); });
  return list;
}

void rebuild_loose(const Model& model, std::vector<std::uint32_t>& bodies, std::vector<std::uint32_t>& points) {
  bodies.clear();
  for (std::uint32_t s = 0; s < model.bodies.slots(); s++)
    if (model.bodies.alive_at(s) && model.motion[s].articulate < 0) bodies.push_back(s);
  points.clear();
  for (std::uint32_t s = 0; s < model.points.slots(); s++)
    if (model.points.alive_at(s) && !model.points.at_slot(s).body && model.points.at_slot(s).articulate < 0)
      points.push_back(s);
}

}  // namespace

void find_articulates(Model& model, std::vector<std::unique_ptr<Articulate>>& articulates,
                      std::vector<std::uint32_t>& loose_bodies, std::vector<std::uint32_t>& loose_points) {
  for (std::int32_t i : model.disturbed) disturb(*articulates[static_cast<std::size_t>(i)]);
  model.disturbed.clear();
  if (!model.topology_changed) return;
  const std::vector<Thing> start = touched(model, articulates);
  Search search(model);
  for (Thing t : start) {
    if (search.seen(t)) continue;
    bool constrained = false;
    std::vector<Thing> things = search.from(t, constrained);
    for (Thing u : things) articulate_of(model, u) = -1;
    if (!constrained) continue;
    std::sort(things.begin(), things.end(),
              [&](Thing a, Thing b) { return serial_of(model, a) < serial_of(model, b); });
    articulates.push_back(build_articulate(model, things));
  }
  std::erase(articulates, nullptr);
  std::sort(articulates.begin(), articulates.end(), [](const auto& a, const auto& b) { return a->serial < b->serial; });
  for (std::size_t i = 0; i < articulates.size(); i++)
    for (const Node& node : articulates[i]->nodes)
      articulate_of(model, {node.slot, node.is_body}) = static_cast<std::int32_t>(i);
  model.dirty_articulates.assign(articulates.size(), 0);
  model.untied_bodies.clear();
  model.untied_points.clear();
  model.topology_changed = false;
  rebuild_loose(model, loose_bodies, loose_points);
}

}  // namespace pantin
