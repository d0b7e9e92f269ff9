#pragma once
// Structures: vertices, edges and faces as a value. Every function gives a new one; `build` makes one real.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

using StructureEdge = std::array<std::uint32_t, 2>;
using StructureFace = std::vector<std::uint32_t>;

inline StructureEdge edge_between(std::uint32_t a, std::uint32_t b) { return {a < b ? a : b, a < b ? b : a}; }

struct Structure {
  std::vector<Vec3> vertices;         ///< [m]
  std::vector<StructureEdge> edges;   ///< two vertices each, the lower number first
  std::vector<StructureFace> faces;   ///< round trips of three or more vertices, counter-clockwise seen from outside
  std::vector<std::string> elements;  ///< (vertices) chemical elements, "C"; empty where it is no molecule
};

inline constexpr std::size_t most_vertices = 4'000'000;

/// Checks and completes: edges of faces that are not among the edges are added behind them. Throws Error for a number
/// that is not finite, a vertex that is not there, an edge with one end, a face of fewer than three different vertices.
Structure make_structure(std::vector<Vec3> vertices, const std::vector<StructureEdge>& edges,
                         std::vector<StructureFace> faces);

Structure scaled(Structure s, Vec3 factors);  ///< factors finite, none 0
Structure rotated(Structure s, const Quat& turn);
Structure moved(Structure s, Vec3 by);  ///< [m]
/// The mirror image in the plane through a position [m]; `normal` of any length but 0.
Structure mirrored(const Structure& s, Vec3 normal, Vec3 through);
/// Both as one: vertices of b within `tolerance` [m] >= 0 of one of a become that one; what is then there twice is kept
/// once.
Structure joined(const Structure& a, const Structure& b, double tolerance);
/// Each edge halved: a triangle becomes four, another face of n sides n quadrilaterals round its middle.
Structure subdivided(const Structure& s);
/// A vertex in the middle of each face, an edge across each edge between two faces, a face round each inner vertex.
Structure dual(const Structure& s);
/// Each vertex of a closed surface cut off at a fraction of its edges, > 0 and < 1/2.
Structure truncated(const Structure& s, double fraction);

enum class Part : std::uint8_t { vertices, edges, faces };
struct Selection {
  Structure structure;               ///< the parts, what they are made of, and what is made of them alone
  std::vector<std::uint32_t> parts;  ///< numbers of the chosen parts in the old structure
};
/// Those vertices, edges or faces for which `keep(number)` is true.
Selection selected(const Structure& s, Part part, const std::function<bool(std::uint32_t)>& keep);

/// Vertices - edges + faces.
std::int64_t euler_characteristic(const Structure& s);
/// Whether each edge is between two faces that go round it in opposite senses.
bool is_closed(const Structure& s);
/// [m²] of all faces, which are taken to be flat; nothing where there are none.
std::optional<double> area(const Structure& s);
double area(const Structure& s, const StructureFace& face);
/// [m³] inside of a closed surface; else nothing.
std::optional<double> volume(const Structure& s);
/// [m] mean of a face's vertices.
Vec3 middle(const Structure& s, const StructureFace& face);

/// Where mass is: in the vertices, along the edges as thin rods, on the faces as thin sheets, or in the volume; uniform.
enum class MassIn : std::uint8_t { points, edges, faces, solid };
struct MassDistribution {
  double mass = 0.0;        ///< [kg]
  Vec3 centre = zero3();    ///< [m]
  Mat3 inertia = zero33();  ///< [kg m²] about the centre
};
/// Exact moments of a mass [kg] > 0. Throws Error where there are no edges, no faces or no volume for it. `shares` of the
/// mass in points (vertices), > 0; empty: alike.
MassDistribution distribution(const Structure& s, MassIn where, double mass, const std::vector<double>& shares = {});
/// The same of one flat face.
MassDistribution distribution(const Structure& s, const StructureFace& face, double mass);

/// The faces of a graph drawn on a surface, counter-clockwise about `normal(vertex)`; in the plane the one outside is
/// among them, clockwise.
std::vector<StructureFace> traced_faces(const Structure& s, const std::function<Vec3(std::uint32_t)>& normal);
/// Without vertices that have fewer edges than `least`, again and again.
Structure without_loose_ends(const Structure& s, int least = 2);

}  // namespace pantin
