#include "world/in_plane.hpp"

#include <cmath>

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
  for (const Passage& p : c.passages) see(p.point ? position(world, p.point) : p.position);
  if (c.path)
    for (Vec3 position : c.path->positions()) see(position);
  if (c.b) see(position(world, c.b));
  const bool to_position = !c.b && !c.path && c.passages.empty() && c.kind != ConstraintKind::on_plane;
  if (to_position && !c.target && c.hand < 0) see(c.position);
}

Vec3 in_world(const World& world, BodyId body, Vec3 axis) {
  return body ? rotate(orientation(world, body), axis) : axis;
}

void require_axes(const World& world, std::string_view call, const Constraint& c) {
  switch (c.kind) {
    case ConstraintKind::axis:
    case ConstraintKind::motor:
    case ConstraintKind::limit:
      if (c.body_a) require_about_normal(world, call, "axis", in_world(world, c.body_a, c.axis_a), "");
      return;
    case ConstraintKind::align:
      require_in_plane(world, call, "the first axis", in_world(world, c.body_a, c.axis_a), "");
      return require_in_plane(world, call, "the second axis", in_world(world, c.body_b, c.axis_b), "");
    case ConstraintKind::on_plane: return require_in_plane(world, call, "normal", c.axis_a, "");
    case ConstraintKind::orient:
      if (!c.attitude) require_turn(world, call, c.body_a, c.turn);
      return;
    default: return;
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
