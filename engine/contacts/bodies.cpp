#include "contacts/bodies.hpp"

#include "base/functions.hpp"

namespace pantin {

BodyState state_of(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, std::uint32_t slot,
                   bool drifted) {
  const Motion& m = model.motion[slot];
  Node* node = drifted && m.articulate >= 0
                   ? &articulates[static_cast<std::size_t>(m.articulate)]->nodes[static_cast<std::size_t>(m.node)]
                   : nullptr;
  BodyState s{};
  s.node = node;
  s.x = node ? model.plane.beside(node->x0, m.x) : m.x;
  s.q = node ? node->q0 : m.q;
  s.R = matrix(s.q);
  s.mass = m.mass;
  s.inertia = m.inertia;
  s.mobility = inverse_inertia(m);
  s.v = (node ? node->p0 : m.p) / m.mass;
  s.w = s.R * ((node ? node->P0 : m.angular) * s.mobility);
  return s;
}

bool asleep(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, const Contacts& contacts,
            std::uint32_t slot) {
  const std::int32_t articulate = model.motion[slot].articulate;
  if (articulate >= 0) return articulates[static_cast<std::size_t>(articulate)]->rest.asleep;
  return slot < contacts.bodies.size() && contacts.bodies[slot].rest.asleep;
}

bool sleeps_in_touch(const Contacts& contacts, std::uint32_t slot) {
  return slot < contacts.bodies.size() && contacts.bodies[slot].island >= 0;
}

void add_momenta(Model& model, const BodyState& s, std::uint32_t slot, Vec3 p, Vec3 angular) {
  const Vec3 principal = turning_part(model.motion[slot], angular);
  if (s.node) {
    s.node->p0 += p;
    s.node->P0 += principal;
    s.node->O0 = s.node->inverse_inertia * s.node->P0;
    return;
  }
  model.motion[slot].p += p;
  model.motion[slot].angular += principal;
}

void displace(Model& model, const BodyState& s, std::uint32_t slot, Vec3 way, Vec3 turn) {
  const double angle = norm(turn);
  Quat q = s.q;
  if (angle > 0.0) {
    const Vec3 u = turn * (functions::sin(0.5 * angle) / angle);
    q = normalised(Quat{functions::cos(0.5 * angle), u[0], u[1], u[2]} * s.q);
  }
  Motion& m = model.motion[slot];
  const Vec3 world = s.R * (s.node ? s.node->P0 : m.angular), principal = transposed_times(matrix(q), world);
  if (s.node) {
    s.node->x0 += way;
    s.node->q0 = q;
    s.node->R0 = matrix(q);
    s.node->P0 = principal;
    s.node->O0 = s.node->inverse_inertia * principal;
    return;
  }
  m.x += way;
  m.q = q;
  m.angular = principal;
}

}  // namespace pantin
