#include "contacts/bodies.hpp"

#include "base/functions.hpp"

namespace pantin {

namespace {

BodyState state_of_point(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates,
                         std::uint32_t slot, bool drifted) {
  const Point& point = model.points.at_slot(slot);
  const FreeMotion& m = model.free_motion[slot];
  BodyState s{};
  s.node = drifted && point.articulate >= 0
               ? &articulates[static_cast<std::size_t>(point.articulate)]->nodes[static_cast<std::size_t>(point.node)]
               : nullptr;
  s.x = s.node ? model.plane.beside(s.node->x0, m.x) : m.x;
  s.R = identity33();
  s.mass = point.mass;
  s.v = s.node ? s.node->p0 / point.mass : m.v;
  return s;
}

}  // namespace

BodyState state_of(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, std::uint32_t thing,
                   bool drifted) {
  if (is_point(thing)) return state_of_point(model, articulates, slot_of(thing), drifted);
  const Motion& m = model.motion[thing];
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
  s.inverse_inertia = inverse_inertia(m);
  s.v = (node ? node->p0 : m.p) / m.mass;
  s.w = s.R * ((node ? node->P0 : m.angular) * s.inverse_inertia);
  return s;
}

Vec3 centre_of(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, std::uint32_t thing,
               bool drifted) {
  if (is_point(thing)) return state_of_point(model, articulates, slot_of(thing), drifted).x;
  const Motion& m = model.motion[thing];
  if (!drifted || m.articulate < 0) return m.x;
  const Articulate& a = *articulates[static_cast<std::size_t>(m.articulate)];
  return model.plane.beside(a.nodes[static_cast<std::size_t>(m.node)].x0, m.x);
}

bool asleep(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, const Contacts& contacts,
            std::uint32_t thing) {
  const std::uint32_t slot = slot_of(thing);
  const std::int32_t articulate =
      is_point(thing) ? model.points.at_slot(slot).articulate : model.motion[slot].articulate;
  if (articulate >= 0) return articulates[static_cast<std::size_t>(articulate)]->rest.asleep;
  return !is_point(thing) && slot < contacts.bodies.size() && contacts.bodies[slot].rest.asleep;
}

bool sleeps_in_touch(const Contacts& contacts, std::uint32_t slot) {
  return slot < contacts.bodies.size() && contacts.bodies[slot].island >= 0;
}

void add_momenta(Model& model, const BodyState& s, std::uint32_t thing, Vec3 p, Vec3 angular) {
  if (is_point(thing)) {
    if (s.node)
      s.node->p0 += p;
    else
      model.free_motion[slot_of(thing)].v += p / s.mass;
    return;
  }
  const Vec3 principal = turning_part(model.motion[thing], s.q, angular);
  if (s.node) {
    s.node->p0 += p;
    s.node->P0 += principal;
    s.node->spin0 = s.node->inverse_inertia * s.node->P0;
    return;
  }
  model.motion[thing].p += p;
  model.motion[thing].angular += principal;
}

void displace(Model& model, const BodyState& s, std::uint32_t thing, Vec3 way, Vec3 turn) {
  if (is_point(thing)) {
    (s.node ? s.node->x0 : model.free_motion[slot_of(thing)].x) += way;
    return;
  }
  const double angle = norm(turn);
  Quat q = s.q;
  if (angle > 0.0) {
    const Vec3 u = turn * (functions::sin(0.5 * angle) / angle);
    q = normalised(Quat{functions::cos(0.5 * angle), u[0], u[1], u[2]} * s.q);
  }
  Motion& m = model.motion[thing];
  const Vec3 world = s.R * (s.node ? s.node->P0 : m.angular), principal = transposed_times(matrix(q), world);
  if (s.node) {
    s.node->x0 += way;
    s.node->q0 = q;
    s.node->R0 = matrix(q);
    s.node->P0 = principal;
    s.node->spin0 = s.node->inverse_inertia * principal;
    return;
  }
  m.x += way;
  m.q = q;
  m.angular = principal;
}

Vec3 position_of(const Model& model, const BodyState& s, std::uint32_t thing) {
  const Vec3 kept = is_point(thing) ? model.free_motion[slot_of(thing)].x : model.motion[thing].x;
  return s.node ? model.plane.beside(s.node->x0, kept) : kept;
}

double kinetic_energy(const Model& model, const BodyState& s, std::uint32_t thing) {
  if (s.node) return kinetic_energy(*s.node);
  if (!is_point(thing)) return kinetic_energy(model.motion[thing]);
  return 0.5 * s.mass * norm2(model.free_motion[slot_of(thing)].v);
}

bool is_loose_point(const Model& model, std::uint32_t thing) {
  return is_point(thing) && model.points.at_slot(slot_of(thing)).articulate < 0;
}

}  // namespace pantin
