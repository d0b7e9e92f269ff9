// Molecules and meshes in the formats that the first byte chooses: a structure with atoms that are somewhere, or Error.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/check.hpp"
#include "structures/mesh_file.hpp"
#include "structures/molecule.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<const char*, 5> endings{".xyz", ".sdf", ".pdb", ".cif", ".obj"};
  if (size == 0) return 0;
  const std::string name = std::string("some") + endings[data[0] % endings.size()];
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const pantin::Structure s =
        name.ends_with(".obj") ? pantin::read_mesh_file(text, name) : pantin::read_molecule(text, name);
    if (s.vertices.empty()) std::abort();
    for (const pantin::Vec3& x : s.vertices)
      if (!std::isfinite(x[0] + x[1] + x[2])) std::abort();
  } catch (const pantin::Error&) {}
  return 0;
}
