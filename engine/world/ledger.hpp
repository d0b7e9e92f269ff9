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

/// What changes the energy, besides gravity and laws that have one.
/// hand: also moving anchors and lengths, pushes on what is tied. motor: also turns and angles by functions of time.
/// limit: also all that ties what strikes one. contact: friction and restitution, and what moving surfaces give. push_out:
/// displacing what overlaps. event: kicks, pushes on what is loose. merge: lost in becoming one body.
/// damper: laws that depend on velocities, springs solved at the end of the step. law: parameters, connections made and
/// removed, attributes that follow an age. sleep: what still moved that fell asleep. unsolved: forces on what Newton's
/// iteration leaves open, within its tolerance, and what contacts gave that they should not. integrator: what "euler" and "rk4" change that no
/// force explains, and what the steps of trees do within their error.
enum class Source : std::uint8_t {
  hand,
  motor,
  limit,
  contact,
  push_out,
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
  fallback_step,
  unsolved,
  integrator
};
inline constexpr std::array<std::string_view, 18> source_names = {
    "hand",  "motor",      "limit",         "contact",       "push_out", "event",
    "edit",  "merge",      "emitter",       "removal",       "damper",   "law_edit",
    "sleep", "projection", "energy_return", "fallback_step", "unsolved", "integrator"};

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

/// Energy from outside: part of World::work. The first step starts the balance anew, so building a scene is no work.
void post(World& world, Source source, double joules);

/// What a law without energy and gravity do to each other's work in one kick [J].
void post_falling(World& world, double joules);

/// From the next step on all is kept; each law that has an energy is then run once more in each kick.
void keep_ledger(World& world);

}  // namespace pantin
