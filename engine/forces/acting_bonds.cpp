// Connections at work: which sites they tie, and what edits change of that.
#include <algorithm>
#include <numeric>

#include "forces/forces_parts.hpp"

namespace pantin {

namespace {

/// Keeps those of `n` groups of `width` values that `keep` names, in that order.
template <class Value>
void pick(std::vector<Value>& list, const std::vector<std::size_t>& keep, std::size_t width = 1) {
  std::vector<Value> kept;
  kept.reserve(keep.size() * width);
  for (std::size_t k : keep)
    kept.insert(kept.end(), list.begin() + static_cast<std::ptrdiff_t>(k * width),
                list.begin() + static_cast<std::ptrdiff_t>((k + 1) * width));
  list = std::move(kept);
}

void pick(ActingConnections& a, const std::vector<std::size_t>& keep) {
  pick(a.ids, keep);
  pick(a.serials, keep);
  pick(a.bond_list.sites, keep, static_cast<std::size_t>(a.bond_list.count));
  for (std::vector<double>& column : a.bond_list.parameters) pick(column, keep);
}

/// Takes connections out, by their sorted serials.
void take_out(ActingConnections& a, const std::vector<std::uint64_t>& serials) {
  std::vector<std::size_t> keep;
  for (std::size_t k = 0; k < a.serials.size(); k++)
    if (!std::binary_search(serials.begin(), serials.end(), a.serials[k])) keep.push_back(k);
  if (keep.size() < a.serials.size()) pick(a, keep);
}

void sort_by_serial(ActingConnections& a) {
  if (std::is_sorted(a.serials.begin(), a.serials.end())) return;
  std::vector<std::size_t> order(a.serials.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return a.serials[i] < a.serials[j]; });
  pick(a, order);
}

}  // namespace

void add_bond(const World& world, ActingConnections& acting, ConnectionId id, const BondEnds& ends) {
  const Connection& row = world.connections[id];
  for (std::uint32_t i = 0; i < row.count; i++)
    for (std::uint32_t j = 0; j < i; j++)
      if (ends[i] == ends[j]) return;
  acting.ids.push_back(id);
  acting.serials.push_back(row.serial);
  acting.bond_list.sites.insert(acting.bond_list.sites.end(), ends.begin(), ends.begin() + row.count);
  for (std::size_t k = 0; k < row.parameters.size(); k++) acting.bond_list.parameters[k].push_back(row.parameters[k]);
}

void change_bonds(const World& world, Forces& f, const std::vector<ConnectionId>& changed) {
  std::vector<std::uint64_t> serials = std::move(f.untied);
  f.untied.clear();
  for (ConnectionId id : changed) serials.push_back(world.connections[id].serial);
  if (serials.empty()) return;
  std::sort(serials.begin(), serials.end());
  for (ActingConnections& acting : f.connections) take_out(acting, serials);
  for (ConnectionId id : changed) {
    const Connection& row = world.connections[id];
    BondEnds ends{};
    for (std::uint32_t i = 0; i < row.count; i++) {
      ends[i] = f.site_of[awake(world, row.particles[i]).slot - 1];
      assume(!row.enabled || ends[i] != Forces::none);
    }
    for (auto law = row.law; law && row.enabled; law = law->also)
      for (ActingConnections& acting : f.connections)
        if (acting.law == law && acting.solved == (row.solve != Solve::explicitly)) add_bond(world, acting, id, ends);
  }
  for (ActingConnections& acting : f.connections) sort_by_serial(acting);
}

}  // namespace pantin
