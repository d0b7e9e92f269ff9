#pragma once
// What is taken from gemmi: elements, and the atoms of PDB and mmCIF files. In C++17, as its headers are compiled.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

struct ChemicalElement {
  std::string name;     ///< "C"
  double mass = 0.0;    ///< [u]
  double radius = 0.0;  ///< [Å] covalent (Cordero et al. 2008)
};
/// By a symbol in capitals or not, or by its number.
std::optional<ChemicalElement> find_element(const std::string& symbol);
std::optional<ChemicalElement> find_element(int number);

struct MoleculeAtom {
  ChemicalElement element;
  Vec3 position = zero3();  ///< [Å]
  std::string name;         ///< in its residue
  int serial = 0;           ///< in the file
};
struct MoleculeAtoms {
  std::vector<MoleculeAtom> atoms;                      ///< of the first model, of alternative places the first
  std::vector<std::array<std::string, 2>> named_bonds;  ///< of a component, by names of atoms
};
/// `name` begins messages. Throw std::exception.
MoleculeAtoms read_pdb_atoms(std::string_view text, const std::string& name);
MoleculeAtoms read_cif_atoms(std::string_view text, const std::string& name);

}  // namespace pantin
