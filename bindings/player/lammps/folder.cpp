#include "player/lammps/folder.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "base/bounds.hpp"
#include "player/output.hpp"
#include "scene/errors.hpp"

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
  const std::string& str() const { return text_; }

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

void write_file(const std::string& folder, const char* name, const std::string& content) {
  Output output((fs::path(folder) / name).string());
  output.write(content);
  output.keep();
}

void make_folder(const std::string& folder) {
  std::error_code failed;
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw UsageError(text("cannot write ", folder, ": it is no folder"));
  if (fs::is_directory(folder) && !fs::is_empty(folder) && !fs::exists(fs::path(folder) / "in.scene"))
    throw UsageError(text("cannot write ", folder, ": it holds files that are not of an export; name another folder"));
  fs::create_directories(folder, failed);
  if (failed) throw UsageError(text("cannot write ", folder, ": ", failed.message()));
}

bool has_molecules(const LammpsSystem& system) { return !system.bonds.empty() || !system.bodies.empty(); }

/// The box of the scene, or one around all atoms.
Bounds bounds_of(const World& world, const LammpsSystem& system) {
  if (world.settings.box) return {zero3(), *world.settings.box};
  Bounds bounds;
  for (ParticleId id : system.atoms) bounds.add(position(world, id));
  return widened(bounds, std::max(1e-6, 0.5 * system.nearest));
}

std::string data_text(const World& world, const LammpsSystem& system, const std::string& name) {
  Text out;
  out.reserve(160 * system.atoms.size() + 40 * system.bonds.size() + 4096);
  out << "LAMMPS data of " << name << " at " << world.time << " s; m, kg, s\n\n";
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
        << describe(world, system, system.types[i]) << "\n";
  const bool molecules = has_molecules(system);
  out << "\nAtoms # " << (molecules ? "bond" : "atomic") << "\n\n";
  for (std::size_t i = 0; i < system.atoms.size(); i++) {
    const Vec3 x = position(world, system.atoms[i]);
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
  return out.str();
}

/// One way of interpolation for all pairs of a style, or all bonds.
bool all_splined(const std::vector<LammpsTable>& tables) {
  return std::ranges::all_of(tables, [](const LammpsTable& t) { return t.table.spline; });
}

std::string table_text(const std::vector<LammpsTable>& tables, bool of_pairs) {
  Text out;
  out << "# distance m, energy J, force N\n";
  for (const LammpsTable& t : tables) {
    const LawTable& table = t.table;
    out << "\n# " << t.law << ", to an error of " << table.error << "\n";
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
  return out.str();
}

/// The pair styles, each tables of one way and one number of points.
struct Substyle {
  int exclude = 0;
  bool spline = true;
  std::size_t points = 0;
  std::vector<PairCoefficient> coefficients;
};

std::vector<Substyle> substyles(const LammpsSystem& system) {
  std::vector<Substyle> list;
  for (const PairStyle& style : system.pair_styles) {
    std::map<std::pair<bool, std::size_t>, Substyle> by_way;
    for (const PairCoefficient& c : style.coefficients) {
      const LawTable& table = system.pair_tables[c.table].table;
      Substyle& sub = by_way[{table.spline, table.r.size()}];
      sub.coefficients.push_back(c);
    }
    for (auto& [way, sub] : by_way) {
      sub.exclude = style.exclude;
      std::tie(sub.spline, sub.points) = way;
      list.push_back(std::move(sub));
    }
  }
  return list;
}

/// Factors of pairs 1, 2 and 3 connections apart.
std::string weights(int exclude) {
  return text(exclude >= 1 ? 0 : 1, ' ', exclude >= 2 ? 0 : 1, ' ', exclude >= 3 ? 0 : 1);
}

/// Pair and bond styles by tables, or by formulas.
std::string laws_text(const LammpsSystem& system, bool by_tables) {
  const std::vector<Substyle> subs = by_tables ? substyles(system) : [&] {
    std::vector<Substyle> list;
    for (const PairStyle& style : system.pair_styles) list.push_back({style.exclude, true, 0, style.coefficients});
    return list;
  }();
  std::string out;
  const bool mixed = std::ranges::any_of(subs, [&](const Substyle& s) { return s.exclude != subs[0].exclude; });
  if (!system.bonds.empty())
    out += text("special_bonds lj/coul ",
                mixed          ? "0.5 0.5 0.5"
                : subs.empty() ? "1 1 1"
                               : weights(subs[0].exclude),
                "\n");
  out += "pair_style hybrid/overlay";
  double longest = 0.0;
  for (const LammpsTable& t : system.pair_tables) longest = std::max(longest, t.table.to());
  for (const Substyle& sub : subs)
    out += by_tables ? text(" table ", sub.spline ? "spline " : "linear ", sub.points) : text(" lepton ", longest);
  if (subs.empty()) out = out.substr(0, out.rfind("pair_style")) + "pair_style none";
  out += "\n";
  std::set<std::pair<int, int>> covered;
  for (std::size_t s = 0; s < subs.size(); s++) {
    const std::string number = subs.size() > 1 ? text(s + 1, ' ') : "";
    for (const PairCoefficient& c : subs[s].coefficients) {
      const LammpsTable& t = system.pair_tables[c.table];
      covered.insert({c.a, c.b});
      out += by_tables
                 ? text("pair_coeff ", c.a, ' ', c.b, " table ", number, "pair.table ", t.name, ' ', t.table.to(), "\n")
                 : text("pair_coeff ", c.a, ' ', c.b, " lepton ", number, '"', t.lepton, "\" ", t.table.to(), "\n");
    }
    if (mixed)
      out += text("pair_modify pair ", by_tables ? "table " : "lepton ", number, "special lj/coul ",
                  weights(subs[s].exclude), "\n");
  }
  for (int a = 1; !subs.empty() && a <= static_cast<int>(system.types.size()); a++)
    for (int b = a; b <= static_cast<int>(system.types.size()); b++)
      if (!covered.contains({a, b})) out += text("pair_coeff ", a, ' ', b, " none\n");
  if (system.bonds.empty()) return out;
  std::size_t points = 0;
  for (const LammpsTable& t : system.bond_tables) points = std::max(points, t.table.r.size());
  out += by_tables ? text("bond_style table ", all_splined(system.bond_tables) ? "spline " : "linear ", points, "\n")
                   : std::string("bond_style lepton\n");
  for (std::size_t i = 0; i < system.bond_tables.size(); i++)
    out += by_tables ? text("bond_coeff ", i + 1, " bond.table ", system.bond_tables[i].name, "\n")
                     : text("bond_coeff ", i + 1, " 0.0 \"", system.bond_tables[i].lepton, "\"\n");
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
  std::string out = text("# ", task.name, " at ", world.time, " s, for LAMMPS of 29 September 2021 or newer:\n",
                         "#   lmp -in in.scene        or        mpirun -np 4 lmp -in in.scene\n",
                         "# Units: those of the scene, m, kg, s, J, N; temperatures are k_B T in J. In `units lj` "
                         "LAMMPS converts nothing.\n");
  out += text("# Energy of all laws here: ", task.law_energy, " J. Tables follow their laws to ", system.error,
              " of the energy and force there, or of the largest that\n# there are now where that is more.\n");
  for (const auto* list : {&system.pair_tables, &system.bond_tables})
    for (const LammpsTable& t : *list)
      out += text("#   ", t.name, ": ", t.law, ", ", t.table.r.size(),
                  t.table.spline ? " points, splines" : " points, straight lines", ", from ", t.table.from(), " to ",
                  t.table.to(), " m, error ", rounded(t.table.error), "\n");
  out += "# A particle that comes nearer, or a bond that leaves its table, ends the run: the step is too long then.\n";
  if (lepton) out += "# LAMMPS from 2023 on takes formulas in place of tables: -var laws lepton (slower, exact).\n";
  for (std::size_t i = 0; i < system.types.size(); i++)
    out += text("# Type ", i + 1, ": ", describe(world, system, system.types[i]), ", ", system.types[i].mass, " kg, ",
                system.types[i].count, " of them\n");
  for (const std::string& note : task.notes) out += "# Note: " + note + "\n";
  return out;
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
    out += text("group bath", i + 1, " type", type_list(bath.types), "\n", "fix bath", i + 1, " bath", i + 1,
                " langevin ", bath.temperature, ' ', bath.temperature, ' ', 1.0 / bath.rate, ' ',
                1000 + i + world.settings.seed % 900000, "\n");
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
    out += text("# ", field.law, "\n", "group ", name, " type", type_list(field.types), "\n");
    constexpr const char* axes[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; k++) out += text("variable ", name, axes[k], " atom \"", field.force[k], "\"\n");
    if (!field.energy.empty()) out += text("variable ", name, "e atom \"", field.energy, "\"\n");
    out += text("fix ", name, ' ', name, " addforce v_", name, "x v_", name, "y v_", name, "z");
    out += field.energy.empty() ? std::string("\n") : text(" energy v_", name, "e\nfix_modify ", name, " energy yes\n");
  }
  return out;
}

std::string script_text(const World& world, const LammpsSystem& system, const LammpsTask& task, bool lepton) {
  double reach = 0.0;
  for (const LammpsTable& t : system.pair_tables) reach = std::max(reach, t.table.to());
  const double skin = 0.12 * std::max({reach, system.longest_bond, system.nearest});
  const double ghosts = std::max({reach, 1.5 * system.longest_bond, 2.0 * system.body_extent}) + 2.0 * skin;
  const char* const side = world.settings.box ? "p" : "s";
  std::string out = header_text(world, system, task, lepton);
  out += text("\nvariable steps index ", task.steps, "\nvariable every index ", task.every,
              "\nvariable laws index tables\nvariable check index no\n\n");
  out += text("units lj\nboundary ", side, ' ', side, ' ', side, "\natom_style ",
              has_molecules(system) ? "bond" : "atomic",
              "\natom_modify map array\nread_data scene.data\ninclude laws.${laws}\n");
  out += text("neighbor ", skin,
              " bin\nneigh_modify every 1 delay 0 check yes one 10000 page 1000000\ncomm_modify cutoff ", ghosts, "\n");
  if (!system.bodies.empty()) out += "group bodies molecule > 0\nneigh_modify exclude molecule/intra bodies\n";
  out += text("timestep ", world.settings.step, "\nthermo_style custom step pe ke etotal temp\n",
              "thermo_modify norm no flush yes format float %.15g\n\n");
  out += fields_text(system);
  out +=
      "\n# Forces and energy of the laws at the beginning.\nrun 0\nprint \"pantin: energy $(pe:%.17g)\"\n"
      "if \"${check} == yes\" then \"write_dump all custom start.dump id fx fy fz modify format float %.17g\" &\n"
      "  \"print 'pantin: start.dump is there'\"\n\n";
  out += motion_text(world, system);
  out +=
      "thermo ${every}\nrun ${steps}\n\n# Where all is at the end, not wrapped into the box.\n"
      "write_dump all custom end.dump id xu yu zu vx vy vz modify format float %.17g\n";
  return out;
}

}  // namespace

void write_lammps(const std::string& folder, const World& world, const LammpsSystem& system, const LammpsTask& task) {
  make_folder(folder);
  const bool lepton = all_lepton(system);
  write_file(folder, "scene.data", data_text(world, system, task.name));
  if (!system.pair_tables.empty()) write_file(folder, "pair.table", table_text(system.pair_tables, true));
  if (!system.bond_tables.empty()) write_file(folder, "bond.table", table_text(system.bond_tables, false));
  write_file(folder, "laws.tables", laws_text(system, true));
  if (lepton) write_file(folder, "laws.lepton", laws_text(system, false));
  write_file(folder, "in.scene", script_text(world, system, task, lepton));
}

}  // namespace pantin::player
