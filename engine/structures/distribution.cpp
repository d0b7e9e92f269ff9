// Area, volume and moments of mass of structures, as sums over simplices.
#include <span>

#include "base/check.hpp"
#include "structures/structure.hpp"

namespace pantin {
namespace {

Vec3 vector_area(const Structure& s, const StructureFace& face) {
  Vec3 sum = zero3();
  const Vec3 first = s.vertices[face[0]];
  for (std::size_t i = 1; i + 1 < face.size(); i++)
    sum += cross(s.vertices[face[i]] - first, s.vertices[face[i + 1]] - first);
  return sum * 0.5;
}

/// SimplexMoments of uniform simplices about a reference position.
struct SimplexMoments {
  Vec3 reference = zero3();
  double measure = 0.0;
  Vec3 first = zero3();
  Mat3 second = zero33();

  /// A point, segment, triangle or tetrahedron of n corners x_i: its second moment is the measure / n(n + 1) times the
  /// sum of all x_i x_i' and of s s', s the sum of the corners.
  void add(double its_measure, std::span<const Vec3> corners) {
    const auto n = static_cast<double>(corners.size());
    Vec3 sum = zero3();
    Mat3 squares = zero33();
    for (Vec3 corner : corners) {
      const Vec3 x = corner - reference;
      sum += x;
      squares += outer(x, x);
    }
    measure += its_measure;
    first += sum * (its_measure / n);
    second += (squares + outer(sum, sum)) * (its_measure / (n * (n + 1.0)));
  }

  MassDistribution of_mass(double mass) const {
    const double density = mass / measure;
    const Vec3 mean = first / measure;
    const Mat3 about_centre = second * density - outer(mean, mean) * mass;
    return {mass, reference + mean, identity33() * trace(about_centre) - about_centre};
  }
};

Vec3 mean_of(const std::vector<Vec3>& positions) {
  Vec3 sum = zero3();
  for (Vec3 p : positions) sum += p;
  return positions.empty() ? sum : sum / static_cast<double>(positions.size());
}

void add_face(SimplexMoments& moments, const Structure& s, const StructureFace& face) {
  const Vec3 whole = vector_area(s, face), normal = direction(whole), first = s.vertices[face[0]];
  for (std::size_t i = 1; i + 1 < face.size(); i++) {
    const Vec3 corners[] = {first, s.vertices[face[i]], s.vertices[face[i + 1]]};
    moments.add(0.5 * dot(cross(corners[1] - first, corners[2] - first), normal), corners);
  }
}

void add_solid(SimplexMoments& moments, const Structure& s) {
  const Vec3 tip = moments.reference;
  for (const StructureFace& face : s.faces) {
    const Vec3 centre = middle(s, face);
    for (std::size_t i = 0; i < face.size(); i++) {
      const Vec3 corners[] = {tip, centre, s.vertices[face[i]], s.vertices[face[(i + 1) % face.size()]]};
      moments.add(dot(centre - tip, cross(corners[2] - tip, corners[3] - tip)) / 6.0, corners);
    }
  }
}

}  // namespace

double area(const Structure& s, const StructureFace& face) { return norm(vector_area(s, face)); }

std::optional<double> area(const Structure& s) {
  if (s.faces.empty()) return {};
  double sum = 0.0;
  for (const StructureFace& face : s.faces) sum += area(s, face);
  return sum;
}

std::optional<double> volume(const Structure& s) {
  if (!is_closed(s)) return {};
  SimplexMoments moments{mean_of(s.vertices)};
  add_solid(moments, s);
  return moments.measure;
}

MassDistribution distribution(const Structure& s, MassIn where, double mass, const std::vector<double>& shares) {
  SimplexMoments moments{mean_of(s.vertices)};
  switch (where) {
    case MassIn::points:
      for (std::size_t i = 0; i < s.vertices.size(); i++)
        moments.add(shares.empty() ? 1.0 : shares[i], std::span(&s.vertices[i], 1));
      break;
    case MassIn::edges:
      for (const StructureEdge& e : s.edges) {
        const Vec3 ends[] = {s.vertices[e[0]], s.vertices[e[1]]};
        moments.add(norm(ends[1] - ends[0]), ends);
      }
      break;
    case MassIn::faces:
      for (const StructureFace& face : s.faces) add_face(moments, s, face);
      break;
    case MassIn::solid:
      require(is_closed(s), "mass in \"solid\" needs a closed surface, whose faces go round in one sense");
      add_solid(moments, s);
      break;
  }
  static constexpr const char* needed[] = {"vertices", "edges of some length", "faces of some area", "a volume > 0"};
  require(moments.measure > 0.0, "the mass needs ", needed[static_cast<std::size_t>(where)],
          ", and the structure has none");
  return moments.of_mass(mass);
}

MassDistribution distribution(const Structure& s, const StructureFace& face, double mass) {
  SimplexMoments moments{middle(s, face)};
  add_face(moments, s, face);
  require(moments.measure > 0.0, "a face without area cannot have mass");
  return moments.of_mass(mass);
}

}  // namespace pantin
