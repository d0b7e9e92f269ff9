#include "structures/mesh_file.hpp"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "base/check.hpp"
#include "base/interruptible.hpp"

namespace pantin {
namespace {

/// Calls use(word) for each word of a line after its first.
template <class Use>
void each_word(std::string_view line, const Use& use) {
  constexpr std::string_view blank = " \t\r";
  for (auto at = line.find_first_of(blank); at != line.npos;) {
    at = line.find_first_not_of(blank, at);
    if (at == line.npos) return;
    const auto end = std::min(line.find_first_of(blank, at), line.size());
    use(line.substr(at, end - at));
    at = line.find_first_of(blank, at);
  }
}

template <class Number>
bool read_number(std::string_view word, Number& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

/// Positions of all vertices [m]. Throws Error where a number is none: the library would read it as 0.
std::vector<Vec3> check_numbers(std::string_view text, const std::string& name) {
  std::vector<Vec3> vertices;
  Interruptible loop;
  for (std::size_t number = 1; !text.empty(); number++) {
    const auto end = std::min(text.find('\n'), text.size());
    loop.count_bytes(end);
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.starts_with("v ") || line.starts_with("v\t")) {
      Vec3 v = zero3();
      int count = 0;
      each_word(line, [&](std::string_view word) {
        if (count < 3) {
          double coordinate = 0.0;
          require(read_number(word, coordinate) && std::isfinite(coordinate), name, ":", number,
                  ": a vertex must have three finite numbers [m], got '", word, "'");
          v[count] = coordinate;
        }
        count++;
      });
      require(count >= 3, name, ":", number, ": a vertex must have three finite numbers [m], got ", count);
      vertices.push_back(v);
    } else if (line.starts_with("f ") || line.starts_with("f\t")) {
      each_word(line, [&](std::string_view word) {
        int corner = 0;
        require(read_number(word.substr(0, word.find('/')), corner) && corner != 0, name, ":", number,
                ": a face must have numbers of vertices, got '", word, "'");
      });
    }
  }
  return vertices;
}

}  // namespace

Structure read_mesh_file(const std::string& text_of_file, const std::string& name) {
  const std::vector<Vec3> positions = check_numbers(text_of_file, name);
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  tinyobj::ObjReader reader;
  const bool read = reader.ParseFromString(text_of_file, "", config);
  require(read && reader.GetAttrib().vertices.size() == 3 * positions.size(), name,
          ": is no .obj file that can be read. ", reader.Error().substr(0, reader.Error().find('\n')));
  std::vector<StructureFace> faces;
  std::vector<Vec3> vertices;
  std::map<int, std::uint32_t> used;
  Interruptible loop;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    std::size_t at = 0;
    for (const auto corners : shape.mesh.num_face_vertices) {
      loop.count(corners);
      StructureFace face;
      for (std::size_t i = 0; i < corners; i++) {
        const int v = shape.mesh.indices[at + i].vertex_index;
        require(v >= 0 && static_cast<std::size_t>(v) < positions.size(), name, ": face ", faces.size() + 1,
                " has vertex ", v + 1, ", and there are ", positions.size());
        const auto [entry, is_new] = used.try_emplace(v, static_cast<std::uint32_t>(vertices.size()));
        if (is_new) vertices.push_back(positions[static_cast<std::size_t>(v)]);
        face.push_back(entry->second);
      }
      at += corners;
      faces.push_back(std::move(face));
    }
  }
  require(!faces.empty(), name, ": has no faces");
  try {
    return make_structure(std::move(vertices), {}, std::move(faces));
  } catch (const Error& error) { throw Error(text(name, ": ", error.what())); }
}

std::size_t open_edges(const Structure& s) {
  std::map<StructureEdge, std::pair<int, int>> sides;  // faces along an edge and against it
  for (const StructureFace& face : s.faces)
    for (std::size_t i = 0; i < face.size(); i++) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      auto& [along, against] = sides[edge_between(a, b)];
      (a < b ? along : against)++;
    }
  return static_cast<std::size_t>(
      std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second != std::pair(1, 1); }));
}

}  // namespace pantin
