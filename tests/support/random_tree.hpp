#pragma once
// Trees of ball hinges by chance: solids of any orientation, bars of two masses without an inertia about their line, and
// particles, at places of each other; as they are, in a world, and for the reference.
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "edit/edit.hpp"
#include "support/hinged.hpp"

namespace pantin::cases {

struct TreePart {
  enum class Kind : std::uint8_t { solid, bar, particle } kind = Kind::solid;
  double mass = 1.0;
  Eigen::Vector3d moments = {0, 0, 0}, at = {0, 0, 0};  ///< [kg m²] in its own axes, [m]
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  std::vector<Eigen::Vector3d> points;  ///< [m] in its own axes, from its centre
};
struct TreeTie {
  int a = 0, b = -1;  ///< -1: the world
  int point_a = 0, point_b = 0;
};

struct RandomTree {
  std::vector<TreePart> parts;
  std::vector<TreeTie> ties;
  Eigen::Vector3d velocity = {0, 0, 0},
                  spin = {0, 0, 0};  ///< of all as one body, about the origin, which the nail is at
  std::vector<BodyId> bodies;        ///< null of particles
  std::vector<ParticleId> particles;
  std::vector<PointId> nails;
  std::vector<std::vector<PointId>> ends;  ///< (parts) their points
};

struct RandomTreeDef {
  int parts = 10;
  bool nailed = true;
  int hub = 0;  ///< so many of them hang on the first
};

RandomTree make_random_tree(Random& random, const RandomTreeDef& wish);
void add(World& world, RandomTree& tree);
reference::Hinged hinged(const RandomTree& tree);
/// Largest distance of a centre from where the reference has it [m].
double distance(const World& world, const RandomTree& tree, const reference::State& y);

}  // namespace pantin::cases
