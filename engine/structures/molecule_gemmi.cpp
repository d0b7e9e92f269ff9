#include "structures/molecule_gemmi.hpp"

#include <algorithm>
#include <gemmi/chemcomp_xyz.hpp>
#include <gemmi/cif.hpp>
#include <gemmi/elem.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>
#include <string_view>
#include <unordered_set>

#include "base/check.hpp"
#include "base/interruptible.hpp"

namespace pantin {
namespace {

ChemicalElement data_of(const gemmi::Element& element) {
  return {element.name(), element.weight(), static_cast<double>(element.covalent_r())};
}

/// Lines for the reader of .pdb files.
struct CountedLines : gemmi::MemoryStream {
  using MemoryStream::MemoryStream;
  char* gets(char* line, int size) {
    loop.count();
    return MemoryStream::gets(line, size);
  }
  Interruptible loop;
};

/// Blocks of a text for the reader of .cif files.
struct CountedBlocks {
  std::size_t operator()(char* buffer, std::size_t most) {
    const std::size_t size = std::min(most, rest.size());
    loop.count_bytes(size);
    std::copy_n(rest.data(), size, buffer);
    rest.remove_prefix(size);
    return size;
  }
  std::string_view rest;
  Interruptible loop{};
};

MoleculeAtoms atoms_of(const gemmi::Structure& structure) {
  MoleculeAtoms out;
  Interruptible loop;
  if (structure.models.empty()) return out;
  for (const gemmi::Chain& chain : structure.models[0].chains)
    for (const gemmi::Residue& residue : chain.residues) {
      std::unordered_set<std::string_view> known;
      for (const gemmi::Atom& atom : residue.atoms) {
        loop.count();
        const bool first = known.insert(atom.name).second;
        if (!first && atom.altloc != '\0') continue;
        const Vec3 position = vec(atom.pos.x, atom.pos.y, atom.pos.z);
        require(finite(position), "atom ", out.atoms.size() + 1, ", '", atom.name,
                "', has a coordinate that is no finite number");
        require(atom.element != gemmi::El::X, "atom ", out.atoms.size() + 1, ", '", atom.name,
                "', is of no known element");
        out.atoms.push_back({data_of(atom.element), position, atom.name, atom.serial});
      }
    }
  return out;
}

}  // namespace

std::optional<ChemicalElement> find_element(const std::string& symbol) {
  if (symbol.empty() || symbol.size() > 2) return {};
  const gemmi::Element element(symbol);
  if (element == gemmi::El::X) return {};
  return data_of(element);
}

std::optional<ChemicalElement> find_element(int number) {
  if (number < 1 || number >= static_cast<int>(gemmi::El::D)) return {};
  return data_of(gemmi::Element(number));
}

MoleculeAtoms read_pdb_atoms(std::string_view text, const std::string& name) {
  return atoms_of(gemmi::pdb_impl::read_pdb_from_stream(CountedLines(text.data(), text.size()), name, {}));
}

MoleculeAtoms read_cif_atoms(std::string_view text, const std::string& name) {
  tao::pegtl::buffer_input<CountedBlocks> input(name, text.size() + 1, CountedBlocks{text});
  gemmi::cif::Document document = gemmi::cif::read_input(input);
  require(!document.blocks.empty(), "holds no block of data");
  gemmi::cif::Block& block = document.blocks[0];
  if (!block.find_values("_chem_comp_atom.atom_id").item()) return atoms_of(gemmi::make_structure_from_block(block));
  MoleculeAtoms component = atoms_of(gemmi::make_structure_from_chemcomp_block(block));
  for (auto row : block.find("_chem_comp_bond.", {"atom_id_1", "atom_id_2"}))
    component.named_bonds.push_back({row.str(0), row.str(1)});
  return component;
}

}  // namespace pantin
