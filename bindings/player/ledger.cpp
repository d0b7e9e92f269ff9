#include "player/ledger.hpp"

#include "measure/ledger_closure.hpp"

namespace pantin::player {

LedgerLines ledger_lines(const World& world) {
  LedgerLines lines{world.time, law_ledger(world), world.ledger, 0.0, {}};
  if (!lines.posts.kept) return lines;
  lines.closure = closure(world);
  lines.truncation = truncation(world);
  return lines;
}

}  // namespace pantin::player
