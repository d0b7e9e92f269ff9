#include "player/lammps/folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "base/bounds.hpp"
#include "base/hash.hpp"
#include "player/output.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

/// A text that grows fast.
class Text {
 public:
  Text& operator<<(std::string_view part) {
    text_ += part;
    return *this;
  }
  Text& operator<<(double x) { return number(x); }
  Text& operator<<(std::uint64_t x) { return number(x); }
  Text& operator<<(std::uint32_t x) { return number(x); }
  Text& operator<<(int x) { return number(x); }
  void reserve(std::size_t bytes) { text_.reserve(bytes); }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;

  template <class T>
  Text& number(T x) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, x).ptr;
    text_.append(digits, end);
    return *this;
  }
};

bool has_file(const std::string& folder, const std::string& name) { return fs::exists(fs::path(folder) / name); }

void write_file(const std::string& folder, const std::string& name, const std::string& content) {
  Output output((fs::path(folder) / name).string());
  output.write(content);
  output.keep();
}

/// Of an export before.
void remove_file(const std::string& folder, const std::string& name) {
  std::error_code ignored;
  fs::remove(fs::path(folder) / name, ignored);
}

constexpr const char* made_for = ", for LAMMPS of 29 September 2021 or newer:\n";  // ends a script's first line

constexpr const char* set_begins = "# Parameters of the scene: ";

bool is_export(const std::string& folder) {
  const auto script = file_content((fs::path(folder) / "in.scene").string());
  return script && script->substr(0, script->find('\n') + 1).ends_with(made_for);
}

void make_folder(const std::string& folder) {
  std::error_code failed;
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw UsageError(text("cannot write ", folder, ": it is no folder"));
  if (fs::is_directory(folder) && !fs::is_empty(folder) && !is_export(folder))
    throw UsageError(text("cannot write ", folder, ": it holds files that are not of an export; name another folder"));
  fs::create_directories(folder, failed);
  if (failed) throw UsageError(text("cannot write ", folder, ": ", failed.message()));
}

/// A scene's words for a comment: LAMMPS goes on in the next line after '&', opens texts by quotes, and puts variables in.
std::string words(std::string_view scene_text) {
  std::string out(scene_text);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f ||
        std::string_view("&\"'$#\\`").find(c) != std::string_view::npos)
      c = '_';
  return out;
}

bool has_molecules(const LammpsSystem& system) { return !system.bonds.empty() || !system.bodies.empty(); }

/// The box of the scene, or one around all atoms.
Bounds bounds_of(const World& world, const LammpsSystem& system) {
  if (world.settings.box) return {zero3(), *world.settings.box};
  Bounds bounds;
  for (ParticleId id : system.atoms) bounds.add(position(world, id));
  // LAMMPS has no cells for a box that is flat beside the distances that laws reach.
  double reach = 0.5 * system.nearest;
  for (const LammpsTable& t : system.pair_tables) reach = std::max(reach, t.table.to());
  return widened(bounds, reach);
}

std::string data_text(const World& world, const LammpsSystem& system, const std::string& name) {
  Text out;
  out.reserve(160 * system.atoms.size() + 40 * system.bonds.size() + 4096);
  out << "LAMMPS data of " << words(name) << " at " << world.time << " s; m, kg, s\n\n";
  out << static_cast<std::uint64_t>(system.atoms.size()) << " atoms\n"
      << static_cast<std::uint64_t>(system.types.size()) << " atom types\n";
  if (!system.bonds.empty())
    out << static_cast<std::uint64_t>(system.bonds.size()) << " bonds\n"
        << static_cast<std::uint64_t>(system.bond_tables.size()) << " bond types\n";
  const Bounds box = bounds_of(world, system);
  constexpr const char* axes[] = {"x", "y", "z"};
  for (int k = 0; k < 3; k++) out << box.low[k] << " " << box.high[k] << " " << axes[k] << "lo " << axes[k] << "hi\n";
  out << "\nMasses\n\n";
  for (std::size_t i = 0; i < system.types.size(); i++)
    out << static_cast<std::uint64_t>(i + 1) << " " << system.types[i].mass << " # "
        << words(describe(world, system, system.types[i])) << "\n";
  const bool molecules = has_molecules(system);
  const std::vector<Vec3> away = boxes_away(world, system);
  out << "\nAtoms # " << (molecules ? "bond" : "atomic") << "\n\n";
  for (std::size_t i = 0; i < system.atoms.size(); i++) {
    const Vec3 x = position(world, system.atoms[i]) - away[i];
    out << static_cast<std::uint64_t>(i + 1) << " ";
    if (molecules) out << system.body_of[i] << " ";
    out << system.type_of[i] << " " << x[0] << " " << x[1] << " " << x[2] << "\n";
  }
  out << "\nVelocities\n\n";
  for (std::size_t i = 0; i < system.atoms.size(); i++) {
    const Vec3 v = velocity(world, system.atoms[i]);
    out << static_cast<std::uint64_t>(i + 1) << " " << v[0] << " " << v[1] << " " << v[2] << "\n";
  }
  if (!system.bonds.empty()) out << "\nBonds\n\n";
  for (std::size_t i = 0; i < system.bonds.size(); i++) {
    const LammpsBond& bond = system.bonds[i];
    out << static_cast<std::uint64_t>(i + 1) << " " << bond.type << " " << bond.a + 1 << " " << bond.b + 1 << "\n";
  }
  return out.take();
}

/// LAMMPS reads a file from its beginning up to each table that it looks for: more than so many are in several.
constexpr std::size_t tables_in_a_file = 8;

/// The file of a table by its number: "pair.table", "pair2.table", …
std::string table_file(const char* of, std::size_t number) {
  const std::size_t file = number / tables_in_a_file;
  return text(of, file > 0 ? text(file + 1) : "", ".table");
}

std::string table_text(std::span<const LammpsTable> tables, bool of_pairs) {
  Text out;
  std::size_t rows = 0;
  for (const LammpsTable& t : tables) rows += t.table.r.size();
  out.reserve(80 * rows + 400 * tables.size());
  out << "# distance m, energy J, force N\n";
  for (const LammpsTable& t : tables) {
    const LawTable& table = t.table;
    out << "\n# " << words(t.law) << ", to an error of " << table.error << "\n";
    out << t.name << "\nN " << static_cast<std::uint64_t>(table.r.size());
    if (of_pairs)
      out << " RSQ " << table.from() << " " << table.to() << " FPRIME " << table.slope_from << " " << table.slope_to;
    else
      out << " FP " << table.slope_from << " " << table.slope_to;
    out << "\n\n";
    for (std::size_t i = 0; i < table.r.size(); i++)
      out << static_cast<std::uint64_t>(i + 1) << " " << table.r[i] << " " << table.energy[i] << " " << table.force[i]
          << "\n";
  }
  return out.take();
}

/// Pairs whose tables are of one way and one number of points; of formulas all of a style.
struct Substyle {
  std::string text;  ///< "table spline 1024"
  std::vector<PairCoefficient> coefficients;
};

std::vector<Substyle> substyles(const LammpsSystem& system, bool by_tables) {
  std::vector<Substyle> list;
  for (const PairStyle& style : system.pair_styles) {
    std::map<std::string, std::vector<PairCoefficient>> by_text;
    for (const PairCoefficient& c : style.coefficients) {
      const LawTable& table = system.pair_tables[c.table].table;
      by_text[by_tables ? text("table ", table.spline ? "spline " : "linear ", table.r.size())
                        : text("lepton ", table.to())]
          .push_back(c);
    }
    for (auto& [way, coefficients] : by_text) list.push_back({way, std::move(coefficients)});
  }
  return list;
}

std::string pair_laws_text(const LammpsSystem& system, bool by_tables) {
  const std::vector<Substyle> subs = substyles(system, by_tables);
  if (subs.empty()) return "pair_style none\n";
  std::string out = "pair_style hybrid/overlay";
  for (const Substyle& sub : subs) out += " " + sub.text;
  out += "\n";
  const char* const style = by_tables ? "table" : "lepton";
  std::map<std::string, int> met;
  std::set<std::pair<int, int>> covered;
  for (const Substyle& sub : subs) {
    const std::string number = subs.size() > 1 ? text(++met[style], ' ') : "";
    for (const PairCoefficient& c : sub.coefficients) {
      const LammpsTable& t = system.pair_tables[c.table];
      covered.insert({c.a, c.b});
      out +=
          text("pair_coeff ", c.a, ' ', c.b, ' ', style, ' ', number,
               by_tables ? table_file("pair", c.table) + " " + t.name : '"' + t.lepton + '"', ' ', t.table.to(), "\n");
    }
  }
  for (int a = 1; a <= static_cast<int>(system.types.size()); a++)
    for (int b = a; b <= static_cast<int>(system.types.size()); b++)
      if (!covered.contains({a, b})) out += text("pair_coeff ", a, ' ', b, " none\n");
  return out;
}

/// Pair and bond styles by tables, or by formulas.
std::string laws_text(const LammpsSystem& system, bool by_tables) {
  if (system.bonds.empty()) return pair_laws_text(system, by_tables);
  const auto weight = [&](int apart) { return system.exclude >= apart ? "0" : "1"; };
  std::string out = text("special_bonds lj/coul ", weight(1), ' ', weight(2), ' ', weight(3), "\n");
  out += pair_laws_text(system, by_tables);
  const LawTable& first = system.bond_tables[0].table;  // all are alike
  out += by_tables ? text("bond_style table ", first.spline ? "spline " : "linear ", first.r.size(), "\n")
                   : std::string("bond_style lepton no_offset\n");
  for (std::size_t i = 0; i < system.bond_tables.size(); i++) {
    const LammpsTable& t = system.bond_tables[i];
    out += text("bond_coeff ", i + 1,
                by_tables ? " " + table_file("bond", i) + " " + t.name : " 0.0 \"" + t.lepton + "\"", "\n");
  }
  return out;
}

bool all_lepton(const LammpsSystem& system) {
  const auto has = [](const LammpsTable& t) { return !t.lepton.empty(); };
  return std::ranges::all_of(system.pair_tables, has) && std::ranges::all_of(system.bond_tables, has);
}

std::string type_list(const std::vector<int>& types) {
  std::string all;
  for (int type : types) all += text(' ', type);
  return all;
}

/// What the script begins with, for who reads it.
std::string header_text(const World& world, const LammpsSystem& system, const LammpsTask& task, bool lepton) {
  std::string out = text("# ", words(task.name), " at ", world.time, " s", made_for,
                         "#   lmp -in in.scene        or        mpirun -np 4 lmp -in in.scene\n",
                         "# Units: those of the scene, m, kg, s, J, N; temperatures are k_B T in J. In `units lj` "
                         "LAMMPS converts nothing.\n");
  out += text("# Energy of all laws here: ", task.law_energy, " J. Tables follow their laws to ", system.error,
              " of the energy and force there, or of the usual ones\n# now where these are more.\n");
  for (const auto* list : {&system.pair_tables, &system.bond_tables})
    for (const LammpsTable& t : *list)
      out += text("#   ", t.name, ": ", words(t.law), ", ", t.table.r.size(),
                  t.table.spline ? " points, splines" : " points, straight lines", ", from ", t.table.from(), " to ",
                  t.table.to(), " m, error ", rounded(t.table.error),
                  t.table.beside > 0.0 ? text(" beside ", rounded(t.table.beside), " J") : "",
                  t.table.inner_error > 0.0
                      ? text(" from ", rounded(t.table.good_from), " m on, ", rounded(t.table.inner_error), " before")
                      : "",
                  "\n");
  out += "# A particle that comes nearer, or a bond that leaves its table, ends the run: the step is too long then.\n";
  if (lepton)
    out += text("# LAMMPS from ", system.bonds.empty() ? "2023" : "February 2024",
                " on takes formulas in place of tables: -var laws lepton (slower, exact).\n");
  for (std::size_t i = 0; i < system.types.size(); i++)
    out += text("# Type ", i + 1, ": ", words(describe(world, system, system.types[i])), ", ", system.types[i].mass,
                " kg, ", system.types[i].count, " of them\n");
  out += set_begins + words(task.set) + "\n";
  if (!task.back.empty()) out += "# Back into the scene: " + words(task.back) + "\n";
  for (const std::string& note : task.notes) out += "# Note: " + words(note) + "\n";
  return out;
}

/// Of a bath, for LAMMPS: 1 to 9e8, another at each time, so that a run that goes on has other noise.
std::uint64_t seed_of(const World& world, std::size_t bath) {
  Hash hash;
  hash.add(world.settings.seed);
  hash.add(world.time);
  hash.add(std::uint64_t{bath});
  return 1 + hash.value % 899999999;
}

/// Gravity, fields, baths and what moves the atoms.
std::string motion_text(const World& world, const LammpsSystem& system) {
  std::string out;
  const Vec3 g = world.settings.gravity;
  if (norm(g) > 0.0)
    out += text("fix gravity all gravity ", norm(g), " vector ", g[0], ' ', g[1], ' ', g[2],
                "\nfix_modify gravity energy yes\n");
  for (std::size_t i = 0; i < system.baths.size(); i++) {
    const LammpsBath& bath = system.baths[i];
    out +=
        text("group bath", i + 1, " type", type_list(bath.types), "\n", "fix bath", i + 1, " bath", i + 1, " langevin ",
             bath.temperature, ' ', bath.temperature, ' ', 1.0 / bath.rate, ' ', seed_of(world, i), "\n");
  }
  if (system.bodies.empty()) return out + "fix move all nve\n";
  if (std::ranges::any_of(system.body_of, [](std::uint32_t body) { return body == 0; }))
    out += "group free subtract all bodies\nfix move free nve\n";
  return out + "fix rigid bodies rigid/small molecule\n";
}

std::string fields_text(const LammpsSystem& system) {
  std::string out;
  for (std::size_t i = 0; i < system.fields.size(); i++) {
    const LammpsField& field = system.fields[i];
    const std::string name = text("field", i + 1);
    out += text("# ", words(field.law), "\n", "group ", name, " type", type_list(field.types), "\n");
    constexpr const char* axes[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; k++) out += text("variable ", name, axes[k], " atom \"", field.force[k], "\"\n");
    if (!field.energy.empty()) out += text("variable ", name, "e atom \"", field.energy, "\"\n");
    out += text("fix ", name, ' ', name, " addforce v_", name, "x v_", name, "y v_", name, "z");
    out += field.energy.empty() ? std::string("\n") : text(" energy v_", name, "e\nfix_modify ", name, " energy yes\n");
  }
  return out;
}

/// Of laws alone: beside what falls for long, theirs would be lost in the total.
std::string law_energy(const LammpsSystem& system) {
  std::string all = "epair+ebond";
  for (std::size_t i = 0; i < system.fields.size(); i++)
    if (!system.fields[i].energy.empty()) all += text("+f_field", i + 1);
  return all;
}

std::string script_text(const World& world, const LammpsSystem& system, const LammpsTask& task, bool lepton) {
  double reach = 0.0;
  for (const LammpsTable& t : system.pair_tables) reach = std::max(reach, t.table.to());
  const double skin = 0.12 * std::max({reach, system.longest_bond, system.nearest});
  double ghosts = std::max(reach, 2.0 * system.body_extent);
  for (const LammpsTable& t : system.bond_tables) ghosts = std::max(ghosts, t.table.to());
  const char* const side = world.settings.box ? "p" : "m";
  std::string out = header_text(world, system, task, lepton);
  out += text(
      "\nvariable steps index ", task.steps, "\nvariable every index ", task.every,
      "\nvariable restart index 0\nvariable laws index tables\nvariable check index no\n",
      "# How far processes know the atoms of others: as far as laws act and bonds may stretch. Where bonds stay short, "
      "many\n# processes are faster with less, -var ghosts 3; a bond that gets longer ends the run.\nvariable ghosts "
      "index ",
      ghosts + 2.0 * skin, "\n\n");
  out += text("units lj\nboundary ", side, ' ', side, ' ', side, "\natom_style ",
              has_molecules(system) ? "bond" : "atomic",
              "\natom_modify map array\nread_data scene.data\ninclude laws.${laws}\n");
  out += text("neighbor ", skin,
              " bin\nneigh_modify every 1 delay 0 check yes one 10000 page 1000000\ncomm_modify cutoff ${ghosts}\n");
  if (!system.bodies.empty()) out += "group bodies molecule > 0\nneigh_modify exclude molecule/intra bodies\n";
  out += text("timestep ", world.settings.step, "\nthermo_style custom step pe ke etotal temp\n",
              "thermo_modify norm no flush yes format float %.15g\n",
              system.atoms.size() == 1 ? "compute_modify thermo_temp extra/dof 0\n" : "", "\n");
  out += fields_text(system);
  out +=
      "\n# Forces and energy of the laws at the beginning.\nrun 0\nprint \"pantin: energy $(pe:%.17g)\"\n"
      "if \"${check} == yes\" then \"write_dump all custom start.dump id fx fy fz modify format float %.17g\" &\n"
      "  \"print 'pantin: start.dump is there'\"\n\n";
  out += motion_text(world, system);
  out +=
      "thermo ${every}\n"
      "if \"${restart} > 0\" then \"restart ${restart} first.restart second.restart\"\n"
      "run ${steps}\n";
  out += text("print \"pantin: energy at the end $(", law_energy(system), ":%.17g)\"\n");
  out +=
      "\n# Where all is at the end, not wrapped into the box.\n"
      "write_dump all custom end.dump id type xu yu zu vx vy vz modify format float %.17g\n";
  return out;
}

/// And takes away those of an export before.
void write_tables(const std::string& folder, const char* of, bool of_pairs, std::span<const LammpsTable> tables) {
  for (std::size_t first = 0; first == 0 || first < tables.size() || has_file(folder, table_file(of, first));
       first += tables_in_a_file) {
    const std::string name = table_file(of, first);
    if (first >= tables.size()) {
      remove_file(folder, name);
      continue;
    }
    const std::size_t count = std::min(tables_in_a_file, tables.size() - first);
    write_file(folder, name, table_text(tables.subspan(first, count), of_pairs));
  }
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) {
  make_folder(folder);
  folder_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0 || flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(folder_);
  throw UsageError(text("another program is writing into ", folder, ": name another folder"));
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

void write_lammps(const std::string& folder, const World& world, const LammpsSystem& system, const LammpsTask& task) {
  const bool lepton = all_lepton(system);
  write_file(folder, "scene.data", data_text(world, system, task.name));
  write_tables(folder, "pair", true, system.pair_tables);
  write_tables(folder, "bond", false, system.bond_tables);
  write_file(folder, "laws.tables", laws_text(system, true));
  if (lepton)
    write_file(folder, "laws.lepton", laws_text(system, false));
  else
    remove_file(folder, "laws.lepton");
  write_file(folder, "in.scene", script_text(world, system, task, lepton));
}

std::string other_set_in(const std::string& folder, const std::string& set) {
  const auto script = file_content((fs::path(folder) / "in.scene").string());
  const std::size_t at = script && is_export(folder) ? script->find(set_begins) : std::string::npos;
  if (at == std::string::npos) return "";
  const std::size_t from = at + std::string_view(set_begins).size();
  const std::string told = script->substr(from, script->find('\n', from) - from);
  return told == words(set) ? "" : told;
}

std::vector<std::string> set_results_aside(const std::string& folder) {
  std::vector<std::string> aside;
  for (const char* name : {"end.dump", "first.restart", "second.restart"}) {
    if (!has_file(folder, name)) continue;
    aside.push_back((fs::path(folder) / text("earlier-", name)).string());
    fs::rename(fs::path(folder) / name, aside.back());
  }
  return aside;
}

}  // namespace pantin::player
