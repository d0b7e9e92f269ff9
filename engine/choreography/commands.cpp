#include "choreography/commands.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "choreography/bring_back.hpp"
#include "choreography/build_by_hand.hpp"
#include "choreography/copy_by_hand.hpp"
#include "choreography/hands.hpp"
#include "contacts/find.hpp"
#include "edit/assemble.hpp"
#include "edit/common.hpp"
#include "measure/freedoms.hpp"
#include "measure/query.hpp"
#include "measure/reach.hpp"
#include "shapes/distance.hpp"

namespace pantin {

using namespace internal;

namespace {

/// What a point is called that is there to be held by a hand.
std::string name_of_grip(std::int32_t hand) { return text("(grip of hand ", hand + 1, ")"); }

/// With the point that was made to be held by, if there is one.
void release_by_hand(World& world, std::int32_t index) {
  const auto at = static_cast<std::size_t>(index);
  const bool holds = index >= 0 && at < world.hands.size() && world.hands[at].grab;
  const PointId held = holds ? world.constraints[world.hands[at].grab].a : PointId{};
  release(world, index);
  if (!held || world.points[held].name != name_of_grip(index)) return;
  const bool used = world.particles[world.points[held].particle].is_hinge() || !world.points[held].constraints.empty();
  if (!used) remove_point(world, held);
}

void grab_by_hand(World& world, const Command& c) {
  hand_of_input(world, c.hand);
  if (body_meant(c)) release_by_hand(world, c.hand);
  const PointId point = point_meant(world, c, name_of_grip(c.hand));
  try {
    grab(world, c.hand, point, c.max_force == 0.0 ? std::optional<double>() : c.max_force);
  } catch (const Error&) {
    if (body_meant(c)) remove_point(world, point);
    throw;
  }
}

void push_by_hand(World& world, const Command& c) {
  const Vec3 impulse = world.plane.along(c.amount);
  if (const BodyId body = body_meant(c)) return kick(world, body, impulse, c.position);
  kick(world, c.point, impulse);
}

/// What connections leave is shown as what breaks is.
void cut_by_hand(World& world, const Command& c) {
  if (const auto* hinge = std::get_if<ParticleId>(&c.thing)) {
    cut(world, *hinge);
  } else if (const auto* tie = std::get_if<ConnectionId>(&c.thing)) {
    const Connection& row = world.connections[*tie];
    const Break broken{end_of(world, row, 0), end_of(world, row, 1), next_time(world)};
    remove(world, *tie);
    if (world.breaks.size() == most_breaks) world.breaks.pop_front();
    world.breaks.push_back(broken);
  } else {
    const auto* constraint = std::get_if<ConstraintId>(&c.thing);
    require(constraint != nullptr, "cut: ", describe(world, c.thing),
            " cannot be cut; hinges, connections and "
            "constraints can");
    remove(world, *constraint);
  }
  Notice& told = world.notices.back();
  if (told.kind != Notice::Kind::drop) told.hand = c.hand;  // a drop is of the hand that held
}

void spin_by_hand(World& world, const Command& c) {
  require_finite("spin", "spin", c.amount, "rad/s");
  const BodyId body = body_meant(c) ? body_meant(c) : world.points[c.point].body;
  require(static_cast<bool>(body), "spin: ", describe(world, c.point), " is a free particle, which cannot turn");
  const Motion& m = world.motion_of(body);
  const Vec3 spin = rotate(m.q, m.angular * inverse_inertia(m));
  set_spin(world, body, spin + world.plane.about(c.amount));
}

void heat_by_hand(World& world, const Command& c) {
  require_finite("heat", "position", c.position, "m");
  require_positive("heat", "radius", c.radius, "m");
  require_finite("heat", "the energy", c.energy, "J");
  const Things things = heated_by(world, c.position, c.radius);
  if (takes_heat(world, things, c.energy)) heat(world, things, std::fmax(c.energy, -heat_in(world, things)));
}

/// A key that is let go is told.
void control(World& world, const Command& c) {
  require(c.value >= -1.0 && c.value <= 1.0, "control: '", c.name, "' must be from -1 to 1, got ", c.value);
  if (c.value != 0.0) {
    world.controls[c.name] = c.value;
  } else if (world.controls.erase(c.name) > 0) {
    notice(world, Notice::Kind::key_up, {}, c.name, c.hand);
  }
}

void set_down(MouseButton& button, bool down) {
  button.pressed |= down && !button.held;
  button.released |= !down && button.held;
  button.held = down;
}

void move_mouse(World& world, const Command& c) {
  require_finite("mouse", "position", c.position, "m");
  require_finite("mouse", "the wheel", c.value, "notches");
  Mouse now = world.mouse;
  std::istringstream names(c.name);
  std::set<std::string> down;
  for (std::string name; names >> name; down.insert(name))
    require(now.button(name) != nullptr, "mouse: there is no button '", name, "'");
  for (const char* name : {"left", "middle", "right"}) set_down(*now.button(name), down.contains(name));
  now.position = c.position;
  now.wheel += c.value;
  world.mouse = now;
}

void add_bodies_without_points(const World& world, Vec3 position, double radius, std::vector<BodyId>& bodies) {
  const Geometry ball = BallShape{radius};
  for (const BodyId id : world.bodies.ids()) {
    const Body& body = world.bodies[id];
    const bool reached =
        body.points.empty() && std::ranges::any_of(body.shapes, [&](ShapeId shape) {
          const Shape& row = world.shapes[shape];
          return separation(row.geometry, pose_of(world, row), ball, Pose{position, identity33()}).distance <= 0.0;
        });
    if (reached) bodies.push_back(id);
  }
  std::sort(bodies.begin(), bodies.end());
}

void carry_out(World& world, const Command& c) {
  switch (c.kind) {
    case Command::Kind::grab: return grab_by_hand(world, c);
    case Command::Kind::release: return release_by_hand(world, c.hand);
    case Command::Kind::cut: return cut_by_hand(world, c);
    case Command::Kind::key: return notice(world, Notice::Kind::key, {}, c.name, c.hand);
    case Command::Kind::button: return notice(world, Notice::Kind::button, {}, c.name, c.hand);
    case Command::Kind::join: return join_by_hand(world, c);
    case Command::Kind::nail: add_nail(world, point_meant(world, c)); return;
    case Command::Kind::push: return push_by_hand(world, c);
    case Command::Kind::spin: return spin_by_hand(world, c);
    case Command::Kind::remove: return c.name == "whole" ? remove_whole(world, c) : remove(world, c.thing);
    case Command::Kind::make: return c.name == "copy" ? copy_by_hand(world, c) : make_by_hand(world, c);
    case Command::Kind::heat: return heat_by_hand(world, c);
    case Command::Kind::tie: return tie_by_hand(world, c);
    case Command::Kind::drive: return drive_by_hand(world, c);
    case Command::Kind::control: return control(world, c);
    case Command::Kind::bring: return bring_back(world, c);
    case Command::Kind::mouse: return move_mouse(world, c);
  }
}

}  // namespace

Things heated_by(const World& world, Vec3 position, double radius) {
  Things things = things_of(world, near(world, position, radius));
  add_bodies_without_points(world, position, radius, things.bodies);
  std::sort(things.free_points.begin(), things.free_points.end());
  if (things.bodies.size() + things.free_points.size() != 1) return things;
  if (things.bodies.empty()) return tied_to(world, things.free_points[0], false);
  return tied_to(world, things.bodies[0], false);
}

bool takes_heat(const World& world, const Things& things, double joules) {
  if (things.bodies.size() + things.free_points.size() != 1 || count_freedoms(world, things).common == 0) return true;
  return heat_in(world, things) > 1e-12 * std::fmax(energy(world, things).kinetic, joules);
}

void carry_out(World& world, std::span<const Command> commands) {
  if (commands.empty()) return;
  const Acting acting(world);
  world.locked = false;
  for (const Command& command : commands) {
    world.who = [hand = command.hand] { return text("hand ", hand + 1); };
    try {
      carry_out(world, command);
    } catch (const Error& error) {
      log_line(world, "dropped", text(name_of(command.kind), " by hand ", command.hand + 1, ": ", error.what()));
    }
  }
}

}  // namespace pantin
