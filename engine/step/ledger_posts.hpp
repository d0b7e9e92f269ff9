#pragma once
// What each phase posts to the ledger.
#include "articulates/articulate.hpp"
#include "world/world.hpp"

namespace pantin {

/// State before a stage of a step, for what it posts. Nothing is measured where the ledger is not kept.
struct LedgerMark {
  double kinetic = 0.0;      ///< [J]
  double falling = 0.0;      ///< [J] potential energy in gravity of what no kick gives it
  double all_falling = 0.0;  ///< [J] the same of all
  double told = 0.0;         ///< [J] posted so far, but for gravity, return and the integrator
  double size = 0.0;         ///< [J] sum of magnitudes of energies
};
/// `drifted`: what is tied has its state in the articulates.
LedgerMark ledger_mark(const World& world, bool drifted);
void begin_ledger(World& world);
/// What changed the kinetic energy since the mark, but for work from outside: gravity, in a kick of loose points;
void post_kick(World& world, const LedgerMark& before, bool drifted);
/// in a drift, what an articulate told of the symmetric projection, fallback steps, what stayed unsolved and a tree's errors;
void post_report(World& world, const DriftReport& report);
/// gravity as far as things fell, and the integrator's own errors;
void post_drift(World& world, const LedgerMark& before);
/// what the energies of solved laws gave to the motion since it was posted last;
void post_solved_laws(World& world, Articulate& articulate);
/// in a projection, `returned` [J] and the rest.
void post_projection(World& world, const LedgerMark& before, double returned);
void end_ledger(World& world);

}  // namespace pantin
