#pragma once
// Making one thing of several and several of one, between two steps. Every function checks its input and throws Error,
// leaving the world as it was. Mass, centre of mass, momentum and angular momentum are kept to round-off; kinetic energy
// that is lost by what becomes one body is the ledger's line `merge`.
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edit/edit.hpp"
#include "measure/measure.hpp"

namespace pantin {

/// a lives on with the points and the own mass of b, which is gone; points, hinges and constraints stay, but for those
/// between the two. A name that a has already is taken from b's point.
void merge(World& world, BodyId a, BodyId b);
/// What an orientation by a function of time is to be once its body has become part of another, whose frame is turned.
struct TurnedAttitude {
  std::function<Quat(double)> wanted;
  Quat turn;
  Quat operator()(double time) const { return wanted(time) * conjugate(turn); }
};
/// Some of a body's points, not all, become a body of their own, which moves as they did. A shape goes with the points that
/// are in it, else with the nearest; one with points of both parts in it is an error. Both must have mass enough to be
/// bodies: own mass goes with the shapes if it is theirs, each filled evenly, and else stays where it is.
BodyId split(World& world, BodyId body, std::span<const PointId> points, std::string name = {});
/// What of a body is in front of a plane of the world, through a position [m], becomes a body of its own. Boxes and hulls are
/// cut; a round shape on both sides is an error. Sensors go whole to the side of their origin.
BodyId split(World& world, BodyId body, Vec3 through, Vec3 normal, std::string name = {});
/// Free particles and bodies of a group become one body: the first of its bodies where it has no particles.
BodyId freeze(World& world, GroupId group, std::string name = {});
/// The points of a body become free particles, its own mass another; points without mass are gone. An angular momentum
/// that these cannot carry is an error.
std::vector<ParticleId> shatter(World& world, BodyId body);

struct ShatterDef {
  std::size_t pieces = 12;  ///< 2 … 1000, and as many as the body has shapes
  std::uint64_t seed = 1;
  std::optional<Vec3> at;  ///< [m] in the world: pieces are smaller the nearer they are
};
/// A body of boxes and hulls breaks into convex bodies, the cells of random positions in it (Voronoi 1908): flush, each with
/// its share of the mass, the points in it, and the velocities that it had. What ties the body's rotation ends, and its
/// sensors go; mass, centre, momenta and kinetic energy are kept to round-off.
std::vector<BodyId> shatter(World& world, BodyId body, const ShatterDef& def);

struct JoinDef {
  std::optional<Vec3> at;       ///< [m] where they are to meet; not given: on their way to each other
  double time_constant = 0.05;  ///< [s] > 0
  double max_force = std::numeric_limits<double>::infinity();  ///< [N] > 0: never pulls harder, until they are near
  std::function<void(ParticleId)> on_met;                      ///< called with the hinge, in the step after
  std::string name;                                            ///< of the hinge
  Vec3 axis = zero3();  ///< of the hinge, world axes as they are then; 0: it turns freely
};
/// Draws two points of different bodies together as a dynamic constraint (Barzel and Barr 1988), and makes the hinge when
/// they meet; told as "joined". They come together on a straight line, so the forces on them, which are opposite, are not
/// along it: momentum is kept on the way, angular momentum is not (by forces along it points that pass each other would
/// never meet). They count as met within a tenth of the tolerance of their size. A greatest force that is too weak is told
/// in the log.
ConstraintId add_join(World& world, PointId a, PointId b, const JoinDef& def = {});

/// Pairs of particles (of a group, those of its bodies too) that are at most `distance` [m] > 0 apart, and not of one
/// body, ring or connection.
std::vector<std::array<ParticleId, 2>> pairs_within(const World& world, GroupId group, double distance);
std::vector<std::array<ParticleId, 2>> pairs_within(const World& world, const std::vector<ParticleId>& particles,
                                                    double distance);
/// Connections that are members of a group, and those among its things; those all of whose ends are among particles.
std::vector<ConnectionId> connections_in(const World& world, GroupId group);
std::vector<ConnectionId> connections_among(const World& world, const std::vector<ParticleId>& particles);
/// Adds kinetic energy [J], relative to the common motion of what nothing holds; a negative one cools, at most to rest.
/// What is at rest gets random velocities.
void heat(World& world, const AnyId& things, double joules);
void heat(World& world, const Things& things, double joules);
/// Turns things as one about their centre of mass, with their velocities, and moves them by a way [m]: ties among them keep.
void move(World& world, const Things& things, Vec3 by, const Quat& turn = {});
/// Kinetic energy [J] relative to the common motion of what nothing holds.
double heat_in(const World& world, const Things& things);

}  // namespace pantin
