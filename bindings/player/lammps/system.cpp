#include "player/lammps/system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "forces/forces.hpp"
#include "measure/measure.hpp"
#include "player/lammps/formula.hpp"
#include "player/lammps/law_shape.hpp"
#include "player/lammps/live_laws.hpp"
#include "player/lammps/near_distances.hpp"
#include "player/lammps/refused.hpp"
#include "player/lammps/system_fields.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_pair_tables = 1000, most_bond_tables = 500;
constexpr std::size_t most_bond_points = std::size_t{1} << 23, most_pair_points = std::size_t{1} << 24;
/// What tables of pairs have together where that is enough, and each at least.
constexpr std::size_t usual_pair_points = std::size_t{1} << 20, least_points = 1024;

/// Makes the system piece by piece.
class SystemMaker {
 public:
  SystemMaker(const World& world, double error) : world_(world), made_(lammps_atoms(world)) { made_.error = error; }

  LammpsSystem make() {
    atom_of_.assign(world_.particles.slots(), 0);
    for (std::uint32_t atom = 0; atom < made_.atoms.size(); atom++) {
      const ParticleId id = made_.atoms[atom];
      atom_of_[id.slot - 1] = atom;
    }
    kinetic_ = kinetic_of([](FamilyId) { return true; });
    for (ConnectionId id : world_.connections.ids())
      if (world_.connections[id].enabled) note(world_.connections[id]);
    settle_exclusions();
    near_.emplace(world_, made_, [left_out = pairs_left_out()](std::uint32_t a, std::uint32_t b) {
      return left_out.contains({std::min(a, b), std::max(a, b)});
    });
    made_.nearest = near_->nearest();
    std::set<TableKey> tables;
    for (InteractionId id : world_.interactions.ids())
      if (world_.interactions[id].enabled) note(world_.interactions[id], tables);
    enough_points_ =
        std::max(least_points, std::bit_floor(usual_pair_points / std::max<std::size_t>(1, tables.size())));
    for (InteractionId id : world_.interactions.ids())
      if (world_.interactions[id].enabled) add(world_.interactions[id]);
    add_bonds();
    made_.notes = laws_.notes();
    add_fields(world_, made_);
    note_sizes();
    return std::move(made_);
  }

 private:
  using Key = std::vector<double>;
  using TableKey = std::pair<std::string, Key>;  // which law, and what it reads

  /// Connections of one law and equal values.
  struct BondKind {
    const Connection* first = nullptr;
    std::shared_ptr<const Law> law;
    std::vector<double> lengths;  // [m]
    double kinetic = 0.0;         // [J] the largest of two ends relative to each other
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  };

  /// A table of the law of some shape, and its factor.
  struct ScaledTable {
    double factor = 0.0;
    LawTable table;
  };

  const World& world_;
  LammpsSystem made_;
  std::vector<std::uint32_t> atom_of_;  // (slots of particles)
  std::optional<NearDistances> near_;
  double kinetic_ = 0.0;  // [J] the largest of an atom about the common motion
  LiveLaws laws_{world_};
  std::map<const Law*, std::string> identities_;
  std::map<TableKey, std::size_t> pair_tables_;
  std::map<TableKey, BondKind> bond_kinds_;
  std::map<std::tuple<const Interaction*, std::uint64_t, double>, ScaledTable> shapes_;
  std::size_t enough_points_ = 0, pair_points_ = 0;  // of a table of pairs; of all

  double half_box() const {
    if (!world_.settings.box) return infinity;
    const Vec3 edge = *world_.settings.box;
    return 0.5 * std::min({edge[0], edge[1], edge[2]});
  }

  Box box() const { return {world_.settings.box.value_or(zero3())}; }

  /// [J] The largest of an atom of some families, about the motion that they have in common.
  template <class IsOf>
  double kinetic_of(IsOf is_of) const {
    double mass = 0.0, most = 0.0;
    Vec3 momentum = zero3();
    const auto each = [&](auto use) {
      for (ParticleId id : made_.atoms)
        if (is_of(world_.particles[id].family)) use(type_at(id).mass, velocity(world_, id));
    };
    each([&](double m, Vec3 v) {
      mass += m;
      momentum += v * m;
    });
    each([&](double m, Vec3 v) { most = std::max(most, 0.5 * m * norm2(v - momentum / mass)); });
    return most;
  }

  /// Laws that a script wrote alike twice are one.
  std::string identity(const std::shared_ptr<const Law>& law) {
    const auto [at, is_new] = identities_.try_emplace(law.get(), "");
    if (!is_new) return at->second;
    const auto name_of = [](const Input& input) {
      return text(input.name, ':', static_cast<int>(input.role), ':', static_cast<int>(input.who));
    };
    try {
      at->second = formula(law->graph, law->force[0], FormulaFor::lepton, name_of);
      if (law->energy != no_expression)
        at->second += " " + formula(law->graph, law->energy, FormulaFor::lepton, name_of);
    } catch (const Error&) { at->second = text("law ", identities_.size()); }
    for (const Parameter& p : law->parameters) at->second += " " + p.name;
    return at->second;
  }

  /// What the table of a law between two types depends on, the first of them what the law calls a; its cutoff last. Within a
  /// family either may be called a.
  TableKey table_key(const Interaction& row, std::size_t a, std::size_t b) {
    TableKey key = key_in_order(row, a, b);
    return row.a == row.b && a != b ? std::min(key, key_in_order(row, b, a)) : key;
  }

  TableKey key_in_order(const Interaction& row, std::size_t a, std::size_t b) {
    const auto value = [&](int who, const std::string& name) {
      return attribute_of(made_, made_.types[who == 0 ? a : b], name);
    };
    const std::shared_ptr<const Law> live = laws_.of(row);
    double cutoff = live->cutoff;
    if (live->touching) cutoff = std::min(cutoff, value(0, "radius") + value(1, "radius"));
    Key key = row.parameters;
    for (const Input& input : inputs_of_law(*live))
      if (input.role == Role::attribute) key.push_back(merged(value(input.who, input.name)));
    key.push_back(cutoff);
    return {identity(live), key};
  }

  /// Calls `use` with each two types that an interaction is between.
  template <class Use>
  void each_pair_of_types(const Interaction& row, Use use) const {
    std::vector<std::size_t> of_b;
    for (std::size_t b = 0; b < made_.types.size(); b++)
      if (made_.types[b].family == row.b) of_b.push_back(b);
    for (std::size_t a = 0; a < made_.types.size(); a++)
      for (std::size_t b : of_b)
        if (made_.types[a].family == row.a && (row.a != row.b || a <= b)) use(a, b);
  }

  void note(const Interaction& row, std::set<TableKey>& tables) {
    each_pair_of_types(row, [&](std::size_t a, std::size_t b) { tables.insert(table_key(row, a, b)); });
    require(tables.size() <= most_pair_tables, place_of(row), ": it needs more than ", most_pair_tables,
            " tables, one for each two kinds of particles; round the values that it reads");
  }

  /// How the particles of an interaction meet.
  struct Meeting {
    std::vector<double> distances;  // [m] of near ones now
    double kinetic = 0.0;           // [J] the largest that one brings along
  };

  Meeting meeting_of(const Interaction& row) const {
    const double own = kinetic_of([&](FamilyId family) { return family == row.a || family == row.b; });
    return {near_->of(row), own > 0.0 ? own : kinetic_};
  }

  /// The table of a law between two types, the first of them what the law calls a.
  std::size_t pair_table(const Interaction& row, const Meeting& meeting, std::size_t a, std::size_t b) {
    const auto value = [&](int who, const std::string& name) {
      return attribute_of(made_, made_.types[who == 0 ? a : b], name);
    };
    const std::shared_ptr<const Law> live = laws_.of(row);
    const TableKey key = table_key(row, a, b);
    const double cutoff = key.second.back();
    const auto [at, is_new] = pair_tables_.try_emplace(key, made_.pair_tables.size());
    if (!is_new) return at->second;
    LawTable table = pair_table_of(row, *live, meeting, cutoff, value);
    pair_points_ += table.r.size();
    require(pair_points_ <= most_pair_points, place_of(row),
            ": its tables, one for each two kinds of particles, have more "
            "than ",
            most_pair_points, " points; round the values that it reads, or ask for a larger --error");
    made_.pair_tables.push_back({text("PAIR", made_.pair_tables.size() + 1), place_of(row), std::move(table),
                                 live->has_energy(), lepton(*live, row.parameters, value)});
    return at->second;
  }

  /// Made, or a table of the same interaction times a factor. That of the largest factor is exact enough for all: the energy
  /// that particles bring along, which errors may be held against, matters least there.
  LawTable pair_table_of(const Interaction& row, const Law& live, const Meeting& meeting, double cutoff,
                         const std::function<double(int, const std::string&)>& value) {
    const LawShape shape = shape_of(live, row.parameters, value);
    ScaledTable& known = shapes_[{&row, shape.hash, cutoff}];
    if (shape.factor != 0.0 && std::abs(shape.factor) <= std::abs(known.factor))
      return times(known.table, shape.factor / known.factor);
    LawOfDistance law(place_of(row), live, row.parameters, value);
    TableWish wish;
    std::ranges::copy_if(meeting.distances, std::back_inserter(wish.distances),
                         [&](double r) { return r < 0.98 * cutoff; });
    wish.idle = wish.distances.empty();
    if (wish.idle) wish.distances.push_back(std::min(near_->spacing(), 0.9 * cutoff));
    wish.to = cutoff;
    wish.kinetic = kinetic_;
    wish.idle_kinetic = meeting.kinetic;
    wish.error = made_.error;
    wish.enough = enough_points_;
    LawTable table = make_table(law, wish);
    if (std::abs(shape.factor) > std::abs(known.factor)) known = {shape.factor, table};
    return table;
  }

  /// The energy as a formula of r, or empty where it cannot be one.
  template <class ValueOf>
  static std::string lepton(const Law& law, const std::vector<double>& parameters, const ValueOf& value) {
    if (law.energy == no_expression) return "";
    try {
      return formula(law.graph, law.energy, FormulaFor::lepton, [&](const Input& input) {
        double x = 0.0;
        if (input.role == Role::attribute) x = value(input.who, input.name);
        for (std::size_t i = 0; input.role == Role::parameter && i < parameters.size(); i++)
          if (law.parameters[i].name == input.name) x = parameters[i];
        return x < 0.0 ? "(" + to_text(x) + ")" : to_text(x);
      });
    } catch (const Error&) { return ""; }
  }

  void add(const Interaction& row) {
    std::vector<PairCoefficient> list;
    std::set<std::pair<int, int>> taken;
    const Meeting meeting = meeting_of(row);
    each_pair_of_types(row, [&](std::size_t a, std::size_t b) {
      const int low = static_cast<int>(std::min(a, b)) + 1, high = static_cast<int>(std::max(a, b)) + 1;
      if (taken.insert({low, high}).second) list.push_back({low, high, pair_table(row, meeting, a, b)});
    });
    if (list.empty()) return;
    const auto is_free = [&](const PairStyle& style) {
      return std::ranges::none_of(style.coefficients, [&](const PairCoefficient& c) {
        return taken.contains({c.a, c.b});
      });
    };
    auto style = std::ranges::find_if(made_.pair_styles, is_free);
    if (style == made_.pair_styles.end()) style = made_.pair_styles.insert(style, PairStyle{});
    style->coefficients.insert(style->coefficients.end(), list.begin(), list.end());
  }

  /// LAMMPS leaves the same pairs out of all laws. Those that leave out fewer may leave out as many where they act on none of
  /// these.
  void settle_exclusions() {
    for (InteractionId id : world_.interactions.ids())
      if (world_.interactions[id].enabled)
        made_.exclude = std::max(made_.exclude, world_.interactions[id].law->exclude);
    std::vector<std::vector<std::uint32_t>> bonded;
    for (InteractionId id : world_.interactions.ids()) {
      const Interaction& row = world_.interactions[id];
      if (!row.enabled || row.law->exclude == made_.exclude) continue;
      if (bonded.empty()) bonded = bonded_atoms();
      for (std::uint32_t a = 0; a < bonded.size(); a++)
        require(!acts_beyond(row, a, bonded), place_of(row), ": exclude = ", row.law->exclude, " here and ",
                made_.exclude, " elsewhere, and LAMMPS leaves the same pairs out of all laws; give all the same");
    }
  }

  std::vector<std::vector<std::uint32_t>> bonded_atoms() const {
    std::vector<std::vector<std::uint32_t>> list(made_.atoms.size());
    for (const auto& [key, kind] : bond_kinds_)
      for (const auto& [a, b] : kind.ends) {
        list[a].push_back(b);
        list[b].push_back(a);
      }
    return list;
  }

  FamilyId family_of(std::uint32_t atom) const { return world_.particles[made_.atoms[atom]].family; }

  /// Whether a law acts between an atom and one that others would leave out.
  bool acts_beyond(const Interaction& row, std::uint32_t atom,
                   const std::vector<std::vector<std::uint32_t>>& bonded) const {
    if (family_of(atom) != row.a) return false;
    bool acts = false;
    each_left_out(atom, bonded, [&](int away, std::uint32_t other) {
      acts = acts || (away > row.law->exclude && family_of(other) == row.b);
    });
    return acts;
  }

  /// Calls use(connections apart, other atom) with each that is left out beside an atom.
  template <class Use>
  void each_left_out(std::uint32_t atom, const std::vector<std::vector<std::uint32_t>>& bonded, Use use) const {
    std::vector<std::uint32_t> reached = {atom};
    std::size_t edge = 0;
    for (int away = 1; away <= made_.exclude; away++) {
      const std::size_t end = reached.size();
      for (; edge < end; edge++)
        for (std::uint32_t next : bonded[reached[edge]])
          if (std::ranges::find(reached, next) == reached.end()) {
            use(away, next);
            reached.push_back(next);
          }
    }
  }

  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_left_out() const {
    std::set<std::pair<std::uint32_t, std::uint32_t>> list;
    if (made_.exclude == 0) return list;
    const auto bonded = bonded_atoms();
    for (std::uint32_t a = 0; a < bonded.size(); a++)
      each_left_out(a, bonded, [&](int, std::uint32_t b) {
        if (a < b) list.emplace(a, b);
      });
    return list;
  }

  const AtomType& type_at(ParticleId id) const {
    return made_.types[static_cast<std::size_t>(made_.type_of[atom_of_[id.slot - 1]]) - 1];
  }

  void note(const Connection& row) {
    Key key;
    for (double value : row.parameters) key.push_back(merged(value));
    const std::shared_ptr<const Law> live = laws_.of(row);
    for (const Input& input : inputs_of_law(*live))
      if (input.role == Role::attribute)
        key.push_back(merged(attribute_of(made_, type_at(row.particles[input.who]), input.name)));
    BondKind& kind = bond_kinds_[{identity(live), key}];
    if (!kind.first) kind.first = &row, kind.law = live;
    const double length = norm(box().nearest(position(world_, row.particles[1]) - position(world_, row.particles[0])));
    require(length > 0.0, place_of(row),
            ": a connection of no length has no direction in LAMMPS; move one of its ends a little");
    require(
        length < half_box(), place_of(row), ": a connection of ", rounded(length),
        " m is longer than half an edge of the box, ", rounded(half_box()),
        " m: beyond, LAMMPS and this program differ in which image of a particle it leads to; make the box larger, or "
        "put particles between its ends");
    const double mass_a = type_at(row.particles[0]).mass, mass_b = type_at(row.particles[1]).mass;
    const Vec3 apart = velocity(world_, row.particles[1]) - velocity(world_, row.particles[0]);
    kind.kinetic = std::max(kind.kinetic, 0.5 * mass_a * mass_b / (mass_a + mass_b) * norm2(apart));
    kind.lengths.push_back(length);
    kind.ends.emplace_back(atom_of_[row.particles[0].slot - 1], atom_of_[row.particles[1].slot - 1]);
  }

  void add_bonds() {
    require(bond_kinds_.size() <= most_bond_tables, "there are ", bond_kinds_.size(),
            " kinds of connections, by law and values of its parameters: LAMMPS has a table for each, at most ",
            most_bond_tables, "; give them fewer values, as lengths in steps");
    // LAMMPS has one way and one number of points for all bonds.
    std::size_t points = 256;
    bool straight = false;
    for (const auto& [key, kind] : bond_kinds_) {
      const LawTable table = bond_table(kind, points, false);
      check_stiffness(*kind.first, table);
      points = std::max(points, table.r.size());
      straight = straight || !table.spline;
    }
    for (bool even = false; !even;) {
      made_.bond_tables.clear();
      even = true;
      for (const auto& [key, kind] : bond_kinds_) {
        LawTable table = bond_table(kind, points, straight);
        even = even && table.r.size() == points;
        points = std::max(points, table.r.size());
        require(points * bond_kinds_.size() <= most_bond_points, place_of(*kind.first), ": tables of ",
                bond_kinds_.size(), " kinds of connections, each of ", points,
                " points, are too large; ask for a larger --error");
        add(kind, std::move(table));
      }
    }
    for (const auto& [key, kind] : bond_kinds_) {
      const int type = static_cast<int>(std::distance(bond_kinds_.begin(), bond_kinds_.find(key))) + 1;
      for (const auto& [a, b] : kind.ends) made_.bonds.push_back({type, a, b});
      made_.longest_bond = std::max(made_.longest_bond, std::ranges::max(kind.lengths));
    }
  }

  auto value_at(const Connection& row) const {
    return [this, &row](int who, const std::string& name) {
      return attribute_of(made_, type_at(row.particles[static_cast<std::size_t>(who)]), name);
    };
  }

  LawTable bond_table(const BondKind& kind, std::size_t points, bool straight) const {
    const Connection& row = *kind.first;
    require(!std::isfinite(kind.law->cutoff) || kind.law->remade, place_of(row),
            ": a connection whose law ends at a cutoff is none that LAMMPS has; give it no cutoff");
    LawOfDistance law(place_of(row), *kind.law, row.parameters, value_at(row));
    TableWish wish{TableOver::distance, kind.lengths};
    wish.most = half_box();
    wish.points = points;
    wish.straight = straight;
    wish.kinetic = kinetic_;
    wish.idle_kinetic = kind.kinetic > 0.0 ? kind.kinetic : kinetic_;
    wish.error = made_.error;
    return make_table(law, wish);
  }

  void add(const BondKind& kind, LawTable table) {
    const Connection& row = *kind.first;
    made_.bond_tables.push_back({text("BOND", made_.bond_tables.size() + 1), place_of(row), std::move(table),
                                 kind.law->energy != no_expression, lepton(*kind.law, row.parameters, value_at(row))});
  }

  /// What Pantin would solve with its articulate LAMMPS does in explicit steps, which diverge from 4 on.
  void check_stiffness(const Connection& row, const LawTable& table) const {
    const double h = world_.settings.step, rate2 = table.stiffness * (1.0 / type_at(row.particles[0]).mass +
                                                                      1.0 / type_at(row.particles[1]).mass);
    require(h * h * rate2 < 4.0, place_of(row), ": a spring of ", rounded(table.stiffness),
            " N/m is too stiff for LAMMPS' steps of ", h,
            " s, which are explicit; try --set scene.step=", rounded(1.0 / std::sqrt(rate2)));
  }

  /// What sums of energies and forces come to, whatever their signs.
  void note_sizes() {
    double usual = 0.0;
    for (const LammpsTable& t : made_.pair_tables) usual = std::max(usual, t.table.usual_energy);
    made_.energy_size = usual * near_->pairs();
    for (const LammpsBond& bond : made_.bonds)
      made_.energy_size += made_.bond_tables[static_cast<std::size_t>(bond.type) - 1].table.usual_energy;
    for (const auto* list : {&made_.pair_tables, &made_.bond_tables})
      for (const LammpsTable& t : *list) made_.usual_force = std::max(made_.usual_force, t.table.usual_force);
  }
};

}  // namespace

LammpsSystem lammps_system(const World& world, double error) { return SystemMaker(world, error).make(); }

}  // namespace pantin::player
