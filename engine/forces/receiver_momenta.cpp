#include "forces/receiver_momenta.hpp"

#include "articulates/articulate.hpp"
#include "contacts/bodies.hpp"

namespace pantin {

void ReceiverMomenta::add(Vec3 impulse, Vec3 angular) {
  if (v)
    *v += impulse * inverse_mass;
  else
    *p += impulse;
  if (!P) return;
  Vec3 turn = rotate(conjugate(q), angular);
  if (line) turn[0] = 0.0;
  *P += turn;
  if (node) node->spin0 = inverse_inertia * *P;
}

bool sleeps(const World& world, const Receiver& m) {
  if (m.articulate >= 0) return world.articulates[static_cast<std::size_t>(m.articulate)]->rest.asleep;
  return m.is_body && asleep(world, world.articulates, world.contacts, m.slot);
}

ReceiverMomenta momenta_of(World& world, const Receiver& m, bool drifted) {
  ReceiverMomenta s;
  if (m.is_body) {
    Motion& motion = world.motion[m.slot];
    s.p = &motion.p;
    s.P = motion.freedom != Freedom::point ? &motion.angular : nullptr;
    s.inverse_mass = 1.0 / motion.mass;
    s.inverse_inertia = inverse_inertia(motion);
    s.q = motion.q;
    s.line = motion.freedom == Freedom::line;
  } else {
    s.v = &world.free_motion[m.slot].v;
    s.inverse_mass = 1.0 / world.points.at_slot(m.slot).mass;
  }
  if (!drifted || m.articulate < 0) return s;
  Node& n = world.articulates[static_cast<std::size_t>(m.articulate)]->nodes[m.node];
  s.node = &n;
  s.v = nullptr;
  s.p = &n.p0;
  s.P = s.P ? &n.P0 : nullptr;
  s.q = n.q0;
  return s;
}

}  // namespace pantin
