#include "player/lua_of_ties.hpp"

#include <cmath>
#include <optional>

#include "base/shortened.hpp"
#include "laws/law.hpp"
#include "measure/measure.hpp"
#include "player/lua_of_body.hpp"

namespace pantin::player {
namespace {

/// The axis of a hinge or motor, in the world; in full where it was not a short one.
Vec3 axis_in_world(const World& now, const Constraint& c) {
  const Quat frame = orientation(now, c.body_a);
  const Vec3 exact = rotate(frame, c.axis_a), plain = shortened(exact, 1.0);
  if (norm(direction(plain) - exact) <= 1e-15) return plain;
  Vec3 axis = exact;
  for (int attempt = 0; attempt < 8; attempt++) {
    const Vec3 off = c.axis_a - rotate(conjugate(frame), direction(axis));
    if (norm2(off) == 0.0) return axis;
    axis = axis + rotate(frame, off);
  }
  return exact;
}

/// The axis of the hinge between two bodies, in the world; nothing: they turn freely.
std::optional<Vec3> axis_between(const World& now, const Particle& ring, BodyId a, BodyId b) {
  for (const ConstraintId id : ring.axes) {
    const Constraint& c = now.constraints[id];
    if ((c.body_a == a && c.body_b == b) || (c.body_a == b && c.body_b == a)) return axis_in_world(now, c);
  }
  return {};
}

bool are_joined_by_script(const World& now, const World& opened, PointId a, PointId b) {
  return opened.points.alive(a) && opened.points.alive(b) && opened.points[a].serial == now.points[a].serial &&
         opened.points[b].serial == now.points[b].serial && opened.points[a].particle == opened.points[b].particle;
}

std::string lua_of_rod(const World& now, const Constraint& c, LuaNames& names) {
  const Vec3 other = c.b ? position(now, c.b) : c.position.now;
  const std::string length = c.number.now == norm(other - position(now, c.a)) ? "" : ", " + lua_of(c.number.now);
  return text("scene:rod(", names.point(c.a), ", ", names.place(c.b, c.position.now), length, ")");
}

std::string lua_of_string(const World& now, const Constraint& c, LuaNames& names) {
  std::string through;
  double way = 0.0;
  std::optional<Vec3> last;
  for (const Passage& passage : c.passages()) {
    const Vec3 at = passage.point ? position(now, passage.point) : passage.position;
    if (last) way += norm(at - *last);
    last = at;
    through += text(through.empty() ? "" : ", ", names.place(passage.point, passage.position));
  }
  const std::string options = c.number.now == way ? "" : text(", { length = ", lua_of(c.number.now), " }");
  return text("scene:string({ ", through, " }", options, ")");
}

std::string lua_of_motor(const World& now, const Constraint& c, LuaNames& names) {
  const std::string against = c.body_b ? names.body(c.body_b) + ", " : "";
  return text("scene:motor(", names.body(c.body_a), ", ", against, "{ axis = ", lua_of(axis_in_world(now, c)),
              ", speed = ", lua_of(c.number.rate), ", max_torque = ", lua_of(c.max_torque), " })");
}

std::string lua_of_nail(const World& now, const Constraint& c, LuaNames& names) {
  const bool there = same(c.position.now, position(now, c.a));
  return text("scene:nail(", names.point(c.a), there ? "" : ", " + lua_of(c.position.now), ")");
}

std::string lua_of_join(const Constraint& c, LuaNames& names) {
  const Vec3 axis = c.progress()->hinge_axis;
  return text("scene:join(", names.point(c.a), ", ", names.point(c.b), ", { max_force = ", lua_of(c.max_force),
              ", time_constant = ", lua_of(c.time_constant), norm2(axis) > 0.0 ? ", axis = " + lua_of(axis) : "",
              " })");
}

}  // namespace

// Joined one after the other, as each pair may have an axis of its own.
LuaOfTie lua_of_hinge(const World& now, const World& opened, ParticleId id, LuaNames& names) {
  LuaOfTie lua;
  const Particle& ring = now.particles[id];
  for (std::size_t i = 1; i < ring.points.size(); i++) {
    const BodyId mine = now.points[ring.points[i]].body;
    std::size_t with = 0;
    std::optional<Vec3> axis;
    for (std::size_t k = 0; k < i && !axis; k++) {
      const BodyId other = now.points[ring.points[k]].body;
      axis = mine && other ? axis_between(now, ring, other, mine) : std::nullopt;
      if (axis) with = k;
    }
    if (!axis && are_joined_by_script(now, opened, ring.points[0], ring.points[i])) continue;
    const std::string options = axis ? text(", { axis = ", lua_of(*axis), " }") : "";
    lua.lines.push_back(
        text("scene:hinge(", names.point(ring.points[with]), ", ", names.point(ring.points[i]), options, ")"));
  }
  return lua;
}

LuaOfTie lua_of_constraint(const World& now, ConstraintId id, LuaNames& names) {
  const Constraint& c = now.constraints[id];
  if (c.hand >= 0 || c.kind == ConstraintKind::axis) return {};
  if (c.number.of_time || c.position.of_time || c.turn.of_time) return {{}, "follows a function of time"};
  switch (c.kind) {
    case ConstraintKind::nail: return {{lua_of_nail(now, c, names)}, {}};
    case ConstraintKind::rod: return {{lua_of_rod(now, c, names)}, {}};
    case ConstraintKind::string: return {{lua_of_string(now, c, names)}, {}};
    case ConstraintKind::join: return {{lua_of_join(c, names)}, {}};
    case ConstraintKind::motor:
      if (!c.by_speed) return {{}, "keeps an angle, as no hand's does"};
      return {{lua_of_motor(now, c, names)}, {}};
    default: return {{}, "is nothing that a hand makes"};
  }
}

LuaOfTie lua_of_connection(const World& now, ConnectionId id, LuaNames& names) {
  const Connection& tie = now.connections[id];
  if (tie.law->name != "spring" || tie.count != 2) return {{}, "has a law that no hand gives"};
  std::string ends, numbers;
  for (std::uint32_t i = 0; i < 2; i++) {
    const ParticleId end = tie.particles[i];
    ends += text(i > 0 ? ", " : "", end ? names.point(now.particles[end].points[0]) : lua_of(tie.positions[i]));
  }
  for (std::size_t k = 0; k < tie.parameters.size(); k++)
    numbers += text(k > 0 ? ", " : "", tie.law->parameters[k].name, " = ", lua_of(tie.parameters[k]));
  const std::string how = tie.asked == Solve::at_middle ? ", { implicit = true }" : "";
  return {{text("scene:connect(", ends, ", force.spring { ", numbers, " }", how, ")")}, {}};
}

}  // namespace pantin::player
