#pragma once
// Where energy came from and went. What edits, hands and events give is always known. The rest is kept from when somebody
// asks: each phase then posts the kinetic energy that it changed, per source, so that nothing is explained by what is left.
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace pantin {

struct World;
struct DriftReport;

/// What changes the energy, besides gravity and laws that have one.
/// hand: also moving anchors and lengths, pushes on what is tied. motor: also turns and angles by functions of time.
/// limit: also all that ties what strikes one. event: kicks, pushes on what is loose. merge: lost in becoming one body.
/// damper: laws that depend on velocities, springs solved at the end of the step. law: parameters, connections made and
/// removed, attributes that follow an age. sleep: what still moved that fell asleep. unsolved: forces on what Newton's
/// iteration leaves open, within its tolerance. integrator: what "euler" and "rk4" change that no force explains.
enum class Source : std::uint8_t {
  hand,
  motor,
  limit,
  event,
  edit,
  merge,
  emitter,
  removal,
  damper,
  law,
  sleep,
  projection,
  energy_return,
  safe_step,
  unsolved,
  integrator
};
inline constexpr std::array<std::string_view, 16> source_names = {
    "hand",   "motor",    "limit", "event",      "edit",          "merge",     "emitter",  "removal",
    "damper", "law_edit", "sleep", "projection", "energy_return", "safe_step", "unsolved", "integrator"};

struct Ledger {
  std::array<double, source_names.size()> given{};  ///< [J] since the start; the last five since it is kept

  bool wanted = false;  ///< to be kept from the next step on
  bool kept = false;
  double since = 0.0;                    ///< [s] when keeping began
  double gravity = 0.0;                  ///< [J] given to the motion
  double laws = 0.0;                     ///< [J] given by the kicks of laws that have an energy
  double gravity_potential = 0.0;        ///< [J] change of the potential energy in gravity, by the motion alone
  std::map<std::string, double> kicks;   ///< [J] the same of each of these laws
  std::map<std::string, double> before;  ///< [J] what each had given when keeping began
  double unexplained = 0.0;              ///< [J] sum over the steps of |change of the kinetic energy - posts|
  double posted = 0.0;                   ///< [J] sum of magnitudes of the posts
  double round_off = 0.0;                ///< [J] that sums over all things may have made in `unexplained`
  double kinetic = 0.0, potential = 0.0, explained = 0.0;  ///< [J] at the start of the step, and until then
};

/// Energy from outside: part of World::work.
void post(World& world, Source source, double joules);

/// From the next step on all is kept; each law that has an energy is then run once more in each kick.
void keep_ledger(World& world);

/// |change of the kinetic energy - posts|, since the ledger is kept, over the sum of |posts|, or over the largest kinetic or
/// the potential energy where that is more, as of what rests: a test of the code.
double closure(const World& world);
/// What the energy of a law (and of "gravity") changed by, and what its kicks gave: the step's own error, per law, [J]. Of
/// laws without energy, together: what their kicks gave beyond a second estimate of their work.
std::map<std::string, double> truncation(const World& world);

/// State before a part of a step, for what it posts. Nothing is measured where the ledger is not kept.
struct LedgerMark {
  double kinetic = 0.0;  ///< [J]
  double falling = 0.0;  ///< [J] potential energy in gravity of what no kick gives it
  double told = 0.0;     ///< [J] posted so far, but for gravity, return and the integrator
  double size = 0.0;     ///< [J] sum of magnitudes of energies
};
/// `drifted`: what is tied has its state in the articulates.
LedgerMark ledger_mark(const World& world, bool drifted);
void begin_ledger(World& world);
/// What changed the kinetic energy since the mark, but for work from outside: gravity, in a kick of loose points;
void post_kick(World& world, const LedgerMark& before, bool drifted);
/// of that, what a law without energy and gravity do to each other's work in one kick;
void post_falling(World& world, double joules);
/// in a drift, what an articulate told of carried projection, safe steps and what stayed unsolved;
void post_report(World& world, const DriftReport& report);
/// gravity as far as things fell, and the integrator's own errors;
void post_drift(World& world, const LedgerMark& before);
/// in a projection, `returned` [J] and the rest.
void post_projection(World& world, const LedgerMark& before, double returned);
void end_ledger(World& world);

}  // namespace pantin
