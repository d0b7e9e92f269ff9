#include <algorithm>

#include "contacts/find.hpp"

namespace pantin {

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
    if (old != before.end() && old->key == now[i].key) {
      inherit(now[i], old);
      now[i].placed = old->placed;
    } else {
      orphans.push_back(i);
    }
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

}  // namespace pantin
