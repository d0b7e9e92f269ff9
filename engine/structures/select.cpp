#include <algorithm>
#include <set>

#include "structures/structure.hpp"

namespace pantin {
namespace {

/// Some parts of a structure.
struct Chosen {
  const Structure& s;
  std::vector<char> vertices;  // (vertices)
  std::set<StructureEdge> edges;
  std::vector<std::uint32_t> faces;

  void add_edge(std::uint32_t a, std::uint32_t b) {
    vertices[a] = vertices[b] = 1;
    edges.insert(edge_between(a, b));
  }
  void add_face(std::uint32_t f) {
    const StructureFace& face = s.faces[f];
    for (std::size_t k = 0; k < face.size(); k++) add_edge(face[k], face[(k + 1) % face.size()]);
    faces.push_back(f);
  }
  bool has_edges_of(std::uint32_t f) const {
    const StructureFace& face = s.faces[f];
    for (std::size_t k = 0; k < face.size(); k++)
      if (!edges.contains(edge_between(face[k], face[(k + 1) % face.size()]))) return false;
    return true;
  }

  Structure structure() const {
    Structure out;
    std::vector<std::uint32_t> now(s.vertices.size());
    for (std::size_t v = 0; v < s.vertices.size(); v++) {
      if (!vertices[v]) continue;
      now[v] = static_cast<std::uint32_t>(out.vertices.size());
      out.vertices.push_back(s.vertices[v]);
      if (!s.elements.empty()) out.elements.push_back(s.elements[v]);
    }
    for (const StructureEdge& e : s.edges)
      if (edges.contains(e)) out.edges.push_back({now[e[0]], now[e[1]]});
    for (std::uint32_t f : faces) {
      out.faces.push_back(s.faces[f]);
      for (std::uint32_t& v : out.faces.back()) v = now[v];
    }
    return out;
  }
};

}  // namespace

Selection selected(const Structure& s, Part part, const std::function<bool(std::uint32_t)>& keep) {
  Selection selection;
  const std::size_t count = part == Part::vertices ? s.vertices.size()
                            : part == Part::edges  ? s.edges.size()
                                                   : s.faces.size();
  for (std::uint32_t i = 0; i < count; i++)
    if (keep(i)) selection.parts.push_back(i);
  Chosen chosen{s, std::vector<char>(s.vertices.size(), 0), {}, {}};
  for (std::uint32_t i : selection.parts) {
    if (part == Part::vertices) chosen.vertices[i] = 1;
    if (part == Part::edges) chosen.add_edge(s.edges[i][0], s.edges[i][1]);
    if (part == Part::faces) chosen.add_face(i);
  }
  if (part == Part::vertices)
    for (const StructureEdge& e : s.edges)
      if (chosen.vertices[e[0]] && chosen.vertices[e[1]]) chosen.edges.insert(e);
  if (part != Part::faces)
    for (std::uint32_t f = 0; f < s.faces.size(); f++)
      if (chosen.has_edges_of(f)) chosen.faces.push_back(f);
  selection.structure = chosen.structure();
  return selection;
}

Structure without_loose_ends(const Structure& s, int least) {
  Structure whole = s;
  for (;;) {
    std::vector<int> degree(whole.vertices.size(), 0);
    for (const StructureEdge& e : whole.edges) {
      degree[e[0]]++;
      degree[e[1]]++;
    }
    if (std::all_of(degree.begin(), degree.end(), [&](int d) { return d >= least; })) return whole;
    whole = selected(whole, Part::vertices, [&](std::uint32_t v) { return degree[v] >= least; }).structure;
  }
}

}  // namespace pantin
