#include "contacts/heat.hpp"

#include <algorithm>

#include "base/stable.hpp"
#include "contacts/bodies.hpp"
#include "contacts/touching.hpp"

namespace pantin {

HeatOf::HeatOf(const Model& model, const Articulates& articulates, const Contacts& contacts, bool drifted,
               std::span<const Placing> impulses, std::vector<TouchHeat>& to)
    : model_(model), articulates_(articulates), to_(to), drifted_(drifted) {
  if (!contacts.heat_kept) return;
  impulses_ = impulses;
  for (const Placing& impulse : impulses_) before_.push_back(slip(impulse));
}

HeatOf::Slip HeatOf::slip(const Placing& impulse) const {
  const auto of = [&](std::uint32_t slot, Vec3 arm) {
    const BodyState s = state_of(model_, articulates_, slot, drifted_);
    return Slip{s.v + cross(s.w, arm), s.w};
  };
  const Slip a = of(impulse.body_a, impulse.arm_a);
  if (impulse.body_b < 0) return a;
  const Slip b = of(static_cast<std::uint32_t>(impulse.body_b), impulse.arm_b);
  return {a.velocity - b.velocity, a.spin - b.spin};
}

void HeatOf::add(double work) {
  double sum = 0.0;
  for (std::size_t k = 0; k < impulses_.size(); k++) {
    const Placing& p = impulses_[k];
    const Slip after = slip(p);
    const double by =
        0.5 * (dot(p.impulse, before_[k].velocity + after.velocity) + dot(p.moment, before_[k].spin + after.spin));
    to_.push_back({pair_of(model_, p.body_a, p.body_b, p.shape_b), -by});
    sum += by;
  }
  share_work(model_, impulses_, work - sum, to_);
}

void share_work(const Model& model, std::span<const Placing> impulses, double work, std::vector<TouchHeat>& to) {
  double size = 0.0;
  for (const Placing& p : impulses) size += norm(p.impulse);
  for (const Placing& p : impulses) {
    const double part = size > 0.0 ? norm(p.impulse) / size : 1.0 / static_cast<double>(impulses.size());
    to.push_back({pair_of(model, p.body_a, p.body_b, p.shape_b), -part * work});
  }
}

namespace {

/// One of each pair, rising.
std::vector<TouchHeat> summed(std::vector<TouchHeat> list) {
  sort_stably(list.begin(), list.end(), [](const TouchHeat& x, const TouchHeat& y) { return x.pair < y.pair; });
  std::vector<TouchHeat> sums;
  for (const TouchHeat& one : list) {
    if (sums.empty() || sums.back().pair != one.pair) sums.push_back({one.pair});
    sums.back().heat += one.heat;
    sums.back().last += one.last;
  }
  return sums;
}

bool is_gone(const Model& model, const TouchPair& pair) { return !alive(model, pair.a) || !alive(model, pair.b); }

}  // namespace

void settle_heat(const Model& model, Contacts& contacts, double wrong) {
  std::vector<TouchHeat> now = summed(std::move(contacts.new_heat));
  contacts.new_heat.clear();
  double given = 0.0;
  for (const TouchHeat& one : now) given += std::max(0.0, -one.heat);
  for (TouchHeat& one : now)
    if (one.heat < 0.0) one.heat *= 1.0 - wrong / given;
  for (TouchHeat& one : now) one.last = one.heat;
  std::vector<TouchHeat> all = std::move(contacts.heat);
  for (TouchHeat& one : all)
    if (is_gone(model, one.pair)) one.pair = {};
  all.insert(all.end(), now.begin(), now.end());
  contacts.heat = summed(std::move(all));
}

std::optional<double> heat_of(const Contacts& contacts, const TouchPair& pair) {
  if (!contacts.heat_kept || pair == TouchPair{}) return {};
  const auto at = std::lower_bound(contacts.heat.begin(), contacts.heat.end(), pair,
                                   [](const TouchHeat& one, const TouchPair& p) { return one.pair < p; });
  return at != contacts.heat.end() && at->pair == pair ? at->last : 0.0;
}

}  // namespace pantin
