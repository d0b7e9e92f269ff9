#include "structures/lattice.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "structures/flat.hpp"

namespace pantin {
namespace {

using Steps = std::array<int, 3>;

/// Places on a grid whose steps are `unit` [edges] long; neighbours are those at a distance of one edge.
struct LatticeKind {
  const char* name;
  bool flat;
  int least;  // neighbours: what has fewer is left out
  Vec3 unit;
  Steps cell;                     // grid steps
  std::vector<Steps> places;      // in a cell
  std::vector<Steps> neighbours;  // of each pair of opposite ones that which comes later in the order of making
};

const std::vector<LatticeKind>& all_kinds() {
  const double half = 0.5, side = std::sqrt(0.75), face = std::sqrt(0.5), space = std::sqrt(1.0 / 3.0);
  const std::vector<Steps> triangles = {{2, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
  const std::vector<Steps> diagonals = {{1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {-1, -1, 1}};
  const Vec3 grid = vec(half, side, 1);
  static const std::vector<LatticeKind> kinds = {
      {"cubic", false, 2, vec(1, 1, 1), {1, 1, 1}, {{0, 0, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {"fcc",
       false,
       2,
       vec(face, face, face),
       {2, 2, 2},
       {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}},
       {{1, 1, 0}, {-1, 1, 0}, {1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}}},
      {"bcc", false, 1, vec(space, space, space), {2, 2, 2}, {{0, 0, 0}, {1, 1, 1}}, diagonals},
      {"diamond",
       false,
       2,
       vec(space, space, space),
       {4, 4, 4},
       {{0, 0, 0}, {2, 2, 0}, {2, 0, 2}, {0, 2, 2}, {1, 1, 1}, {3, 3, 1}, {3, 1, 3}, {1, 3, 3}},
       diagonals},
      {"square", true, 2, vec(1, 1, 1), {1, 1, 1}, {{0, 0, 0}}, {{1, 0, 0}, {0, 1, 0}}},
      {"triangular", true, 2, grid, {2, 2, 1}, {{0, 0, 0}, {1, 1, 0}}, triangles},
      {"honeycomb", true, 2, grid, {6, 2, 1}, {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {5, 1, 0}}, triangles},
      {"kagome",
       true,
       2,
       grid,
       {4, 4, 1},
       {{2, 0, 0}, {1, 1, 0}, {3, 1, 0}, {0, 2, 0}, {1, 3, 0}, {3, 3, 0}},
       triangles},
  };
  return kinds;
}

const LatticeKind& kind_of(std::string_view name) {
  std::string known;
  for (const LatticeKind& kind : all_kinds()) {
    if (kind.name == name) return kind;
    known += text(known.empty() ? "" : ", ", kind.name);
  }
  throw Error(text("lattice: unknown kind '", name, "'. Known are ", known));
}

constexpr std::uint32_t nobody = 0xffffffff;

}  // namespace

std::vector<std::string> lattice_kinds() {
  std::vector<std::string> names;
  for (const LatticeKind& kind : all_kinds()) names.push_back(kind.name);
  return names;
}

Structure lattice(std::string_view name, const LatticeCells& cells, double edge) {
  const LatticeKind& kind = kind_of(name);
  require(edge > 0.0 && std::isfinite(edge), "lattice: edge must be > 0 m, got ", edge);
  const int counts[] = {cells.x, cells.y, kind.flat ? 1 : cells.z};
  double estimate = static_cast<double>(kind.places.size());
  for (int i = 0; i < 3; i++) {
    require(counts[i] >= 1, "lattice: cells must be 1 or more each way, got ", counts[i], " along ", "xyz"[i]);
    estimate *= counts[i] + (kind.flat && i == 2 ? 0 : 1);
  }
  require(estimate <= static_cast<double>(most_vertices), "lattice: at most ", most_vertices,
          " vertices, this would have about ", estimate);
  const int nx = counts[0] * kind.cell[0] + 1, ny = counts[1] * kind.cell[1] + 1,
            nz = kind.flat ? 1 : counts[2] * kind.cell[2] + 1;
  std::vector<char> in_cell(static_cast<std::size_t>(kind.cell[0] * kind.cell[1] * kind.cell[2]), 0);
  const auto place_in_cell = [&](int x, int y, int z) -> char& {
    return in_cell[static_cast<std::size_t>((z % kind.cell[2] * kind.cell[1] + y % kind.cell[1]) * kind.cell[0] +
                                            x % kind.cell[0])];
  };
  for (const Steps& p : kind.places) place_in_cell(p[0], p[1], p[2]) = 1;
  const auto site = [&](int x, int y, int z) {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nx) +
           static_cast<std::size_t>(x);
  };

  Structure s;
  std::vector<std::uint32_t> number(site(nx - 1, ny - 1, nz - 1) + 1, nobody);
  std::vector<Steps> steps;
  for (int z = 0; z < nz; z++)
    for (int y = 0; y < ny; y++)
      for (int x = 0; x < nx; x++) {
        if (!place_in_cell(x, y, z)) continue;
        number[site(x, y, z)] = static_cast<std::uint32_t>(s.vertices.size());
        steps.push_back({x, y, z});
        s.vertices.push_back(vec(x - (nx - 1) / 2.0, y - (ny - 1) / 2.0, z - (nz - 1) / 2.0) * kind.unit * edge);
      }
  for (std::uint32_t v = 0; v < steps.size(); v++)
    for (const Steps& step : kind.neighbours) {
      const int x = steps[v][0] + step[0], y = steps[v][1] + step[1], z = steps[v][2] + step[2];
      if (x < 0 || y < 0 || z < 0 || x >= nx || y >= ny || z >= nz) continue;
      if (const std::uint32_t other = number[site(x, y, z)]; other != nobody) s.edges.push_back({v, other});
    }
  s = without_loose_ends(s, kind.least);
  if (kind.flat) add_flat_faces(s);
  return s;
}

}  // namespace pantin
