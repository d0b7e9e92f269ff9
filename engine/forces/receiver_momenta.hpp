#pragma once
// The momenta of what laws move, wherever they are kept. Not for use outside world/.
#include "forces/forces.hpp"

namespace pantin {

struct Node;

/// The momenta of a receiver: after a drift those of its articulate's working copy, else of the model.
struct ReceiverMomenta {
  Vec3* p = nullptr;  // [kg m/s], or of a free point
  Vec3* v = nullptr;  // [m/s]
  Vec3* P = nullptr;  // [kg m²/s] in principal axes; null where it cannot turn
  Node* node = nullptr;
  double inverse_mass = 0.0;
  Vec3 inverse_inertia = zero3();
  Quat q;
  bool line = false;  // cannot turn about its first axis

  Vec3 velocity() const { return v ? *v : *p * inverse_mass; }
  Vec3 spin() const { return P ? rotate(q, *P * inverse_inertia) : zero3(); }
  void add(Vec3 impulse, Vec3 angular);
};

ReceiverMomenta momenta_of(World& world, const Receiver& receiver, bool drifted);
/// Whether it is of what sleeps.
bool sleeps(const World& world, const Receiver& receiver);

}  // namespace pantin
