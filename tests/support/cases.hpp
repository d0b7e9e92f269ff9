#pragma once
// Scenes that the tests share, made through the public interface. SI units, gravity along -y, everything at rest in the
// plane z = 0. A rod is a box of length × 0.1 length × 0.1 length, along x in its own frame.
#include <optional>
#include <vector>

#include "edit/edit.hpp"

namespace pantin::cases {

struct ChainDef {
  int links = 10;
  double length = 1.0;   ///< [m] of a link
  double mass = 1.0;     ///< [kg] of a link
  Vec3 start = zero3();  ///< [m] head of the first link; the chain goes along +x from there
  bool pinned = true;    ///< the head of the first link is nailed
};

/// Bodies joined one after the other; link i's head is joined to link i - 1's tail.
struct Chain {
  std::vector<BodyId> bodies;
  std::vector<PointId> heads, tails;
  std::vector<ParticleId> hinges;
  ConstraintId pin;
};

/// Inertia of a rod about its centre, [kg m²].
Mat3 rod_inertia(double mass, double length);
/// A rod with massless points at both ends; `def` gives all but points, mass and inertia.
BodyId add_rod_body(World& world, double mass, double length, BodyDef def = {});

Chain add_chain(World& world, const ChainDef& def = {});
/// A chain of unit rods with a solid sphere of radius 0.5 m and `ratio` [kg] jointed at its surface.
Chain add_heavy_chain(World& world, int links, double ratio);
/// A closed regular polygon of unit rods; its topmost hinge is nailed.
Chain add_ring(World& world, int links);
struct WheelDef {
  int spokes = 20;    ///< all round; made are those
  int from = 0;       ///< of these numbers
  int to = -1;        ///< -1: all
  int links = 2;      ///< of a spoke
  double mass = 100;  ///< [kg] of the disc
};
struct Wheel {
  BodyId hub;
  PointId centre;
  std::vector<PointId> edge, ends;  ///< (spokes) points of the disc, tails of the last links
};
/// A disc of radius 1 m in the plane y = 0, with chains of unit rods outwards from hinges at its edge.
Wheel add_wheel(World& world, const WheelDef& def = {});
struct CubeDef {
  int edge = 5;             ///< particles
  double apart = 1.0;       ///< [m]
  double mass = 1.0;        ///< [kg] of a particle
  double stiffness = 50.0;  ///< [N/m]
  Solve solve = Solve::at_middle;
  FamilyId family = {};
  Vec3 start = zero3();  ///< [m] of the first
};
/// Particles, each tied by springs to the 26 about it. Lines of them are along z, then y.
std::vector<ParticleId> add_cube(World& world, const CubeDef& def = {});
/// Two particles of 1 kg on massless rods of 1 m, both at 90° from the downward vertical, at the origin.
struct DoublePendulum {
  PointId inner, outer;
  ConstraintId upper, lower;
};
DoublePendulum add_double_pendulum(World& world);
/// A body of moments (1, 2, 3) kg m² that spins nearly about its middle axis, without gravity.
BodyId add_top(World& world);

/// Keeps a point on a plane, or on that through it.
ConstraintId add_on_plane(World& world, PointId point, Vec3 normal = vec(0, 1, 0), std::optional<Vec3> through = {},
                          double time_constant = 0.1);

/// The one point of a free particle.
PointId point_of(const World& world, ParticleId particle);
/// The point of a body with that index.
PointId point_of(const World& world, BodyId body, std::size_t index);

}  // namespace pantin::cases
