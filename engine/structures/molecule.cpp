#include "structures/molecule.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "base/check.hpp"
#include "base/interruptible.hpp"
#include "base/near_positions.hpp"
#include "structures/molecule_gemmi.hpp"
#include "structures/rings.hpp"

namespace pantin {
namespace {

/// What a file says: positions [Å], elements, and bonds where it has them.
struct MoleculeFile {
  std::vector<Vec3> positions;
  std::vector<ChemicalElement> elements;
  std::vector<StructureEdge> bonds;
  bool complete = false;  ///< there are no other bonds than these

  void add(const ChemicalElement& element, Vec3 position) {
    require(positions.size() < most_vertices, "has more than ", most_vertices, " atoms");
    elements.push_back(element);
    positions.push_back(position);
  }
};

/// The lines of a text, one after the other; errors name the last.
class Lines {
 public:
  Lines(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const auto end = rest_.find('\n');
    line = rest_.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
    number_++;
    loop_.count_bytes(line.size());
    if (line.size() > longest) fail("the line has ", line.size(), " bytes; at most ", longest, " are read");
    return true;
  }
  std::string_view need(const char* what) {
    std::string_view line;
    if (!next(line)) throw Error(text(name_, ":", number_ + 1, ": the file ends before ", what));
    return line;
  }
  template <class... Parts>
  [[noreturn]] void fail(const Parts&... message) const {
    throw Error(text(name_, ":", number_, ": ", message...));
  }

 private:
  static constexpr std::size_t longest = std::size_t{1} << 20;  // [bytes]

  std::string_view rest_;
  const std::string& name_;
  std::size_t number_ = 0;
  Interruptible loop_;
};

std::string_view trimmed(std::string_view s) {
  const auto from = s.find_first_not_of(" \t");
  return from == s.npos ? std::string_view{} : s.substr(from, s.find_last_not_of(" \t") - from + 1);
}

std::string_view field(std::string_view line, std::size_t from, std::size_t count) {
  return from < line.size() ? trimmed(line.substr(from, count)) : std::string_view{};
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const auto end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

/// What messages show of a bad text.
std::string shown(std::string_view s) {
  std::string clean;
  for (char c : s.substr(0, 40)) clean += c >= ' ' && c <= '~' ? c : '?';
  return text("'", clean, s.size() > 40 ? "…'" : "'");
}

template <class Number>
std::optional<Number> number_of(std::string_view s) {
  if (s.starts_with('+')) s.remove_prefix(1);
  Number value{};
  const auto result = std::from_chars(s.data(), s.data() + s.size(), value);
  if (s.empty() || result.ec != std::errc{} || result.ptr != s.data() + s.size()) return {};
  return value;
}

double coordinate(const Lines& lines, std::string_view s) {
  const auto value = number_of<double>(s);
  if (!value || !std::isfinite(*value)) lines.fail("a coordinate must be a finite number [Å], got ", shown(s));
  return *value;
}

/// By its symbol, which digits may follow, or its number.
std::optional<ChemicalElement> element_of(std::string_view s) {
  if (const auto number = number_of<int>(s)) return find_element(*number);
  return find_element(std::string(s.substr(0, std::min(s.find_first_of("0123456789"), s.size()))));
}

ChemicalElement need_element(const Lines& lines, std::string_view s) {
  const auto element = element_of(s);
  if (!element) lines.fail("must name a chemical element, got ", shown(s));
  return *element;
}

MoleculeFile read_xyz(std::string_view text, const std::string& name) {
  Lines lines(text, name);
  const std::string_view first = trimmed(lines.need("the number of atoms"));
  const auto count = number_of<long>(first);
  if (!count || *count < 1) lines.fail("must be the number of atoms, got ", shown(first));
  if (*count > static_cast<long>(most_vertices)) lines.fail("at most ", most_vertices, " atoms are read, got ", *count);
  lines.need("the comment in its second line");
  MoleculeFile file;
  for (long i = 1; i <= *count; i++) {
    const auto words = words_of(lines.need(pantin::text("atom ", i, " of ", *count).c_str()));
    if (words.size() < 4) lines.fail("must be an element and three coordinates [Å]");
    const ChemicalElement element = need_element(lines, words[0]);
    file.add(element, vec(coordinate(lines, words[1]), coordinate(lines, words[2]), coordinate(lines, words[3])));
  }
  return file;
}

/// MDL molfile, version 2000: fields of fixed width.
MoleculeFile read_sdf(std::string_view text, const std::string& name) {
  Lines lines(text, name);
  for (int i = 0; i < 3; i++) lines.need("its fourth line, the counts");
  const std::string_view counts = lines.need("the counts");
  if (counts.find("V3000") != counts.npos) lines.fail("version V3000 is not read; save it as V2000");
  const auto atoms = number_of<long>(field(counts, 0, 3)), bonds = number_of<long>(field(counts, 3, 3));
  if (!atoms || !bonds || *atoms < 1 || *bonds < 0)
    lines.fail("must be the numbers of atoms and bonds, got ", shown(counts));
  MoleculeFile file;
  for (long i = 1; i <= *atoms; i++) {
    const std::string_view line = lines.need(pantin::text("atom ", i, " of ", *atoms).c_str());
    const Vec3 position = vec(coordinate(lines, field(line, 0, 10)), coordinate(lines, field(line, 10, 10)),
                              coordinate(lines, field(line, 20, 10)));
    file.add(need_element(lines, field(line, 31, 3)), position);
  }
  for (long i = 1; i <= *bonds; i++) {
    const std::string_view line = lines.need(pantin::text("bond ", i, " of ", *bonds).c_str());
    const auto a = number_of<long>(field(line, 0, 3)), b = number_of<long>(field(line, 3, 3));
    if (!a || !b || *a < 1 || *b < 1 || *a > *atoms || *b > *atoms || *a == *b)
      lines.fail("must be a bond between two of the ", *atoms, " atoms, got ", shown(line));
    file.bonds.push_back({static_cast<std::uint32_t>(*a - 1), static_cast<std::uint32_t>(*b - 1)});
  }
  file.complete = *bonds > 0;
  return file;
}

using Conect = std::pair<int, int>;

/// Checks the coordinates, which gemmi takes as 0 where they are no numbers, and reads the bonds, which it leaves out.
std::vector<Conect> read_conect(std::string_view text, const std::string& name) {
  Lines lines(text, name);
  std::vector<Conect> bonds;
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with("ATOM  ") || line.starts_with("HETATM")) {
      if (line.size() < 54) lines.fail("the line of an atom ends before its coordinates do");
      for (std::size_t i = 0; i < 3; i++) coordinate(lines, field(line, 30 + 8 * i, 8));
    } else if (line.starts_with("CONECT")) {
      const auto from = number_of<int>(field(line, 6, 5));
      for (std::size_t i = 0; i < 4 && from; i++)
        if (const auto to = number_of<int>(field(line, 11 + 5 * i, 5))) bonds.push_back({*from, *to});
    }
  }
  return bonds;
}

MoleculeFile read_pdb(std::string_view text, const std::string& name) {
  const std::vector<Conect> conect = read_conect(text, name);
  MoleculeFile file;
  std::map<int, std::uint32_t> by_serial;
  for (const MoleculeAtom& atom : read_pdb_atoms(text, name).atoms) {
    by_serial[atom.serial] = static_cast<std::uint32_t>(file.positions.size());
    file.add(atom.element, atom.position);
  }
  for (const auto& [from, to] : conect) {
    const auto a = by_serial.find(from), b = by_serial.find(to);
    if (a != by_serial.end() && b != by_serial.end() && a != b) file.bonds.push_back({a->second, b->second});
  }
  return file;
}

MoleculeFile read_cif(std::string_view text, const std::string& name) {
  const MoleculeAtoms read = read_cif_atoms(text, name);
  MoleculeFile file;
  std::map<std::string, std::uint32_t> by_name;
  for (const MoleculeAtom& atom : read.atoms) {
    by_name.emplace(atom.name, static_cast<std::uint32_t>(file.positions.size()));
    file.add(atom.element, atom.position);
  }
  for (const auto& names : read.named_bonds) {
    const auto a = by_name.find(names[0]), b = by_name.find(names[1]);
    if (a != by_name.end() && b != by_name.end() && a != b) file.bonds.push_back({a->second, b->second});
  }
  file.complete = !file.bonds.empty();
  return file;
}

/// Bonds by distance, where at least one of the two has none in the file (O'Boyle et al. 2011).
void add_near_bonds(MoleculeFile& file) {
  constexpr double slack = 0.45, same_position = 0.1;  // Å
  std::vector<char> bonded(file.positions.size(), 0);
  for (const StructureEdge& bond : file.bonds) bonded[bond[0]] = bonded[bond[1]] = 1;
  double widest = 0.0;
  for (const ChemicalElement& element : file.elements) widest = std::fmax(widest, element.radius);
  const NearPositions near(file.positions, 2.0 * widest + slack);
  for (std::uint32_t a = 0; a < file.positions.size(); a++)
    near.each(file.positions[a], [&](std::uint32_t b) {
      if (b <= a) return;
      const double distance = norm(file.positions[a] - file.positions[b]);
      require(distance > same_position, "atoms ", a + 1, " and ", b + 1, " are only ", distance, " Å apart");
      const double reach = file.elements[a].radius + file.elements[b].radius + slack;
      if (!(bonded[a] && bonded[b]) && distance <= reach) file.bonds.push_back({a, b});
    });
}

Structure structure_of(MoleculeFile file) {
  require(!file.positions.empty(), "has no atoms");
  if (!file.complete) add_near_bonds(file);
  for (StructureEdge& bond : file.bonds) std::sort(bond.begin(), bond.end());
  std::sort(file.bonds.begin(), file.bonds.end());
  file.bonds.erase(std::unique(file.bonds.begin(), file.bonds.end()), file.bonds.end());
  Structure s;
  s.vertices = std::move(file.positions);
  s.edges = std::move(file.bonds);
  for (const ChemicalElement& element : file.elements) s.elements.push_back(element.name);
  s.faces = flat_rings(s, 8, 0.1);
  return s;
}

}  // namespace

Structure read_molecule(std::string_view text, const std::string& name) {
  const auto dot = name.rfind('.');
  const std::string ending = dot == name.npos ? "" : name.substr(dot);
  const auto read = ending == ".xyz"                         ? read_xyz
                    : ending == ".sdf" || ending == ".mol"   ? read_sdf
                    : ending == ".pdb"                       ? read_pdb
                    : ending == ".cif" || ending == ".mmcif" ? read_cif
                                                             : nullptr;
  require(read, name, ": a molecule is read from .xyz, .sdf, .mol, .pdb, .cif or .mmcif");
  try {
    return structure_of(read(text, name));
  } catch (const std::exception& error) {
    const std::string message = error.what();
    throw Error(message.starts_with(name) ? message : pantin::text(name, ": ", message));
  }
}

double atomic_mass(const std::string& element) {
  const auto known = element_of(element);
  require(known.has_value(), "there is no chemical element '", element, "'");
  return known->mass;
}

}  // namespace pantin
