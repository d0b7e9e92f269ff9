#pragma once
// What friction and impact take of whom, where somebody asked: impulses do work at the mean of the velocities before and
// after them, so that the work of those that act at once adds up to the change of the kinetic energy.
#include <span>
#include <vector>

#include "contacts/contact.hpp"
#include "contacts/passes.hpp"

namespace pantin {

/// Impulses that are about to be given at once. Does nothing where heat is not kept.
class HeatOf {
 public:
  /// `drifted`: what is tied has its state in the articulates. The impulses must live as long as this; heat is added to `to`.
  HeatOf(const Model& model, const Articulates& articulates, const Contacts& contacts, bool drifted,
         std::span<const Placing> impulses, std::vector<TouchHeat>& to);
  /// They were given, and did `work` [J] with what ties answered; that of ties is shared by impulse, or evenly where all are 0.
  void add(double work);

 private:
  /// Of a relative to b.
  struct Slip {
    Vec3 velocity, spin;  ///< [m/s] of its point, [rad/s]
  };
  Slip slip(const Placing& impulse) const;

  const Model& model_;
  const Articulates& articulates_;
  std::vector<TouchHeat>& to_;
  bool drifted_;
  std::span<const Placing> impulses_;
  std::vector<Slip> before_;  // (impulses)
};

/// Adds work [J] that ties did where these impulses made them, shared by impulse, or evenly where all are 0.
void share_work(const Model& model, std::span<const Placing> impulses, double work, std::vector<TouchHeat>& to);

/// What friction and impact took of the two in the last step [J]; nothing where that is not kept.
std::optional<double> heat_of(const Contacts& contacts, const TouchPair& pair);

/// Adds what the impulses of a pass took to the heat of each pair, but for energy that they gave and should not have, `wrong`
/// [J] in all.
void settle_heat(const Model& model, Contacts& contacts, double wrong);

}  // namespace pantin
