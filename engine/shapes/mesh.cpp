#include "shapes/mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/interruptible.hpp"
#include "shapes/mesh_tree.hpp"

namespace pantin {

namespace {

using Triangle = TriangleMesh::Triangle;

constexpr std::uint32_t most_in_leaf = 4;

void widen(Bounds& bounds, Vec3 v) {
  bounds.low = v < bounds.low ? v : bounds.low;
  bounds.high = v > bounds.high ? v : bounds.high;
}

Bounds bounds_of_triangle(const TriangleMesh& mesh, std::uint32_t index) {
  Bounds bounds;
  for (const std::uint32_t corner : mesh.triangles[index].corner) widen(bounds, mesh.vertices[corner]);
  return bounds;
}

/// Of each vertex the first at the same place.
std::vector<std::uint32_t> first_at_place(const std::vector<Vec3>& vertices) {
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> first;
  Interruptible loop;
  for (std::uint32_t i = 0; i < vertices.size(); i++) {
    loop.count();
    first.push_back(places.try_emplace({vertices[i][0], vertices[i][1], vertices[i][2]}, i).first->second);
  }
  return first;
}

void set_triangles(TriangleMesh& mesh, std::span<const std::array<std::uint32_t, 3>> faces) {
  for (std::size_t i = 0; i < faces.size(); i++) {
    for (const std::uint32_t corner : faces[i])
      require(corner < mesh.vertices.size(), "Triangle ", i + 1, " of a mesh has the vertex ", corner,
              ", counted from 0; there are ", mesh.vertices.size(), ".");
    const Vec3 a = mesh.vertices[faces[i][0]], u = mesh.vertices[faces[i][1]] - a, v = mesh.vertices[faces[i][2]] - a;
    const Vec3 n = cross(u, v);
    const double longest = std::max({norm2(u), norm2(v), norm2(v - u)});
    if (norm2(n) > 1e-28 * longest * longest)
      mesh.triangles.push_back({faces[i], direction(n), {-1, -1, -1}, {true, true, true}});
  }
  require(!mesh.triangles.empty(), "A mesh has no triangles with an area; its ", faces.size(),
          " triangles may have corners in a line.");
}

/// An edge from one corner to another is shared with the one triangle that has it the other way round.
void set_neighbours(TriangleMesh& mesh) {
  const std::vector<std::uint32_t> place = first_at_place(mesh.vertices);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::int32_t>> edges;
  const auto edge = [&](const Triangle& triangle, std::size_t side) {
    return std::pair{place[triangle.corner[side]], place[triangle.corner[(side + 1) % 3]]};
  };
  Interruptible loop;
  for (std::size_t i = 0; i < mesh.triangles.size(); loop.count(), i++)
    for (std::size_t side = 0; side < 3; side++)
      edges[edge(mesh.triangles[i], side)].push_back(static_cast<std::int32_t>(i));
  for (Triangle& triangle : mesh.triangles) {
    loop.count();
    for (std::size_t side = 0; side < 3; side++) {
      const auto [from, to] = edge(triangle, side);
      const auto other = edges.find({to, from});
      if (other == edges.end() || other->second.size() != 1 || edges[{from, to}].size() != 1) continue;
      triangle.neighbour[side] = other->second.front();
      const Triangle& next = mesh.triangles[static_cast<std::size_t>(other->second.front())];
      Vec3 apex = mesh.vertices[triangle.corner[side]];
      for (const std::uint32_t corner : next.corner)
        if (place[corner] != from && place[corner] != to) apex = mesh.vertices[corner];
      const Vec3 away = apex - mesh.vertices[triangle.corner[side]];
      triangle.convex[side] = dot(triangle.normal, away) < -1e-12 * norm(away);
    }
  }
}

/// Halves the triangles at the middle of their centres along the longest extent, until few are left.
void split(TriangleMesh& mesh, const std::vector<Bounds>& bounds, std::uint32_t branch, std::uint32_t first,
           std::uint32_t count, Interruptible& loop) {
  loop.count(count);
  Bounds all, centres;
  const auto centre = [&](std::uint32_t i) { return (bounds[i].low + bounds[i].high) * 0.5; };
  for (std::uint32_t i = first; i < first + count; i++) {
    widen(all, bounds[mesh.order[i]].low);
    widen(all, bounds[mesh.order[i]].high);
    widen(centres, centre(mesh.order[i]));
  }
  mesh.tree[branch] = {all, first, count};
  if (count <= most_in_leaf) return;
  const Vec3 extent = centres.high - centres.low;
  const int axis = extent[0] >= extent[1] && extent[0] >= extent[2] ? 0 : extent[1] >= extent[2] ? 1 : 2;
  const auto begin = mesh.order.begin() + first;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t i, std::uint32_t j) {
    return std::pair{centre(i)[axis], i} < std::pair{centre(j)[axis], j};
  });
  const std::uint32_t low = static_cast<std::uint32_t>(mesh.tree.size());
  mesh.tree[branch].first = low;
  mesh.tree[branch].count = 0;
  mesh.tree.resize(mesh.tree.size() + 2);
  split(mesh, bounds, low, first, half, loop);
  split(mesh, bounds, low + 1, first + half, count - half, loop);
}

void set_tree(TriangleMesh& mesh) {
  std::vector<Bounds> bounds;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); i++) {
    bounds.push_back(bounds_of_triangle(mesh, i));
    mesh.order.push_back(i);
  }
  mesh.tree.resize(1);
  Interruptible loop;
  split(mesh, bounds, 0, 0, static_cast<std::uint32_t>(mesh.triangles.size()), loop);
  mesh.bounds = mesh.tree[0].bounds;
}

/// A list that is kept for the next use by the same thread.
class Found {
 public:
  Found() { list.swap(spare()), list.clear(); }
  Found(const Found&) = delete;
  Found& operator=(const Found&) = delete;
  ~Found() { list.swap(spare()); }
  std::vector<std::uint32_t> list;

 private:
  static std::vector<std::uint32_t>& spare() {
    thread_local std::vector<std::uint32_t> kept;
    return kept;
  }
};

}  // namespace

std::shared_ptr<const TriangleMesh> make_mesh(std::vector<Vec3> vertices,
                                              std::span<const std::array<std::uint32_t, 3>> faces) {
  for (std::size_t i = 0; i < vertices.size(); i++)
    require(finite(vertices[i]) && largest(vertices[i]) <= 1e12, "Vertex ", i + 1, " of a mesh is (", vertices[i][0],
            ", ", vertices[i][1], ", ", vertices[i][2], ") m; its vertices must be within 1e12 m of the origin.");
  require(faces.size() <= 0x7fffffff, "A mesh has ", faces.size(), " triangles; it must have fewer than 2147483648.");
  const auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices = std::move(vertices);
  set_triangles(*mesh, faces);
  set_neighbours(*mesh);
  set_tree(*mesh);
  return mesh;
}

MeshTriangle triangle_of(const TriangleMesh& mesh, std::uint32_t index) {
  const Triangle& triangle = mesh.triangles[index];
  MeshTriangle result{{}, triangle.normal, {}, triangle.convex, index};
  for (std::size_t i = 0; i < 3; i++) {
    const std::int32_t next = triangle.neighbour[i];
    result.corner[i] = mesh.vertices[triangle.corner[i]];
    result.over[i] = next < 0 ? triangle.normal : mesh.triangles[static_cast<std::size_t>(next)].normal;
  }
  return result;
}

void triangles_in(const TriangleMesh& mesh, const Bounds& box, const std::function<void(const MeshTriangle&)>& use) {
  Found found;
  walk_tree(
      mesh, [&](const Bounds& bounds) { return overlap(bounds, box); },
      [&](std::uint32_t index) {
        if (overlap(bounds_of_triangle(mesh, index), box)) found.list.push_back(index);
      });
  std::sort(found.list.begin(), found.list.end());
  for (const std::uint32_t index : found.list) use(triangle_of(mesh, index));
}

}  // namespace pantin
