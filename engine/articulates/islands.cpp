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
  Thing holder(PointId point) const {
    const Point& p = model_.points[point];
    return p.body ? Thing{p.body.slot - 1, true} : Thing{point.slot - 1, false};
  }
  void add(PointId point) { add(holder(point)); }
  /// What is tied by connections that are solved with their articulate.
  void visit(const Particle& particle) {
    for (ConnectionId id : particle.connections) {
      const Connection& c = model_.connections[id];
      if (!c.enabled || c.solve == Solve::explicitly) continue;
      const Thing first = c.particles[0] ? holder(star(model_, c.particles[0])) : Thing{};
      const Thing second = c.particles[1] ? holder(star(model_, c.particles[1])) : Thing{};
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
    constrained_ = true;
    c.each_point([&](PointId point) { add(point); });
    for (BodyId body : {c.body_a, c.body_b})
      if (body) add(Thing{body.slot - 1, true});
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

/// Things of dirty articulates, which are dropped, and touched untied ones; the dead among them.
std::vector<Thing> touched(Model& model, std::vector<std::unique_ptr<Articulate>>& articulates) {
  std::vector<Thing> list;
  for (std::size_t i = 0; i < articulates.size() && i < model.dirty_articulates.size(); i++) {
    if (!model.dirty_articulates[i]) continue;
    for (const Node& node : articulates[i]->nodes) list.push_back({node.slot, node.is_body});
    articulates[i].reset();
  }
  for (BodyId id : model.untied_bodies) list.push_back({id.slot - 1, true});
  for (PointId id : model.untied_points) list.push_back({id.slot - 1, false});
  return list;
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
  std::inplace_merge(loose.begin(), loose.begin() + old, loose.end());
}

}  // namespace

void find_articulates(Model& model, std::vector<std::unique_ptr<Articulate>>& articulates,
                      std::vector<std::uint32_t>& loose_bodies, std::vector<std::uint32_t>& loose_points) {
  for (std::int32_t i : model.disturbed) disturb(*articulates[static_cast<std::size_t>(i)]);
  model.disturbed.clear();
  if (!model.topology_changed) return;
  std::vector<Thing> changed = touched(model, articulates);
  Search search(model);
  const std::size_t count = changed.size();
  for (std::size_t i = 0; i < count; i++) {
    const Thing t = changed[i];
    if (!lives(model, t) || search.seen(t)) continue;
    bool constrained = false;
    std::vector<Thing> things = search.from(t, constrained);
    changed.insert(changed.end(), things.begin(), things.end());
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
  update_loose(model, changed, true, loose_bodies);
  update_loose(model, changed, false, loose_points);
}

}  // namespace pantin
