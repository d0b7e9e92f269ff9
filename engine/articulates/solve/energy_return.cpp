// Energy return: what the projection took out of the kinetic energy is given back to the motion that no symmetry keeps.
#include "articulates/solve/energy_return.hpp"

#include <algorithm>

#include "articulates/solve/momenta.hpp"
#include "articulates/solve/state.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// Of the nodes' starts about a position; of spin that nothing couples to only the energy.
struct Moments {
  Mat3 inertia = zero33();                // [kg m²]
  Vec3 angular = zero3();                 // [kg m²/s]
  double kinetic = 0.0, uncoupled = 0.0;  // [J] of all; of spin that nothing couples to
};

Moments moments_about(const Articulate& a, Vec3 X) {
  Moments m;
  for (const Node& n : a.nodes) {
    add_locked_inertia(m.inertia, n, X);
    m.angular += cross(n.x0 - X, n.p0);
    m.kinetic += kinetic_energy(n);
    if (!n.turns) continue;
    const Vec3 P = n.P0 * n.felt_axes;
    m.angular += n.R0 * P;
    m.uncoupled += 0.5 * dot(n.P0 - P, n.spin0);
  }
  return m;
}

Vec3 locked_spin(const Moments& m, Vec3 axis) {
  const double inertia = dot(axis, m.inertia * axis);
  return inertia > 0.0 ? axis * (dot(axis, m.angular) / inertia) : zero3();
}

/// Spin of the articulate if all were one rigid body: J⁻¹ L, or 0 where J is singular (all on a line).
Vec3 locked_spin(const Moments& m, const Plane& plane) {
  if (plane.flat()) return locked_spin(m, plane.about(vec(1, 1, 1)));
  const Mat3& J = m.inertia;
  const double t = trace(J);
  const double volume = dot(J[0], cross(J[1], J[2]));
  return volume > 1e-12 * t * t * t ? inverse(J) * m.angular : zero3();
}

/// Anchors on the world: none; of orientation only; of one position; of positions on a line; others.
enum class Anchorage : std::uint8_t { none, orientation, position, line, fixed };
struct Anchors {
  Anchorage kind = Anchorage::none;
  Vec3 position = zero3(), axis = zero3();
};

Anchors anchors(const Articulate& a) {
  Anchors found;
  Vec3 axis = zero3();
  bool orientation_tied = false;
  for (const Condition& c : a.conditions) {
    const Row& r = row(a, c);
    if (r.b >= 0 || c.turns_axis) continue;
    // A distance along an axis (of a rack, a screw) is kept along that alone: it guides its point, too.
    const bool guides = r.rule->guides || (r.lever == 0.0 && norm2(c.axis) > 0.0);
    if (c.stiff || guides) return {Anchorage::fixed, c.whole1, zero3()};  // no momentum is kept
    if (r.lever > 0.0) {
      axis = !orientation_tied && r.rule->leaves_turn ? r.rb1 : zero3();
      orientation_tied = true;
      continue;
    }
    const Vec3 position = c.whole1;
    if (found.kind == Anchorage::none) found = {Anchorage::position, position, zero3()};
    const Vec3 d = position - found.position;
    if (norm(d) <= 1e-9 * a.length) continue;
    const Vec3 u = direction(d);
    if (found.kind == Anchorage::line && norm(cross(u, found.axis)) > 1e-9)
      return {Anchorage::fixed, found.position, u};
    found.kind = Anchorage::line;
    found.axis = u;
  }
  if (!orientation_tied) return found;
  if (found.kind == Anchorage::none) return {Anchorage::orientation, zero3(), zero3()};
  if (found.kind == Anchorage::position && norm2(axis) > 0.0) return {Anchorage::line, found.position, axis};
  if (found.kind == Anchorage::line && norm2(axis) > 0.0 && norm(cross(axis, found.axis)) <= 1e-9) return found;
  return {Anchorage::fixed, found.position, zero3()};
}

/// The rigid motion whose momentum is kept by symmetry: velocity V at X, spin w; and the energies, [J].
struct RigidMotion {
  Vec3 X = zero3(), V = zero3(), w = zero3();
  double kinetic = 0.0;   // of all motion
  double relative = 0.0;  // of the motion relative to the rigid one, without spin that nothing couples to
};

RigidMotion rigid_motion(const Moments& m, Vec3 X, Vec3 w, Vec3 V = zero3(), double mass = 0.0) {
  return {X, V, w, m.kinetic, m.kinetic - m.uncoupled - 0.5 * (mass * norm2(V) + dot(w, m.angular))};
}

/// Anchors leave rigid motions free: none: all six; one position: the turn about it, of which gravity keeps only the part
/// about its own direction; a line: the turn about that line, if gravity is along it; else none.
RigidMotion conserved_motion(const Articulate& a, Vec3 gravity) {
  const Anchors held = anchors(a);
  if (held.kind == Anchorage::none || held.kind == Anchorage::orientation) {
    Vec3 X = zero3(), V = zero3();
    for (const Node& n : a.nodes) {
      X += n.x0 * n.mass;
      V += n.p0;
    }
    X = X / a.total_mass;
    const Moments m = moments_about(a, X);
    const Vec3 spin = held.kind == Anchorage::none ? locked_spin(m, a.plane) : zero3();
    return rigid_motion(m, X, spin, V / a.total_mass, a.total_mass);
  }
  const Moments m = moments_about(a, held.position);
  const double g = norm(gravity);
  const bool line = held.kind == Anchorage::line;
  const Vec3 down = g > 0.0 ? gravity / g : held.axis;
  if (held.kind == Anchorage::fixed || (line && norm(cross(down, held.axis)) > 1e-9))
    return rigid_motion(m, held.position, zero3());
  return rigid_motion(m, held.position,
                      line      ? locked_spin(m, held.axis)
                      : g > 0.0 ? locked_spin(m, down)
                                : locked_spin(m, a.plane));
}

bool may_return(const Articulate& a) {
  if (a.pulled || a.touches) return false;
  if (a.fell_back || a.soft_constraint || a.nonconservative) return false;
  return !struck(a) && std::none_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) {
    return c.driven || norm2(c.velocity) > 0.0 || c.value_rate != 0.0 || (c.works_along_d && !c.ranged);
  });
}

/// Scales the motion relative to a rigid one, by `most` at most, to change the kinetic energy [J]; returns by how much it
/// did.
double change_relative_motion(Articulate& a, const RigidMotion& rigid, double change, double most) {
  if (!(rigid.relative > 1e-9 * rigid.kinetic)) return 0.0;
  const double factor = std::min(most, std::sqrt(std::max(0.0, 1.0 + change / rigid.relative)));
  for (Node& n : a.nodes) {
    const Vec3 p = (rigid.V + cross(rigid.w, n.x0 - rigid.X)) * n.mass;
    n.p0 = p + (n.p0 - p) * factor;
    if (!n.turns) continue;
    n.P0 += (n.P0 - n.inertia * transposed_times(n.R0, rigid.w)) * n.felt_axes * (factor - 1.0);
    n.spin0 = n.inverse_inertia * n.P0;
  }
  return (factor * factor - 1.0) * rigid.relative;
}

}  // namespace

double return_energy(Articulate& a, double kinetic, Vec3 gravity) {
  if (!may_return(a)) return 0.0;
  const RigidMotion rigid = conserved_motion(a, gravity);
  constexpr double most = 1.2;
  return change_relative_motion(a, rigid, kinetic - rigid.kinetic, most);
}

double change_kinetic_energy(Articulate& a, double change, double most, Vec3 gravity) {
  return change_relative_motion(a, conserved_motion(a, gravity), change, most);
}

}  // namespace pantin
