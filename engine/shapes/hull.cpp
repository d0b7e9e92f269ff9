#include "shapes/hull.hpp"

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/interruptible.hpp"

namespace pantin {

namespace {

constexpr std::size_t most_points = 100000, most_corners = 10000;  // its faces and corners are compared, each with each

using Loop = std::vector<std::uint32_t>;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// qhull's state, freed at the end. Its messages go nowhere; one after every 20 facets asks whether anybody waits.
class Qhull {
 public:
  explicit Qhull(std::vector<double>& coordinates)
      : silent_(fopencookie(this, "w", {nullptr, listen, nullptr, nullptr})) {
    std::setvbuf(silent_.get(), nullptr, _IONBF, 0);
    qh_zero(&state_, silent_.get());
    char command[] = "qhull TF20";
    failed_ = qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False, command,
                           silent_.get(), silent_.get()) != 0;
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int blocks = 0, bytes = 0;
    qh_memfreeshort(&state_, &blocks, &bytes);
  }
  bool failed() const { return failed_; }

  /// Corners of each facet in order, by index of points.
  std::vector<Loop> loops() {
    std::vector<Loop> loops;
    qhT* qh = &state_;
    facetT* facet;
    FORALLfacets {
      setT* corners = qh_facet3vertex(qh, facet);
      Loop loop;
      vertexT *vertex, **vertexp;
      FOREACHvertex_(corners) loop.push_back(static_cast<std::uint32_t>(qh_pointid(qh, vertex->point)));
      qh_settempfree(qh, &corners);
      loops.push_back(std::move(loop));
    }
    return loops;
  }

 private:
  static ssize_t listen(void* self, const char*, std::size_t size) {
    if (is_given_up()) static_cast<Qhull*>(self)->state_.STOPadd = 1;
    return static_cast<ssize_t>(size);
  }

  std::unique_ptr<std::FILE, CloseFile> silent_;
  qhT state_;
  bool failed_ = false;
};

/// Newell's: exact for triangles, the mean of all corners for more.
Vec3 area_of(const Hull& hull, const Loop& loop) {
  Vec3 area = zero3();
  const Vec3 origin = hull.vertices[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); i++)
    area += cross(hull.vertices[loop[i]] - origin, hull.vertices[loop[i + 1]] - origin);
  return area * 0.5;
}

/// Keeps the points that are corners, in their order.
void set_corners(Hull& hull, std::span<const Vec3> points, std::vector<Loop>& loops) {
  std::vector<std::uint32_t> index(points.size(), 0);
  for (const Loop& loop : loops)
    for (const std::uint32_t i : loop) index[i] = 1;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < points.size(); i++) {
    if (index[i] == 0) continue;
    hull.vertices.push_back(points[i]);
    index[i] = count++;
  }
  for (Loop& loop : loops)
    for (std::uint32_t& i : loop) i = index[i];
}

/// Begins each loop at its lowest corner and orders loops, so that qhull's order does not matter.
void set_faces(Hull& hull, std::vector<Loop>& loops) {
  Vec3 middle = zero3();
  for (const Vec3 v : hull.vertices) middle += v / static_cast<double>(hull.vertices.size());
  for (Loop& loop : loops)
    if (dot(area_of(hull, loop), hull.vertices[loop[0]] - middle) < 0.0) std::reverse(loop.begin(), loop.end());
  for (Loop& loop : loops) std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  std::sort(loops.begin(), loops.end());
  for (const Loop& loop : loops) {
    const Vec3 normal = direction(area_of(hull, loop));
    double offset = -infinity;
    for (const std::uint32_t i : loop) offset = std::max(offset, dot(normal, hull.vertices[i]));
    hull.faces.push_back(
        {normal, offset, static_cast<std::uint32_t>(hull.loops.size()), static_cast<std::uint32_t>(loop.size())});
    hull.loops.insert(hull.loops.end(), loop.begin(), loop.end());
  }
}

/// False where an edge has not two faces.
bool set_edges(Hull& hull) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges;
  for (std::uint32_t f = 0; f < hull.faces.size(); f++) {
    const Hull::Face& face = hull.faces[f];
    for (std::uint32_t i = 0; i < face.count; i++) {
      const std::uint32_t from = hull.loops[face.first + i], to = hull.loops[face.first + (i + 1) % face.count];
      edges[std::minmax(from, to)].push_back(f);
    }
  }
  for (const auto& [ends, faces] : edges) {
    if (faces.size() != 2) return false;
    hull.edges.push_back({ends.first, ends.second});
    hull.edge_faces.push_back({faces[0], faces[1]});
  }
  return true;
}

void set_packs(Hull& hull) {
  hull.packs.clear();
  for (std::size_t first = 0; first < hull.vertices.size(); first += 4) {
    Vec3 x{}, y{}, z{};
    for (std::size_t i = 0; i < 4; i++) {
      const Vec3 v = hull.vertices[std::min(first + i, hull.vertices.size() - 1)];
      x[i] = v[0], y[i] = v[1], z[i] = v[2];
    }
    hull.packs.insert(hull.packs.end(), {x, y, z});
  }
}

void set_extents(Hull& hull) {
  for (const Vec3 v : hull.vertices) hull.reach = std::max(hull.reach, norm(v));
  hull.thickness = infinity;
  for (const Hull::Face& face : hull.faces) {
    const Vec3 opposite = hull.vertices[farthest(hull, -face.normal)];
    hull.thickness = std::min(hull.thickness, face.offset - dot(face.normal, opposite));
  }
}

double room_at(const Hull& hull, Vec3 x, Vec3& nearest) {
  double room = infinity;
  for (const Hull::Face& face : hull.faces) {
    const double here = face.offset - dot(face.normal, x);
    if (here >= room) continue;
    room = here;
    nearest = face.normal;
  }
  return room;
}

/// From the mean of the corners away from whichever face is nearest, by ever less.
void set_inner_ball(Hull& hull) {
  constexpr int steps = 64;
  Vec3 x = zero3(), nearest = zero3();
  for (const Vec3 v : hull.vertices) x += v;
  x *= 1.0 / static_cast<double>(hull.vertices.size());
  hull.inner_radius = 0.0;
  for (int k = 0; k < steps; k++) {
    const double room = room_at(hull, x, nearest);
    if (room > hull.inner_radius || k == 0) {
      hull.inner_radius = std::max(0.0, room);
      hull.inner_centre = x;
    }
    x -= nearest * (0.5 * hull.thickness / (k + 2.0));
  }
}

double volume_of(const Hull& hull) {
  double sum = 0.0;
  for (const Hull::Face& face : hull.faces) {
    const Vec3 a = hull.vertices[hull.loops[face.first]] - hull.vertices[0];
    for (std::uint32_t i = 1; i + 1 < face.count; i++)
      sum += dot(a, cross(hull.vertices[hull.loops[face.first + i]] - hull.vertices[0],
                          hull.vertices[hull.loops[face.first + i + 1]] - hull.vertices[0]));
  }
  return sum / 6.0;
}

/// The largest edge of their bounds [m].
double check_points(std::span<const Vec3> points) {
  require(points.size() >= 4 && points.size() <= most_points, "A hull has ", points.size(),
          " points; it must have 4 or more, and no more than ", most_points, ".");
  Vec3 low = points[0], high = points[0];
  for (std::size_t i = 0; i < points.size(); i++) {
    require(finite(points[i]) && largest(points[i]) <= 1e12, "Point ", i + 1, " of a hull is (", points[i][0], ", ",
            points[i][1], ", ", points[i][2], ") m; its points must be within 1e12 m of the origin.");
    low = points[i] < low ? points[i] : low;
    high = points[i] > high ? points[i] : high;
  }
  const double extent = largest(high - low);
  require(extent >= 1e-12, "A hull's points are within ", extent, " m of each other; it must be 1e-12 m or more.");
  return extent;
}

}  // namespace

std::uint32_t farthest(const Hull& hull, Vec3 d) {
  Vec3 best{-infinity, -infinity, -infinity, -infinity}, best_pack{};
  const std::size_t packs = hull.packs.size() / 3;
  const Vec3 dx{d[0], d[0], d[0], d[0]}, dy{d[1], d[1], d[1], d[1]}, dz{d[2], d[2], d[2], d[2]};
  Vec3 pack{};
  for (std::size_t i = 0; i < packs; i++) {
    const Vec3* xyz = &hull.packs[3 * i];
    const Vec3 along = dx * xyz[0] + dy * xyz[1] + dz * xyz[2];
    const auto more = along > best;
    best = more ? along : best;
    best_pack = more ? pack : best_pack;
    pack += 1.0;
  }
  const Vec3 index = best_pack * 4.0 + Vec3{0.0, 1.0, 2.0, 3.0};
  int lane = 0;
  for (int i = 1; i < 4; i++)
    if (best[i] > best[lane] || (best[i] == best[lane] && index[i] < index[lane])) lane = i;
  return std::min(static_cast<std::uint32_t>(index[lane]), static_cast<std::uint32_t>(hull.vertices.size() - 1));
}

std::shared_ptr<const Hull> make_hull(std::span<const Vec3> points) {
  const double extent = check_points(points);
  std::vector<double> coordinates;
  for (const Vec3 p : points) coordinates.insert(coordinates.end(), {p[0], p[1], p[2]});
  Qhull qhull(coordinates);
  stop_if_given_up();
  const auto flat =
      "A hull's points lie in a plane as good as: their volume must be 1e-12 of the cube of their extent, ";
  require(!qhull.failed(), flat, extent, " m, or more.");
  std::vector<Loop> loops = qhull.loops();
  const auto hull = std::make_shared<Hull>();
  set_corners(*hull, points, loops);
  require(hull->vertices.size() <= most_corners, "A hull has ", hull->vertices.size(),
          " corners; it must have no more than ", most_corners, ".");
  set_faces(*hull, loops);
  const bool closed = set_edges(*hull);
  require(closed && volume_of(*hull) >= 1e-12 * extent * extent * extent, flat, extent, " m, or more.");
  set_packs(*hull);
  set_extents(*hull);
  set_inner_ball(*hull);
  return hull;
}

std::shared_ptr<const Hull> moved(const Hull& hull, Vec3 by) {
  const auto copy = std::make_shared<Hull>(hull);
  for (Vec3& v : copy->vertices) v += by;
  for (Hull::Face& face : copy->faces) {
    face.offset = -infinity;
    for (std::uint32_t i = 0; i < face.count; i++)
      face.offset = std::max(face.offset, dot(face.normal, copy->vertices[copy->loops[face.first + i]]));
  }
  copy->reach = 0.0;
  set_packs(*copy);
  set_extents(*copy);
  copy->inner_centre += by;
  return copy;
}

void set_triangle(Hull& hull, const std::array<Vec3, 3>& corner, Vec3 normal) {
  hull.vertices.assign(corner.begin(), corner.end());
  const double offset = dot(normal, corner[0]);
  hull.faces.assign({{normal, offset, 0, 3}, {-normal, -offset, 3, 3}});
  hull.loops.assign({0, 1, 2, 0, 2, 1});
  hull.edges.assign({{0, 1}, {1, 2}, {0, 2}});
  hull.edge_faces.assign(3, {0, 1});
  hull.reach = std::max({norm(corner[0]), norm(corner[1]), norm(corner[2])});
  hull.thickness = hull.inner_radius = 0.0;
  set_packs(hull);
}

}  // namespace pantin
