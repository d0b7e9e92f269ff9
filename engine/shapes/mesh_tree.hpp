#pragma once
#include <array>

#include "shapes/mesh.hpp"

namespace pantin {

/// Calls use(index) for the triangles of all leaves whose bounds, and those above them, pass a test.
template <class Test, class Use>
void walk_tree(const TriangleMesh& mesh, Test test, Use use) {
  std::array<std::uint32_t, 64> open;
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const TriangleMesh::Branch& branch = mesh.tree[open[--count]];
    if (!test(branch.bounds)) continue;
    if (branch.count > 0) {
      for (std::uint32_t i = 0; i < branch.count; i++) use(mesh.order[branch.first + i]);
      continue;
    }
    open[count++] = branch.first + 1;
    open[count++] = branch.first;
  }
}

}  // namespace pantin
