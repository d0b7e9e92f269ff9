#include "world/ledger.hpp"

#include <cmath>

#include "world/world.hpp"

namespace pantin {

void post(World& world, Source source, double joules) {
  world.work += joules;
  world.ledger.given[static_cast<std::size_t>(source)] += joules;
  if (source != Source::law) world.ledger.posted += std::fabs(joules);
}

void keep_ledger(World& world) { world.ledger.wanted = true; }

void post_falling(World& world, double joules) {
  if (!world.ledger.kept) return;
  world.ledger.gravity += joules;
  world.ledger.posted += std::fabs(joules);
}

}  // namespace pantin
