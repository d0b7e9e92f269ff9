#include "contacts/take_back.hpp"

#include <algorithm>

#include "articulates/solve/momenta.hpp"
#include "articulates/solve/project.hpp"
#include "base/sets.hpp"
#include "contacts/bodies.hpp"
#include "contacts/gather.hpp"
#include "contacts/heat.hpp"
#include "contacts/turn_back.hpp"

namespace pantin {

namespace {

std::uint32_t thing_of(const Node& n) { return n.is_body ? n.slot : point_thing(n.slot); }

/// Things that pushed each other, and nothing else: their angular momentum is to stay.
struct Group {
  std::size_t root;
  bool anchored = false;
  Vec3 missing = zero3();  ///< [N m s]
  std::vector<std::uint32_t> things = {};
};

/// Impulses act at one point of two bodies, and are taken back where each of them has carried it. What that changes of the
/// angular momentum is given back as a turn of all that pushed each other, so that light things between heavy ones keep theirs.
class Turns {
 public:
  Turns(Model& model, const Articulates& articulates, const Contacts& contacts, const std::vector<Given>& given,
        bool drifted)
      : model_(model),
        articulates_(articulates),
        drifted_(drifted),
        sets_(articulates.size() + number_of(model, point_thing(static_cast<std::uint32_t>(model.points.slots())))) {
    for (const Placing& p : contacts.placed) {
      things_.push_back(p.body_a);
      if (p.body_b < 0) continue;
      things_.push_back(static_cast<std::uint32_t>(p.body_b));
      sets_.join(number(p.body_a), number(things_.back()));
    }
    add_articulates();
    std::sort(things_.begin(), things_.end());
    things_.erase(std::unique(things_.begin(), things_.end()), things_.end());
    for (const std::uint32_t thing : things_) roots_.push_back(sets_.find(number(thing)));
    groups_.reserve(roots_.size());
    for (const std::size_t root : roots_) groups_.push_back({root});
    std::sort(groups_.begin(), groups_.end(), [](const Group& x, const Group& y) { return x.root < y.root; });
    const auto same = [](const Group& x, const Group& y) { return x.root == y.root; };
    groups_.erase(std::unique(groups_.begin(), groups_.end(), same), groups_.end());
    for (const Placing& p : contacts.placed)
      if (p.body_b < 0) group_of(p.body_a).anchored = true;
    for (const Given& g : given) {
      const Vec3 x = centre_of(model_, articulates_, g.thing, drifted_);
      group_of(g.thing).missing += cross(x, g.impulse) + g.moment;
    }
    for (const auto& articulate : articulates)
      if (articulate->touches && !is_free(*articulate)) anchor(*articulate);
  }

  /// Returns the work that it did [J].
  double give_back() {
    const auto needs = [](const Group& g) { return !g.anchored && norm2(g.missing) > 0.0; };
    if (std::none_of(groups_.begin(), groups_.end(), needs)) return 0.0;
    for (const std::uint32_t thing : things_) group_of(thing).things.push_back(thing);
    double work = 0.0;
    for (const Group& g : groups_)
      if (needs(g)) work += turn_as_one(model_, articulates_, g.things, g.missing, drifted_);
    return work;
  }

 private:
  std::size_t number(std::uint32_t thing) const { return island_number(model_, articulates_.size(), thing); }
  Group& group_of(std::uint32_t thing) {
    const std::size_t root = sets_.find(number(thing));
    return *std::lower_bound(groups_.begin(), groups_.end(), root,
                             [](const Group& g, std::size_t wanted) { return g.root < wanted; });
  }
  void add_articulates() {
    for (const auto& articulate : articulates_)
      if (articulate->touches)
        for (const Node& n : articulate->nodes) things_.push_back(thing_of(n));
  }
  void anchor(const Articulate& articulate) { group_of(thing_of(articulate.nodes.front())).anchored = true; }
  Model& model_;
  const Articulates& articulates_;
  bool drifted_;
  Sets sets_;
  std::vector<std::uint32_t> things_;
  std::vector<std::size_t> roots_;
  std::vector<Group> groups_;  // by root
};

/// An impulse of one frame in the frame of another normal, by the smallest turn between them.
Vec3 turned_with(Vec3 from, Vec3 to, Vec3 impulse) {
  const Vec3 axis = cross(from, to);
  const double cosine = dot(from, to);
  return cosine > 0.0 ? impulse + cross(axis, impulse) + cross(axis, cross(axis, impulse)) / (1.0 + cosine) : impulse;
}

/// What contacts of solved islands gave: as they gave it, or, where they touch still, as they would give it now.
void add_contacts(const Model& model, const Articulates& articulates, const Contacts& contacts, bool drifted,
                  std::vector<Given>& as_then, std::vector<Given>& as_now) {
  std::vector<const Contact*> now(contacts.placed.size(), nullptr);
  for (const Contact& c : contacts.list)
    if (c.placed >= 0 && c.gap <= closed_gap * c.size) now[static_cast<std::size_t>(c.placed)] = &c;
  for (std::size_t k = 0; k < now.size(); k++) {
    const Placing& p = contacts.placed[k];
    if (!p.solved) continue;
    const Vec3 impulse = now[k] ? turned_with(p.normal, now[k]->normal, p.impulse) : p.impulse,
               moment = now[k] ? turned_with(p.normal, now[k]->normal, p.moment) : p.moment;
    std::vector<Given>& to = now[k] ? as_now : as_then;
    const auto add = [&](std::uint32_t thing, Vec3 arm_then, double sign) {
      const Vec3 arm = now[k] ? now[k]->at - centre_of(model, articulates, thing, drifted) : arm_then;
      to.push_back({thing, model.plane.along(impulse) * -sign, (cross(arm, impulse) + moment) * -sign});
    };
    add(p.body_a, p.arm_a, 1.0);
    if (p.body_b >= 0) add(static_cast<std::uint32_t>(p.body_b), p.arm_b, -1.0);
  }
}

/// What scalars within bounds gave, as they would give it now.
void add_scalars(const Model& model, const Articulates& articulates, const TouchSpace& space,
                 const TouchSettings& settings, std::vector<Given>& given) {
  for (std::size_t k = 0; k < space.held.size();) {
    const std::uint32_t number = space.held[k].articulate;
    Articulate& a = *articulates[number];
    find_forbidden(a, settings.h, settings.at);
    const std::vector<ScalarRow> now = scalar_rows(a);
    for (; k < space.held.size() && space.held[k].articulate == number; k++) {
      const TouchScalar& then = space.held[k];
      const auto same = std::find_if(now.begin(), now.end(), [&](const ScalarRow& row) {
        return row.row() == then.row.row() && dot(row.terms.front().along, then.row.terms.front().along) > 0.0;
      });
      for (const ScalarRow::End& end : same == now.end() ? then.row.ends : same->ends) {
        const std::uint32_t thing = thing_of(a.nodes[static_cast<std::size_t>(end.node)]);
        given.push_back({thing, model.plane.along(end.force) * then.given, end.moment * then.given});
      }
    }
  }
}

/// One of each thing, rising.
std::vector<Given> by_thing(std::vector<Given> list) {
  std::stable_sort(list.begin(), list.end(), [](const Given& x, const Given& y) { return x.thing < y.thing; });
  std::vector<Given> sums;
  for (const Given& g : list) {
    if (sums.empty() || sums.back().thing != g.thing) {
      sums.push_back(g);
      continue;
    }
    sums.back().impulse += g.impulse;
    sums.back().moment += g.moment;
  }
  return sums;
}

}  // namespace

double take_back(TouchSpace& space, Model& model, const Articulates& articulates, Contacts& contacts,
                 const TouchSettings& settings) {
  const bool drifted = settings.drifted;
  if (contacts.placed.empty()) return 0.0;
  double work = 0.0;
  for (Placing& p : contacts.placed) {
    p.impulse = p.impulse * -1.0;
    p.moment = p.moment * -1.0;
  }
  HeatOf heat(model, articulates, contacts, drifted, contacts.placed, contacts.new_heat);
  std::vector<Given> as_then = space.given, as_now;
  add_contacts(model, articulates, contacts, drifted, as_then, as_now);
  add_scalars(model, articulates, space, settings, as_now);
  Turns turns(model, articulates, contacts, as_then, drifted);
  as_then.insert(as_then.end(), as_now.begin(), as_now.end());
  for (const Given& g : by_thing(std::move(as_then))) {
    const BodyState s = state_of(model, articulates, g.thing, drifted);
    const double before = kinetic_energy(model, s, g.thing);
    add_momenta(model, s, g.thing, g.impulse * -1.0, g.moment * -1.0);
    const double by = kinetic_energy(model, s, g.thing) - before;
    work += by;
    if (const std::size_t i = number_of(model, g.thing); i < space.placing_work.size()) space.placing_work[i] += by;
  }
  work += turns.give_back() + space.answered.all();
  heat.add(work);
  return work;
}

}  // namespace pantin
