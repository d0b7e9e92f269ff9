#include "support/random_tree.hpp"

#include <algorithm>

#include "measure/measure.hpp"
#include "support/cases.hpp"

namespace pantin::cases {

namespace {

using Vector = Eigen::Vector3d;
using Kind = TreePart::Kind;

double within(Random& random, double least, double most) { return least + (most - least) * random.uniform(); }
Vector anywhere(Random& random, double reach) {
  return {within(random, -reach, reach), within(random, -reach, reach), within(random, -reach, reach)};
}

TreePart make_part(Random& random, Kind kind) {
  TreePart part;
  part.kind = kind;
  part.mass = within(random, 0.5, 2.0);
  if (kind == Kind::particle) {
    part.points = {Vector::Zero()};
    return part;
  }
  part.turn = Eigen::Quaterniond(within(random, -1, 1), within(random, -1, 1), within(random, -1, 1), 1.0).normalized();
  if (kind == Kind::bar) {
    part.moments.setConstant(part.mass * 0.25);  // two halves at ±0.5 m, and as much about the line
    part.points = {Vector(-0.5, 0, 0), Vector(0.5, 0, 0)};
    return part;
  }
  const Vector size(within(random, 0.2, 1.0), within(random, 0.2, 1.0), within(random, 0.2, 1.0));
  const Vector square = size.cwiseProduct(size) * (part.mass / 12.0);
  part.moments = {square.y() + square.z(), square.z() + square.x(), square.x() + square.y()};
  part.points = {anywhere(random, 0.5)};
  return part;
}

/// A point for a hinge: one that is there, or a new one.
int point_for(Random& random, TreePart& part) {
  const bool again = random.uniform() < 0.3 || part.kind == Kind::particle;
  if (again) return static_cast<int>(random.bits() % part.points.size());
  part.points.push_back(part.kind == Kind::bar ? Vector(within(random, -0.5, 0.5), 0, 0) : anywhere(random, 0.5));
  return static_cast<int>(part.points.size()) - 1;
}

Vector place(const TreePart& part, int point) {
  return part.at + part.turn * part.points[static_cast<std::size_t>(point)];
}

BodyId add_part(World& world, const RandomTree& tree, const TreePart& part) {
  BodyDef def;
  def.at = vec(part.at.x(), part.at.y(), part.at.z());
  def.orientation = {part.turn.w(), part.turn.x(), part.turn.y(), part.turn.z()};
  const Vector v = tree.velocity + tree.spin.cross(part.at);
  def.velocity = vec(v.x(), v.y(), v.z());
  def.spin = vec(tree.spin.x(), tree.spin.y(), tree.spin.z());
  const bool solid = part.kind == Kind::solid;
  if (solid) {
    def.mass = part.mass;
    def.inertia = diagonal(vec(part.moments.x(), part.moments.y(), part.moments.z()));
  }
  for (std::size_t k = 0; k < part.points.size(); k++) {
    PointDef point;
    point.at = vec(part.points[k].x(), part.points[k].y(), part.points[k].z());
    if (!solid && k < 2) point.mass = 0.5 * part.mass;
    def.points.push_back(point);
  }
  return add_body(world, def);
}

}  // namespace

RandomTree make_random_tree(Random& random, const RandomTreeDef& def) {
  RandomTree tree;
  tree.parts.push_back(make_part(random, Kind::solid));
  if (def.nailed) {
    tree.parts[0].at = -(tree.parts[0].turn * tree.parts[0].points[0]);
    tree.ties.push_back({0, -1, 0, 0});
  } else {
    tree.velocity = anywhere(random, 1.0);
  }
  tree.spin = anywhere(random, 2.0);
  while (std::ssize(tree.parts) < def.parts) {
    const double draw = random.uniform();
    const int number = static_cast<int>(tree.parts.size());
    TreePart part = make_part(random, draw < 0.6 ? Kind::solid : draw < 0.8 ? Kind::bar : Kind::particle);
    int parent = number <= def.hub ? 0 : static_cast<int>(random.bits() % tree.parts.size());
    while (tree.parts[static_cast<std::size_t>(parent)].kind == Kind::particle) parent--;
    TreePart& on = tree.parts[static_cast<std::size_t>(parent)];
    const TreeTie tie{number, parent, 0, point_for(random, on)};
    part.at = place(on, tie.point_b) - part.turn * part.points[0];
    tree.ties.push_back(tie);
    tree.parts.push_back(part);
  }
  return tree;
}

void add(World& world, RandomTree& tree) {
  tree.bodies.resize(tree.parts.size());
  tree.particles.resize(tree.parts.size());
  tree.ends.resize(tree.parts.size());
  for (std::size_t i = 0; i < tree.parts.size(); i++) {
    const TreePart& part = tree.parts[i];
    if (part.kind == Kind::particle) {
      const Vector v = tree.velocity + tree.spin.cross(part.at);
      ParticleDef def;
      def.at = vec(part.at.x(), part.at.y(), part.at.z());
      def.velocity = vec(v.x(), v.y(), v.z());
      def.mass = part.mass;
      tree.particles[i] = add_particle(world, def);
      tree.ends[i] = {point_of(world, tree.particles[i])};
    } else {
      tree.bodies[i] = add_part(world, tree, part);
      for (std::size_t k = 0; k < part.points.size(); k++) tree.ends[i].push_back(point_of(world, tree.bodies[i], k));
    }
  }
  // All that meet at one point are one hinge.
  std::vector<std::vector<PointId>> rings;
  const auto end = [&](int part, int point) {
    return tree.ends[static_cast<std::size_t>(part)][static_cast<std::size_t>(point)];
  };
  for (const TreeTie& tie : tree.ties) {
    if (tie.b < 0) {
      tree.nails.push_back(end(tie.a, tie.point_a));
      add_nail(world, tree.nails.back());
      continue;
    }
    const PointId at = end(tie.b, tie.point_b);
    const auto ring = std::find_if(rings.begin(), rings.end(), [&](const std::vector<PointId>& r) {
      return std::find(r.begin(), r.end(), at) != r.end();
    });
    if (ring == rings.end())
      rings.push_back({at, end(tie.a, tie.point_a)});
    else
      ring->push_back(end(tie.a, tie.point_a));
  }
  for (const std::vector<PointId>& ring : rings) add_hinge(world, ring);
}

reference::Hinged hinged(const RandomTree& tree) {
  reference::Hinged made;
  for (const TreePart& part : tree.parts) {
    const Eigen::Matrix3d R = part.turn.toRotationMatrix();
    made.bodies.push_back({part.mass, R * part.moments.asDiagonal() * R.transpose(), part.at,
                           tree.velocity + tree.spin.cross(part.at), tree.spin});
    // A bar does not spin about its line.
    if (part.kind == Kind::bar) made.bodies.back().spin -= R.col(0) * R.col(0).dot(tree.spin);
    if (part.kind == Kind::particle) made.bodies.back().spin.setZero();
  }
  for (const TreeTie& tie : tree.ties)
    made.hinges.push_back({tie.a, tie.b, place(tree.parts[static_cast<std::size_t>(tie.a)], tie.point_a)});
  return made;
}

double distance(const World& world, const RandomTree& tree, const reference::State& y) {
  double most = 0.0;
  for (std::size_t i = 0; i < tree.parts.size(); i++) {
    const Vector at = reference::centre(y, static_cast<int>(i));
    const Vec3 x = tree.bodies[i] ? world.motion_of(tree.bodies[i]).x : position(world, tree.ends[i][0]);
    most = std::max(most, norm(x - vec(at.x(), at.y(), at.z())));
  }
  return most;
}

}  // namespace pantin::cases
