#pragma once
// A tree of ball hinges in its own rotations. Its state is the orientation and the spin of each node; positions follow from
// hinge to hinge, so no gap can open. Forces of hinges are found by one symmetric elimination of 3 x 3 blocks, from the ends
// inwards to a hinge in the middle, so that of a chain both halves are worked on at the same time.
//
// Outside of a hinge f, the force on the outer node, accelerates the hinge's point by β + C f; C is what yields there. Of a
// node with the arm `in` to its inner hinge and `out` to an outer one, K_xy = 1/m - r_x^ W r_y^, W = R I⁻¹ R':
//   D = C_outer + K_out,out      ρ = a_out - β_outer      f_outer = D⁻¹ (ρ + K_out,in f_inner)
//   C = K_in,in - K_in,out D⁻¹ K_out,in                   β = a_in - K_in,out D⁻¹ ρ
// with a = g + α x r + ω x (ω x r), α = W (L x ω), what the point would do without hinges. The world yields nothing. Where
// more than one hinge is outside of a node (a branch), each changes by how much a force and a torque move it, one after the
// other, so a hub costs in proportion to its hinges, each two or three links.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "trees/tree_course.hpp"

namespace pantin {

struct TreeNode {
  double mass = 0.0;                                  ///< [kg]
  Vec3 inertia = zero3(), inverse_inertia = zero3();  ///< [kg m²], [1/(kg m²)] of a point 0
  double extent = 0.0;                                ///< [m] from its centre of points that show how it turns
};
/// Ties node a to node b, or to the world (b = -1), by arms in principal axes [m].
struct TreeHinge {
  std::int32_t a = 0, b = -1;
  Vec3 la = zero3(), lb = zero3();
};

/// What of a tree does not change. Nodes have slots, four to a batch: two nodes that are equally far from the outermost on
/// their sides are a pair, the slots 2p and 2p + 1, and are worked on together.
struct Tree {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Batch {
    Vec3x4 in, out;                               // [m] arms to the inner hinge, and to the only outer one
    Vec3x4 inverse_inertia, inertia_differences;  // of the latter I_y - I_z, I_z - I_x, I_x - I_y
    Lanes inverse_mass;
    Lanes turn_per_force_in, turn_per_force_out;  // see `turn_per_force`
  };
  enum class Kind : std::uint8_t { leaf, link, branch };
  /// In the order of elimination.
  struct Pair {
    Kind kind = Kind::leaf;
    bool outer_is_pair = false;  // the two outer ones are a pair, in this order
    std::uint32_t outer[2];  // of links: slots of what hangs on their outer hinges; of branches: indices in `branches`
  };
  struct Branch {
    std::uint32_t slot;
    std::uint32_t first, last;  // of `arms`
  };
  struct Arm {
    std::uint32_t outer;  // slot of what hangs on it
    Vec3 l;
    double turn_per_force;
  };
  /// Where a node is, by a hinge to one whose position is known, or to the world (-1).
  struct Placement {
    std::int32_t parent, child;
    std::uint32_t parent_slot, child_slot;
    std::uint32_t hinge;
    Vec3 parent_arm, child_arm;  // [m] in principal axes
  };

  std::uint32_t nodes = 0, world_slot = 0;  // the latter after all others
  std::uint32_t middle[2] = {0, 0};         // slots at the last hinge
  bool anchored = false;
  std::vector<std::uint32_t> slots;  // (nodes)
  std::vector<Batch> batches;
  std::vector<Pair> pairs;
  std::vector<Branch> branches;
  std::vector<Arm> arms;
  std::vector<Placement> placements;    // in breadth-first order from the nail or from node 0
  std::vector<double> masses, extents;  // (nodes) [kg], [m]
  double mass = 0.0;                    // [kg]
};

/// Where a tree is worked on.
struct TreeWorkspace {
  using Two = double __attribute__((vector_size(16)));  // of the two nodes of a pair
  struct Symmetric4 {
    Lanes xx, xy, xz, yy, yz, zz;
  };
  struct Batch {
    Mat3x4 R;
    Vec3x4 r_in, r_out, alpha, a_in, a_out;  // of the last three what they would be without hinges
    Symmetric4 W, K_in, K_out;
    Lanes K_cross[9];    // K_out,in by rows
    Vec3x4 f_in, f_out;  // [N] on the node; on what hangs on its outer hinge
    Vec3x4 torque;       // [N m] of a branch's outer hinges
  };
  /// How the points of inner hinges move by the force f there, with all that is outside: β + C f. Of the world 0.
  struct Outside {
    Two C[6], beta[3];  // xx, xy, xz, yy, yz, zz
  };
  struct Vector2 {
    Two x, y, z;
  };
  struct Joint {
    // force at the outer hinge, by that at the inner one and without: D⁻¹ K_out,in, D⁻¹ ρ
    Vector2 by_x, by_y, by_z, alone;
  };
  struct Arm {
    Mat3 U_force, U_torque, D_inverse;  // by how much a force at the arm moves the node, and turns it
    Vec3 r, rho, f;
  };
  AlignedVector<Batch> batches;
  std::vector<Outside> outside;  ///< (pairs, and the world)
  std::vector<Joint> joints;     ///< (pairs)
  std::vector<Arm> arms;
  AlignedVector<Lanes> k;                     ///< (stages × state) rates
  TreeState stage_state, end;                 ///< of a step
  TreeState error_estimate;                   ///< of order 5
  AlignedVector<Vec3x4> rotation_errors;      ///< (slots) [rad] estimates of a step's, in the lanes
  AlignedVector<Vec3x4> displacement_errors;  ///< (nodes) [m] what these make of the positions
  TreeState present;                          ///< at the end of a drift
  std::vector<Vec3> momenta;                  ///< (nodes) [kg m/s]
};

/// How fast a force at an arm makes a node turn faster, at most [rad/s² per N]: |arm across an axis|/moment about it. Times the force
/// it bounds the square of the rate at which the node can swing.
double turn_per_force(const TreeNode& node, Vec3 arm);

/// Orders the elimination. The hinges must make one tree; at most one is to the world.
Tree make_tree(std::span<const TreeNode> nodes, std::span<const TreeHinge> hinges);

/// Sizes it for a tree.
void make_room(const Tree& tree, TreeWorkspace& workspace);

/// Rates of a state under a uniform gravity [m/s²].
void find_rates(const Tree& tree, TreeWorkspace& workspace, Vec3 gravity, const Rotation4* state, Rotation4* rates);

/// Square of the rate [1/s²] at which the hinges' forces of the last evaluation can make a node swing: of the stiffest, a
/// little too large.
double largest_own_rate2(const Tree& tree, const TreeWorkspace& workspace);

}  // namespace pantin
