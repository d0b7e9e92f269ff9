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
  std::vector<Steps> positions;   // in a cell
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

/// The grid steps of a block, and which of them are positions of the lattice.
class LatticeGrid {
 public:
  LatticeGrid(const LatticeKind& kind, const Steps& cells) : kind_(kind) {
    for (std::size_t i = 0; i < 3; i++) size_[i] = cells[i] * kind.cell[i] + 1;
    if (kind.flat) size_[2] = 1;
    in_cell_.assign(static_cast<std::size_t>(kind.cell[0] * kind.cell[1] * kind.cell[2]), 0);
    for (const Steps& position : kind.positions) in_cell_[index(position, kind.cell)] = 1;
  }

  bool has(const Steps& at) const {
    for (std::size_t i = 0; i < 3; i++)
      if (at[i] < 0 || at[i] >= size_[i]) return false;
    return in_cell_[index({at[0] % kind_.cell[0], at[1] % kind_.cell[1], at[2] % kind_.cell[2]}, kind_.cell)] != 0;
  }
  std::size_t site(const Steps& at) const { return index(at, size_); }
  const Steps& size() const { return size_; }
  /// [edges] from the middle of the block.
  Vec3 position(const Steps& at) const {
    return vec(at[0] - (size_[0] - 1) / 2.0, at[1] - (size_[1] - 1) / 2.0, at[2] - (size_[2] - 1) / 2.0) * kind_.unit;
  }

 private:
  static std::size_t index(const Steps& at, const Steps& size) {
    return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(at[1])) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(at[0]);
  }
  const LatticeKind& kind_;
  Steps size_;
  std::vector<char> in_cell_;
};

Steps checked_cells(const LatticeKind& kind, const LatticeCells& cells) {
  const Steps counts = {cells.x, cells.y, kind.flat ? 1 : cells.z};
  auto estimate = static_cast<double>(kind.positions.size());
  for (std::size_t i = 0; i < 3; i++) {
    require(counts[i] >= 1, "lattice: cells must be 1 or more each way, got ", counts[i], " along ", "xyz"[i]);
    estimate *= counts[i] + (kind.flat && i == 2 ? 0 : 1);
  }
  require(estimate <= static_cast<double>(most_vertices), "lattice: at most ", most_vertices,
          " vertices, this would have about ", estimate);
  return counts;
}

}  // namespace

std::vector<std::string> lattice_kinds() {
  std::vector<std::string> names;
  for (const LatticeKind& kind : all_kinds()) names.push_back(kind.name);
  return names;
}

Structure lattice(std::string_view name, const LatticeCells& cells, double edge) {
  const LatticeKind& kind = kind_of(name);
  require(edge > 0.0 && std::isfinite(edge), "lattice: edge must be > 0 m, got ", edge);
  const LatticeGrid grid(kind, checked_cells(kind, cells));
  const auto [nx, ny, nz] = grid.size();
  Structure s;
  std::vector<std::uint32_t> number(grid.site({nx - 1, ny - 1, nz - 1}) + 1, nobody);
  std::vector<Steps> steps;
  for (int z = 0; z < nz; z++)
    for (int y = 0; y < ny; y++)
      for (int x = 0; x < nx; x++) {
        if (!grid.has({x, y, z})) continue;
        number[grid.site({x, y, z})] = static_cast<std::uint32_t>(s.vertices.size());
        steps.push_back({x, y, z});
        s.vertices.push_back(grid.position({x, y, z}) * edge);
      }
  for (std::uint32_t v = 0; v < steps.size(); v++)
    for (const Steps& step : kind.neighbours) {
      const Steps other = {steps[v][0] + step[0], steps[v][1] + step[1], steps[v][2] + step[2]};
      if (grid.has(other)) s.edges.push_back({v, number[grid.site(other)]});
    }
  s = without_loose_ends(s, kind.least);
  require(!s.vertices.empty(), "lattice: so few cells leave only loose ends; take more");
  if (kind.flat) add_flat_faces(s);
  return s;
}

}  // namespace pantin
