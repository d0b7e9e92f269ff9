#pragma once
// From a structure to things of the world.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/edit.hpp"
#include "structures/structure.hpp"

namespace pantin {

/// What parts of a structure become: particles tied by a law; pieces of a rigid body; a rod along an edge; a plate on a
/// face. Rods and plates are hinged at the vertices that they share.
enum class BuildAs : std::uint8_t { nothing, deformable, rigid, articulated, panels };

/// A law that ties 2, 3 or 4 particles; a parameter that is `present` is measured at each tie.
struct BuildLaw {
  std::shared_ptr<const Law> law;  ///< null: none
  std::vector<double> values;      ///< (parameters of the law)
  Solve solve = Solve::explicitly;
};

struct BuildDef {
  BuildAs as = BuildAs::deformable;
  /// A mixed build: what each vertex, edge or face becomes, by its number. Vertices may be deformable or rigid, edges
  /// also articulated, faces also panels; each connected piece of rigid ones is a body.
  std::function<BuildAs(std::uint32_t)> vertices, edges, faces;
  double mass = 1.0;              ///< [kg] > 0 of all
  std::optional<MassIn> mass_in;  ///< not given: edges if articulated, faces of panels, else points
  /// Rigid pieces touch others, each as the convex hull of its vertices with the material and the layer of this; where
  /// `mass_in` is not given they are solid.
  std::optional<ShapeDef> hull;
  BuildLaw edge, angle, torsion;  ///< on edges, pairs of edges that meet, and three in a row
  Vec3 at = zero3();              ///< [m] position of the structure's origin
  Vec3 velocity = zero3();        ///< [m/s]
  FamilyId family;                ///< of the particles; null: of none
  std::optional<Color> color;     ///< of particles and points
  std::optional<double> radius;   ///< [m] >= 0 of particles and points
  std::optional<Vec3> axis;       ///< hinges turn about it only; world axes, of any length but 0
  std::string name;               ///< of the group
};

struct Built {
  GroupId group;                      ///< of the particles, then bodies, then connections
  std::vector<ParticleId> particles;  ///< (vertices) hinges, particles of a body's points, or free particles
  std::vector<BodyId> bodies;         ///< rigid pieces by their first vertices, rods and plates by edges and faces
  std::vector<ConnectionId> connections;
};

/// Makes a structure real. Throws Error, with the world as it was, where a number is bad, or the structure lacks what
/// the form is made of.
Built build(World& world, const Structure& structure, const BuildDef& def);

}  // namespace pantin
