#pragma once
// Molecules from files. Places in files are in Å, and so are those of the structure: [Å].
#include <string>
#include <string_view>

#include "structures/structure.hpp"

namespace pantin {

/// Reads .xyz (the first of its frames), .sdf or .mol (V2000, the first molecule), .pdb and .cif or .mmcif (the first
/// model), by the ending of `name`, which also begins messages: "c60.xyz:3: …". Bonds are those of the file, or else
/// between atoms nearer than the sum of their covalent radii (Cordero et al. 2008) and 0.45 Å; faces are the flat rings
/// of up to 8 bonds. Throws Error where the text is no such file or has no atoms, or a number is bad.
Structure read_molecule(std::string_view text, const std::string& name);

/// [u] of an element, "C". Throws Error where there is none of that name.
double atomic_mass(const std::string& element);

}  // namespace pantin
