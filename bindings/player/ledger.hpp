#pragma once
// Where energy came from and went.
#include <map>
#include <string>

#include "forces/forces.hpp"

namespace pantin::player {

/// As it stands at a time.
struct LedgerLines {
  double time = 0.0;                         ///< [s]
  LawLedger laws;                            ///< [J]
  Ledger posts;                              ///< [J]
  double closure = 0.0;                      ///< of it, where it is kept
  std::map<std::string, double> truncation;  ///< [J] the same
};

LedgerLines ledger_lines(const World& world);

}  // namespace pantin::player
