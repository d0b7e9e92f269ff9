#include "structures/structure.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/check.hpp"
#include "base/functions.hpp"
#include "base/interruptible.hpp"
#include "base/near_positions.hpp"

namespace pantin {
namespace {

void check_face(const StructureFace& face, std::size_t number, std::size_t vertices) {
  require(face.size() >= 3, "structure: face ", number, " has ", face.size(), " vertices; it needs three or more");
  StructureFace sorted = face;
  std::sort(sorted.begin(), sorted.end());
  require(sorted.back() < vertices, "structure: face ", number, " has a vertex ", sorted.back() + 1, ", but there are ",
          vertices);
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  require(twice == sorted.end(), "structure: face ", number, " has vertex ", twice == sorted.end() ? 0 : *twice + 1,
          " twice");
}

/// The same structure with vertices in other positions.
template <class Map>
Structure with_positions(Structure s, const Map& map) {
  for (Vec3& v : s.vertices) v = map(v);
  return s;
}

void turn_inside_out(Structure& s) {
  for (StructureFace& face : s.faces) std::reverse(face.begin() + 1, face.end());
}

/// Numbers of edges by their ends.
std::map<StructureEdge, std::uint32_t> numbers_of_edges(const Structure& s) {
  std::map<StructureEdge, std::uint32_t> numbers;
  Interruptible loop;
  for (std::uint32_t e = 0; e < s.edges.size(); e++) {
    loop.count();
    numbers.emplace(s.edges[e], e);
  }
  return numbers;
}

/// The face to the left of each directed edge; nothing where two faces go along one in the same sense.
std::optional<std::map<StructureEdge, std::uint32_t>> faces_to_the_left(const Structure& s) {
  std::map<StructureEdge, std::uint32_t> left;
  Interruptible loop;
  for (std::uint32_t f = 0; f < s.faces.size(); loop.count(s.faces[f].size()), f++)
    for (std::size_t i = 0; i < s.faces[f].size(); i++)
      if (!left.emplace(StructureEdge{s.faces[f][i], s.faces[f][(i + 1) % s.faces[f].size()]}, f).second) return {};
  return left;
}

std::map<StructureEdge, std::uint32_t> require_left(const Structure& s, const char* call) {
  auto left = faces_to_the_left(s);
  require(left.has_value(), call,
          ": faces must go round in one sense, so that two meet along an edge in opposite ones");
  return std::move(*left);
}

/// The vertex before or behind one in a face.
std::uint32_t neighbour_in(const StructureFace& face, std::uint32_t vertex, std::size_t step) {
  const auto at = static_cast<std::size_t>(std::find(face.begin(), face.end(), vertex) - face.begin());
  return face[(at + step) % face.size()];
}

/// Directed edges from a vertex, counter-clockwise; empty unless faces go all round it.
std::vector<StructureEdge> fan(const Structure& s, const std::map<StructureEdge, std::uint32_t>& left,
                               std::uint32_t vertex, std::uint32_t first) {
  std::vector<StructureEdge> around;
  for (std::uint32_t to = first;;) {
    const auto face = left.find({vertex, to});
    if (face == left.end()) return {};
    around.push_back({vertex, to});
    const StructureFace& corners = s.faces[face->second];
    to = neighbour_in(corners, vertex, corners.size() - 1);
    if (to == first) return around;
  }
}

/// An edge of each vertex that has one, by the vertex.
std::vector<std::optional<std::uint32_t>> any_neighbours(const Structure& s) {
  std::vector<std::optional<std::uint32_t>> any(s.vertices.size());
  for (const StructureFace& face : s.faces)
    for (std::size_t i = 0; i < face.size(); i++)
      if (!any[face[i]]) any[face[i]] = face[(i + 1) % face.size()];
  return any;
}

}  // namespace

Structure make_structure(std::vector<Vec3> vertices, const std::vector<StructureEdge>& edges,
                         std::vector<StructureFace> faces) {
  require(vertices.size() <= most_vertices, "structure: at most ", most_vertices, " vertices, got ", vertices.size());
  Structure s;
  for (std::size_t i = 0; i < vertices.size(); i++)
    require(finite(vertices[i]), "structure: vertex ", i + 1, " must be finite, got (", vertices[i][0], ", ",
            vertices[i][1], ", ", vertices[i][2], ") m");
  std::set<StructureEdge> known;
  Interruptible loop;
  for (std::size_t i = 0; i < edges.size(); i++) {
    loop.count();
    const StructureEdge edge = edge_between(edges[i][0], edges[i][1]);
    require(edge[1] < vertices.size(), "structure: edge ", i + 1, " has a vertex ", edge[1] + 1, ", but there are ",
            vertices.size());
    require(edge[0] != edge[1], "structure: edge ", i + 1, " goes from vertex ", edge[0] + 1, " to itself");
    require(known.insert(edge).second, "structure: edge ", i + 1, ", between vertices ", edge[0] + 1, " and ",
            edge[1] + 1, ", is there already");
    s.edges.push_back(edge);
  }
  for (std::size_t i = 0; i < faces.size(); i++) {
    check_face(faces[i], i + 1, vertices.size());
    loop.count(faces[i].size());
    for (std::size_t k = 0; k < faces[i].size(); k++) {
      const StructureEdge edge = edge_between(faces[i][k], faces[i][(k + 1) % faces[i].size()]);
      if (known.insert(edge).second) s.edges.push_back(edge);
    }
  }
  s.vertices = std::move(vertices);
  s.faces = std::move(faces);
  return s;
}

Structure scaled(Structure s, Vec3 factors) {
  require(finite(factors) && factors[0] != 0.0 && factors[1] != 0.0 && factors[2] != 0.0,
          "scale: the factors must be finite and not 0, got (", factors[0], ", ", factors[1], ", ", factors[2], ")");
  if (factors[0] * factors[1] * factors[2] < 0.0) turn_inside_out(s);
  return with_positions(std::move(s), [&](Vec3 v) { return v * factors; });
}

Structure rotated(Structure s, const Quat& turn) {
  return with_positions(std::move(s), [&](Vec3 v) { return rotate(turn, v); });
}

Structure moved(Structure s, Vec3 by) {
  require(finite(by), "move: the displacement must be finite [m]");
  return with_positions(std::move(s), [&](Vec3 v) { return v + by; });
}

Structure mirrored(const Structure& s, Vec3 normal, Vec3 through) {
  require(finite(normal) && norm(normal) > 0.0 && finite(through), "mirror: the normal must be finite and not 0");
  const Vec3 n = normal / norm(normal);
  Structure image = with_positions(s, [&](Vec3 v) { return v - n * (2.0 * dot(v - through, n)); });
  turn_inside_out(image);
  return image;
}

Structure joined(const Structure& a, const Structure& b, double tolerance) {
  require(tolerance >= 0.0 && std::isfinite(tolerance), "join: tolerance must be >= 0 m, got ", tolerance);
  const NearPositions positions(a.vertices, tolerance);
  Structure s = a;
  std::vector<std::uint32_t> now(b.vertices.size());
  const bool molecule = !a.elements.empty() && !b.elements.empty();
  if (!molecule) s.elements.clear();
  for (std::uint32_t i = 0; i < b.vertices.size(); i++) {
    const auto known = positions.lowest(b.vertices[i]);
    now[i] = known.value_or(static_cast<std::uint32_t>(s.vertices.size()));
    if (known) continue;
    s.vertices.push_back(b.vertices[i]);
    if (molecule) s.elements.push_back(b.elements[i]);
  }
  std::set<StructureEdge> edges(a.edges.begin(), a.edges.end());
  Interruptible loop;
  for (const StructureEdge& e : b.edges) {
    loop.count();
    const StructureEdge edge = edge_between(now[e[0]], now[e[1]]);
    if (edge[0] != edge[1] && edges.insert(edge).second) s.edges.push_back(edge);
  }
  std::set<StructureFace> faces;
  const auto is_new = [&](StructureFace face) {
    loop.count(face.size());
    std::sort(face.begin(), face.end());
    return std::adjacent_find(face.begin(), face.end()) == face.end() && faces.insert(face).second;
  };
  for (const StructureFace& face : a.faces) is_new(face);
  for (StructureFace face : b.faces) {
    for (std::uint32_t& v : face) v = now[v];
    if (is_new(face)) s.faces.push_back(face);
  }
  return s;
}

Structure subdivided(const Structure& s) {
  Structure fine;
  fine.vertices = s.vertices;
  const auto edges = numbers_of_edges(s);
  const auto first = static_cast<std::uint32_t>(s.vertices.size());
  const auto halfway = [&](std::uint32_t a, std::uint32_t b) { return first + edges.at(edge_between(a, b)); };
  Interruptible loop;
  for (std::uint32_t e = 0; e < s.edges.size(); e++) {
    loop.count();
    const auto [a, b] = s.edges[e];
    fine.vertices.push_back((s.vertices[a] + s.vertices[b]) / 2.0);
    fine.edges.push_back({a, first + e});
    fine.edges.push_back({b, first + e});
  }
  for (const StructureFace& face : s.faces) {
    const std::size_t n = face.size();
    loop.count(n);
    StructureFace inner;
    for (std::size_t i = 0; i < n; i++) inner.push_back(halfway(face[i], face[(i + 1) % n]));
    const auto centre = static_cast<std::uint32_t>(fine.vertices.size());
    if (n > 3) fine.vertices.push_back(middle(s, face));
    for (std::size_t i = 0; i < n; i++) {
      const std::uint32_t before = inner[(i + n - 1) % n];
      if (n > 3)
        fine.faces.push_back({face[i], inner[i], centre, before});
      else
        fine.faces.push_back({face[i], inner[i], before});
      fine.edges.push_back(n > 3 ? edge_between(inner[i], centre) : edge_between(before, inner[i]));
    }
    if (n == 3) fine.faces.push_back(inner);
  }
  require(fine.vertices.size() <= most_vertices, "subdivide: at most ", most_vertices, " vertices, this would have ",
          fine.vertices.size());
  return fine;
}

Structure dual(const Structure& s) {
  require(!s.faces.empty(), "dual: the structure has no faces");
  const auto left = require_left(s, "dual");
  std::vector<Vec3> vertices;
  for (const StructureFace& face : s.faces) vertices.push_back(middle(s, face));
  std::vector<StructureEdge> edges;
  for (const StructureEdge& e : s.edges) {
    const auto a = left.find(e), b = left.find({e[1], e[0]});
    if (a != left.end() && b != left.end() && a->second != b->second)
      edges.push_back(edge_between(a->second, b->second));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<StructureFace> faces;
  const auto any = any_neighbours(s);
  for (std::uint32_t v = 0; v < s.vertices.size(); v++) {
    StructureFace face;
    if (any[v])
      for (const StructureEdge& spoke : fan(s, left, v, *any[v])) face.push_back(left.at(spoke));
    if (face.size() >= 3) faces.push_back(face);
  }
  return make_structure(std::move(vertices), edges, std::move(faces));
}

Structure truncated(const Structure& s, double fraction) {
  require(fraction > 0.0 && fraction < 0.5, "truncate: the fraction must be > 0 and < 1/2, got ", fraction);
  require(is_closed(s), "truncate: the structure must be a closed surface");
  const auto left = require_left(s, "truncate");
  std::map<StructureEdge, std::uint32_t> cut;
  std::vector<Vec3> vertices;
  const auto any = any_neighbours(s);
  std::vector<StructureFace> faces;
  for (std::uint32_t v = 0; v < s.vertices.size(); v++) {
    if (!any[v]) continue;
    StructureFace face;
    for (const StructureEdge& spoke : fan(s, left, v, *any[v])) {
      face.push_back(static_cast<std::uint32_t>(vertices.size()));
      cut.emplace(spoke, face.back());
      vertices.push_back(s.vertices[v] + (s.vertices[spoke[1]] - s.vertices[v]) * fraction);
    }
    faces.push_back(face);
  }
  for (const StructureFace& old : s.faces) {
    StructureFace face;
    for (std::size_t i = 0; i < old.size(); i++) {
      const std::uint32_t a = old[i], b = old[(i + 1) % old.size()];
      face.push_back(cut.at({a, b}));
      face.push_back(cut.at({b, a}));
    }
    faces.push_back(face);
  }
  return make_structure(std::move(vertices), {}, std::move(faces));
}

std::int64_t euler_characteristic(const Structure& s) {
  return static_cast<std::int64_t>(s.vertices.size()) - static_cast<std::int64_t>(s.edges.size()) +
         static_cast<std::int64_t>(s.faces.size());
}

bool is_closed(const Structure& s) {
  const auto left = faces_to_the_left(s);
  if (!left || s.faces.empty() || left->size() != 2 * s.edges.size()) return false;
  return std::all_of(s.edges.begin(), s.edges.end(), [&](const StructureEdge& e) {
    return left->contains(e) && left->contains({e[1], e[0]});
  });
}

Vec3 middle(const Structure& s, const StructureFace& face) {
  Vec3 sum = zero3();
  for (std::uint32_t v : face) sum += s.vertices[v];
  return sum / static_cast<double>(face.size());
}

std::vector<StructureFace> traced_faces(const Structure& s, const std::function<Vec3(std::uint32_t)>& normal) {
  std::vector<std::vector<std::pair<double, std::uint32_t>>> around(s.vertices.size());  // (angle, to)
  std::map<StructureEdge, std::size_t> position;                                         // of an end in it
  for (const StructureEdge& e : s.edges)
    for (std::size_t side : {0u, 1u}) around[e[side]].push_back({0.0, e[1 - side]});
  for (std::uint32_t v = 0; v < around.size(); v++) {
    if (around[v].empty()) continue;
    const Vec3 n = normal(v), to_first = s.vertices[around[v][0].second] - s.vertices[v];
    const Vec3 x = to_first - n * (dot(to_first, n) / norm2(n)), y = cross(n, x) / norm(n);
    for (auto& [angle, to] : around[v]) {
      const Vec3 d = s.vertices[to] - s.vertices[v];
      angle = functions::atan2(dot(d, y), dot(d, x));
    }
    std::sort(around[v].begin(), around[v].end());
    for (std::size_t i = 0; i < around[v].size(); i++) position[{v, around[v][i].second}] = i;
  }
  std::set<StructureEdge> done;
  std::vector<StructureFace> faces;
  const auto trace = [&](std::uint32_t from, std::uint32_t to) {
    StructureFace face;
    while (done.insert({from, to}).second) {
      face.push_back(from);
      const auto& spokes = around[to];
      const std::uint32_t next = spokes[(position.at({to, from}) + spokes.size() - 1) % spokes.size()].second;
      from = to;
      to = next;
    }
    if (!face.empty()) faces.push_back(face);
  };
  for (const StructureEdge& e : s.edges) {
    trace(e[0], e[1]);
    trace(e[1], e[0]);
  }
  return faces;
}

}  // namespace pantin
