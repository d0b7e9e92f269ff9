#include <algorithm>

#include "base/check.hpp"
#include "shapes/mesh.hpp"

namespace pantin {

namespace {

Vec3 point_of(const HeightField& field, std::uint32_t column, std::uint32_t row) {
  const double x = field.spacing * (column - 0.5 * (field.columns - 1));
  const double z = field.spacing * (row - 0.5 * (field.rows - 1));
  return vec(x, field.heights[std::size_t{row} * field.columns + column], z);
}

std::array<Vec3, 3> corners_of(const HeightField& field, std::uint32_t index) {
  const std::uint32_t cell = index / 2, column = cell % (field.columns - 1), row = cell / (field.columns - 1);
  const Vec3 first = point_of(field, column, row), last = point_of(field, column + 1, row + 1);
  if (index % 2 == 0) return {first, point_of(field, column, row + 1), last};
  return {first, last, point_of(field, column + 1, row)};
}

Vec3 normal_of(const std::array<Vec3, 3>& corner) {
  return direction(cross(corner[1] - corner[0], corner[2] - corner[0]));
}

/// Over the edge from corner i to i + 1, or the triangle itself at the rim.
std::uint32_t neighbour_of(const HeightField& field, std::uint32_t index, std::size_t side) {
  const std::uint32_t across = field.columns - 1, cell = index / 2, column = cell % across, row = cell / across;
  if (index % 2 == 0) {
    if (side == 0) return column > 0 ? index - 1 : index;
    if (side == 1) return row + 2 < field.rows ? index + 2 * across + 1 : index;
    return index + 1;
  }
  if (side == 0) return index - 1;
  if (side == 1) return column + 2 < field.columns ? index + 1 : index;
  return row > 0 ? index - 2 * across - 1 : index;
}

/// The cells from one place to another along an axis, as far as there are any.
struct CellRange {
  std::uint32_t first, last;
  bool none;
};

CellRange cells_between(double low, double high, double spacing, std::uint32_t points) {
  const double middle = 0.5 * (points - 1), last = points - 2.0;
  const double from = std::floor(low / spacing + middle - 1e-9), to = std::floor(high / spacing + middle + 1e-9);
  if (!(from <= last + 1.0) || !(to >= -1.0)) return {0, 0, true};
  return {static_cast<std::uint32_t>(std::clamp(from, 0.0, last)),
          static_cast<std::uint32_t>(std::clamp(to, 0.0, last)), false};
}

bool meets(const std::array<Vec3, 3>& corner, const Bounds& box) {
  for (int i = 0; i < 3; i++) {
    const auto [low, high] = std::minmax({corner[0][i], corner[1][i], corner[2][i]});
    if (low > box.high[i] || high < box.low[i]) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const HeightField> make_height_field(std::uint32_t columns, std::uint32_t rows, double spacing,
                                                     std::vector<double> heights) {
  require(columns >= 2 && rows >= 2, "A height field has ", columns, " x ", rows,
          " heights; it must have 2 x 2 or more.");
  require(std::uint64_t{columns} * rows <= 0x40000000, "A height field has ", columns, " x ", rows,
          " heights; it must have 1073741824 or fewer.");
  require(heights.size() == std::size_t{columns} * rows, "A height field of ", columns, " columns and ", rows,
          " rows has ", heights.size(), " heights; it must have columns x rows.");
  require(spacing >= 1e-12 && spacing <= 1e12, "A height field's spacing is ", spacing,
          " m; it must be 1e-12 m … 1e12 m.");
  for (std::size_t i = 0; i < heights.size(); i++)
    require(std::fabs(heights[i]) <= 1e12, "Height ", i + 1, " of a height field is ", heights[i],
            " m; it must be within 1e12 m.");
  const auto field = std::make_shared<HeightField>();
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  field->columns = columns;
  field->rows = rows;
  field->spacing = spacing;
  field->lowest = *lowest;
  field->highest = *highest;
  field->heights = std::move(heights);
  return field;
}

MeshTriangle triangle_of(const HeightField& field, std::uint32_t index) {
  MeshTriangle triangle{corners_of(field, index), {}, {}, {true, true, true}, index};
  triangle.normal = normal_of(triangle.corner);
  for (std::size_t side = 0; side < 3; side++) {
    triangle.over[side] = triangle.normal;
    const std::uint32_t next = neighbour_of(field, index, side);
    if (next == index) continue;
    const std::array<Vec3, 3> corner = corners_of(field, next);
    triangle.over[side] = normal_of(corner);
    const Vec3 u = triangle.corner[(side + 1) % 3] - triangle.corner[side];
    triangle.convex[side] = dot(cross(triangle.normal, triangle.over[side]), u) > 1e-12 * norm(u);
  }
  return triangle;
}

void triangles_in(const HeightField& field, const Bounds& box, const std::function<void(const MeshTriangle&)>& use) {
  if (box.low[1] > field.highest || box.high[1] < field.lowest) return;
  const CellRange x = cells_between(box.low[0], box.high[0], field.spacing, field.columns);
  const CellRange z = cells_between(box.low[2], box.high[2], field.spacing, field.rows);
  if (x.none || z.none) return;
  for (std::uint32_t row = z.first; row <= z.last; row++)
    for (std::uint32_t column = x.first; column <= x.last; column++)
      for (std::uint32_t half = 0; half < 2; half++) {
        const std::uint32_t index = 2 * (row * (field.columns - 1) + column) + half;
        if (meets(corners_of(field, index), box)) use(triangle_of(field, index));
      }
}

}  // namespace pantin
