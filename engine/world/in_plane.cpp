#include "world/in_plane.hpp"

#include <cmath>

#include "constraints/kind.hpp"
#include "model/path.hpp"
#include "world/checks.hpp"

namespace pantin::internal {

namespace {

constexpr double slack = 1e-9;  // relative: round-off of what is in the plane

constexpr const char* letters[] = {"x", "y", "z"};

std::string of_plane(const World& world) {
  return text("scene.plane is \"", plane_names[static_cast<std::size_t>(world.plane.normal)], "\"");
}
const char* normal_letter(const World& world) { return letters[world.plane.normal]; }

}  // namespace

void require_in_plane(const World& world, std::string_view call, std::string_view name, Vec3 v, std::string_view unit) {
  if (!world.plane.flat() || norm(v - world.plane.along(v)) <= slack * norm(v)) return;
  throw Error(text(call, ": ", of_plane(world), ", so ", name, " must have no ", normal_letter(world), ", got ",
                   to_text(v), " ", unit));
}

void require_about_normal(const World& world, std::string_view call, std::string_view name, Vec3 v,
                          std::string_view unit) {
  if (!world.plane.flat() || norm(v - world.plane.about(v)) <= slack * norm(v)) return;
  throw Error(text(call, ": ", of_plane(world), ", so ", name, " must be along ", normal_letter(world), ", got ",
                   to_text(v), " ", unit));
}

void require_height(const World& world, std::string_view call, std::string_view name, Vec3 position, Vec3 of) {
  const double height = world.plane.height(position), wanted = world.plane.height(of);
  const double size = std::fmax(largest(position), largest(of));
  if (std::fabs(height - wanted) <= world.settings.tolerance * size) return;
  throw Error(text(call, ": ", of_plane(world), ", so ", name, " must stay at ", normal_letter(world), " = ", wanted,
                   " m, got ", height, " m"));
}

void require_turn(const World& world, std::string_view call, BodyId body, const Quat& orientation) {
  const Quat turn = orientation * conjugate(pantin::orientation(world, body));
  const Vec3 u = vec(turn.x, turn.y, turn.z);
  if (!world.plane.flat() || norm(u - world.plane.about(u)) <= slack) return;
  throw Error(text(call, ": ", of_plane(world), ", so ", describe(world, body), " can be turned about ",
                   normal_letter(world), " only; this orientation asks for more"));
}

Quat turned_in_plane(const World& world, BodyId body, const Quat& orientation) {
  if (!world.plane.flat()) return orientation;
  const Quat now = pantin::orientation(world, body);
  return normalised(world.plane.about(orientation * conjugate(now)) * now);
}

namespace {

/// The points and positions that a constraint keeps at distances: they must have one height.
void require_heights(const World& world, std::string_view call, const Constraint& c) {
  if (!c.a) return;
  const Vec3 first = position(world, c.a);
  const auto see = [&](Vec3 position) { require_height(world, call, "what it ties", position, first); };
  for (const Passage& p : c.passages()) see(p.point ? position(world, p.point) : p.position);
  for (const CoupledValue& v : c.coupled())
    if (v.point_a && norm2(v.axis_b) == 0.0) see(v.point_b ? position(world, v.point_b) : v.position);
  if (c.is<PathData>())
    for (Vec3 position : c.as<PathData>().path->positions()) see(position);
  if (c.b) see(position(world, c.b));
  if (rule_of(c).ends_at_position && !c.b && !c.position.of_time && c.hand < 0) see(c.position.now);
}

void require_axes(const World& world, std::string_view call, const Constraint& c) {
  if (rule_of(c).orients && !c.turn.of_time) require_turn(world, call, c.body_a, c.turn.now);
  if (rule_of(c).in_plane == nullptr) return;
  for (const PlaneNeed& need : rule_of(c).in_plane(world, c)) {
    if (need.along_normal) require_about_normal(world, call, need.name, need.vector, "");
    if (!need.along_normal) require_in_plane(world, call, need.name, need.vector, "");
  }
}

}  // namespace

void require_in_plane(const World& world, const Constraint& c) {
  if (!world.plane.flat()) return;
  const std::string_view call = kind_name(c.kind);
  require_heights(world, call, c);
  require_axes(world, call, c);
}

}  // namespace pantin::internal
