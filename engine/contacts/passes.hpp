#pragma once
// Touch in a step: placing before a drift and `meet` after it solve the same problem, for velocities that do not bring
// shapes into each other and for velocities with all impulses of the step; `push_out` opens what overlaps all the same.
#include <memory>
#include <span>
#include <vector>

#include "articulates/articulate.hpp"
#include "contacts/contact.hpp"
#include "contacts/solve/contact_search.hpp"
#include "model/model.hpp"

namespace pantin {

struct TouchSettings {
  double h;      ///< [s] of the drift
  Vec3 gravity;  ///< [m/s²]
  bool drifted;  ///< what rows tie has its state in the articulates
  double at;     ///< (0 … 1) of the step: when the state is
  double
      wanted_at;  ///< (0 … 1) of the step: when anchors move as they are to, in the middle of a drift that is to come
  double step;    ///< [s] length of the whole step
  ContactSearch search = ContactSearch::automatic;
  bool foresees = false;  ///< forces of a drift that is to come
};

struct TouchSpace;
class Workers;
struct BodyLoad;

struct TouchReport {
  double work = 0.0;          ///< [J] change of the kinetic energy by contacts
  double belts = 0.0;         ///< [J] what moving surfaces may have given of it
  double wrong = 0.0;         ///< [J] that contacts gave and should not have
  double taken_back = 0.0;    ///< [J] of that, at the end of the step
  double from_rest = 0.0;     ///< [J] that forces give from rest in the step to what touches
  double beside_falls = 0.0;  ///< [J] what gravity does in the drift beyond its kicks, by what contacts gave before it
  ImpulseWork ties;           ///< what ties that move gave when they answered
  std::uint32_t islands = 0, contacts = 0, iterations = 0;
  std::uint32_t unsolved = 0;  ///< islands beyond what is accepted

  void operator+=(const TouchReport& more);
};

using Articulates = std::vector<std::unique_ptr<Articulate>>;

/// Forgets what the last drift needed.
void begin_placing(const Model& model, const Articulates& articulates, Contacts& contacts,
                   const TouchSettings& settings);
/// Impulses with which the drift of h ends without new overlaps: 0 ≤ γ_n ⊥ G v̄ + gap/h ≥ 0 of its mean velocities v̄, which the
/// islands of `space` then have.
void find_placing(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
                  const TouchSettings& settings, TouchReport& report);
/// Gives them. `kicks` are the forces of laws with energies that kicked things before and after the drift [N], [N m]: by slots
/// of bodies, then of points, or none.
void give_placing(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
                  const TouchSettings& settings, std::span<const BodyLoad> kicks, TouchReport& report);
/// Takes these impulses back and gives those of the whole step, with which velocities part or stay, after
/// impacts, which rebound: 0 ≤ γ_n ⊥ n·v ≥ 0.
void meet(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
          const TouchSettings& settings, std::span<const BodyLoad> kicks, TouchReport& report);
/// Displaces what overlaps by more than a little, momenta kept; `work` is that of displacing it.
void push_out(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
              const TouchSettings& settings, TouchReport& report);

}  // namespace pantin
