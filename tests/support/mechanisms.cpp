#include "support/mechanisms.hpp"

#include <array>

#include "base/check.hpp"
#include "edit/edit.hpp"
#include "peers/pile_trial.hpp"
#include "peers/piles.hpp"

namespace pantin::support {

namespace {

Vec3 vec(const Eigen::Vector3d& v) { return pantin::vec(v.x(), v.y(), v.z()); }
Eigen::Vector3d vector(const Vec3& v) { return {v[0], v[1], v[2]}; }

ShapeDef shape(const Geometry& geometry) {
  ShapeDef def;
  def.geometry = geometry;
  def.material.friction = peers::friction;
  def.material.restitution = 0.0;
  return def;
}

BodyId add_solid(World& world, const peers::Mechanism& mechanism, int solid) {
  const peers::SolidDef& def = mechanism.solids[static_cast<std::size_t>(solid)];
  const Eigen::Quaterniond q = def.turn;
  BodyDef body;
  body.at = vec(def.at);
  body.orientation = {q.w(), q.x(), q.y(), q.z()};
  body.mass = def.mass;
  body.inertia = diagonal(vec(def.moments));
  if (def.form != peers::Form::none) body.shapes = {shape(geometry_of(def))};
  for (std::size_t k = 0; k < mechanism.joints.size(); k++) {
    const peers::BallJoint& joint = mechanism.joints[k];
    for (const bool first : {true, false}) {
      if ((first ? joint.a : joint.b) != solid) continue;
      PointDef end;
      end.at = vec(first ? joint.at_a : joint.at_b);
      end.name = (first ? "a" : "b") + std::to_string(k);
      body.points.push_back(end);
    }
  }
  return add_body(world, body);
}

void add_wall(World& world, const peers::Wall& wall) {
  ShapeDef def = shape(HalfSpaceShape{});
  const auto q = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), wall.normal);
  def.at = vec(wall.offset * wall.normal);
  def.orientation = {q.w(), q.x(), q.y(), q.z()};
  add_shape(world, def);
}

PointId end_of(const World& world, BodyId solid, const std::string& name) {
  for (const PointId point : world.bodies[solid].points)
    if (world.points[point].name == name) return point;
  throw Error(text("a solid has no end ", name));
}

void join(World& world, const std::vector<BodyId>& bodies, const peers::BallJoint& joint, std::size_t k) {
  const auto end = [&](int solid, const char* side) {
    return end_of(world, bodies[static_cast<std::size_t>(solid)], text(side, k));
  };
  if (joint.a < 0)
    add_nail(world, end(joint.b, "b"));
  else
    add_hinge(world, std::array{end(joint.a, "a"), end(joint.b, "b")});
}

}  // namespace

std::vector<BodyId> add_mechanism(World& world, const peers::Mechanism& mechanism) {
  std::vector<BodyId> bodies;
  for (std::size_t i = 0; i < mechanism.solids.size(); i++)
    bodies.push_back(add_solid(world, mechanism, static_cast<int>(i)));
  for (std::size_t k = 0; k < mechanism.joints.size(); k++) join(world, bodies, mechanism.joints[k], k);
  for (const peers::Wall& wall : mechanism.walls) add_wall(world, wall);
  return bodies;
}

void read_solids(const World& world, const std::vector<BodyId>& bodies, std::vector<peers::SolidState>& state) {
  state.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); i++) {
    const Motion& motion = world.motion_of(bodies[i]);
    const Quat q = orientation(world, bodies[i]);
    state[i] = {vector(motion.x), Eigen::Quaterniond(q.w, q.x, q.y, q.z), vector(motion.p * (1.0 / motion.mass)),
                vector(angular_velocity(motion))};
  }
}

}  // namespace pantin::support
