#include "player/animation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "forces/curves.hpp"
#include "forces/forces.hpp"

namespace pantin::player {
namespace {

constexpr Color iron = {0.25f, 0.27f, 0.30f, 1.0f}, paper = {1.00f, 0.965f, 0.89f, 1.0f},
                thread = {0.52f, 0.52f, 0.50f, 1.0f};

std::array<float, 3> floats(Vec3 v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

template <class Id>
std::uint64_t number(Id id) {
  return (std::uint64_t{id.generation} << 32) | id.slot;
}

std::string name_or(const std::string& name, const char* kind, std::uint32_t slot) {
  return name.empty() ? text(kind, " ", slot) : name;
}

/// Turns the third axis to a direction.
Quat turn_to(Vec3 d) {
  const Vec3 z = vec(0, 0, 1);
  if (d[2] < -0.999999) return {0.0, 1.0, 0.0, 0.0};
  const Vec3 axis = cross(z, d);
  return normalised({1.0 + d[2], axis[0], axis[1], axis[2]});
}

}  // namespace

Animation::Animation(const World& world, double rate, double pace) : clock_{rate, pace}, stage_(find_stage(world)) {}

void Animation::add_frames(const World& world) {
  while (clock_.take(world)) add_frame(world);
}

void Animation::add_frame(const World& world) {
  joints_.assign(world.particles.slots(), 0.0);
  add_bodies(world);
  add_ground(world);
  add_particles(world);
  add_constraints(world);
  add_ties(world);
}

template <class Make>
std::size_t Animation::mesh(const Key& look, Make make) {
  const auto [found, added] = looks_.try_emplace(look, meshes_.size());
  if (added) meshes_.push_back(make());
  return found->second;
}

std::size_t Animation::ball(const Color& color) {
  const Key look = {
      particle, (std::uint64_t{std::bit_cast<std::uint32_t>(color.r)} << 32) | std::bit_cast<std::uint32_t>(color.g),
      (std::uint64_t{std::bit_cast<std::uint32_t>(color.b)} << 32) | std::bit_cast<std::uint32_t>(color.a)};
  return mesh(look, [&] { return ball_mesh(color); });
}

Animation::Node* Animation::node_of(const Key& key) {
  const auto found = present_.find(key);
  if (found == present_.end()) return nullptr;
  Node& last = nodes_[found->second];
  return last.first + last.positions.size() == clock_.frames - 1 ? &last : nullptr;
}

void Animation::add(const Key& key, const std::string& name, std::size_t mesh, Vec3 at, Quat turn, Vec3 size) {
  if (!finite(at)) return;
  if (!node_of(key)) {
    present_[key] = nodes_.size();
    nodes_.push_back({name, mesh, clock_.frames - 1, {}, {}, {}});
  }
  Node& node = nodes_[present_.at(key)];
  std::array<float, 4> q = {static_cast<float>(turn.x), static_cast<float>(turn.y), static_cast<float>(turn.z),
                            static_cast<float>(turn.w)};
  if (!node.turns.empty()) {  // of the two that turn alike the nearer one
    float same = 0.0f;
    for (std::size_t i = 0; i < 4; i++) same += q[i] * node.turns.back()[i];
    if (same < 0.0f)
      for (float& x : q) x = -x;
  }
  node.positions.push_back(floats(at));
  node.turns.push_back(q);
  node.sizes.push_back(floats(size));
}

void Animation::add_stick(const Key& key, const std::string& name, Vec3 from, Vec3 to, double radius,
                          const Color& color) {
  const double length = norm(to - from);
  if (!(length > 0.0)) return;
  const std::size_t tube = mesh({key[0], 0, 0}, [&] { return tube_mesh(color); });
  add(key, name, tube, 0.5 * (from + to), turn_to((to - from) / length), vec(radius, radius, length));
}

void Animation::add_bodies(const World& world) {
  for (const BodyId id : world.bodies.ids()) {
    const Figure& figure = figures_.of(world, id, stage_);
    const std::size_t look = mesh({body, figure.hash, 0}, [&] { return body_mesh(figure); });
    const Body& row = world.bodies[id];
    add({body, number(id), figure.hash}, name_or(row.name, "body", id.slot), look,
        origin(world, id) + image_shift(world, world.motion_of(id).x), orientation(world, id), vec(1, 1, 1));
    for (std::size_t i = 0; i < row.points.size(); i++) {
      double& joint = joints_[world.points[row.points[i]].particle.slot - 1];
      joint = std::max(joint, figure.joints[i]);
    }
  }
}

void Animation::add_ground(const World& world) {
  for (const ShapeId id : world.shapes.ids()) {
    const Shape& row = world.shapes[id];
    if (row.body) continue;
    const std::string name = name_or(row.name, "ground", id.slot);
    if (std::holds_alternative<HalfSpaceShape>(row.geometry)) {
      const Floor floor = floor_of(world, id, stage_);
      const std::size_t look = mesh({ground, number(id), 1}, [&] { return floor_mesh(row.color); });
      add({ground, number(id), 1}, name, look, floor.middle, row.orientation, vec(2, 2, 1) * floor.reach);
    } else {
      const Figure& figure = figures_.of(world, id);
      const std::size_t look = mesh({ground, figure.hash, 0}, [&] { return body_mesh(figure); });
      add({ground, number(id), figure.hash}, name, look, zero3(), {}, vec(1, 1, 1));
    }
  }
}

void Animation::add_particles(const World& world) {
  appearance_.update(world);
  for (const ParticleId id : world.particles.ids()) {
    const Particle& row = world.particles[id];
    if (row.asleep_in || row.points.empty()) continue;
    const Point& first = world.points[row.points[0]];
    if (!row.is_hinge() && first.body) continue;
    const Vec3 place = position(world, id), at = place + image_shift(world, place);
    if (row.is_hinge()) {
      const double joint = joints_[id.slot - 1], given = row.radius.value_or(0.0);
      const double radius = given > 0.0 ? given : 1.45 * (joint > 0.0 ? joint : 0.05 * stage_.unit);
      const bool own = row.color && !(*row.color == first.color);
      add({hinge, number(id), 0}, name_or(row.name, "hinge", id.slot), ball(own ? *row.color : paper), at, {},
          vec(radius, radius, radius));
    } else {
      const double radius = appearance_.radius(id.slot - 1).value_or(drawn_radius(world, row.points[0], stage_));
      if (!(radius > 0.0)) continue;
      const Key key = {particle, number(id), 0};
      const Node* before = node_of(key);
      add(key, name_or(row.name, "particle", id.slot), before ? before->mesh : ball(present_color(world, id)), at, {},
          vec(radius, radius, radius));
    }
  }
}

void Animation::add_constraints(const World& world) {
  for (const ConstraintId id : world.constraints.ids()) {
    const Constraint& c = world.constraints[id];
    find_look(world, c, stage_, look_);
    const std::string name = name_or(c.name, constraint_names[static_cast<std::size_t>(c.kind)].data(), id.slot);
    for (std::size_t i = 0; i < look_.knobs.size(); i++) {
      const ConstraintLook::Knob& k = look_.knobs[i];
      double radius = k.radius;
      if (k.joints > 0.0)
        radius = k.joints * std::max(joints_[world.points[c.a].particle.slot - 1], 0.04 * stage_.unit);
      add({knob, number(id), i}, i == 0 ? name : text(name, ".", i), ball(iron), k.at, {}, vec(radius, radius, radius));
    }
    for (std::size_t i = 0; i < look_.lines.size(); i++) {
      const ConstraintLook::Line& l = look_.lines[i];
      const double radius = l.radius > 0.0 ? l.radius : 0.008 * stage_.unit;
      add_stick({l.metal ? bar : string, number(id), i}, look_.lines.size() == 1 ? name : text(name, ".", i + 1),
                l.from, l.to, radius, l.metal ? iron : thread);
    }
  }
}

void Animation::add_ties(const World& world) {
  for (const ConnectionId id : world.connections.ids()) {
    const Connection& c = world.connections[id];
    if (!c.enabled || c.count != 2) continue;
    const Vec3 a = end_of(world, c, 0), from = a + image_shift(world, a);
    Vec3 way = end_of(world, c, 1) - a;
    if (world.settings.box) way = Box{*world.settings.box}.nearest(way);
    add_stick({tie, number(id), 0}, text("tie ", id.slot), from, from + way, 0.012 * std::min(norm(way), stage_.unit),
              thread);
  }
}

}  // namespace pantin::player
